#include <doctest/doctest.h>

#include "tests/core/lang/test_dialects.h"

using namespace pcg;
using namespace pcg::test;

namespace {

const char *const rules = "x = rand(0, 1)\n"
						  "Start --> set(a, \"one\" + 1) set(n, 3) [ set(a, \"two\") Inner(x) log(a, n) ] log(a) log(rand(0, 1))\n"
						  "Inner(y) --> set(n, 4) case y >= 0: wait(1) log(a, n, y == x) else: log(\"never\")";

// Runs another interpreter in the middle of its own run, where a group begins.
class NestingHost : public LogHost {
public:
	Vm *inner = nullptr;
	RuleId rule = RuleId::Invalid;

	void push_group(Vm &vm) override {
		LogHost::push_group(vm);
		if (inner != nullptr) {
			CHECK(inner->call(rule) == RunState::Paused);
		}
	}
};

} // namespace

TEST_CASE("a run that was saved and restored into another interpreter ends like one that was not") {
	Diagnostics diagnostics;
	const auto program = program_of(rules, day_dialect(), diagnostics);
	REQUIRE(program);
	LogHost host;
	Vm vm(*program, host);
	vm.begin(42);
	REQUIRE(vm.call(program->find_rule("Start")) == RunState::Paused);
	const VmState state = vm.save();
	REQUIRE(vm.resume() == RunState::Finished);

	LogHost other_host;
	Vm other(*program, other_host);
	REQUIRE(other.restore(state));
	CHECK(other.is_paused());
	CHECK(other.resume() == RunState::Finished);
	CHECK(host.text().starts_with("[ wait two,4,true two,3 ] one1"));
	CHECK("[ wait " + other_host.text() == host.text());
}

TEST_CASE("one interpreter serves many waiting runs") {
	Diagnostics diagnostics;
	const auto program = program_of("Start --> set(n, rand(0, 100)) wait(1) log(n) wait(1) log(n)", day_dialect(), diagnostics);
	REQUIRE(program);
	LogHost host;
	Vm vm(*program, host);
	std::vector<VmState> waiting;
	for (uint64_t seed = 0; seed < 3; ++seed) {
		vm.begin(seed);
		REQUIRE(vm.call(program->find_rule("Start")) == RunState::Paused);
		waiting.push_back(vm.save());
	}
	host.log.clear();
	for (int round = 0; round < 2; ++round) {
		for (VmState &state : waiting) {
			REQUIRE(vm.restore(state));
			vm.resume();
			if (vm.is_paused()) {
				state = vm.save();
			}
		}
	}
	REQUIRE(host.log.size() == 9); // in the first round each waits once more
	CHECK(host.log[0] == host.log[6]);
	CHECK(host.log[2] == host.log[7]);
	CHECK(host.log[4] == host.log[8]);
	CHECK(host.log[0] != host.log[2]);
}

TEST_CASE("a host that pauses a loop of rules again and again keeps no frame of those that are over") {
	Diagnostics diagnostics;
	const auto program = program_of("Start --> set(a, 1) Loop(1) log(a)\nLoop(n) --> set(a, n) wait(1) case n < 3000: Next else: log(n, a)\n"
									"Next --> set(b, n) Loop(b + 1)", day_dialect(), diagnostics);
	REQUIRE(program);
	LogHost host;
	Vm vm(*program, host);
	RunState state = vm.call(program->find_rule("Start"));
	size_t most_frames = 0, most_trail = 0;
	while (state == RunState::Paused) {
		vm.drop_finished_callers();
		most_frames = std::max(most_frames, vm.save().frames.size());
		most_trail = std::max(most_trail, vm.save().trail.size());
		REQUIRE(vm.restore(vm.save()));
		state = vm.resume();
	}
	CHECK(state == RunState::Finished);
	CHECK(most_frames == 3); // the host's, Start's, which has a log to write, and Loop's
	CHECK(most_trail <= 5);
	CHECK(host.text().ends_with("wait 3000,3000 1"));
}

