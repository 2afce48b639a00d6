#include <algorithm>

#include "core/lang/parser.h"

// Successors: commands, chains, groups.
namespace pcg {

uint32_t Parser::add(Command command) {
	_ast.commands.push_back(command);
	return uint32_t(_ast.commands.size() - 1);
}

uint32_t Parser::add_body(const std::vector<uint32_t> &commands) {
	_ast.bodies.push_back({ add_children(commands) });
	return uint32_t(_ast.bodies.size() - 1);
}

// A body in a chain ends where the chain goes on; chains of a body close it.
bool Parser::ends_body(const Chains &chains, bool has_commands) const {
	switch (peek().kind) {
		case TokenKind::End:
		case TokenKind::CloseBrace:
		case TokenKind::CloseBracket:
		case TokenKind::CloseParen:
		case TokenKind::Bar:
		case TokenKind::Comma:
			return true;
		default:
			break;
	}
	if (is_word("else") || starts_item()) {
		return true;
	}
	if (is_word("case")) {
		return has_commands && chains.in_case;
	}
	return has_commands && chains.in_chance && starts_chance();
}

// A share such as `30%:` or `(a + b)% :` begins with what cannot begin a command.
bool Parser::starts_chance() const {
	switch (peek().kind) {
		case TokenKind::Number:
		case TokenKind::OpenParen:
		case TokenKind::Minus:
			return true;
		case TokenKind::Name:
			break;
		default:
			return false;
	}
	uint32_t next = _at + 1;
	if (_tokens[next].kind == TokenKind::OpenParen && _tokens[next].match != 0) {
		next = _tokens[next].match + 1;
	}
	switch (_tokens[next].kind) {
		case TokenKind::Percent:
		case TokenKind::Plus:
		case TokenKind::Minus:
		case TokenKind::Star:
		case TokenKind::Slash:
			return true;
		default:
			return false;
	}
}

uint32_t Parser::parse_body(Chains chains) {
	std::vector<uint32_t> commands;
	Depth depth(*this);
	if (!depth.is_fine()) {
		return add_body(commands);
	}
	while (!_panic && !ends_body(chains, !commands.empty())) {
		if (is_word("case")) {
			commands.push_back(parse_case(chains));
			break;
		}
		if (starts_chance()) {
			commands.push_back(parse_chance(chains));
			break;
		}
		commands.push_back(parse_command());
		if (_panic && is(TokenKind::Colon) && commands.size() > 1) {
			commands.erase(commands.end() - 2); // what stands before it was meant for a condition
		}
	}
	return add_body(commands);
}

uint32_t Parser::parse_branch(uint32_t condition, uint32_t offset, Chains chains) {
	Branch branch;
	branch.condition = condition;
	branch.offset = offset;
	if (condition == no_node) {
		expect(TokenKind::Colon, "after `else`");
	} else {
		expect_condition_end();
	}
	branch.body = parse_body(chains);
	_ast.branches.push_back(branch);
	return uint32_t(_ast.branches.size() - 1);
}

uint32_t Parser::parse_case(Chains chains) {
	Command command;
	command.kind = CommandKind::Case;
	command.offset = peek().offset;
	std::vector<uint32_t> branches;
	const Chains inner = { true, chains.in_chance };
	while (is_word("case") && !_panic) {
		const uint32_t offset = take().offset;
		const uint32_t condition = parse_expression();
		branches.push_back(parse_branch(condition, offset, inner));
	}
	if (is_word("else") && !_panic) {
		const uint32_t offset = take().offset;
		branches.push_back(parse_branch(no_node, offset, inner));
		if (is_word("case") && !chains.in_case && !_panic) {
			error("syntax", peek(), "`case` behind the `else:` of a chain", "put the first chain into brackets: [ case .. else: .. ]");
		}
	}
	command.branches = add_children(branches);
	return add(command);
}

uint32_t Parser::parse_chance(Chains chains) {
	Command command;
	command.kind = CommandKind::Chance;
	command.offset = peek().offset;
	std::vector<uint32_t> branches;
	const Chains inner = { chains.in_case, true };
	while (starts_chance() && !_panic) {
		const uint32_t offset = peek().offset;
		const uint32_t share = parse_binary(0);
		expect(TokenKind::Percent, "after the share of a random choice");
		branches.push_back(parse_branch(share, offset, inner));
	}
	if (is_word("else") && !_panic) {
		const uint32_t offset = take().offset;
		branches.push_back(parse_branch(no_node, offset, inner));
		if (!_panic && starts_chance() && !chains.in_chance) {
			error("syntax", peek(), "a share behind the `else:` of a choice", "put the first choice into brackets: [ 50%: .. else: .. ]");
		}
	}
	command.branches = add_children(branches);
	return add(command);
}

uint32_t Parser::parse_command() {
	if (is(TokenKind::OpenBracket)) {
		return parse_group();
	}
	if (is(TokenKind::Ellipsis)) {
		error("ellipsis", peek(), "`...` stands for something left out: it is not a command",
				"write the commands out, or leave the branch empty");
		take();
		_panic = false;
		return add_nothing();
	}
	if (is_word("inline") && (is(TokenKind::OpenParen, 1) || is(TokenKind::OpenBrace, 1) || is(TokenKind::Name, 1))) {
		return parse_inline();
	}
	if (is(TokenKind::Name)) {
		return parse_call();
	}
	error("syntax", peek(), "expected a command, " + found_text(peek()), is(TokenKind::Or) ? "a single `|` parts the entries of a block" : "");
	return add_nothing();
}

// In place of a command that was diagnosed.
uint32_t Parser::add_nothing() {
	Command nothing;
	nothing.kind = CommandKind::Group;
	nothing.body = add_body({});
	return add(nothing);
}

uint32_t Parser::parse_group() {
	Command command;
	command.kind = CommandKind::Group;
	const uint32_t open = _at;
	command.offset = take().offset;
	const Inside inside(*this, open);
	command.body = parse_body({});
	if (!is(TokenKind::CloseBracket) && !_panic) {
		unexpected("a command or `]`");
	}
	recover_behind(open);
	accept(TokenKind::CloseBracket);
	return add(command);
}

uint32_t Parser::parse_inline() {
	Command command;
	Depth depth(*this);
	if (!depth.is_fine()) {
		command.body = add_body({});
		return add(command);
	}
	command.kind = CommandKind::Inline;
	command.offset = take().offset;
	if (accept(TokenKind::OpenParen)) {
		command.name = take_name("the kind of inlining");
		expect(TokenKind::CloseParen, "after it");
	}
	if (accept(TokenKind::OpenBrace)) {
		const Inside inside(*this, _at - 1);
		command.body = parse_body({});
		expect(TokenKind::CloseBrace, "after the inlined commands");
	} else {
		command.body = add_body({ parse_command() });
	}
	return add(command);
}

uint32_t Parser::parse_call() {
	Command command;
	command.offset = peek().offset;
	command.name = text(take());
	if (is(TokenKind::OpenParen)) {
		if (is_import_call(_at)) {
			return parse_import_call_command(command);
		}
		const uint32_t after = peek().match + 1;
		const bool is_share = peek().match != 0 && !peek().touches_previous && _tokens[after].kind == TokenKind::Percent;
		if (!is_share) {
			command.has_arguments = true;
			command.arguments = add_children(parse_arguments());
		}
	}
	if (is(TokenKind::Name) && !is_keyword(text(peek())) && _dialect.takes_rule(command.name)) {
		command.block = parse_rule_as_block();
	} else if (is(TokenKind::OpenBrace) && !_panic) {
		const bool has_conditions = _dialect.takes_conditions(command.name);
		command.block = parse_block(has_conditions);
		if (accept(TokenKind::Star)) {
			_ast.blocks[command.block].is_repeated = true;
		}
		if (is(TokenKind::OpenBrace) && !_panic) {
			command.second_block = parse_block(has_conditions);
		}
	}
	return add(command);
}

uint32_t Parser::parse_import_call_command(Command command) {
	const uint32_t call = parse_import_call(command.name);
	command.kind = CommandKind::ImportCall;
	command.name = _ast.exprs[call].name;
	command.arguments = _ast.exprs[call].children;
	command.block = _ast.exprs[call].block;
	return add(command);
}

} // namespace pcg
