#include <doctest/doctest.h>

#include "tests/core/lang/test_dialects.h"

using namespace pcg;
using namespace pcg::test;

TEST_CASE("an unknown name is an error with the closest known name, once per place") {
	Diagnostics diagnostics;
	CHECK(program_of("@StartRule\nHousehold --> VisitPark\nGoToPark --> log(ag)", day_dialect(), diagnostics) == nullptr);
	REQUIRE(diagnostics.list().size() == 2);
	CHECK(to_text(diagnostics.list()[0]) == "test.rules:2:15: error: unknown rule or operation `VisitPark` [unknown-name]\n"
											"    Household --> VisitPark\n"
											"                  ^\n"
											"    did you mean `GoToPark`?");
	CHECK(diagnostics.list()[1].hint == "did you mean `age`?");
}

TEST_CASE("arguments are checked by number and by kind before anything runs") {
	CHECK(check_day("A --> wait") == "wrong-argument-count 1:7");
	CHECK(check_day("A --> wait(1, 2)") == "wrong-argument-count 1:7");
	CHECK(check_day("A --> wait(\"soon\")") == "type-mismatch 1:12");
	CHECK(check_day("A --> later(5)") == "not-a-rule 1:13");
	CHECK(check_day("A --> later(B)\nB(x) --> log(x)") == "wrong-argument-count 1:13");
	CHECK(check_day("A --> log(sqrt(1, 2))") == "wrong-argument-count 1:11");
	CHECK(check_day("A --> B(1)\nB --> log(1)") == "wrong-argument-count 1:7");
	CHECK(check_day("A --> members") == "missing-block 1:7");
	CHECK(check_day("A --> log(1) { true: A }") == "unexpected-block 1:14");
	CHECK(check_day("A --> members { log(1) }") == "missing-head 1:17");
	CHECK(check_day("A --> log('0.5)") == ""); // log takes anything
	CHECK(check_day("A --> wait(~1)") == "size-not-allowed 1:12");
}

TEST_CASE("what is no command and what is no value are told apart") {
	CHECK(check_day("A --> count()") == "not-a-command 1:7");
	CHECK(check_day("A --> log(wait(1))") == "not-a-value 1:11");
	CHECK(check_day("A --> log(B)\nB --> log(1)") == "not-a-value 1:11");
	CHECK(check_day("x = 3\nA --> x") == "not-a-command 2:7");
}

TEST_CASE("set needs a plain name and a value") {
	CHECK(check_day("A --> set(a)") == "wrong-argument-count 1:7");
	CHECK(check_day("A --> set(3, 4)") == "not-a-name 1:11");
	CHECK(check_day("A --> set(a.b, 4)") == "not-a-name 1:11");
}

TEST_CASE("names are defined once") {
	CHECK(check_day("x = 1\nx = 2\nA --> log(x)") == "duplicate-name 2:1");
	CHECK(check_day("A --> log(1)\nA(x) --> log(x)") == "");
	CHECK(check_day("A(x) --> log(1)\nA(y) --> log(y)") == "duplicate-name 2:1");
	CHECK(check_day("A(x, x) --> log(x)") == "duplicate-name 1:6");
}

TEST_CASE("rules that nothing calls and operations in the wrong phase are warned about") {
	CHECK(check_day("@StartRule\nA --> log(1)\nB --> log(2)") == "unused-rule 3:1");
	CHECK(check_day("@StartRule\nA --> later(B)\nB --> C wait(1)\nC --> log(2)") == "wrong-phase 4:7");
	CHECK(check_day("@StartRule\nA --> wait(1)") == "wrong-phase 2:7");
	CHECK(check_day("A --> log(1)") == ""); // no start: a library
}

TEST_CASE("shapes: what is unknown is a leaf or left out, with a warning") {
	CHECK(check_shape("Lot --> A B. C(1)\nC --> log(1)") == "unknown-name 1:9; wrong-argument-count 1:14");
	CHECK(check_shape("Lot --> frobnicate { a: A. }") == "unknown-name 1:9");
	CHECK(check_shape("Lot --> log(nothing) log(f(1))") == "unknown-name 1:13; unknown-name 1:26");
	CHECK(check_shape("Lot --> case true: A.") == "missing-else 1:9");
	CHECK(check_shape("Lot --> split(w) { 1: A. }") == "unknown-word 1:15");
	CHECK(check_shape("attr h = 1\nLot --> set(h, 2) set(material.color.r, 1) set(scope.sx, 1) set(k, 1)") == "unknown-name 2:48; unknown-name 2:65");
	CHECK(check_shape("const h = 1\nLot --> set(h, 2)") == "unknown-name 2:13");
}

