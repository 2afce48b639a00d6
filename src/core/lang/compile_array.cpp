#include <algorithm>

#include "core/lang/compiler.h"

// Arrays, ranges, indices, and comp() as a function.
namespace pcg {

void Compiler::array_row(const Expr &row) {
	const auto elements = _scope.ast->list(row.children);
	for (uint32_t element : elements) {
		expression(element);
	}
	emit(OpCode::MakeRow, row.offset, 1 - int(elements.size()), uint32_t(elements.size()));
}

Compiler::Known Compiler::array(const Expr &expr) {
	const auto rows = _scope.ast->list(expr.children);
	const auto is_plain = [&](uint32_t id) {
		const ExprKind kind = _scope.ast->exprs[id].kind;
		return kind == ExprKind::Number || kind == ExprKind::Text;
	};
	bool has_only_plain = true;
	for (uint32_t row : rows) {
		const auto elements = _scope.ast->list(_scope.ast->exprs[row].children);
		has_only_plain &= std::all_of(elements.begin(), elements.end(), is_plain);
	}
	for (uint32_t row : rows) {
		const Expr &source = _scope.ast->exprs[row];
		if (has_only_plain && source.children.count != _scope.ast->exprs[rows[0]].children.count) {
			complain("array-shape", source.offset, "the rows of an array have equal lengths");
		}
		array_row(source);
	}
	if (rows.size() != 1) {
		emit(OpCode::StackRows, expr.offset, 1 - int(rows.size()), uint32_t(rows.size()));
	}
	return ValueType::Array;
}

Compiler::Known Compiler::range(const Expr &expr) {
	const auto parts = _scope.ast->list(expr.children);
	for (uint32_t part : parts) {
		expression(part);
	}
	emit(OpCode::MakeRange, expr.offset, 1 - int(parts.size()), 0, 0, parts.size());
	return ValueType::Array;
}

Compiler::Known Compiler::index(const Expr &expr) {
	const auto parts = _scope.ast->list(expr.children);
	for (size_t i = 0; i < std::min<size_t>(parts.size(), 3); ++i) {
		expression(parts[i]);
	}
	if (parts.size() > 3) {
		complain("array-shape", expr.offset, "an array has rows and columns: at most two indices");
	}
	const size_t count = std::min<size_t>(parts.size() - 1, 2);
	emit(OpCode::Index, expr.offset, -int(count), 0, 0, count);
	return ValueType::Void;
}

Compiler::Known Compiler::components(const Expr &expr) {
	const auto found = std::find_if(_dialect.functions.begin(), _dialect.functions.end(),
			[&](const FunctionSpec &spec) { return spec.name == expr.name && spec.has_block; });
	if (found == _dialect.functions.end()) {
		unknown("function", expr.name, expr.offset, false);
		return unknown_value(expr.offset);
	}
	const uint32_t mask = arguments(found->params, found->name, expr.children);
	const bool outer = _has_value_blocks;
	_has_value_blocks = true;
	const uint32_t entries = block(expr.block, BlockKind::Selectors);
	_has_value_blocks = outer;
	emit(OpCode::CallFunctionBlock, expr.offset, 1 - int(expr.children.count), entries, uint32_t(found - _dialect.functions.begin()),
			expr.children.count);
	emit(OpCode::Data, expr.offset, 0, mask);
	return found->result;
}

} // namespace pcg
