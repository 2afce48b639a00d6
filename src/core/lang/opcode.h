#pragma once

#include <cstdint>

// Instructions of the interpreter; private to core/lang. Jumps are relative to the next instruction.
namespace pcg {

enum class OpCode : uint8_t {
	PushConstant, // operand: constant
	LoadLocal, // operand: index from the frame's base
	LoadSlot, // operand: slot; an unset one is an error
	JumpIfUnset, // extra: slot, operand: jump
	LoadAttribute, // operand: attribute
	LoadVariable, // operand: variable of the dialect
	Add, // these with extra 1: element by element
	Subtract,
	Multiply,
	Divide,
	Modulo,
	Equal,
	NotEqual,
	Less,
	LessEqual,
	Greater,
	GreaterEqual,
	Negate,
	Not,
	And, // without a short cut: element by element
	Or,
	Jump, // operand: jump
	JumpIfFalse, // pops
	AndJump, // keeps a false value and jumps, else pops
	OrJump, // keeps a true value and jumps, else pops
	CheckBool, // the right side of && and ||
	Draw, // pushes a number in [0, 100)
	ChanceJump, // pops a share, takes it from the drawn number below; jumps while something is left of that, else pops it too
	Pop,
	TagSize, // extra: SizeKind
	CallFunction, // extra: function of the dialect, count: arguments, operand: which are checked (see check_mask_others)
	CallOperation, // the same of operations
	CallBlock, // as CallOperation; operand: block; two Data follow: mask, second block + 1
	CallFunctionBlock, // as CallBlock, of functions
	Data,
	CallUser, // operand: callable
	CallRule, // operand: rule
	CallHostRule, // operand: rule
	SetSlot, // operand: slot
	PushGroup,
	PopGroup,
	MakeRow, // operand: values and arrays, side by side
	StackRows, // operand: arrays, one above the other
	MakeRange, // count: 2 or 3 numbers, a:b or a:step:b
	Index, // count: 1 or 2 indices
	BeginImport, // operand: import scope, count: values of its overridden attributes
	EndImport,
	FindTarget, // pops a text: the attribute or variable of that name; operand: text in front of names
	FindWord, // pops a text: its place among the words; operand: text with the words
	Leaf, // begins an expression that makes no frames: Vm::evaluate() runs it without one
	ReturnLeaf, // ends it, with its value on top
	Return, // of a chunk with a value, which is on top
	End, // of a chunk without one
};

// Bit k of the mask of a call: argument k is checked when it runs, since its type is not known before; the last bit stands for all from there on.
// `others`: not all of these have to be numbers.
constexpr uint32_t last_check_bit = 15;
constexpr uint32_t check_mask_others = 1u << 16;

} // namespace pcg
