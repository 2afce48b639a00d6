#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "core/cga/dialect.h"
#include "core/io/rule_loader.h"
#include "core/sim/dialect.h"
#include "tests/core/agenda/agenda_fixture.h"

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

std::string trimmed(const std::string &text) {
	const size_t first = text.find_first_not_of(" \t\r");
	return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

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

// The path of a file that one test holds: beside the test itself.
std::string beside(const std::string &path, const std::string &name) { return path.substr(0, path.find_last_of('/') + 1) + name; }

MessageTest read_test(const std::string &path) {
	MessageTest test;
	test.path = path;
	FileSourceProvider disk;
	const Result<std::string> text = disk.read(path);
	REQUIRE(text.is_ok());
	std::istringstream lines(*text);
	std::string line, file = path, content;
	size_t line_number = 0;
	while (std::getline(lines, line)) {
		++line_number;
		const size_t mark = line.find("// ");
		const std::string remark = mark == std::string::npos ? "" : trimmed(line.substr(mark + 3));
		if (remark.rfind("file ", 0) == 0) {
			test.files.add(file, content);
			file = beside(path, trimmed(remark.substr(5)));
			content.clear();
			line_number = 0;
			continue;
		}
		content += line + "\n";
		read_remark(test, remark, file, line_number);
	}
	test.files.add(file, content);
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
