#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "core/cga/dialect.h"
#include "core/io/rule_loader.h"
#include "core/sim/dialect.h"
#include "tests/core/agenda/agenda_fixture.h"
#include "tests/core/rules/rule_file.h"

using namespace pcg;

// Runs tests/rules/error and tests/rules/limit; the README there tells the format.
namespace {

struct Expected {
	std::string text; // "main.pcg:12:5 error unknown-name"; without the column if the test does not care
	std::string hint;
	bool was_found = false;
};

struct MessageTest {
	std::string path;
	MemorySourceProvider files;
	std::vector<Expected> expected;
};

void read_remark(MessageTest &test, const std::string &remark, const std::string &file, size_t line) {
	std::istringstream words(remark);
	std::string first, severity, id, place, position;
	words >> first;
	if (first == "hint") {
		REQUIRE(!test.expected.empty());
		test.expected.back().hint = trimmed(remark.substr(4));
	} else if (first == "expect") {
		words >> severity >> id >> place >> position;
		if (place != "at") {
			position = std::to_string(line) + (place.empty() ? "" : ":" + place);
		}
		test.expected.push_back({ file + ":" + position + " " + severity + " " + id, {}, false });
	}
}

MessageTest read_test(const std::string &path) {
	MessageTest test;
	test.path = path;
	read_rule_file(path, test.files, [&](const RuleFileLine &line) { read_remark(test, line.remark, line.file, line.number); });
	return test;
}

void check_message(MessageTest &test, const Diagnostic &diagnostic) {
	const std::string severity_and_id = (diagnostic.severity == Severity::Error ? " error " : " warning ") + std::string(diagnostic.id);
	const std::string line = diagnostic.file + ":" + std::to_string(diagnostic.line);
	for (Expected &expected : test.expected) {
		const bool is_same = expected.text == line + severity_and_id ||
				expected.text == line + ":" + std::to_string(diagnostic.column) + severity_and_id;
		if (is_same && !expected.was_found) {
			expected.was_found = true;
			CHECK((expected.hint.empty() || expected.hint == diagnostic.hint));
			return;
		}
	}
	FAIL_CHECK("not expected: ", to_text(diagnostic));
}

void run_household(std::shared_ptr<const Program> program, Diagnostics &diagnostics) {
	AgendaFixture fixture;
	fixture.add_household(fixture.add_building("house", 0.0f));
	fixture.add_person(40.0f);
	fixture.use(std::move(program));
	diagnostics.append(fixture.diagnostics);
}

void run_test(const std::string &path) {
	MessageTest test = read_test(path);
	const bool is_cga = path.ends_with(".cga");
	Diagnostics diagnostics;
	auto program = load_program(path, is_cga ? cga::cga_dialect() : pcg_dialect(), test.files, diagnostics);
	if (program != nullptr && !is_cga && path.find("/limit/") != std::string::npos) {
		run_household(std::move(program), diagnostics);
	}
	INFO(to_text(diagnostics));
	for (const Diagnostic &diagnostic : diagnostics.list()) {
		check_message(test, diagnostic);
	}
	for (const Expected &expected : test.expected) {
		INFO("expected: ", expected.text);
		CHECK(expected.was_found);
	}
	CHECK(!test.expected.empty());
}

void run_folder(const std::string &folder, size_t at_least) {
	std::vector<std::string> paths;
	std::error_code error;
	for (const auto &entry : std::filesystem::directory_iterator(folder, error)) {
		const std::filesystem::path extension = entry.path().extension();
		if (extension == ".pcg" || extension == ".cga") {
			paths.push_back(entry.path().generic_string());
		}
	}
	std::sort(paths.begin(), paths.end());
	REQUIRE(paths.size() >= at_least); // found at all: the tests run from the top folder of the project
	for (const std::string &path : paths) {
		INFO(path);
		run_test(path);
	}
}

} // namespace

TEST_CASE("mistakes in rule files by example") { run_folder("tests/rules/error", 15); }
TEST_CASE("limits of rule files by example") { run_folder("tests/rules/limit", 5); }