TEST_CASE("who waits needs no stack, and who runs inside of another run has one of its own") {
	Diagnostics diagnostics;
	const auto program = program_of(rules, day_dialect(), diagnostics);
	REQUIRE(program);
	const RuleId start = program->find_rule("Start");
	LogHost alone_host;
	Vm alone(*program, alone_host);
	alone.begin(42);
	REQUIRE(alone.call(start) == RunState::Paused);
	const VmState state = alone.save();
	REQUIRE(alone.resume() == RunState::Finished);

	VmStacks stacks;
	LogHost hosts[3];
	NestingHost nesting_host;
	Vm first(*program, hosts[0], {}, &stacks), second(*program, hosts[1], {}, &stacks), third(*program, hosts[2], {}, &stacks);
	Vm nesting(*program, nesting_host, {}, &stacks);
	for (Vm *vm : { &first, &second, &nesting }) {
		vm->begin(42);
	}
	REQUIRE(first.call(start) == RunState::Paused);
	REQUIRE(third.restore(first.save()));
	CHECK_FALSE(third.restore({}));
	REQUIRE(third.restore(state));
	CHECK(stacks.idle.size() == 1);
	nesting_host.inner = &second;
	nesting_host.rule = start;
	REQUIRE(nesting.call(start) == RunState::Paused);
	nesting_host.inner = nullptr;
	CHECK(stacks.idle.size() == 2);
	for (Vm *vm : { &first, &second, &third, &nesting }) {
		CHECK(vm->resume() == RunState::Finished);
	}
	CHECK(hosts[0].text() == alone_host.text());
	CHECK(hosts[1].text() == alone_host.text());
	CHECK(nesting_host.text() == alone_host.text());
	CHECK("[ wait " + hosts[2].text() == "[ wait ] " + alone_host.text().substr(7)); // its first run ended with the second restoring
}

TEST_CASE("a run that is given up leaves its stack to others") {
	Diagnostics diagnostics;
	const auto program = program_of(rules, day_dialect(), diagnostics);
	REQUIRE(program);
	VmStacks stacks;
	LogHost host;
	Vm vm(*program, host, {}, &stacks);
	vm.begin(42);
	for (int time = 0; time < 2; ++time) {
		REQUIRE(vm.call(program->find_rule("Start")) == RunState::Paused);
		vm.abandon();
		CHECK(stacks.idle.size() == 1);
	}
}

TEST_CASE("a damaged or foreign state is refused") {
	Diagnostics diagnostics;
	const auto program = program_of(rules, day_dialect(), diagnostics);
	const auto foreign = program_of("Start --> wait(1) log(1)", day_dialect(), diagnostics);
	REQUIRE(program);
	REQUIRE(foreign);
	LogHost host;
	Vm vm(*program, host);
	REQUIRE(vm.call(program->find_rule("Start")) == RunState::Paused);
	const VmState good = vm.save();
	const auto is_refused = [&](auto &&damage) {
		VmState state = good;
		damage(state);
		LogHost other_host;
		Vm other(*program, other_host);
		return !other.restore(state) && other.resume() == RunState::Finished;
	};
	CHECK(is_refused([](VmState &s) { s.address = 0; }));
	CHECK(is_refused([](VmState &s) { s.address += 1; }));
	CHECK(is_refused([](VmState &s) { s.address = 0xFFFFFFFF; }));
	CHECK(is_refused([](VmState &s) { s.frames.clear(); }));
	CHECK(is_refused([](VmState &s) { s.frames.back().return_address = 1; }));
	CHECK(is_refused([](VmState &s) { s.frames.back().callable = 99; }));
	CHECK(is_refused([](VmState &s) { s.frames.back().trail_mark = 99; }));
	CHECK(is_refused([](VmState &s) { s.frames[1].kind = VmFrame::Kind::Group; }));
	CHECK(is_refused([](VmState &s) { s.slots.clear(); }));
	CHECK(is_refused([](VmState &s) { s.trail[0].slot = 77; }));
	CHECK(is_refused([](VmState &s) { s.slots[1].index = 12345; /* the text in `a` */ }));
	CHECK(is_refused([](VmState &s) { s.texts.clear(); }));
	CHECK(is_refused([](VmState &s) { s.stack.push_back(Value::of(1.0)); }));
	CHECK(is_refused([](VmState &s) { s.base = 1; }));
	LogHost other_host;
	Vm other(*foreign, other_host);
	CHECK(!other.restore(good));
}

TEST_CASE("a run that is given up leaves nothing behind") {
	Diagnostics diagnostics;
	const auto program = program_of(rules, day_dialect(), diagnostics);
	REQUIRE(program);
	LogHost host;
	Vm vm(*program, host);
	REQUIRE(vm.call(program->find_rule("Start")) == RunState::Paused);
	vm.abandon();
	CHECK(host.text() == "[ wait ]");
	CHECK(!vm.is_paused());
	CHECK(vm.call(program->find_rule("Start")) == RunState::Paused);
}
