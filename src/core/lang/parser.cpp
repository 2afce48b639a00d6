#include "core/lang/parser.h"

#include <algorithm>

#include "core/base/utf8.h"

namespace pcg {

Ast parse(const Source &source, const Dialect &dialect, Diagnostics &diagnostics) {
	const TokenList list = tokenize(source, dialect.has_time_units, diagnostics);
	if (list.is_too_deep) {
		Ast nothing;
		nothing.is_abandoned = true;
		return nothing;
	}
	return Parser(source, list, dialect, diagnostics).run();
}

// --- Tokens and errors

bool Parser::accept(TokenKind kind) {
	if (!is(kind)) {
		return false;
	}
	take();
	return true;
}

std::string Parser::found_text(const Token &token) const {
	if (token.kind == TokenKind::End) {
		return "the file ends";
	}
	const std::string found(first_bytes(text(token), 40));
	return "found `" + found.substr(0, found.find('\n')) + "`";
}

void Parser::error(std::string_view id, const Token &token, std::string message, std::string hint) {
	const bool follows_from_lexer = _list.is_cut_short && token.kind == TokenKind::End;
	if (!_panic && !follows_from_lexer) {
		_diagnostics.add(_source.diagnostic(Severity::Error, id, token.offset, std::move(message), std::move(hint)));
	}
	_panic = true;
	// What has so many mistakes is no rule file; the first ones tell why.
	constexpr uint32_t most = 100;
	if (++_error_count >= most) {
		_at = uint32_t(_tokens.size() - 1);
	}
}

void Parser::unexpected(std::string_view wanted) {
	error("syntax", peek(), "expected " + std::string(wanted) + ", " + found_text(peek()));
}

bool Parser::expect(TokenKind kind, std::string_view where) {
	if (accept(kind)) {
		return true;
	}
	unexpected("`" + std::string(token_kind_name(kind)) + "` " + std::string(where));
	return false;
}

// Of a `case`, or of an entry of a block.
void Parser::expect_condition_end() {
	if (is(TokenKind::Assign)) {
		error("syntax", peek(), "expected `==`, found `=`", "two values are compared with `==`");
	} else {
		expect(TokenKind::Colon, "after the condition");
	}
}

bool Parser::is_keyword(std::string_view name) const { return name == "case" || name == "else"; }

std::string_view Parser::take_name(std::string_view what) {
	const std::string_view name = is(TokenKind::Name) ? text(peek()) : std::string_view();
	if (name.empty() || is_keyword(name) || name.ends_with('.')) {
		unexpected(what);
		return {};
	}
	take();
	return name;
}

bool Parser::Depth::is_fine() {
	if (_parser._depth <= max_depth) {
		return true;
	}
	_parser.error("nested-too-deeply", _parser.peek(), "nested deeper than " + std::to_string(max_depth) + " levels",
			"give the inner part a rule or function of its own");
	return false;
}

// After a mistake inside of a bracket that is closed, the parser goes on behind it.
void Parser::recover_behind(uint32_t open) {
	if (_panic && _tokens[open].match != 0) {
		_at = std::max(_at, _tokens[open].match);
		_panic = false;
	}
}

NodeRange Parser::add_children(const std::vector<uint32_t> &list) {
	const NodeRange range = { uint32_t(_ast.children.size()), uint32_t(list.size()) };
	_ast.children.insert(_ast.children.end(), list.begin(), list.end());
	return range;
}

// --- Items

Ast Parser::run() {
	while (!is(TokenKind::End)) {
		const size_t item_count = _ast.items.size() + _ast.imports.size();
		const uint32_t begin = _at;
		parse_item();
		if (_panic) {
			const bool is_lost = _ast.items.size() + _ast.imports.size() == item_count;
			synchronize();
			for (uint32_t i = begin; i < _at && is_lost && i < begin + 3; ++i) {
				if (_tokens[i].kind == TokenKind::Name) {
					_ast.lost_names.push_back(text(_tokens[i]));
				}
			}
		}
	}
	if (!_annotations.empty() && !_list.is_cut_short && _annotations.back().name != "Group") {
		_diagnostics.add(_source.diagnostic(Severity::Warning, "annotation-without-item", _annotations.back().offset,
				"nothing follows this annotation", "annotations stand in front of a rule, an attribute or an import"));
	}
	return std::move(_ast);
}

bool Parser::is_with(uint32_t at) const {
	return at + 1 < _tokens.size() && _tokens[at].kind == TokenKind::Name && text(_tokens[at]) == "with" &&
			_tokens[at + 1].kind == TokenKind::OpenParen;
}

// What stands behind a name and its parameters.
uint32_t Parser::behind_name(uint32_t name) const {
	const uint32_t next = name + 1; // the end of the file at most
	return _tokens[next].kind == TokenKind::OpenParen && _tokens[next].match != 0 ? _tokens[next].match + 1 : next;
}

// ID --> | ID = | ID (..) --> | ID (..) = | the same with `with (` in between.
bool Parser::starts_definition(uint32_t at) const {
	if (_tokens[at].kind != TokenKind::Name || is_keyword(text(_tokens[at]))) {
		return false;
	}
	const uint32_t next = behind_name(at);
	const TokenKind kind = _tokens[next].kind;
	return kind == TokenKind::Arrow || kind == TokenKind::PaperArrow || kind == TokenKind::Assign || is_with(next);
}

bool Parser::starts_item() const {
	if (is(TokenKind::At) || is(TokenKind::End)) {
		return true;
	}
	if (!is(TokenKind::Name) || _brackets > 0) {
		return false;
	}
	const std::string_view word = text(peek());
	const bool names_follow = is(TokenKind::Name, 1) && !is_keyword(text(peek(1)));
	if (names_follow && (word == "attr" || word == "const" || word == "import" || word == "style")) {
		return true;
	}
	if (names_follow && (word == "start" || word == "extension")) { // old files have rules of these names
		const bool ends_line = peek(1).starts_line && !peek().starts_line; // a call of such a rule, and the next rule below it
		return !ends_line && starts_definition(_at + 1);
	}
	if (is(TokenKind::String, 1) && (word == "version" || word == "import")) {
		return true;
	}
	return starts_definition(_at);
}

// Skips to something that can only be the beginning of an item: a keyword, an annotation, `Name -->`, or `name =` at the start of a line.
void Parser::synchronize() {
	_panic = false;
	_annotations.clear();
	const uint32_t begin = _at;
	while (!is(TokenKind::End)) {
		const bool is_new = _at > begin || peek().starts_line;
		if (is_new && starts_item() && (peek().starts_line || is(TokenKind::At))) {
			return;
		}
		take();
	}
}

} // namespace pcg
