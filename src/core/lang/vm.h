#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/base/random.h"
#include "core/lang/program.h"

// Runs a program as a stack of frames that can be left and re-entered at any operation: a delayed rule that waits is this object, put aside
// (paper, "Delayed execution of rules": pairs of a rule and the next item). One Vm serves many runs; what is saved is a VmState,
// which is small.
namespace pcg {

struct VmLimits {
	uint32_t max_depth = 1000; // nested rule and function calls
	uint32_t max_native_depth = 250; // of them inside of handlers (bodies of blocks, predicates), which use the machine's stack
	uint64_t max_steps = 50'000'000; // calls of rules, functions and operations in one run; an endless rule ends here at the latest
	uint64_t max_silent_steps = 20'000'000; // of them without an operation or a rule call: functions that call each other
	uint32_t max_stack = 32'768; // values
};

// The world behind the built-ins. Handlers reach theirs with static_cast<TheirHost &>(vm.host()).
class VmHost {
public:
	virtual ~VmHost() = default;
	// With Dialect::RuleCalls::ByHost only. The arguments live on the interpreter's stack: copy what outlives the call.
	virtual Flow call_rule(Vm &, RuleId, std::span<const Value>) { return Flow::Next; }
	// `[` and `]`, beside the interpreter's own saving of locals. Every push is followed by its pop, after an error too.
	virtual void push_group(Vm &) {}
	virtual void pop_group(Vm &) {}
	// Asked now and then: true ends the run as an error does, whose message is the host's.
	virtual bool is_interrupted() { return false; }
	// Attributes are about to be changed for one call: a copy of Vm::attribute_values() that the host owns, put in place with
	// Vm::use_attributes() and forgotten at the next pop_group. nullptr: the interpreter keeps the copy until begin().
	virtual Value *copy_attributes(Vm &) { return nullptr; }
	// Every run-time error of this run, once: file, line, column and message are set. `what` of a household or lot is the host's to add.
	virtual void report(Diagnostic diagnostic) = 0;
};

enum class RunState : uint8_t { Finished, Paused, Failed };

// One level of what is running. Group: `[ .. ]`. Import: a call with attributes of its own. Native: the border to a handler that evaluates or runs a chunk.
// HostRule: a rule that a host with RuleCalls::ByHost runs, and the border to it; these never pause.
struct VmFrame {
	enum class Kind : uint8_t { Rule, Function, Group, Native, Import, HostRule } kind = Kind::Rule;
	uint32_t callable = 0; // of Rule and Function: index in Program::callables
	uint32_t return_address = 0;
	uint32_t base = 0; // of the caller
	uint32_t trail_mark = 0;
};

// What a local was before it was set: undone when its rule or group ends.
struct VmTrailEntry {
	uint32_t slot = 0;
	Value old;
};

// A paused run as plain data, for saving and for putting aside. Values of type Text hold in `index` a symbol of the program or, from 2^31 on, 2^31 +
// an index in `texts`; those of type Array an index in `arrays`.
struct VmState {
	struct SavedArray {
		uint32_t rows = 1;
		uint32_t columns = 0;
		ValueType element = ValueType::Number;
		std::vector<Value> values;
	};
	uint64_t fingerprint = 0;
	uint64_t seed = 0;
	uint64_t steps = 0;
	uint64_t random_key = 0;
	uint64_t random_counter = 0;
	uint32_t address = 0;
	uint32_t base = 0;
	std::vector<VmFrame> frames;
	std::vector<VmTrailEntry> trail;
	std::vector<Value> stack;
	std::vector<Value> slots;
	std::vector<Value> attributes;
	std::vector<std::string> texts;
	std::vector<SavedArray> arrays;
};

// Stacks that Vms of one program and one limit share: who runs has one, who waits has none. For one thread.
struct VmStacks {
	std::vector<std::unique_ptr<std::byte[]>> idle;
};

class Vm {
public:
	// `stacks`, if given, outlives the Vm; without, it has a stack of its own, even while it waits.
	Vm(const Program &program, VmHost &host, VmLimits limits = {}, VmStacks *stacks = nullptr);
	Vm(const Vm &) = delete;
	Vm &operator=(const Vm &) = delete;

