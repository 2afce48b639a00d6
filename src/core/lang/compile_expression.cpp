#include <cmath>

#include <algorithm>
#include <iterator>

#include "core/lang/compiler.h"

// Expressions to code that leaves one value on the stack.
namespace pcg {

namespace {

OpCode binary_opcode(TokenKind op) {
	switch (op) {
		case TokenKind::Plus:
			return OpCode::Add;
		case TokenKind::Minus:
			return OpCode::Subtract;
		case TokenKind::Star:
			return OpCode::Multiply;
		case TokenKind::Slash:
			return OpCode::Divide;
		case TokenKind::Percent:
			return OpCode::Modulo;
		case TokenKind::Equal:
			return OpCode::Equal;
		case TokenKind::NotEqual:
			return OpCode::NotEqual;
		case TokenKind::Less:
			return OpCode::Less;
		case TokenKind::LessEqual:
			return OpCode::LessEqual;
		case TokenKind::Greater:
			return OpCode::Greater;
		case TokenKind::And:
			return OpCode::And;
		case TokenKind::Or:
			return OpCode::Or;
		default:
			return OpCode::GreaterEqual;
	}
}

// What an operator yields if it does not fail.
ValueType binary_result(TokenKind op, ValueType a, ValueType b) {
	switch (op) {
		case TokenKind::Plus:
			if (a == ValueType::Text || b == ValueType::Text) {
				return ValueType::Text;
			}
			return a == ValueType::Number && b == ValueType::Number ? ValueType::Number : ValueType::Void;
		case TokenKind::Minus:
		case TokenKind::Star:
		case TokenKind::Slash:
		case TokenKind::Percent:
			return ValueType::Number;
		default:
			return ValueType::Bool;
	}
}

bool compute(TokenKind op, double a, double b, Value &result) {
	switch (op) {
		case TokenKind::Plus:
			result = Value::of(a + b);
			return true;
		case TokenKind::Minus:
			result = Value::of(a - b);
			return true;
		case TokenKind::Star:
			result = Value::of(a * b);
			return true;
		case TokenKind::Slash:
			result = Value::of(a / b);
			return b != 0.0;
		case TokenKind::Percent:
			result = Value::of(std::fmod(a, b));
			return b != 0.0;
		case TokenKind::Less:
			result = Value::of(a < b);
			return true;
		case TokenKind::LessEqual:
			result = Value::of(a <= b);
			return true;
		case TokenKind::Greater:
			result = Value::of(a > b);
			return true;
		case TokenKind::GreaterEqual:
			result = Value::of(a >= b);
			return true;
		case TokenKind::Equal:
			result = Value::of(a == b);
			return true;
		case TokenKind::NotEqual:
			result = Value::of(a != b);
			return true;
		default:
			return false;
	}
}

} // namespace

Compiler::Known Compiler::unknown_value(uint32_t offset) {
	emit_constant(is_strict() ? Value() : Value::of(0.0), offset); // nothing that could be found wrong again
	return ValueType::Void;
}

Compiler::Known Compiler::expression(uint32_t id) {
	const Expr &expr = _scope.ast->exprs[id];
	switch (expr.kind) {
		case ExprKind::Error:
			return unknown_value(expr.offset);
		case ExprKind::Number:
			emit_constant(Value::of(expr.number), expr.offset);
			return ValueType::Number;
		case ExprKind::Text:
			emit_constant(Value::of(&_program->texts[symbol(expr.name)]), expr.offset);
			return ValueType::Text;
		case ExprKind::Name:
			return name(expr);
		case ExprKind::Call:
			return call(expr);
		case ExprKind::Unary:
			return unary(expr);
		case ExprKind::Binary:
			return binary_chain(id);
		case ExprKind::Case:
			return case_expression(expr);
		case ExprKind::Chance:
			return chance_expression(expr);
		case ExprKind::Size:
			complain("size-not-allowed", expr.offset, "`'` and `~` mean something in front of sizes only", "leave it out");
			return expression(_scope.ast->list(expr.children)[0]);
		case ExprKind::Array:
			return array(expr);
		case ExprKind::Index:
			return index(expr);
		case ExprKind::Element:
			return range(expr);
		case ExprKind::Components:
			return components(expr);
		case ExprKind::ImportCall:
			return import_call(expr);
	}
	return unknown_value(expr.offset);
}

Compiler::Known Compiler::size_expression(uint32_t id) {
	const Expr &expr = _scope.ast->exprs[id];
	if (expr.kind != ExprKind::Size) {
		return expression(id);
	}
	const uint32_t begin = here(), depth = _builders.back().depth;
	const Known known = expression(_scope.ast->list(expr.children)[0]);
	Value value;
	if (ends_in_constant(begin, value) && value.is_number()) {
		drop_code(begin, depth);
		value.size_kind = expr.size_kind;
		emit_constant(value, expr.offset);
	} else {
		emit(OpCode::TagSize, expr.offset, 0, 0, uint32_t(expr.size_kind));
	}
	return known;
}

Chunk Compiler::value_chunk(uint32_t expr, bool is_size) {
	begin_chunk();
	is_size ? size_expression(expr) : expression(expr);
	const uint32_t offset = _scope.ast->exprs[expr].offset;
	if (!makes_no_frames()) {
		return end_chunk(OpCode::Return, offset);
	}
	Builder &builder = _builders.back();
	builder.code.insert(builder.code.begin(), { OpCode::Leaf, 0, 0, 0 }); // jumps are relative: they still lead where they led
	builder.places.insert(builder.places.begin(), place(offset));
	return end_chunk(OpCode::ReturnLeaf, offset);
}

// Whether the chunk calls nothing of the rule set and is more than a constant.
bool Compiler::makes_no_frames() const {
	const std::vector<Instruction> &code = _builders.back().code;
	const bool is_constant = code.size() <= 2 && code.front().code == OpCode::PushConstant &&
			(code.size() == 1 || code.back().code == OpCode::TagSize);
	constexpr OpCode makers[] = { OpCode::CallUser, OpCode::CallRule, OpCode::CallHostRule, OpCode::CallOperation, OpCode::CallBlock,
		OpCode::CallFunctionBlock, OpCode::SetSlot, OpCode::PushGroup, OpCode::BeginImport };
	return !is_constant && std::none_of(code.begin(), code.end(), [&](const Instruction &instruction) {
		return std::find(std::begin(makers), std::end(makers), instruction.code) != std::end(makers);
	});
}

// --- Operators

bool Compiler::fold_binary(TokenKind op, uint32_t begin, uint32_t depth, uint32_t offset) {
	const std::vector<Instruction> &code = _builders.back().code;
	if (code.size() != begin + 2 || code[begin].code != OpCode::PushConstant || code[begin + 1].code != OpCode::PushConstant) {
		return false;
	}
	const Value a = _program->constants[code[begin].operand], b = _program->constants[code[begin + 1].operand];
	Value result;
	if (!a.is_number() || !b.is_number() || !compute(op, a.number, b.number, result)) {
		return false;
	}
	drop_code(begin, depth);
	emit_constant(result, offset);
	return true;
}

// a + b + c + .. leans to the left and may be long: its operators are taken from the innermost outwards in a loop.
Compiler::Known Compiler::binary_chain(uint32_t id) {
	std::vector<uint32_t> chain;
	while (_scope.ast->exprs[id].kind == ExprKind::Binary) {
		chain.push_back(id);
		id = _scope.ast->list(_scope.ast->exprs[id].children)[0];
	}
	const uint32_t begin = here(), depth = _builders.back().depth;
	Known known = expression(id);
	while (!chain.empty()) {
		const Expr &expr = _scope.ast->exprs[chain.back()];
		chain.pop_back();
		if (!expr.is_elementwise && (expr.op == TokenKind::And || expr.op == TokenKind::Or)) {
			known = logical(expr);
		} else {
			known = binary(expr, known, begin, depth);
		}
	}
	return known;
}

// The left operand lies on the stack already.
Compiler::Known Compiler::binary(const Expr &expr, Known left, uint32_t begin, uint32_t depth) {
	const Known right = expression(_scope.ast->list(expr.children)[1]);
	if (!fold_binary(expr.op, begin, depth, expr.offset)) {
		emit(binary_opcode(expr.op), expr.offset, -1, 0, expr.is_elementwise ? 1 : 0);
	}
	// With a dot it is an array as soon as one side is.
	return expr.is_elementwise && (left != ValueType::Number || right != ValueType::Number) ? ValueType::Void : binary_result(expr.op, left, right);
}

Compiler::Known Compiler::logical(const Expr &expr) {
	const auto operands = _scope.ast->list(expr.children);
	const uint32_t jump = emit_jump(expr.op == TokenKind::And ? OpCode::AndJump : OpCode::OrJump, expr.offset, -1);
	if (expression(operands[1]) != ValueType::Bool) {
		emit(OpCode::CheckBool, _scope.ast->exprs[operands[1]].offset, 0);
	}
	land(jump);
	return ValueType::Bool;
}

bool Compiler::fold_unary(TokenKind op, uint32_t begin, uint32_t depth, uint32_t offset) {
	Value value;
	if (!ends_in_constant(begin, value) || value.type != (op == TokenKind::Not ? ValueType::Bool : ValueType::Number)) {
		return false;
	}
	drop_code(begin, depth);
	emit_constant(op == TokenKind::Not ? Value::of(!value.boolean) : Value::of(-value.number), offset);
	return true;
}

Compiler::Known Compiler::unary(const Expr &expr) {
	const uint32_t begin = here(), depth = _builders.back().depth;
	const Known known = expression(_scope.ast->list(expr.children)[0]);
	if (expr.op == TokenKind::Plus) {
		return known;
	}
	if (!fold_unary(expr.op, begin, depth, expr.offset)) {
		emit(expr.op == TokenKind::Not ? OpCode::Not : OpCode::Negate, expr.offset, 0);
	}
	if (expr.is_elementwise) {
		return ValueType::Void;
	}
	return expr.op == TokenKind::Not ? ValueType::Bool : ValueType::Number;
}

// --- Chains

Compiler::Known Compiler::case_expression(const Expr &expr) {
	const auto parts = _scope.ast->list(expr.children);
	std::vector<uint32_t> ends;
	Known known = ValueType::Void;
	for (size_t i = 0; i + 1 < parts.size(); i += 2) {
		expression(parts[i]);
		const uint32_t next = emit_jump(OpCode::JumpIfFalse, _scope.ast->exprs[parts[i]].offset, -1);
		const Known value = expression(parts[i + 1]);
		known = i == 0 || known == value ? value : ValueType::Void;
		ends.push_back(emit_jump(OpCode::Jump, expr.offset, -1));
		land(next);
	}
	const Known last = expression(parts.back());
	for (uint32_t end : ends) {
		land(end);
	}
	return known == last ? known : ValueType::Void;
}

void Compiler::share(uint32_t expr) {
	const uint32_t begin = here();
	Value constant;
	expression(expr);
	if (ends_in_constant(begin, constant) && constant.is_number() && constant.number < 0.0) {
		warn("negative-share", _scope.ast->exprs[expr].offset, "a share below 0 is never chosen");
	}
}

void Compiler::warn_shares(std::span<const uint32_t> shares) {
	double sum = 0.0;
	for (uint32_t share : shares) {
		const Expr &expr = _scope.ast->exprs[share];
		if (expr.kind != ExprKind::Number) {
			return;
		}
		sum += expr.number;
	}
	if (sum > 100.0 + 1e-9) {
		warn("shares-above-100", _scope.ast->exprs[shares[0]].offset,
				"the shares of this choice add up to " + value_text(Value::of(sum)) + " %; what lies above 100 is never chosen");
	}
}

Compiler::Known Compiler::chance_expression(const Expr &expr) {
	const auto parts = _scope.ast->list(expr.children);
	std::vector<uint32_t> ends, shares;
	Known known = ValueType::Void;
	emit(OpCode::Draw, expr.offset, 1);
	for (size_t i = 0; i + 1 < parts.size(); i += 2) {
		shares.push_back(parts[i]);
		share(parts[i]);
		const uint32_t next = emit_jump(OpCode::ChanceJump, _scope.ast->exprs[parts[i]].offset, -2);
		const Known value = expression(parts[i + 1]);
		known = i == 0 || known == value ? value : ValueType::Void;
		ends.push_back(emit_jump(OpCode::Jump, expr.offset, 0)); // where the share was not drawn, the number still lies there
		land(next);
	}
	emit(OpCode::Pop, expr.offset, -1);
	const Known last = expression(parts.back());
	for (uint32_t end : ends) {
		land(end);
	}
	warn_shares(shares);
	return known == last ? known : ValueType::Void;
}

} // namespace pcg
