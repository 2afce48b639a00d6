#include <algorithm>
#include <cmath>

#include "core/lang/parser.h"

// Expressions, by precedence climbing.
namespace pcg {

namespace {

// 0 for what is no binary operator.
int precedence(TokenKind kind) {
	switch (kind) {
		case TokenKind::Or:
			return 1;
		case TokenKind::And:
			return 2;
		case TokenKind::Equal:
		case TokenKind::NotEqual:
			return 3;
		case TokenKind::Less:
		case TokenKind::LessEqual:
		case TokenKind::Greater:
		case TokenKind::GreaterEqual:
			return 4;
		case TokenKind::Plus:
		case TokenKind::Minus:
			return 5;
		case TokenKind::Star:
		case TokenKind::Slash:
		case TokenKind::Percent:
			return 6;
		default:
			return 0;
	}
}

void append_utf8(std::string &text, uint32_t code) {
	if (code < 0x80) {
		text += char(code);
	} else if (code < 0x800) {
		text += char(0xC0 | (code >> 6));
		text += char(0x80 | (code & 0x3F));
	} else {
		text += char(0xE0 | (code >> 12));
		text += char(0x80 | ((code >> 6) & 0x3F));
		text += char(0x80 | (code & 0x3F));
	}
}

// The four digits of \uXXXX; false if they are not there.
bool read_code(std::string_view digits, uint32_t &code) {
	code = 0;
	for (char c : digits) {
		const int digit = c >= '0' && c <= '9' ? c - '0' : (c >= 'a' && c <= 'f' ? c - 'a' + 10 : (c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1));
		if (digit < 0) {
			return false;
		}
		code = code * 16 + uint32_t(digit);
	}
	return digits.size() == 4;
}

} // namespace

uint32_t Parser::add(Expr expr) {
	_ast.exprs.push_back(expr);
	return uint32_t(_ast.exprs.size() - 1);
}

uint32_t Parser::error_expr() {
	Expr expr;
	expr.offset = peek().offset;
	return add(expr);
}

std::string_view Parser::decode_string(const Token &token) {
	const std::string_view raw = text(token).substr(1, token.length >= 2 ? token.length - 2 : 0);
	if (raw.find('\\') == std::string_view::npos) {
		return raw;
	}
	std::string decoded;
	for (size_t i = 0; i < raw.size(); ++i) {
		if (raw[i] != '\\' || i + 1 == raw.size()) {
			decoded += raw[i];
			continue;
		}
		const char escape = raw[++i];
		uint32_t code = 0;
		if (escape == 'n' || escape == 't') {
			decoded += escape == 'n' ? '\n' : '\t';
		} else if (escape == 'u' && read_code(raw.substr(i + 1, 4), code)) {
			append_utf8(decoded, code);
			i += 4;
		} else if (escape == '"' || escape == '\\') {
			decoded += escape;
		} else { // Windows paths in old files: "assets\door.obj"
			decoded += '\\';
			decoded += escape;
		}
	}
	_ast.texts.push_back(std::move(decoded));
	return _ast.texts.back();
}

uint32_t Parser::parse_expression() {
	Depth depth(*this);
	if (_panic || !depth.is_fine()) {
		return error_expr();
	}
	if (is(TokenKind::Quote) || is(TokenKind::Tilde)) {
		Expr size;
		size.kind = ExprKind::Size;
		size.size_kind = is(TokenKind::Quote) ? SizeKind::Relative : SizeKind::Flexible;
		size.offset = take().offset;
		size.children = add_children({ parse_expression() });
		return add(size);
	}
	if (is_word("case")) {
		return parse_case_expression();
	}
	const uint32_t value = parse_binary(0);
	if (is(TokenKind::Percent) && is(TokenKind::Colon, 1) && !_panic) {
		return parse_chance_expression(value);
	}
	return value;
}

uint32_t Parser::parse_case_expression() {
	Expr chain;
	chain.kind = ExprKind::Case;
	chain.offset = peek().offset;
	std::vector<uint32_t> children;
	while (is_word("case") && !_panic) {
		take();
		children.push_back(parse_expression());
		expect_condition_end();
		children.push_back(parse_expression());
	}
	if (!is_word("else")) {
		unexpected("`case` or `else`: a value is needed whatever holds");
		return error_expr();
	}
	take();
	expect(TokenKind::Colon, "after `else`");
	children.push_back(parse_expression());
	chain.children = add_children(children);
	return add(chain);
}

uint32_t Parser::parse_chance_expression(uint32_t share) {
	Expr chain;
	chain.kind = ExprKind::Chance;
	chain.offset = _ast.exprs[share].offset;
	std::vector<uint32_t> children;
	for (;;) {
		take();
		take();
		children.push_back(share);
		children.push_back(parse_expression());
		if (is_word("else") || _panic) {
			break;
		}
		share = parse_binary(0);
		if (!is(TokenKind::Percent) || !is(TokenKind::Colon, 1)) {
			unexpected("another share such as `30%:`, or `else`");
			return error_expr();
		}
	}
	take();
	expect(TokenKind::Colon, "after `else`");
	children.push_back(parse_expression());
	chain.children = add_children(children);
	return add(chain);
}

uint32_t Parser::parse_binary(int lowest) {
	uint32_t left = parse_unary();
	while (!_panic) {
		const TokenKind op = peek().kind;
		const int level = precedence(op);
		const bool ends_share = op == TokenKind::Percent && is(TokenKind::Colon, 1);
		if (level == 0 || level <= lowest || ends_share) {
			break;
		}
		Expr binary;
		binary.kind = ExprKind::Binary;
		binary.op = op;
		binary.is_elementwise = peek().is_elementwise;
		binary.offset = take().offset;
		binary.children = add_children({ left, parse_binary(level) });
		left = add(binary);
	}
	return left;
}

uint32_t Parser::parse_unary() {
	if (!is(TokenKind::Minus) && !is(TokenKind::Not) && !is(TokenKind::Plus)) {
		return parse_postfix();
	}
	Depth depth(*this);
	if (!depth.is_fine()) {
		return error_expr();
	}
	Expr unary;
	unary.kind = ExprKind::Unary;
	unary.op = peek().kind;
	unary.is_elementwise = peek().is_elementwise;
	unary.offset = take().offset;
	unary.children = add_children({ parse_unary() });
	return add(unary);
}

// An index binds only where it touches: `f = a` and `[` on the next line stay apart.
uint32_t Parser::parse_postfix() {
	uint32_t value = parse_primary();
	for (uint32_t count = 0; is(TokenKind::OpenBracket) && peek().touches_previous && !_panic; ++count) {
		if (count > max_nesting) {
			error("nested-too-deeply", peek(), "more than " + std::to_string(max_nesting) + " indices");
			break;
		}
		Expr index;
		index.kind = ExprKind::Index;
		const Inside inside(*this, _at);
		index.offset = take().offset;
		std::vector<uint32_t> children = { value, parse_array_element() };
		while (accept(TokenKind::Comma)) {
			children.push_back(parse_array_element());
		}
		expect(TokenKind::CloseBracket, "after the index");
		index.children = add_children(children);
		value = add(index);
	}
	return value;
}

uint32_t Parser::parse_primary() {
	Expr expr;
	expr.offset = peek().offset;
	switch (peek().kind) {
		case TokenKind::Number:
			expr.number = take().number;
			expr.kind = std::isnan(expr.number) ? ExprKind::Error : ExprKind::Number;
			return add(expr);
		case TokenKind::String:
			expr.kind = ExprKind::Text;
			expr.name = decode_string(take());
			return add(expr);
		case TokenKind::OpenParen: {
			const Inside inside(*this, _at);
			take();
			const uint32_t inner = parse_expression();
			expect(TokenKind::CloseParen, "after the expression");
			return inner;
		}
		case TokenKind::OpenBracket:
			return parse_array();
		case TokenKind::Name:
			if (!is_keyword(text(peek())) && (!starts_item() || is_compared_wrongly())) {
				return parse_name();
			}
			break;
		default:
			break;
	}
	unexpected("a value");
	return error_expr();
}

// `case a = b:` stands in one line; a value begins one.
bool Parser::is_compared_wrongly() const { return !peek().starts_line && _tokens[behind_name(_at)].kind == TokenKind::Assign; }

uint32_t Parser::parse_name() {
	Expr expr;
	expr.offset = peek().offset;
	expr.name = text(take());
	if (!is(TokenKind::OpenParen)) {
		expr.kind = ExprKind::Name;
		return add(expr);
	}
	if (is_import_call(_at)) {
		return parse_import_call(expr.name);
	}
	expr.kind = ExprKind::Call;
	expr.children = add_children(parse_arguments());
	if (expr.name == "comp" && is(TokenKind::OpenBrace)) {
		return parse_components(expr);
	}
	return add(expr);
}

// After an error inside of the parentheses the parser goes on behind them.
std::vector<uint32_t> Parser::parse_arguments() {
	std::vector<uint32_t> arguments;
	const uint32_t open = _at;
	take();
	const Inside inside(*this, open);
	if (!is(TokenKind::CloseParen)) {
		do {
			arguments.push_back(parse_expression());
		} while (!_panic && accept(TokenKind::Comma));
	}
	if (!is(TokenKind::CloseParen) && !_panic) {
		unexpected("`,` or `)`");
	}
	if (_panic) { // Whoever counts the arguments sees that they are not what was meant.
		arguments.push_back(error_expr());
	}
	recover_behind(open);
	accept(TokenKind::CloseParen);
	return arguments;
}

bool Parser::is_import_call(uint32_t open) const {
	const uint32_t close = _tokens[open].match;
	return close != 0 && _tokens[close + 1].kind == TokenKind::Dot && _tokens[close + 1].touches_previous;
}

uint32_t Parser::parse_import_call(std::string_view name) {
	Expr call;
	call.kind = ExprKind::ImportCall;
	call.offset = peek().offset;
	AstImportCall import_call;
	import_call.import = name;
	import_call.overrides = parse_overrides();
	take();
	call.name = take_name("a rule or function of the import");
	if (is(TokenKind::OpenParen) && !_panic) {
		call.children = add_children(parse_arguments());
	}
	_ast.import_calls.push_back(std::move(import_call));
	call.block = uint32_t(_ast.import_calls.size() - 1);
	return add(call);
}

} // namespace pcg