	// A new run: forgets frames, locals, arena and attribute values. Attributes draw from streams of (seed, name), so their values depend
	// neither on order of use nor on what else the run draws.
	void begin(uint64_t seed);
	// Handlers may call it too (CGA: the rule of a new shape); then it cannot pause.
	RunState call(RuleId rule, std::span<const Value> args = {});
	// After a Pause. The paused operation counts as done.
	RunState resume();
	bool is_paused() const { return _is_paused; }
	// Ends a paused run for good: groups are popped, locals forgotten.
	void abandon();
	// Gives up the frames of rules that have nothing left to do, since their last command called the rule that runs: so a loop of rules can go on for
	// ever. For a host that is about to pause the run, with Locals::Dynamic only.
	void drop_finished_callers();
	// Of a paused run: a copy of it as data, and back into a Vm of the same program and host. False: the state is of another program or damaged.
	VmState save() const;
	bool restore(const VmState &state);

	// For handlers: evaluates a predicate, a size, or runs the body of a block entry, with the locals of the caller. A body that fails or is
	// stopped gives Flow::Stop; it cannot pause.
	Value evaluate(Chunk chunk);
	Flow run_body(Chunk chunk);
	// Most bodies are one call of a rule without arguments, which a host (RuleCalls::ByHost) may make itself instead of running them. Invalid: another body.
	RuleId only_call(Chunk body) const;
	// `call()` in its place: counts as running the body does, and messages name it.
	template <typename Call> Flow make_only_call(Chunk body, Call call) {
		_silent_steps = 0;
		if (_failed || !count_step() || !count_step()) {
			return Flow::Stop;
		}
		const uint32_t address = _address;
		_address = uint32_t(body) + 1;
		const Flow flow = call();
		_address = address;
		return _failed ? Flow::Stop : flow;
	}
	// Entries of a block of the running operation, or of a nested block (BlockEntry::block).
	std::span<const BlockEntry> entries(const Block &block) const {
		return { _program->entries.data() + block.first_entry, block.entry_count };
	}

	// For handlers: reports at the place of the running instruction and ends the run. Functions return the Value, operations Flow::Stop.
	Value fail(std::string_view id, std::string message, std::string hint = {});
	// The same as a warning, once per place in the source; the run goes on.
	void warn(std::string_view id, std::string message, std::string hint = {});
	// Warnings are told again: for hosts whose runs are told apart.
	void forget_warnings() { _warned.clear(); }
	// Whether one was told at this place.
	bool has_warned() const;
	// The same each time: for hosts that know better what was told before.
	void warn_each(std::string_view id, std::string message, std::string hint = {});
	bool has_failed() const { return _failed; }
	SourcePlace place() const;
	// Of the running instruction and different for each call in the source: hosts count uses of a call by it. Program::places[address() - 1] is its
	// place.
	uint32_t address() const { return _address; }
	// The rule that runs, Invalid outside of rules.
	RuleId running_rule() const;

	// Values of attributes; the host's overrides hold for all runs until cleared. False: there is no such attribute, it is
	// `const`, or its value is of another type.
	bool override_attribute(std::string_view name, Value value);
	void clear_overrides();
	// Evaluates it if that has not happened in this run.
	Value attribute(int index);
	// One value per attribute, Void where it was not evaluated yet. A host that keeps copies of its own (CGA: attributes per shape) evaluates them
	// all at the start, copies this array and puts its copy in place; nullptr puts the interpreter's own back, as begin() does.
	void evaluate_attributes();
	Value *attribute_values() { return _attributes; }
	void use_attributes(Value *values) { _attributes = values != nullptr ? values : _own_attributes.data(); }

	// The stream that rand() draws from; the host may swap it (CGA: one per shape). Starts as Random(seed, 0).
	Random &random() { return *_random; }
	void use_random(Random &random) { _random = &random; }
	// Text that lives until the next begin().
	const Text *make_text(std::string_view text);
	// Rows of equal length. `element` says what an empty one holds.
	const ArrayData *make_array(std::span<const Value> values, uint32_t rows = 1, ValueType element = ValueType::Number);
	// In a strict dialect an error as from fail(); else a warning, and the run goes on with `fallback`.
	Value mismatch(std::string_view id, std::string message, const Value &fallback, std::string hint = {});
	// What lies outside of an array: 0, false or "".
	Value default_of(ValueType element);

	VmHost &host() { return *_host; }
	const Program &program() const { return *_program; }

private:
	enum class Stop : uint8_t { Returned, Paused, Stopped };

	// What values refer to and the program does not have.
	struct Made {
		std::deque<Text> texts, override_texts;
		std::deque<std::string> text_storage, override_storage;
		std::deque<ArrayData> arrays;
		std::deque<std::vector<Value>> array_storage, import_attributes;
	};

	static constexpr uint64_t steps_between_questions = 0x4000;

	// Where a handler's evaluation began, to go back to.
	struct Border {
		size_t frame_count;
		uint32_t address;
		uint32_t base;
		Value *top;
	};

