#include <algorithm>

#include "core/lang/parser.h"

// Blocks behind operations: { selector : commands | .. }.
namespace pcg {

namespace {

// Whether no separator of the entry can come behind this.
bool ends_search(const Token &token, bool among_commands) {
	switch (token.kind) {
		case TokenKind::Bar:
		case TokenKind::CloseBrace:
		case TokenKind::CloseBracket:
		case TokenKind::CloseParen:
		case TokenKind::End:
			return true;
		case TokenKind::OpenParen:
		case TokenKind::OpenBrace:
		case TokenKind::OpenBracket:
			return token.match == 0;
		case TokenKind::Or:
		case TokenKind::Comma:
		case TokenKind::Semicolon:
			return among_commands;
		default:
			return false;
	}
}

} // namespace

uint32_t Parser::parse_rule_as_block() {
	AstBlock block;
	Depth depth(*this);
	AstEntry entry;
	entry.offset = block.offset = peek().offset;
	entry.body = add_body(depth.is_fine() ? std::vector<uint32_t>{ parse_command() } : std::vector<uint32_t>{});
	_ast.entries.push_back(entry);
	block.entries = add_children({ uint32_t(_ast.entries.size() - 1) });
	_ast.blocks.push_back(block);
	return uint32_t(_ast.blocks.size() - 1);
}

uint32_t Parser::parse_block(bool has_conditions) {
	AstBlock block;
	const uint32_t open = _at;
	block.offset = take().offset;
	std::vector<uint32_t> entries;
	Depth depth(*this);
	const Inside inside(*this, open);
	if (depth.is_fine() && !is(TokenKind::CloseBrace)) {
		do {
			entries.push_back(parse_entry(has_conditions));
			recover_in_block(open);
		} while (!_panic && accept(TokenKind::Bar));
	}
	if (!is(TokenKind::CloseBrace) && !_panic) {
		unexpected("`|` or `}`");
	}
	recover_behind(open);
	accept(TokenKind::CloseBrace);
	block.entries = add_children(entries);
	_ast.blocks.push_back(block);
	return uint32_t(_ast.blocks.size() - 1);
}

// After a mistake in an entry of a block that is closed, the parser goes on with the next entry.
void Parser::recover_in_block(uint32_t open) {
	const uint32_t close = _tokens[open].match;
	if (!_panic || _at > close) {
		return;
	}
	while (_at < close && !is(TokenKind::Bar)) {
		_at = std::max(_at, peek().match) + 1;
	}
	_panic = false;
}

// The `:`, `=` or `=:` of `head : body`, 0 if there is a body alone: outside of brackets, and owned by no branch of a chain. A head may be a chain
// itself: `case wide : 3 else : 2 : Wall`. `in_body`: among commands, where `||`, `,` and `;` separate nothing.
uint32_t Parser::find_separator(bool in_body) const {
	uint32_t open_branches = 0;
	for (uint32_t i = _at; !ends_search(_tokens[i], in_body && open_branches == 0); i = std::max(_tokens[i].match, i) + 1) {
		const Token &token = _tokens[i];
		const bool is_assigned = token.kind == TokenKind::Assign || token.kind == TokenKind::ConnectedAssign;
		const bool is_colon = token.kind == TokenKind::Colon && _tokens[i - 1].kind != TokenKind::Percent;
		if (is_assigned || (is_colon && open_branches == 0)) {
			return open_branches == 0 ? i : 0;
		}
		open_branches += token.kind == TokenKind::Name && is_keyword(text(token)) ? 1 : 0;
		open_branches -= is_colon ? 1 : 0;
	}
	return 0;
}

uint32_t Parser::parse_entry(bool has_conditions) {
	AstEntry entry;
	entry.offset = peek().offset;
	if (is(TokenKind::OpenBrace)) {
		entry.kind = AstEntry::Kind::Group;
		entry.block = parse_block(has_conditions);
		if (accept(TokenKind::Star)) {
			entry.kind = AstEntry::Kind::Repeat;
			_ast.blocks[entry.block].is_repeated = true;
		}
	} else {
		has_conditions ? parse_condition(entry) : parse_head(entry);
		entry.body = parse_body({});
	}
	_ast.entries.push_back(entry);
	return uint32_t(_ast.entries.size() - 1);
}

void Parser::parse_head(AstEntry &entry) {
	if (find_separator(false) == 0) {
		return;
	}
	entry.head = parse_expression();
	entry.separator = peek().kind;
	if (!accept(TokenKind::Colon) && !accept(TokenKind::Assign) && !accept(TokenKind::ConnectedAssign)) {
		unexpected("`:` between what is selected and its commands");
	} else if (!is_word("case") && find_separator(false) != 0) {
		entry.depth = parse_expression();
		expect(TokenKind::Colon, "after the depth");
	}
}

// What stands behind a missing condition or `|` cannot be told apart: one mistake costs the whole entry.
void Parser::parse_condition(AstEntry &entry) {
	if (find_separator(false) == 0) {
		error("missing-head", peek(), "a condition and `:` belong in front of the commands", "for everybody: { true: .. }");
		return;
	}
	entry.head = parse_expression();
	expect_condition_end();
	const uint32_t next = _panic || starts_chance() ? 0 : find_separator(true);
	if (next != 0 && _tokens[next].kind == TokenKind::Colon) {
		error("unexpected-depth", _tokens[next], "expected `|` before the next condition, " + found_text(_tokens[next]));
	} else if (next != 0) {
		error("syntax", _tokens[next], "expected a command, " + found_text(_tokens[next]), "set(name, value) gives a name its value");
	}
}

} // namespace pcg
