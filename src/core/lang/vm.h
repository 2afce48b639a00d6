#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/base/random.h"
#include "core/lang/program.h"

// Runs a program as a stack of frames that can be left and re-entered at any operation: a delayed rule that waits is this object, put aside
// (paper, "Delayed execution of rules": pairs of a rule and the next item).
namespace pcg {

struct VmLimits {
	uint32_t max_depth = 1000; // nested rule and function calls
	uint64_t max_instructions = 50'000'000; // for one run; an endless loop of rules ends here at the latest
};

// The world behind the built-ins. Handlers reach theirs with static_cast<TheirHost &>(vm.host()).
class VmHost {
public:
	virtual ~VmHost() = default;
	// With Dialect::RuleCalls::ByHost only.
	virtual Flow call_rule(Vm &, RuleId, std::span<const Value>) { return Flow::Next; }
	// `[` and `]`, beside the interpreter's own saving of locals.
	virtual void push_group(Vm &) {}
	virtual void pop_group(Vm &) {}
	// Every run-time error of this run, once: file, line, column and message are set. `what` of a household or lot is the host's to add.
	virtual void report(Diagnostic diagnostic) = 0;
};

enum class RunState : uint8_t { Finished, Paused, Failed };

class Vm {
public:
	Vm(const Program &program, VmHost &host, VmLimits limits = {});

	// A new run: forgets frames, locals, arena and attribute values. Attributes draw from streams of (seed, name), so their values depend
	// neither on order of use nor on what else the run draws.
	void begin(uint64_t seed);
	RunState call(RuleId rule, std::span<const Value> args = {});
	// After a Pause. The paused operation counts as done.
	RunState resume();
	bool is_paused() const;

	// For handlers: evaluates a predicate, a size, or runs the body of a block entry, with the locals of the caller.
	Value evaluate(Chunk chunk);
	Flow run_body(Chunk chunk);
	// Entries of a block of the running operation.
	std::span<const BlockEntry> entries(const Block &block) const;

	// For handlers: reports at the place of the running instruction and ends the run. Functions return the Value, operations Flow::Stop.
	Value fail(std::string_view id, std::string message, std::string hint = {});
	// The same as a warning, once per place in the source; the run goes on.
	void warn(std::string_view id, std::string message, std::string hint = {});
	bool has_failed() const { return _failed; }
	SourcePlace place() const;

	// Values of attributes; the host's overrides hold for all runs until cleared. False: there is no such attribute or it is `const`.
	bool override_attribute(std::string_view name, Value value);
	Value attribute(int index);

	// The stream that rand() draws from; the host may swap it (CGA: one per shape). Starts as Random(seed, 0).
	Random &random() { return *_random; }
	void use_random(Random &random) { _random = &random; }
	// Text that lives until the next begin().
	const Text *make_text(std::string_view text);

	VmHost &host() { return *_host; }
	const Program &program() const { return *_program; }

private:
	const Program *_program;
	VmHost *_host;
	VmLimits _limits;
	Random _own_random;
	Random *_random = &_own_random;
	bool _failed = false;
};

} // namespace pcg
