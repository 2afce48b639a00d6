#include <doctest/doctest.h>

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "tests/core/lang/test_dialects.h"

using namespace pcg;
using namespace pcg::test;

namespace {

// The first file is the main one; runs its rule `Start`.
std::string run_files(std::initializer_list<std::pair<std::string, std::string>> files, const Dialect &dialect) {
	MemorySourceProvider provider;
	for (const auto &[path, text] : files) {
		provider.add(path, text);
	}
	Diagnostics diagnostics;
	const auto program = load_program(files.begin()->first, dialect, provider, diagnostics);
	if (program == nullptr) {
		return to_text(diagnostics);
	}
	LogHost host;
	Vm vm(*program, host);
	if (vm.call(program->find_rule("Start")) != RunState::Finished) {
		return to_text(host.diagnostics);
	}
	return (diagnostics.is_empty() ? "" : places_of(diagnostics) + " | ") + host.text();
}

std::string run_days(std::initializer_list<std::pair<std::string, std::string>> files) { return run_files(files, day_dialect()); }
std::string run_shapes(std::initializer_list<std::pair<std::string, std::string>> files) { return run_files(files, shape_dialect()); }

} // namespace

TEST_CASE("an import with an id keeps its names behind the id") {
	CHECK(run_days({ { "main", "import day : \"lib/day\"\nx = 1\nStart --> log(x, day.x, day.f(1)) day.Go later(day.Go)" },
				  { "lib/day", "import deep : \"deep\" x = 2 f(a) = a + x + deep.x Go --> log(x)" }, { "lib/deep", "x = 10" } }) ==
			"1,2,13 2 later:day.Go");
}

TEST_CASE("an import without an id shares the space, and the importing file wins everywhere") {
	CHECK(run_days({ { "main", "import \"day\"\nx = 1\nStart --> Go" }, { "day", "x = 2 Go --> log(x) Start --> log(0)" } }) == "1");
}

TEST_CASE("two imports of one file have attributes of their own, in one space it is there once") {
	CHECK(run_days({ { "main", "import a : \"day\" import b : \"day\"\nStart --> log(a.x == b.x) a.Go b.Go" },
				  { "day", "x = rand(0, 1) Go --> log(x == x)" } }) == "false true true");
	CHECK(run_days({ { "main", "import \"a\" import \"b\"\nStart --> log(a + b)" }, { "a", "import \"c\" a = c" }, { "b", "import \"c\" b = c" },
				  { "c", "c = 3" } }) == "6");
}

TEST_CASE("imports in a circle are an error that prints the circle") {
	CHECK(run_days({ { "main", "import \"main\"\nStart --> log(1)" } }).find("the file imports itself: main -> main [import-cycle]") !=
			std::string::npos);
	const std::string text = run_days({ { "x/main", "import a : \"b\"\nStart --> a.Go" }, { "x/b", "import \"c\"\nGo --> log(1)" },
			{ "x/c", "import \"b\"\nOther --> log(1)" } });
	CHECK(text == "x/c:1:8: error: files import each other: x/b -> x/c -> x/b [import-cycle]\n"
				  "    import \"b\"\n"
				  "           ^\n"
				  "    put what both need into a third file\n");
}

TEST_CASE("a missing import is told once, at the import") {
	CHECK(run_days({ { "main", "import a : \"nothing\"\nStart --> a.Go log(a.x)" } }) ==
			"main:1:12: error: cannot import `nothing`: there is no such file [missing-import]\n"
			"    import a : \"nothing\"\n"
			"               ^\n"
			"    paths count from the folder of the importing file\n");
	CHECK(run_shapes({ { "main", "import a : \"nothing\"\nStart --> a.Go" } }) == "missing-import 1:12 | leaf:a.Go");
}

TEST_CASE("mistakes in an imported file are told with that file's name") {
	const std::string text = run_days({ { "main", "import a : \"b\"\nStart --> a.Go" }, { "b", "Go --> nothing" } });
	CHECK(text.starts_with("b:1:8: error: unknown rule or operation `nothing`"));
}

