#include <doctest/doctest.h>

#include "tests/core/lang/test_dialects.h"

using namespace pcg;
using namespace pcg::test;

TEST_CASE("expressions follow the precedence of C") {
	CHECK(run_day("Start --> log(1 + 2 * 3, (1 + 2) * 3, 10 - 4 - 3, 7 % 3, -5 % 3, 2 < 3 && !false, 8 / 4 / 2)") == "7,9,3,1,-2,true,1");
	CHECK(run_day("Start --> log(\"h\" + 1, true + \"\", 0.1 + 0.2, 1 == 1, \"a\" < \"b\", \"a\" != \"a\")") ==
			"h1,true,0.3,true,true,false");
}

TEST_CASE("times carry units and count in seconds") { CHECK(run_day("Start --> log(8h, 5m, 30s, 8h30m, 1.5h, 90)") == "28800,300,30,30600,5400,90"); }

TEST_CASE("a case takes the first condition that holds, as a command and as a value") {
	CHECK(run_day("x = case age0 > 3: \"a\" case age0 > 1: \"b\" else: \"c\" age0 = 2\n"
				  "Start --> case x == \"a\": log(1) case x == \"b\": log(2) log(3) else: log(4)") == "2 3");
	CHECK(run_day("Start --> log(0) case false: log(1)") == "0");
}

TEST_CASE("locals are seen by the rules called after them and forgotten on return") {
	CHECK(run_day("Start --> set(a, 1) Inner log(a)\nInner --> log(a) set(a, 2) Leaf\nLeaf --> log(a)") == "1 2 1");
	CHECK(run_day("Start --> Inner(5)\nInner(a) --> Leaf log(f(2))\nLeaf --> log(a + 1)\nf(b) = a * b") == "6 10");
	CHECK(run_day("Start --> set(a, 1) [ set(a, 2) log(a) ] log(a)") == "[ 2 ] 1");
}

TEST_CASE("a name that was not set may be a variable, else it is an error with its name") {
	CHECK(run_day("Start --> log(time) Set log(time)\nSet --> set(time, 1) log(time)") == "77 1 77");
	CHECK(run_day("Start --> Later set(a, 1)\nLater --> log(a)") == "failed unset-local 2:15");
}

TEST_CASE("attributes are evaluated once, on demand, and see no locals") {
	CHECK(run_day("b = a + 1 a = 2\nStart --> set(a, 10) log(b, a)") == "3,10");
	CHECK(run_day("r = rand(0, 1)\nStart --> case r == r: log(\"same\") else: log(\"other\")") == "same");
	CHECK(run_day("a = b b = a\nStart --> log(a)") == "failed attribute-cycle 1:11");
}

TEST_CASE("a block runs its bodies with the locals of the rule") {
	CHECK(run_day("Start --> set(limit, 18) members { age < limit: log(\"child\", age) | age < 65: log(\"adult\", age) } log(count(), count(age > 18))") ==
			"adult,40 adult,38 child,9 4,3");
}

TEST_CASE("a random choice draws once and takes the shares in order") {
	int counts[3] = {};
	for (uint64_t seed = 0; seed < 3000; ++seed) {
		const std::string chosen = run_day("Start --> 70%: log(0) 20%: log(1) else: log(2)", seed);
		++counts[chosen[0] - '0'];
	}
	// Three standard deviations of a binomial: 75, 66, 49.
	CHECK(counts[0] == doctest::Approx(2100).epsilon(75.0 / 2100));
	CHECK(counts[1] == doctest::Approx(600).epsilon(66.0 / 600));
	CHECK(counts[2] == doctest::Approx(300).epsilon(49.0 / 300));
}

TEST_CASE("a paused rule goes on behind the operation that paused it") {
	Diagnostics diagnostics;
	const auto program = program_of("Start --> set(a, 1) [ set(a, 2) Inner case a == 2: wait(1) log(a) ] log(a)\nInner --> wait(1) log(\"in\", a)",
			day_dialect(), diagnostics);
	REQUIRE(program);
	LogHost host;
	Vm vm(*program, host);
	CHECK(vm.call(program->find_rule("Start")) == RunState::Paused);
	CHECK(vm.resume() == RunState::Paused);
	CHECK(vm.resume() == RunState::Finished);
	CHECK(host.text() == "[ wait in,2 wait 2 ] 1");
}

TEST_CASE("shapes: rule calls go to the host, parameters are lexical") {
	CHECK(run_shape("h = 3\nStart --> log(h) A(2) B.\nA(n) --> split(x) { ~n: log(n) | '0.5: C | { 1: D. }* }*\nC --> log(1)") ==
			"3 A { ~2: 2 '0.5: C 1 { 1: leaf:D. }* }* leaf:B.");
	CHECK(run_shape("Start --> comp(f) { front: log(1) | side = log(2) | all =: log(3) | 2: log(4) }") ==
			"{ front: 1 side= 2 all=: 3 2: 4 }");
}

TEST_CASE("a run-time error names its place and ends the run, groups are popped") {
	CHECK(run_day("Start --> log(1) [ log(age) ] log(2)") == "1 [ ] failed needs-focus 1:24");
	CHECK(run_day("Start --> Deep(3)\nDeep(n) --> log(1 / (n - 3))") == "failed division-by-zero 2:19");
	CHECK(run_day("Start --> log(1 + true)") == "failed type-mismatch 1:17");
	CHECK(run_day("Start --> case 1: log(1)") == "failed type-mismatch 1:16");
	CHECK(run_day("x = \"text\"\nStart --> wait(x)") == "failed type-mismatch 2:11");
	CHECK(run_day("Start --> log(true && 3)") == "failed type-mismatch 1:23");
	CHECK(run_shape("Start --> log(1 / 0, -1 / 0)") == "inf,-inf");
}

