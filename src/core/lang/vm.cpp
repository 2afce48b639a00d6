#include "core/lang/vm.h"

#include <algorithm>
#include <cstring>

#include "core/lang/diagnostic_at.h"
#include "core/lang/opcode.h"

namespace pcg {

namespace {

// Most sizes are plain numbers, which need no frame.
bool is_constant(const Program &program, Chunk chunk, Value &value) {
	const Instruction *code = program.code.data() + uint32_t(chunk);
	const bool is_tagged = code->code == OpCode::PushConstant && code[1].code == OpCode::TagSize;
	if (code->code != OpCode::PushConstant || code[is_tagged ? 2 : 1].code != OpCode::Return) {
		return false;
	}
	value = program.constants[code->operand];
	if (is_tagged) {
		value.size_kind = SizeKind(code[1].extra);
	}
	return true;
}

} // namespace

Vm::Vm(const Program &program, VmHost &host, VmLimits limits, VmStacks *stacks) :
		_program(&program), _host(&host), _limits(limits), _stacks(stacks) {
	_limits.max_stack = std::max(_limits.max_stack, program.max_stack + 16);
	if (_stacks == nullptr) {
		take_stack();
		_frames.reserve(64);
		_trail.reserve(64);
	}
	reset_initial_attributes();
	begin(0);
}

void Vm::begin(uint64_t seed) {
	_seed = seed;
	_own_random = Random(seed, 0);
	_random = &_own_random;
	_failed = false;
	_is_paused = false;
	_native_depth = 0;
	_call_depth = 0;
	_steps = 0;
	_silent_steps = 0;
	_top = _stack;
	_waiting.clear();
	_base = 0;
	_address = 0;
	_frames.clear();
	_trail.clear();
	_outer_attributes.clear();
	_slots.assign(_program->slot_count, Value());
	_own_attributes.assign(_initial_attributes.begin(), _initial_attributes.end());
	_attributes = _own_attributes.data();
	if (_made) {
		_made->import_attributes.clear();
		_made->texts.clear();
		_made->text_storage.clear();
		_made->arrays.clear();
		_made->array_storage.clear();
	}
}

// --- Frames

void Vm::set_slot(uint32_t slot, const Value &value) {
	_trail.push_back({ slot, _slots[slot] });
	_slots[slot] = value;
}

void Vm::unwind_trail(uint32_t mark) {
	while (_trail.size() > mark) {
		_slots[_trail.back().slot] = _trail.back().old;
		_trail.pop_back();
	}
}

// Attributes see no locals: their value would depend on who asks first.
void Vm::hide_slots() {
	for (uint32_t slot = 0; slot < _slots.size(); ++slot) {
		if (!_slots[slot].is_void()) {
			set_slot(slot, Value());
		}
	}
}

bool Vm::count_step_with_care() {
	if (_steps <= _limits.max_steps) {
		_failed = _failed || _host->is_interrupted();
		return !_failed;
	}
	return fail_steps();
}

// Most attributes are plain numbers and texts: they need no evaluation in each run.
void Vm::reset_initial_attributes() {
	_initial_attributes.assign(_program->attributes.size(), Value());
	for (size_t i = 0; i < _initial_attributes.size(); ++i) {
		const Chunk code = _program->attributes[i].code;
		if (code != Chunk::None) {
			is_constant(*_program, code, _initial_attributes[i]);
		}
	}
}

bool Vm::is_strict() const { return _program->dialect != nullptr && _program->dialect->is_strict(); }

// Says which limit does not let a rule or function be called.
bool Vm::fail_call() {
	constexpr std::string_view endless = "a rule that calls itself needs a case that ends it";
	if (_silent_steps > _limits.max_silent_steps) {
		fail("step-limit", "functions called each other " + std::to_string(_limits.max_silent_steps) + " times for one value",
				"a function that calls itself twice needs twice the time for each level: keep what it gives in a `with` value");
	} else if (_call_depth >= _limits.max_depth) {
		fail("recursion-limit", "rules and functions call each other deeper than " + std::to_string(_limits.max_depth) + " levels", std::string(endless));
	} else {
		fail("recursion-limit", "the rules need more than " + std::to_string(_limits.max_stack) + " values at a time", std::string(endless));
	}
	return false;
}

bool Vm::fail_native() {
	fail("recursion-limit", "blocks nested deeper than " + std::to_string(_limits.max_native_depth) + " levels while running",
			"a rule that calls itself needs a case that ends it");
	return false;
}

bool Vm::enter(uint32_t index, uint32_t count, uint32_t return_address, VmFrame::Kind kind) {
	if (!count_step()) {
		return false;
	}
	_silent_steps = kind == VmFrame::Kind::Function ? _silent_steps + 1 : 0;
	if (_silent_steps > _limits.max_silent_steps || _call_depth >= _limits.max_depth || _top + _program->max_stack > _stack_end) [[unlikely]] {
		return fail_call();
	}
	const Callable &callable = _program->callables[index];
	_frames.push_back({ kind, index, return_address, _base, uint32_t(_trail.size()) });
	++_call_depth;
	if (kind == VmFrame::Kind::HostRule) {
		++_native_depth;
	}
	if (_program->dialect->locals == Dialect::Locals::Dynamic) {
		_top -= count;
		for (uint32_t i = 0; i < count; ++i) {
			set_slot(_program->param_slots[callable.first_slot + i], _top[i]);
		}
		_base = uint32_t(_top - _stack);
	} else {
		_base = uint32_t(_top - _stack) - count;
	}
	_address = uint32_t(callable.code);
	return true;
}

// Goes back to the caller of the topmost frame; the stack is the instruction's business.
void Vm::pop_frame() {
	const VmFrame frame = _frames.back();
	_frames.pop_back();
	unwind_trail(frame.trail_mark);
	switch (frame.kind) {
		case VmFrame::Kind::Rule:
		case VmFrame::Kind::Function:
			--_call_depth;
			_base = frame.base;
			break;
		case VmFrame::Kind::Group:
			_host->pop_group(*this);
			break;
		case VmFrame::Kind::Import:
			_host->pop_group(*this);
			_attributes = _outer_attributes.back();
			_outer_attributes.pop_back();
			break;
		case VmFrame::Kind::HostRule:
			--_call_depth;
			[[fallthrough]];
		case VmFrame::Kind::Native:
			--_native_depth;
			_base = frame.base;
			break;
	}
	_address = frame.return_address;
}

bool Vm::enter_native(Border &border) {
	border = { _frames.size(), _address, _base, _top };
	if (!may_enter_native()) {
		return false;
	}
	_frames.push_back({ VmFrame::Kind::Native, 0, _address, _base, uint32_t(_trail.size()) });
	++_native_depth;
	return true;
}

void Vm::leave_native(const Border &border) {
	while (_frames.size() > border.frame_count) {
		pop_frame();
	}
	_address = border.address;
	_base = border.base;
	_top = border.top;
}

// --- Runs

RunState Vm::finish(Stop stop, const Border &border) {
	_is_paused = stop == Stop::Paused && !_failed;
	if (_is_paused) {
		put_stack_away();
		return RunState::Paused;
	}
	leave_native(border);
	if (_frames.empty()) {
		put_stack_away();
	}
	return _failed ? RunState::Failed : RunState::Finished;
}

RunState Vm::call(RuleId rule, std::span<const Value> args) {
	if (_is_paused) {
		abandon();
	}
	const bool is_outermost = _frames.empty();
	if (is_outermost) {
		_failed = false;
		_address = 0;
	}
	if (index_of(rule) >= _program->rules.size() || _program->callables[index_of(rule)].code == Chunk::None ||
			_program->callables[index_of(rule)].param_count != args.size()) {
		fail("bad-start", "the host called a rule that does not exist or has other parameters");
		return RunState::Failed;
	}
	take_stack();
	Border border = { _frames.size(), _address, _base, _top };
	Stop stop = Stop::Stopped;
	const bool is_by_host = _program->dialect->rule_calls == Dialect::RuleCalls::ByHost;
	if (is_by_host ? may_enter_native() : enter_native(border)) {
		_top = std::copy(args.begin(), args.end(), _top);
		if (enter(index_of(rule), uint32_t(args.size()), 0, is_by_host ? VmFrame::Kind::HostRule : VmFrame::Kind::Rule)) {
			stop = run();
		}
	}
	return finish(stop, border);
}

RunState Vm::resume() {
	if (!_is_paused) {
		return _failed ? RunState::Failed : RunState::Finished;
	}
	_is_paused = false;
	take_stack();
	return finish(run(), { 0, 0, 0, _stack });
}

void Vm::abandon() {
	_is_paused = false;
	take_stack();
	leave_native({ 0, 0, 0, _stack });
	put_stack_away();
}

Value Vm::evaluate(Chunk chunk) {
	if (chunk == Chunk::None) {
		return Value();
	}
	if (_program->code[uint32_t(chunk)].code == OpCode::Leaf && _top + _program->max_stack <= _stack_end) {
		return evaluate_leaf(chunk);
	}
	Value result;
	if (is_constant(*_program, chunk, result)) {
		return result;
	}
	Border border;
	if (enter_native(border)) {
		_address = uint32_t(chunk);
		const Stop stop = run();
		if (stop == Stop::Returned && !_failed) {
			result = _top[-1];
		}
	}
	leave_native(border);
	return result;
}

Value Vm::evaluate_leaf(Chunk chunk) {
	const uint32_t address = _address;
	Value *const top = _top;
	Value result;
	if (!_failed && count_step()) {
		_address = uint32_t(chunk) + 1;
		if (run() == Stop::Returned && !_failed) {
			result = _top[-1];
		}
	}
	_address = address;
	_top = top;
	return result;
}

Flow Vm::run_body(Chunk chunk) {
	if (chunk == Chunk::None) {
		return Flow::Next;
	}
	Border border;
	Stop stop = Stop::Stopped;
	if (enter_native(border)) {
		_address = uint32_t(chunk);
		stop = run();
	}
	leave_native(border);
	return stop == Stop::Returned && !_failed ? Flow::Next : Flow::Stop;
}

RuleId Vm::only_call(Chunk body) const {
	if (body == Chunk::None) {
		return RuleId::Invalid;
	}
	const Instruction *code = _program->code.data() + uint32_t(body);
	const bool is_one = code[0].code == OpCode::CallHostRule && code[0].count == 0 && code[1].code == OpCode::End;
	return is_one && can_enter_native() ? RuleId(code[0].operand) : RuleId::Invalid;
}

// --- Messages

SourcePlace Vm::place() const {
	const size_t at = _address > 0 ? _address - 1 : 0;
	return at < _program->places.size() ? _program->places[at] : SourcePlace();
}

RuleId Vm::running_rule() const {
	for (size_t i = _frames.size(); i-- > 0;) {
		if (_frames[i].kind == VmFrame::Kind::Rule || _frames[i].kind == VmFrame::Kind::HostRule) {
			return RuleId(_frames[i].callable);
		}
	}
	return RuleId::Invalid;
}

Diagnostic Vm::diagnostic_here(Severity severity, std::string_view id, std::string message, std::string hint) const {
	return diagnostic_at(*_program, _address, severity, id, std::move(message), std::move(hint));
}

Value Vm::fail(std::string_view id, std::string message, std::string hint) {
	if (!_failed) {
		_failed = true;
		_host->report(diagnostic_here(Severity::Error, id, std::move(message), std::move(hint)));
	}
	return Value();
}

bool Vm::has_warned() const {
	return std::binary_search(_warned.begin(), _warned.end(), _address);
}

void Vm::warn(std::string_view id, std::string message, std::string hint) {
	if (has_warned()) {
		return;
	}
	_warned.insert(std::lower_bound(_warned.begin(), _warned.end(), _address), _address);
	warn_each(id, std::move(message), std::move(hint));
}

void Vm::warn_each(std::string_view id, std::string message, std::string hint) {
	_host->report(diagnostic_here(Severity::Warning, id, std::move(message), std::move(hint)));
}

Value Vm::mismatch(std::string_view id, std::string message, const Value &fallback, std::string hint) {
	if (hint.empty() && id == "type-mismatch") {
		hint = "only values of one kind go together: text in quotes is not a number, a number is neither true nor false";
	}
	if (is_strict()) {
		return fail(id, std::move(message), std::move(hint));
	}
	warn(id, std::move(message), std::move(hint));
	return fallback;
}

Value Vm::default_of(ValueType element) {
	switch (element) {
		case ValueType::Bool:
			return Value::of(false);
		case ValueType::Text: {
			static constexpr Text nothing;
			return Value::of(&nothing);
		}
		default:
			return Value::of(0.0);
	}
}

} // namespace pcg