TEST_CASE("shapes: an importer's attribute of the same name flows into the import unless it is protected") {
	const std::string lib = "attr h = 5 attr w = 6 Go --> log(h, w)";
	CHECK(run_shapes({ { "main", "import a : \"lib\"\nattr h = 1\nStart --> a.Go" }, { "lib", lib } }) == "a.Go 1,6");
	CHECK(run_shapes({ { "main", "import a : \"lib\" (h)\nattr h = 1 attr w = 2\nStart --> a.Go" }, { "lib", lib } }) == "a.Go 5,2");
	CHECK(run_shapes({ { "main", "import a : \"lib\" ()\nattr h = 1\nStart --> a.Go" }, { "lib", lib } }) == "a.Go 5,6");
	CHECK(run_shapes({ { "main", "import a : \"lib\" (w = k * 2)\nattr k = 4\nStart --> a.Go" }, { "lib", lib } }) == "a.Go 5,8");
}

TEST_CASE("shapes: rules of an import can be replaced") {
	CHECK(run_shapes({ { "main", "import a : \"lib\" (Roof --> log(2))\nStart --> a.Go" }, { "lib", "Go --> Roof extension Roof --> log(1)" } }) ==
			"a.Go a.Roof 2");
	CHECK(run_shapes({ { "main", "import a : \"lib\"\nk = 7\na.Roof --> log(k)\nStart --> a.Go" }, { "lib", "Go --> Roof Roof --> log(1)" } }) ==
			"a.Go a.Roof 7");
}

TEST_CASE("shapes: a call of an import with attributes of its own evaluates all of them anew") {
	const std::string lib = "attr h = 5 attr w = h * 2 f(x) = h + x Go --> log(h, w) Roof Roof --> log(h)";
	CHECK(run_shapes({ { "main", "import a : \"lib\"\nk = 3\nStart --> a(h = k).Go a.Go" }, { "lib", lib } }) ==
			"[ a.Go 3,6 a.Roof 3 ] a.Go 5,10 a.Roof 5");
	CHECK(run_shapes({ { "main", "import a : \"lib\"\nStart --> log(a(h = 1).f(10), a.f(10), a(h = 2).w)" }, { "lib", lib } }) == "[ ] [ ] 11,15,4");
	CHECK(run_shapes({ { "main", "import a : \"lib\"\nStart --> a(nothing = 1).Go b(h = 1).Go a(h = 1).Nothing log(2)" }, { "lib", lib } }) ==
			"unknown-name 2:13; unknown-import 2:29; unknown-name 2:41 | [ a.Go 5,10 a.Roof 5 ] [ ] 2");
}

TEST_CASE("shapes: what flows in from the importer also flows into a call with attributes of its own") {
	CHECK(run_shapes({ { "main", "import a : \"lib\"\nattr w = 7\nStart --> a(h = 1).Go" }, { "lib", "attr h = 5 attr w = 6 Go --> log(h, w)" } }) ==
			"[ a.Go 1,7 ]");
}

TEST_CASE("days: a call of an import with attributes of its own is told as an error") {
	CHECK(run_days({ { "main", "import a : \"lib\"\n@StartRule Start --> a(h = 1).Go" }, { "lib", "attr h = 5 Go --> log(h)" } }).find("[not-in-this-language]") !=
			std::string::npos);
}

TEST_CASE("shapes: `start` is the name of the rule that is marked so") {
	CHECK(run_shapes({ { "main", "import a : \"lib\"\nStart --> a.start" }, { "lib", "start Temple --> log(1) Other --> log(2)" } }) == "a.Temple 1");
	CHECK(run_shapes({ { "main", "Start --> start B\nstart --> log(1)\nB --> log(2)" } }) == "start 1 B 2"); // a rule of an old file
}

namespace {

std::string run_style(const std::string &style, std::initializer_list<std::pair<std::string, std::string>> files) {
	MemorySourceProvider provider;
	for (const auto &[path, text] : files) {
		provider.add(path, text);
	}
	Diagnostics diagnostics;
	const auto program = load_program(files.begin()->first, shape_dialect(), provider, diagnostics, style);
	if (program == nullptr) {
		return places_of(diagnostics);
	}
	LogHost host;
	Vm vm(*program, host);
	vm.call(program->find_rule("Start"));
	return (diagnostics.is_empty() ? "" : places_of(diagnostics) + " | ") + host.text();
}

const std::string styled = "attr c = 1 attr d = 2\nStart --> log(c, d) Wall\nWall --> log(3)\n"
						   "style Night\nattr c = 10\nextra = 4\nWall --> log(30, extra)\n"
						   "style Rain extends Night\nattr d = 20\n";

} // namespace

