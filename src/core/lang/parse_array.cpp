#include "core/lang/parser.h"

// Arrays, and comp() as a function, which makes one.
namespace pcg {

uint32_t Parser::parse_components(Expr call) {
	call.kind = ExprKind::Components;
	AstBlock block;
	const Inside inside(*this, _at);
	block.offset = take().offset;
	std::vector<uint32_t> entries;
	do {
		AstEntry entry;
		entry.offset = peek().offset;
		entry.head = parse_expression();
		entry.separator = peek().kind;
		if (!accept(TokenKind::Colon) && !accept(TokenKind::Assign) && !accept(TokenKind::ConnectedAssign)) {
			unexpected("`:` between what is selected and its value");
		}
		entry.body = parse_expression();
		_ast.entries.push_back(entry);
		entries.push_back(uint32_t(_ast.entries.size() - 1));
	} while (!_panic && accept(TokenKind::Bar));
	expect(TokenKind::CloseBrace, "after the selectors");
	block.entries = add_children(entries);
	_ast.blocks.push_back(block);
	call.block = uint32_t(_ast.blocks.size() - 1);
	return add(call);
}

uint32_t Parser::parse_array() {
	Expr array;
	array.kind = ExprKind::Array;
	const Inside inside(*this, _at);
	array.offset = take().offset;
	std::vector<uint32_t> rows;
	if (!is(TokenKind::CloseBracket)) {
		do {
			rows.push_back(parse_array_row(peek().offset));
		} while (!_panic && accept(TokenKind::Semicolon));
	}
	expect(TokenKind::CloseBracket, "after the array");
	array.children = add_children(rows);
	return add(array);
}

uint32_t Parser::parse_array_row(uint32_t offset) {
	Expr row;
	row.kind = ExprKind::Array;
	row.offset = offset;
	std::vector<uint32_t> elements;
	do {
		elements.push_back(parse_array_element());
	} while (!_panic && accept(TokenKind::Comma));
	row.children = add_children(elements);
	return add(row);
}

uint32_t Parser::parse_array_element() {
	const uint32_t first = parse_expression();
	if (!is(TokenKind::Colon)) {
		return first;
	}
	Expr range;
	range.kind = ExprKind::Element;
	range.offset = peek().offset;
	std::vector<uint32_t> parts = { first };
	while (accept(TokenKind::Colon) && parts.size() < 3) {
		parts.push_back(parse_expression());
	}
	range.children = add_children(parts);
	return add(range);
}

} // namespace pcg