	Stop run();
	bool only_ends(uint32_t address) const;
	void drop_repeated_trail();
	bool enter(uint32_t callable, uint32_t count, uint32_t return_address, VmFrame::Kind kind);
	bool enter_native(Border &border);
	void leave_native(const Border &border);
	void pop_frame();
	void unwind_trail(uint32_t mark);
	void set_slot(uint32_t slot, const Value &value);
	void hide_slots();
	// False: the run has failed. The host is asked now and then whether to go on.
	bool count_step() {
		++_steps;
		return (_steps <= _limits.max_steps && _steps % steps_between_questions != 0) || count_step_with_care();
	}
	bool count_step_with_care();
	bool fail_steps();
	bool fail_call();
	bool fail_native();
	Value evaluate_leaf(Chunk chunk);
	void reset_initial_attributes();
	bool may_enter_native() { return !_failed && count_step() && (can_enter_native() || fail_native()); }
	bool can_enter_native() const { return _native_depth < _limits.max_native_depth && _top + _program->max_stack <= _stack_end; }
	Flow call_host_rule(RuleId rule, std::span<const Value> args);
	const Value &load_attribute(uint32_t index);
	Value evaluate_attribute(uint32_t index);
	Value arithmetic(const Instruction &instruction, const Value &a, const Value &b);
	Value divide(OpCode code, double a, double b);
	Value compare(OpCode code, const Value &a, const Value &b);
	Value negate(const Value &value);
	Value fail_types(OpCode code, const Value &a, const Value &b);
	bool is_true(const Value &condition);
	bool is_strict() const;
	// vm_arrays.cpp
	Value elementwise(OpCode code, const Value &a, const Value &b);
	Value one_element(OpCode code, const Value &a, const Value &b);
	Value compare_arrays(OpCode code, const ArrayData &a, const ArrayData &b);
	Value negate_array(OpCode code, const ArrayData &array);
	Value make_row(std::span<const Value> parts);
	Value stack_rows(std::span<const Value> rows);
	Value make_range(std::span<const Value> parts);
	Value index_array(const Value &array, std::span<const Value> indices);
	bool fits_array(uint64_t size);
	// vm_attributes.cpp
	bool begin_import(const ImportScope &scope, std::span<const Value> values);
	Value find_target(std::string_view prefix, const Value &name);
	Value find_word(std::string_view words, const Value &word);
	bool replace_argument(const ParamSpec &param, std::string_view name, size_t position, Value &value);
	bool check_arguments(const std::vector<ParamSpec> &params, std::string_view name, const Args &args, uint32_t mask);
	bool call_function(const Instruction &instruction, uint32_t mask, const Block *block);
	Flow call_operation(const Instruction &instruction, uint32_t mask, const Block *block, const Block *second_block);
	RunState finish(Stop stop, const Border &border);
	Diagnostic diagnostic_here(Severity severity, std::string_view id, std::string message, std::string hint) const;
	Value to_saved(const Value &value, VmState &state) const;
	bool from_saved(Value &value, const VmState &state);
	Made &made() {
		if (!_made) {
			_made = std::make_unique<Made>();
		}
		return *_made;
	}
	void take_stack();
	void put_stack_away();
	bool is_sound(const VmState &state) const;
	bool restore_values(const VmState &state);

	const Program *_program;
	VmHost *_host;
	VmLimits _limits;
	uint64_t _seed = 0;
	Random _own_random;
	Random *_random = &_own_random;
	bool _failed = false;
	bool _is_paused = false;
	uint32_t _native_depth = 0;
	uint32_t _call_depth = 0;
	uint64_t _steps = 0;
	uint64_t _silent_steps = 0;

	VmStacks *_stacks;
	std::vector<Value> _waiting; // what lies on the stack while another one has it
	std::unique_ptr<std::byte[]> _memory; // the stack: never moves during a run, pages are used when they are needed
	Value *_stack = nullptr;
	Value *_top = nullptr; // one behind the last value
	Value *_stack_end = nullptr;
	uint32_t _address = 0; // of the next instruction
	uint32_t _base = 0; // parameters of the running frame begin here
	std::vector<VmFrame> _frames;
	std::vector<VmTrailEntry> _trail;
	std::vector<Value> _slots;
	std::vector<Value> _own_attributes;
	std::vector<Value> _initial_attributes; // what runs begin with: the host's overrides, and constants; else Void
	Value *_attributes = nullptr;
	std::unique_ptr<Made> _made; // few runs make anything, and empty deques take memory
	std::vector<Value *> _outer_attributes; // of the frames of kind Import
	std::vector<uint32_t> _warned; // addresses, sorted
};

} // namespace pcg