TEST_CASE("shapes: a style redefines rules and attributes on top of what it extends") {
	CHECK(run_style("", { { "main", styled } }) == "1,2 Wall 3");
	CHECK(run_style("Default", { { "main", styled } }) == "1,2 Wall 3");
	CHECK(run_style("Night", { { "main", styled } }) == "10,2 Wall 30,4");
	CHECK(run_style("Rain", { { "main", styled } }) == "10,20 Wall 30,4");
	CHECK(run_style("Snow", { { "main", styled } }) == "unknown-style 0:0");
}

TEST_CASE("shapes: a style redefines the rule that hosts start with, and leaves its mark there") {
	const std::string both = "@StartRule\nStart --> log(1)\nstyle Night\nStart --> log(2)\nstyle Late extends Night\nattr x = 1";
	CHECK(run_style("", { { "main", both } }) == "1");
	CHECK(run_style("Night", { { "main", both } }) == "2");
	CHECK(run_style("Late", { { "main", both } }) == "2");
	MemorySourceProvider provider;
	provider.add("main", both);
	Diagnostics diagnostics;
	const auto program = load_program("main", shape_dialect(), provider, diagnostics, "Night");
	REQUIRE(program != nullptr);
	CHECK(program->start_rule == program->find_rule("Start"));
	CHECK(program->rules[size_t(program->start_rule)].is_start);
	CHECK(std::ranges::count_if(program->rules, [](const RuleInfo &rule) { return rule.is_start; }) == 1);
}

TEST_CASE("shapes: in old files one import stands before several files, with styles and annotations between them") {
	const std::string one = "Go --> log(1)", two = "Go --> log(2)\nstyle Night\nGo --> log(3)";
	CHECK(run_shapes({ { "main", "import\n@Hidden\na : \"one\"\n@Hidden\nb : \"two\" c(Night) : \"two\"\nStart --> a.Go b.Go c.Go" }, { "one", one },
				  { "two", two } }) == "a.Go 1 b.Go 2 c.Go 3");
	CHECK(run_shapes({ { "main", "b : \"two\"\nStart --> b.Go" }, { "two", two } }).starts_with("main:1:3: error: expected `-->` or `=` after `b`")); // the word is needed once
}

TEST_CASE("shapes: attributes of the importing file flow into imports, its constants do not") {
	const std::string lib = "attr a = 1 attr b = 1 const c = 1 Go --> log(a, b, c)";
	CHECK(run_shapes({ { "main", "import i : \"lib\"\nattr a = 5 const b = 6 attr c = 7\nStart --> i.Go" }, { "lib", lib } }) == "i.Go 5,1,1");
}

TEST_CASE("shapes: styles in a circle and unknown bases end at Default") {
	CHECK(run_style("A", { { "main", "Start --> log(v)\nattr v = 1\nstyle A extends B\nstyle B extends A\nattr v = 2" } }) ==
			"unknown-style 4:1 | 2");
	CHECK(run_style("A", { { "main", "Start --> log(v)\nattr v = 1\nstyle A extends Nothing\nattr v = 3" } }) == "unknown-style 3:1 | 3");
}

TEST_CASE("shapes: an import names the style that it is taken in; overrides reach the Default style only") {
	const std::string lib = "attr h = 1 Go --> log(h)\nstyle Tall\nattr h = 9";
	CHECK(run_shapes({ { "main", "import a (Tall) : \"lib\"\nimport b : \"lib\"\nStart --> a.Go b.Go" }, { "lib", lib } }) == "a.Go 9 b.Go 1");
	CHECK(run_shapes({ { "main", "import a (Tall) : \"lib\" (h = 4)\nimport b : \"lib\" (h = 4)\nStart --> a.Go b.Go" }, { "lib", lib } }) ==
			"a.Go 9 b.Go 4");
	CHECK(run_shapes({ { "main", "import a (Tall) : \"lib\"\nattr h = 7\nStart --> a.Go" }, { "lib", lib } }) == "a.Go 9");
	CHECK(run_shapes({ { "main", "import a (Small) : \"lib\"\nStart --> a.Go" }, { "lib", lib } }) == "unknown-style 1:1 | a.Go 1");
}

TEST_CASE("shapes: a program knows the styles of its file") {
	MemorySourceProvider provider;
	provider.add("main", styled);
	Diagnostics diagnostics;
	const auto program = load_program("main", shape_dialect(), provider, diagnostics);
	REQUIRE(program != nullptr);
	CHECK(program->styles == std::vector<std::string>{ "Night", "Rain" });
}