TEST_CASE("&& and || look at the right side only if they must") {
	CHECK(run_day("Start --> log(false && age > 1, true || age > 1)") == "false,true");
}

TEST_CASE("rules without an end are stopped") {
	CHECK(run_day("Start --> Start") == "failed recursion-limit 1:11");
	CHECK(run_day("f(x) = f(x + 1) Start --> log(f(0))") == "failed recursion-limit 1:8");
	CHECK(run_day("Start --> members { true: Start }") == "failed recursion-limit 1:11");
	CHECK(run_shape("Start --> split(x) { 1: Start }").ends_with("failed recursion-limit 1:25"));
}

TEST_CASE("what grows without going deep is stopped by the number of calls") {
	Diagnostics diagnostics;
	std::string text = "A0 --> log(1)\n";
	for (int i = 1; i < 60; ++i) {
		const std::string below = "A" + std::to_string(i - 1);
		text += "A" + std::to_string(i) + " --> " + below + " " + below + "\n";
	}
	const auto program = program_of(text, day_dialect(), diagnostics);
	REQUIRE(program);
	LogHost host;
	VmLimits limits;
	limits.max_steps = 100'000;
	Vm vm(*program, host, limits);
	CHECK(vm.call(program->find_rule("A59")) == RunState::Failed);
	CHECK(places_of(host.diagnostics).starts_with("step-limit"));
	CHECK(vm.call(program->find_rule("A3")) == RunState::Failed); // the run as a whole is over
	vm.begin(1);
	CHECK(vm.call(program->find_rule("A3")) == RunState::Finished);
}

TEST_CASE("an operation that takes time cannot stand in a block of another operation") {
	CHECK(run_day("Start --> members { true: wait(1) }") == "wait failed pause-in-block 1:27");
}

TEST_CASE("the host overrides attributes but not constants, and only by values of their type") {
	Diagnostics diagnostics;
	const auto program = program_of("a = 1 attr t = \"x\" const c = 3\nStart --> log(a, t, c)", day_dialect(), diagnostics);
	REQUIRE(program);
	LogHost host;
	Vm vm(*program, host);
	const Text text = { "new" };
	CHECK(vm.override_attribute("a", Value::of(7.0)));
	CHECK(vm.override_attribute("t", Value::of(&text)));
	CHECK(!vm.override_attribute("c", Value::of(7.0)));
	CHECK(!vm.override_attribute("nothing", Value::of(7.0)));
	CHECK(!vm.override_attribute("a", Value::of(&text)));
	vm.begin(1);
	vm.call(program->find_rule("Start"));
	vm.clear_overrides();
	vm.begin(1);
	vm.call(program->find_rule("Start"));
	CHECK(host.text() == "7,new,3 1,x,3");
}

TEST_CASE("random attributes depend on the seed and their name, not on order or on what else is drawn") {
	const std::string late = run_day("a = rand(0, 1) b = rand(0, 1)\nStart --> set(x, rand(0, 1)) log(b) log(a)", 5);
	const std::string early = run_day("z = rand(0, 1) a = rand(0, 1) b = rand(0, 1)\nStart --> set(y, a) log(b) log(y)", 5);
	CHECK(late == early);
	CHECK(late != run_day("a = rand(0, 1) b = rand(0, 1)\nStart --> set(x, rand(0, 1)) log(b) log(a)", 6));
}

TEST_CASE("shapes: set hands the operation the attribute or the variable") {
	CHECK(run_shape("attr h = 3\nStart --> log(h) set(h, h + 1) log(h) set(material.color.r, 1)") == "3 4 set variable material.color.r");
}

TEST_CASE("shapes: a host keeps attribute values of its own") {
	Diagnostics diagnostics;
	const auto program = program_of("attr h = 3 attr w = h + 1\nStart --> log(h, w)", shape_dialect(), diagnostics);
	REQUIRE(program);
	LogHost host;
	Vm vm(*program, host);
	vm.begin(1);
	vm.evaluate_attributes();
	std::vector<Value> copy(vm.attribute_values(), vm.attribute_values() + 2);
	copy[0] = Value::of(10.0);
	vm.use_attributes(copy.data());
	vm.call(program->find_rule("Start"));
	vm.use_attributes(nullptr);
	vm.call(program->find_rule("Start"));
	CHECK(host.text() == "10,4 3,4");
}

TEST_CASE("the host starts rules with arguments, and is told when they do not fit") {
	Diagnostics diagnostics;
	const auto program = program_of("Go(a, b) --> log(a + b)", day_dialect(), diagnostics);
	REQUIRE(program);
	LogHost host;
	Vm vm(*program, host);
	const Value args[] = { Value::of(1.0), Value::of(2.0) };
	CHECK(vm.call(program->find_rule("Go", 2), args) == RunState::Finished);
	CHECK(vm.call(program->find_rule("Go", 2)) == RunState::Failed);
	CHECK(vm.call(RuleId::Invalid) == RunState::Failed);
	CHECK(host.text() == "3");
}