TEST_CASE("overloads are chosen by number of arguments, then by their words") {
	CHECK(run_shape("Start --> extrude(3) extrude(world.up, 3)") == "3 a word,3");
}

TEST_CASE("constants are folded") {
	Diagnostics diagnostics;
	const auto program = program_of("A --> log(2 * (3 + 4), -5m, max(1, 2, 3), !true, 10 / 4)", day_dialect(), diagnostics);
	REQUIRE(program);
	// The end for outermost rules, five constants, the call, the end.
	CHECK(program->code.size() == 8);
}

TEST_CASE("defaults of attributes are kept as they were written") {
	Diagnostics diagnostics;
	const auto program = program_of("attr a =\n\t9 // metres\nattr b = a == 12\nc = max(1, // at least\n2)\nconst d = -1", shape_dialect(), diagnostics);
	REQUIRE(program);
	REQUIRE(program->attributes.size() == 3); // c is a function here
	CHECK(program->attributes[0].default_text == "9");
	CHECK(program->attributes[1].default_text == "a == 12");
	CHECK(program->attributes[2].default_text == "-1");
}

TEST_CASE("annotations reach the program as they were written") {
	Diagnostics diagnostics;
	const auto program = program_of("@Range(min=0, max=10)\n@Description(\"How \\\"high\\\"\")\nattr h = 3\n@StartRule @Object(\"bench\")\nA -> log(h)",
			shape_dialect(), diagnostics);
	REQUIRE(program);
	REQUIRE(program->attributes.size() == 1);
	const auto &annotations = program->attributes[0].annotations;
	REQUIRE(annotations.size() == 2);
	CHECK(annotations[0].name == "Range");
	CHECK(annotations[0].arguments == std::vector<std::string>{ "min=0", "max=10" });
	CHECK(annotations[1].arguments == std::vector<std::string>{ "How \"high\"" });
	CHECK(program->rules[0].is_start);
	CHECK(program->rules[0].has_paper_arrow);
	CHECK(program->rules[0].annotations[1].arguments[0] == "bench");
	CHECK(program->start_rule == RuleId(0));
}

TEST_CASE("a host that needs a start gets one, or is told why not") {
	const auto message = [](const std::string &text) {
		Diagnostics diagnostics;
		const auto program = program_of(text, day_dialect(), diagnostics);
		if (program) {
			require_start_rule(*program, diagnostics);
		}
		return places_of(diagnostics);
	};
	CHECK(message("@StartRule\nA --> log(1)") == "");
	CHECK(message("x = 1") == "no-start-rule 0:0");
	CHECK(message("x = 1\nA --> log(1)") == "no-start-rule 2:1");
	CHECK(message("@StartRule\nA --> log(1)\n@StartRule\nB --> log(1)") == "several-start-rules 4:1");
	CHECK(message("@StartRule\nA(x) --> log(x)") == "start-rule-parameters 2:1");
	// Hosts of the other languages say where they begin.
	CHECK(check_shape("@StartRule\nA --> log(1)\n@StartRule\nB(x) --> log(x)") == "");
}

TEST_CASE("a hundred thousand mistakes are counted, and the words are found for those that are told") {
	const auto rules = [](const std::string &called) {
		std::string text = "@StartRule\nA --> R0\n";
		for (int i = 0; i < 100'000; ++i) {
			text += "R" + std::to_string(i) + " --> " + called + std::to_string(i) + "\n";
		}
		return text;
	};
	Diagnostics diagnostics;
	CHECK(program_of(rules("Q"), day_dialect(), diagnostics) == nullptr);
	CHECK(diagnostics.error_count() == 100'000);
	CHECK(diagnostics.list().size() == 200);
	CHECK(diagnostics.list()[0].hint == "did you mean `R0`?");
	Diagnostics warnings;
	CHECK(program_of(rules("Q"), shape_dialect(), warnings) != nullptr);
	CHECK(warnings.warning_count() == 100'000);
	CHECK(warnings.list()[199].hint.starts_with("did you mean `R199`?"));
	Diagnostics counts;
	CHECK(program_of(rules("log(1) R0(0) A"), day_dialect(), counts) == nullptr);
	CHECK(counts.error_count() == 200'000);
}
