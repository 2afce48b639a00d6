#include <algorithm>
#include <bit>

#include "core/lang/opcode.h"
#include "core/lang/vm.h"

// The loop that executes instructions. Nothing in it looks up a string or allocates.
namespace pcg {

bool Vm::is_true(const Value &condition) {
	if (!condition.is_bool()) {
		const Value fallback = Value::of(condition.is_number() && condition.number != 0.0);
		const Value result = mismatch("type-mismatch", "a condition is true or false, this is " + std::string(type_name(condition.type)), fallback);
		return result.is_bool() && result.boolean;
	}
	return condition.boolean;
}

namespace {

// The usual case: all arguments to be checked are wanted as numbers, and are.
bool are_numbers(const Value *arguments, uint32_t count, uint32_t mask) {
	if ((mask & check_mask_others) != 0 || count > last_check_bit) {
		return false;
	}
	for (; mask != 0; mask &= mask - 1) {
		if (!arguments[std::countr_zero(mask)].is_number()) {
			return false;
		}
	}
	return true;
}

// Of other calls: each argument that is checked is of the one type that its parameter wants.
bool are_wanted(const Value *arguments, uint32_t count, const std::vector<ParamSpec> &params, uint32_t mask) {
	bool are = count <= std::min<size_t>(params.size(), last_check_bit);
	for (mask &= check_mask_others - 1; are && mask != 0; mask &= mask - 1) {
		const int i = std::countr_zero(mask);
		are = arguments[i].type == wanted_type(params[size_t(i)].kind);
	}
	return are;
}

} // namespace

inline Flow Vm::call_host_rule(RuleId rule, std::span<const Value> args) {
	_silent_steps = 0;
	const Flow flow = count_step() ? _host->call_rule(*this, rule, args) : Flow::Stop;
	return _failed ? Flow::Stop : flow;
}

inline Flow Vm::call_operation(const Instruction &instruction, uint32_t mask, const Block *block, const Block *second_block) {
	const OperationSpec &spec = _program->dialect->operations[instruction.extra];
	Value *const first = _top - instruction.count;
	const Args args = { { first, instruction.count }, block, second_block, spec.user };
	_silent_steps = 0;
	const bool are_fit = are_numbers(first, instruction.count, mask) || are_wanted(first, instruction.count, spec.params, mask);
	if (!count_step() || (!are_fit && !check_arguments(spec.params, spec.name, args, mask))) {
		return Flow::Stop;
	}
	const Flow flow = spec.handler(*this, args);
	_top = first;
	if (flow == Flow::Pause && _native_depth > 1) {
		fail("pause-in-block", "`" + std::string(spec.name) + "` takes time and cannot stand inside the block of another operation",
				"call it from the rule itself, or from a `case` or `[ ]` in it");
		return Flow::Stop;
	}
	return flow;
}

// Leaves the value in place of the arguments. False: the run has failed.
bool Vm::call_function(const Instruction &instruction, uint32_t mask, const Block *block) {
	const FunctionSpec &spec = _program->dialect->functions[instruction.extra];
	Value *const first = _top - instruction.count;
	const Args args = { { first, instruction.count }, block, nullptr, spec.user };
	if (!are_numbers(first, instruction.count, mask) && !check_arguments(spec.params, spec.name, args, mask)) {
		return false;
	}
	const Value result = spec.handler(*this, args);
	*first = result;
	_top = first + 1;
	return !_failed;
}

// Long because this is the dispatch loop: one short case for each instruction, and nothing between them.
Vm::Stop Vm::run() {
	const Program &program = *_program;
	const Instruction *const code = program.code.data();
	const Instruction *ip = code + _address;
	Value *top = _top;
	// Handlers see the interpreter's state in the members; the loop keeps its own copies in registers.
	const auto store = [&] {
		_address = uint32_t(ip - code);
		_top = top;
	};
	for (;;) {
		const Instruction &i = *ip++;
		if (i.code > OpCode::End) {
			__builtin_unreachable(); // programs are made by the compiler: no need to look in each turn
		}
		switch (i.code) {
			case OpCode::PushConstant:
				*top++ = program.constants[i.operand];
				break;
			case OpCode::LoadLocal:
				*top++ = _stack[_base + i.operand];
				break;
			case OpCode::LoadSlot:
				*top = _slots[i.operand];
				if (top->is_void()) [[unlikely]] {
					store();
					fail("unset-local", "`" + program.slot_names[i.operand] + "` has no value here",
							"set(" + program.slot_names[i.operand] + ", ..) must come before, in this rule or in one that calls it");
					return Stop::Stopped;
				}
				++top;
				break;
			case OpCode::JumpIfUnset:
				if (_slots[i.extra].is_void()) {
					ip += int32_t(i.operand);
				}
				break;
			case OpCode::LoadAttribute:
				*top = _attributes[i.operand];
				if (top->is_void() || top->type == ValueType::Chunk) [[unlikely]] {
					store();
					*top = load_attribute(i.operand);
					if (_failed) {
						return Stop::Stopped;
					}
				}
				++top;
				break;
			case OpCode::LoadVariable: {
				store();
				const Value value = program.dialect->variables[i.operand].handler(*this);
				if (_failed) [[unlikely]] {
					return Stop::Stopped;
				}
				*top++ = value;
				break;
			}
#define PCG_ARITHMETIC(name, expression)                                                                                                    \
	case OpCode::name: {                                                                                                                  \
		const Value &a = top[-2], &b = top[-1];                                                                                            \
		if (a.is_number() && b.is_number()) [[likely]] {                                                                                   \
			top[-2] = Value::of(expression);                                                                                                \
		} else {                                                                                                                           \
			store();                                                                                                                        \
			top[-2] = arithmetic(i, a, b);                                                                                             \
			if (_failed) {                                                                                                                  \
				return Stop::Stopped;                                                                                                        \
			}                                                                                                                               \
		}                                                                                                                                  \
		--top;                                                                                                                             \
		break;                                                                                                                             \
	}
				PCG_ARITHMETIC(Add, a.number + b.number)
				PCG_ARITHMETIC(Subtract, a.number - b.number)
				PCG_ARITHMETIC(Multiply, a.number * b.number)
				PCG_ARITHMETIC(Less, a.number < b.number)
				PCG_ARITHMETIC(LessEqual, a.number <= b.number)
				PCG_ARITHMETIC(Greater, a.number > b.number)
				PCG_ARITHMETIC(GreaterEqual, a.number >= b.number)
				PCG_ARITHMETIC(Equal, a.number == b.number)
				PCG_ARITHMETIC(NotEqual, a.number != b.number)
#undef PCG_ARITHMETIC
			case OpCode::Divide:
			case OpCode::Modulo:
			case OpCode::And:
			case OpCode::Or: {
				store();
				top[-2] = arithmetic(i, top[-2], top[-1]);
				if (_failed) [[unlikely]] {
					return Stop::Stopped;
				}
				--top;
				break;
			}
			case OpCode::Negate:
				store();
				top[-1] = negate(top[-1]);
				if (_failed) [[unlikely]] {
					return Stop::Stopped;
				}
				break;
			case OpCode::Not:
				store();
				top[-1] = top[-1].is_array() ? negate_array(i.code, *top[-1].array) : Value::of(!is_true(top[-1]));
				if (_failed) [[unlikely]] {
					return Stop::Stopped;
				}
				break;
			case OpCode::Jump:
				ip += int32_t(i.operand);
				break;
			case OpCode::JumpIfFalse: {
				--top;
				if (!top->is_bool()) [[unlikely]] {
					store();
					*top = Value::of(is_true(*top));
					if (_failed) {
						return Stop::Stopped;
					}
				}
				ip += top->boolean ? 0 : int32_t(i.operand);
				break;
			}
			case OpCode::AndJump:
			case OpCode::OrJump: {
				if (!top[-1].is_bool()) [[unlikely]] {
					store();
					top[-1] = Value::of(is_true(top[-1]));
					if (_failed) {
						return Stop::Stopped;
					}
				}
				if (top[-1].boolean == (i.code == OpCode::OrJump)) {
					ip += int32_t(i.operand);
				} else {
					--top;
				}
				break;
			}
			case OpCode::CheckBool:
				if (!top[-1].is_bool()) [[unlikely]] {
					store();
					top[-1] = Value::of(is_true(top[-1]));
					if (_failed) {
						return Stop::Stopped;
					}
				}
				break;
			case OpCode::Draw:
				*top++ = Value::of(_random->uniform(0.0, 100.0));
				break;
			case OpCode::ChanceJump: {
				--top;
				if (!top->is_number()) [[unlikely]] {
					store();
					*top = mismatch("type-mismatch", "a share is a number in percent, this is " + std::string(type_name(top->type)), Value::of(0.0));
					if (_failed) {
						return Stop::Stopped;
					}
				}
				top[-1].number -= top->number;
				if (top[-1].number >= 0.0) {
					ip += int32_t(i.operand);
				} else {
					--top;
				}
				break;
			}
			case OpCode::Pop:
				--top;
				break;
			case OpCode::TagSize:
				top[-1].size_kind = SizeKind(i.extra);
				break;
			case OpCode::CallFunction:
				store();
				if (!call_function(i, i.operand, nullptr)) [[unlikely]] {
					return Stop::Stopped;
				}
				top = _top;
				break;
			case OpCode::CallFunctionBlock: {
				const uint32_t mask = (ip++)->operand;
				store();
				if (!call_function(i, mask, &program.blocks[i.operand])) [[unlikely]] {
					return Stop::Stopped;
				}
				top = _top;
				break;
			}
			case OpCode::CallOperation:
			case OpCode::CallBlock: {
				const Block *block = nullptr, *second_block = nullptr;
				uint32_t mask = i.operand;
				if (i.code == OpCode::CallBlock) {
					block = &program.blocks[i.operand];
					mask = ip[0].operand;
					second_block = ip[1].operand > 0 ? &program.blocks[ip[1].operand - 1] : nullptr;
					ip += 2;
				}
				store();
				const Flow flow = call_operation(i, mask, block, second_block);
				if (flow != Flow::Next || _failed) [[unlikely]] {
					return flow == Flow::Pause && !_failed ? Stop::Paused : Stop::Stopped;
				}
				top = _top;
				break;
			}
			case OpCode::Leaf:
			case OpCode::Data:
				break;
			case OpCode::ReturnLeaf:
				store();
				return Stop::Returned;
			case OpCode::CallUser:
			case OpCode::CallRule: {
				store();
				const auto kind = i.code == OpCode::CallUser ? VmFrame::Kind::Function : VmFrame::Kind::Rule;
				if (!enter(i.operand, i.count, _address, kind)) [[unlikely]] {
					return Stop::Stopped;
				}
				ip = code + _address;
				top = _top;
				break;
			}
			case OpCode::CallHostRule: {
				store();
				if (call_host_rule(RuleId(i.operand), { top - i.count, i.count }) != Flow::Next) [[unlikely]] {
					return Stop::Stopped;
				}
				top -= i.count;
				break;
			}
			case OpCode::SetSlot:
				--top;
				set_slot(i.operand, *top);
				break;
			case OpCode::PushGroup:
				store();
				_frames.push_back({ VmFrame::Kind::Group, 0, 0, _base, uint32_t(_trail.size()) });
				_host->push_group(*this);
				break;
			case OpCode::PopGroup:
				store();
				pop_frame();
				break;
			case OpCode::BeginImport:
				top -= i.count;
				store();
				if (!begin_import(program.import_scopes[i.operand], { top, i.count })) [[unlikely]] {
					return Stop::Stopped;
				}
				break;
			case OpCode::EndImport:
				store();
				pop_frame();
				break;
			case OpCode::FindTarget:
			case OpCode::FindWord: {
				store();
				const std::string_view text = program.texts[i.operand].view;
				top[-1] = i.code == OpCode::FindTarget ? find_target(text, top[-1]) : find_word(text, top[-1]);
				if (_failed) [[unlikely]] {
					return Stop::Stopped;
				}
				break;
			}
			case OpCode::MakeRow:
			case OpCode::StackRows:
			case OpCode::MakeRange: {
				store();
				const uint32_t count = i.code == OpCode::MakeRange ? i.count : i.operand;
				const std::span<const Value> parts = { top - count, count };
				const Value value = i.code == OpCode::MakeRow ? make_row(parts) : i.code == OpCode::StackRows ? stack_rows(parts) : make_range(parts);
				if (_failed) [[unlikely]] {
					return Stop::Stopped;
				}
				top -= count;
				*top++ = value;
				break;
			}
			case OpCode::Index: {
				store();
				const Value value = index_array(top[-1 - int(i.count)], { top - i.count, i.count });
				if (_failed) [[unlikely]] {
					return Stop::Stopped;
				}
				top -= i.count;
				top[-1] = value;
				break;
			}
			case OpCode::Return:
			case OpCode::End: {
				const VmFrame::Kind kind = _frames.back().kind;
				const uint32_t base = _base;
				store();
				pop_frame();
				if (kind == VmFrame::Kind::Native || kind == VmFrame::Kind::HostRule) {
					return Stop::Returned;
				}
				const Value result = i.code == OpCode::Return ? top[-1] : Value();
				top = _stack + base;
				if (i.code == OpCode::Return) {
					*top++ = result;
				}
				ip = code + _address;
				break;
			}
		}
	}
}

} // namespace pcg
