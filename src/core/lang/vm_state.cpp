#include <algorithm>

#include "core/lang/opcode.h"
#include "core/lang/vm.h"

// A paused run without a stack, and as data and back. A state may come from a file that somebody damaged: what is restored is checked, since the
// loop itself trusts its addresses.
namespace pcg {

namespace {

constexpr uint32_t first_own_text = 0x80000000u;

} // namespace

// Nothing to do where there is one already.
void Vm::take_stack() {
	if (_memory) {
		return;
	}
	if (_stacks == nullptr || _stacks->idle.empty()) {
		_memory.reset(new std::byte[size_t(_limits.max_stack) * sizeof(Value)]);
	} else {
		_memory = std::move(_stacks->idle.back());
		_stacks->idle.pop_back();
	}
	_stack = reinterpret_cast<Value *>(_memory.get());
	_stack_end = _stack + _limits.max_stack;
	_top = std::copy(_waiting.begin(), _waiting.end(), _stack);
}

// Its own stays where it is.
void Vm::put_stack_away() {
	if (_stacks != nullptr && _memory) {
		_waiting.assign(_stack, _top);
		_stacks->idle.push_back(std::move(_memory));
		_stack = _top = _stack_end = nullptr;
	}
}

Value Vm::to_saved(const Value &value, VmState &state) const {
	Value saved = value;
	if (value.type == ValueType::Text) {
		saved.number = 0.0;
		saved.index = value.text->symbol;
		if (value.text->symbol == no_symbol) {
			saved.index = first_own_text + uint32_t(state.texts.size());
			state.texts.emplace_back(value.text->view);
		}
	} else if (value.type == ValueType::Array) {
		VmState::SavedArray array;
		array.rows = value.array->rows;
		array.columns = value.array->columns;
		array.element = value.array->element;
		for (uint32_t i = 0; i < array.rows * array.columns; ++i) {
			array.values.push_back(to_saved(value.array->values[i], state));
		}
		saved.number = 0.0;
		saved.index = uint32_t(state.arrays.size());
		state.arrays.push_back(std::move(array));
	}
	return saved;
}

VmState Vm::save() const {
	VmState state;
	state.fingerprint = _program->fingerprint;
	state.seed = _seed;
	state.steps = _steps;
	state.random_key = _own_random.key();
	state.random_counter = _own_random.counter();
	state.address = _address;
	state.base = _base;
	state.frames = _frames;
	for (const VmTrailEntry &entry : _trail) {
		state.trail.push_back({ entry.slot, to_saved(entry.old, state) });
	}
	for (const Value &value : _memory ? std::span<const Value>(_stack, _top) : _waiting) {
		state.stack.push_back(to_saved(value, state));
	}
	for (const Value &value : _slots) {
		state.slots.push_back(to_saved(value, state));
	}
	for (const Value &value : _own_attributes) {
		state.attributes.push_back(to_saved(value, state));
	}
	return state;
}

// False: it names text, an array or a piece of code that does not exist. Arrays were numbered after those inside of them.
bool Vm::from_saved(Value &value, const VmState &state) {
	switch (value.type) {
		case ValueType::Void:
		case ValueType::Number:
		case ValueType::Bool:
			return true;
		case ValueType::Text:
			if (value.index >= first_own_text) {
				if (value.index - first_own_text >= state.texts.size()) {
					return false;
				}
				value.text = make_text(state.texts[value.index - first_own_text]);
				return true;
			}
			if (value.index >= _program->texts.size()) {
				return false;
			}
			value.text = &_program->texts[value.index];
			return true;
		case ValueType::Rule:
			return value.rule < _program->rules.size();
		case ValueType::Array:
			if (!_made || value.index >= _made->arrays.size()) {
				return false;
			}
			value.array = &_made->arrays[value.index];
			return true;
		case ValueType::Word:
			return true;
		case ValueType::Chunk:
		case ValueType::Attribute:
		case ValueType::Variable:
			return false;
	}
	return false;
}

// A run can only pause inside of rules and groups that one call() from outside began: at an operation, with nothing on the stack but the locals of
// the frames.
bool Vm::is_sound(const VmState &state) const {
	const auto follows = [&](uint32_t address, OpCode code) {
		return address > 0 && address < _program->code.size() && _program->code[address - 1].code == code;
	};
	if (state.fingerprint != _program->fingerprint || state.slots.size() != _program->slot_count ||
			state.attributes.size() != _program->attributes.size() || state.frames.size() < 2 || state.frames.size() > 4u * _limits.max_depth ||
			!follows(state.address, OpCode::CallOperation) || state.frames[0].kind != VmFrame::Kind::Native) {
		return false;
	}
	uint32_t height = 0, base = 0, trail = 0;
	for (size_t i = 0; i < state.frames.size(); ++i) {
		const VmFrame &frame = state.frames[i];
		if (frame.trail_mark < trail || frame.trail_mark > state.trail.size() || frame.base != base) {
			return false;
		}
		trail = frame.trail_mark;
		if (frame.kind == VmFrame::Kind::Rule) {
			const bool is_first = i == 1;
			if (frame.callable >= _program->rules.size() ||
					(is_first ? frame.return_address != 0 : !follows(frame.return_address, OpCode::CallRule))) {
				return false;
			}
			base = height;
			height += _program->callables[frame.callable].frame_size;
		} else if (i == 0 ? frame.return_address != 0 : frame.kind != VmFrame::Kind::Group || i == 1) {
			return false;
		}
	}
	const bool slots_exist = std::all_of(state.trail.begin(), state.trail.end(),
			[&](const VmTrailEntry &entry) { return entry.slot < _program->slot_count; });
	return slots_exist && base == state.base && height == state.stack.size() && height + _program->max_stack < _limits.max_stack;
}

// Everything of the state that is a value; false if one of them names nothing.
bool Vm::restore_values(const VmState &state) {
	for (const VmState::SavedArray &saved : state.arrays) {
		std::vector<Value> values = saved.values;
		if (uint64_t(saved.rows) * saved.columns != values.size() ||
				!std::all_of(values.begin(), values.end(), [&](Value &value) { return from_saved(value, state); })) {
			return false;
		}
		make_array(values, saved.rows, saved.element);
	}
	_trail = state.trail;
	_slots = state.slots;
	_own_attributes = state.attributes;
	_attributes = _own_attributes.data();
	_top = std::copy(state.stack.begin(), state.stack.end(), _stack);
	const auto restore_all = [&](std::span<Value> values) {
		return std::all_of(values.begin(), values.end(), [&](Value &value) { return from_saved(value, state); });
	};
	return std::all_of(_trail.begin(), _trail.end(), [&](VmTrailEntry &entry) { return from_saved(entry.old, state); }) &&
			restore_all({ _stack, _top }) && restore_all(_slots) && restore_all(_own_attributes);
}

bool Vm::restore(const VmState &state) {
	if (_is_paused) {
		abandon();
	}
	if (!is_sound(state)) {
		return false;
	}
	begin(state.seed);
	take_stack();
	const bool is_whole = restore_values(state);
	if (!is_whole) {
		begin(0);
	}
	put_stack_away();
	if (!is_whole) {
		return false;
	}
	_frames = state.frames;
	_call_depth = uint32_t(std::count_if(_frames.begin(), _frames.end(), [](const VmFrame &frame) { return frame.kind == VmFrame::Kind::Rule; }));
	_native_depth = 1;
	_steps = state.steps;
	_own_random.restore(state.random_key, state.random_counter);
	_address = state.address;
	_base = state.base;
	_is_paused = true;
	return true;
}

} // namespace pcg
