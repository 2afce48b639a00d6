#include <doctest/doctest.h>

#include <ctime>
#include <filesystem>
#include <fstream>

#include "core/io/rule_loader.h"
#include "tests/core/lang/test_dialects.h"

using namespace pcg;
using namespace pcg::test;

namespace {

class TemporaryFolder {
public:
	TemporaryFolder() : _path(std::filesystem::temp_directory_path() / ("pcg_rule_loader_" + std::to_string(size_t(this)))) {
		std::filesystem::create_directories(_path);
	}
	~TemporaryFolder() { std::filesystem::remove_all(_path); }
	std::string write(const std::string &name, const std::string &text) const {
		std::filesystem::create_directories((_path / name).parent_path());
		std::ofstream(_path / name, std::ios::binary) << text;
		return (_path / name).string();
	}
	std::string path(const std::string &name) const { return (_path / name).string(); }

private:
	std::filesystem::path _path;
};

} // namespace

TEST_CASE("rule files are read from disk with what they import") {
	const TemporaryFolder folder;
	const std::string main = folder.write("main.pcg", "import day : \"lib/day.pcg\"\nStart --> day.Go");
	folder.write("lib/day.pcg", "import \"../more.pcg\"\nGo --> log(x)");
	folder.write("more.pcg", "x = 5");
	Diagnostics diagnostics;
	const auto program = load_program(main, day_dialect(), diagnostics);
	CHECK(to_text(diagnostics) == "");
	REQUIRE(program);
	CHECK(program->files.size() == 3);
}

TEST_CASE("a file that is missing or a folder is one message") {
	const TemporaryFolder folder;
	Diagnostics diagnostics;
	CHECK(load_program(folder.path("nothing.pcg"), day_dialect(), diagnostics) == nullptr);
	CHECK(load_program(folder.path(""), day_dialect(), diagnostics) == nullptr);
	REQUIRE(diagnostics.list().size() == 2);
	CHECK(to_text(diagnostics.list()[0]) ==
			folder.path("nothing.pcg") + ": error: there is no such file [unreadable-file]\n    check the path");
	CHECK(diagnostics.list()[1].message == "this is a folder, not a file");
}

TEST_CASE("a file that imports itself is an error with the circle") {
	const TemporaryFolder folder;
	const std::string main = folder.write("main.pcg", "import \"./sub/../main.pcg\"\nStart --> log(1)");
	Diagnostics diagnostics;
	CHECK(load_program(main, day_dialect(), diagnostics) == nullptr);
	CHECK(places_of(diagnostics) == "import-cycle 1:8");
}

TEST_CASE("ten megabytes of brackets are refused at once") {
	for (const std::string &piece : std::vector<std::string>{ "(", "[", "{", "A --> [", ")", "!", "-", "case ", "1%:", "\"\\", "$", "a(", "x = ", "@" }) {
		std::string text;
		while (text.size() < (10u << 20)) {
			text += piece;
		}
		const std::clock_t begin = std::clock(); // of this process alone: other work on the machine does not count
		Diagnostics diagnostics;
		CHECK(program_of(text, day_dialect(), diagnostics) == nullptr);
		CHECK(diagnostics.error_count() >= 1);
		const double seconds = double(std::clock() - begin) / CLOCKS_PER_SEC;
		INFO(piece, " took ", seconds, " s");
		CHECK(seconds < 20.0); // well under one in a release build; sanitizers are slow
	}
}

TEST_CASE("nesting is limited in every construct that nests") {
	const auto repeat = [](const std::string &piece, int times) {
		std::string text;
		for (int i = 0; i < times; ++i) {
			text += piece;
		}
		return text;
	};
	const int deep = 100'000;
	for (const std::string &text : { "x = " + repeat("(", deep), "x = " + repeat("-", deep) + "1", "x = " + repeat("case true: ", deep) + "1",
				 "A --> " + repeat("case true: ", deep) + "log(1)", "A --> " + repeat("[", deep), "A --> " + repeat("split(x){1:", deep),
				 "A --> " + repeat("1%: ", deep), "x = " + repeat("1%: ", deep), "x = " + repeat("f(", deep), "x = " + repeat("'", deep) + "1",
				 "A --> " + repeat("inline ", deep) + "log(1)", "A --> split(x) " + repeat("{", deep) }) {
		Diagnostics diagnostics;
		CHECK(program_of(text, shape_dialect(), diagnostics) == nullptr);
		INFO(text.substr(0, 40));
		INFO(to_text(diagnostics));
		CHECK(diagnostics.error_count() == 1);
		CHECK(places_of(diagnostics).find("nested-too-deeply") != std::string::npos);
	}
}

TEST_CASE("imports of imports, each twice, are limited") {
	MemorySourceProvider provider;
	for (int i = 0; i < 40; ++i) {
		const std::string next = "f" + std::to_string(i + 1);
		provider.add("f" + std::to_string(i), "import a : \"" + next + "\" import b : \"" + next + "\" x = 1");
	}
	provider.add("f40", "x = 1");
	Diagnostics diagnostics;
	CHECK(load_program("f0", day_dialect(), provider, diagnostics) == nullptr);
	CHECK(places_of(diagnostics).find("too-many-imports") != std::string::npos);
}
