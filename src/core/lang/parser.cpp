#include "core/lang/parser.h"

#include <algorithm>

namespace pcg {

Ast parse(const Source &source, bool has_time_units, Diagnostics &diagnostics) {
	const TokenList list = tokenize(source, has_time_units, diagnostics);
	return Parser(source, list, diagnostics).run();
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
	std::string found(text(token).substr(0, 40));
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

// ID --> | ID = | ID (..) --> | ID (..) = | the same with `with (` in between.
bool Parser::starts_definition(uint32_t at) const {
	if (_tokens[at].kind != TokenKind::Name || is_keyword(text(_tokens[at]))) {
		return false;
	}
	uint32_t next = at + 1;
	if (next < _tokens.size() && _tokens[next].kind == TokenKind::OpenParen && _tokens[next].match != 0) {
		next = _tokens[next].match + 1;
	}
	if (next >= _tokens.size()) {
		return false;
	}
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
	if (names_follow && (word == "attr" || word == "const" || word == "import" || word == "style" || word == "start" ||
								word == "extension")) {
		return true;
	}
	if (is(TokenKind::String, 1) && (word == "version" || word == "import")) {
		return true;
	}
	return starts_definition(_at);
}

// Skips to something that can only be the beginning of an item: a keyword, an annotation, `Name -->`, or `name =` at the start of a line.
void Parser::synchronize() {
	_panic = false;
	_brackets = 0;
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

void Parser::parse_item() {
	if (is(TokenKind::At)) {
		parse_annotation();
		return;
	}
	if (parse_keyword_item()) {
		return;
	}
	if (starts_definition(_at)) {
		parse_definition(false, false);
		return;
	}
	if (is(TokenKind::Name)) {
		const Token &name = take();
		if (is(TokenKind::OpenParen) && peek().match == 0) {
			error("syntax", peek(), "this `(` is never closed");
			return;
		}
		error("syntax", peek(), "expected `-->` or `=` after `" + std::string(text(name)) + "`, " + found_text(peek()),
				"a rule: Name --> commands; a value: name = expression");
		return;
	}
	unexpected("a rule, a value or an import");
	take();
}

bool Parser::parse_keyword_item() {
	const bool is_name_next = is(TokenKind::Name, 1) && !is_keyword(text(peek(1)));
	if (is_word("version") && is(TokenKind::String, 1)) {
		parse_version();
	} else if (is_word("import") && (is_name_next || is(TokenKind::String, 1))) {
		parse_import();
	} else if (is_word("style") && is_name_next) {
		parse_style();
	} else if (is_word("attr") && is_name_next) {
		take();
		parse_value(AstItem::Kind::Attribute);
	} else if (is_word("const") && is_name_next) {
		take();
		parse_value(AstItem::Kind::Constant);
	} else if (is_word("start") && is_name_next) {
		take();
		parse_definition(true, false);
	} else if (is_word("extension") && is_name_next) {
		take();
		parse_definition(false, true);
	} else {
		return false;
	}
	return true;
}

void Parser::parse_version() {
	take();
	_ast.version = decode_string(take());
}

void Parser::parse_style() {
	AstStyle style;
	style.offset = take().offset;
	style.name = take_name("the name of the style");
	if (is_word("extends")) {
		take();
		style.base = take_name("the name of a style");
	}
	_ast.styles.push_back(style);
	_annotations.clear();
}

void Parser::parse_import() {
	AstImport import;
	import.offset = take().offset;
	import.annotations = std::move(_annotations);
	_annotations.clear();
	if (!is(TokenKind::String)) {
		import.id = take_name("a name for the import");
		if (accept(TokenKind::OpenParen)) {
			do {
				import.styles.push_back(take_name("the name of a style"));
			} while (accept(TokenKind::Comma));
			expect(TokenKind::CloseParen, "after the styles");
		}
		expect(TokenKind::Colon, "before the file of the import");
	}
	import.path_offset = peek().offset;
	if (!is(TokenKind::String)) {
		unexpected("the file of the import as text, as in import id : \"file\"");
		return;
	}
	import.path = std::string(decode_string(take()));
	import.has_override_list = is(TokenKind::OpenParen);
	if (import.has_override_list) {
		import.overrides = parse_overrides();
	}
	if (!_panic) {
		_ast.imports.push_back(std::move(import));
	}
}

std::vector<AstOverride> Parser::parse_overrides() {
	std::vector<AstOverride> overrides;
	const uint32_t open = _at;
	take();
	++_brackets;
	while (!is(TokenKind::CloseParen) && !is(TokenKind::End) && !_panic) {
		overrides.push_back(parse_override());
		if (!is(TokenKind::CloseParen) && !_panic) {
			expect(TokenKind::Comma, "between overrides");
		}
	}
	--_brackets;
	if (_panic && _tokens[open].match != 0) {
		_at = _tokens[open].match;
		_panic = false;
	}
	expect(TokenKind::CloseParen, "after the overrides");
	return overrides;
}

AstOverride Parser::parse_override() {
	AstOverride result;
	result.offset = peek().offset;
	result.name = take_name("the name of an attribute or rule");
	if (is(TokenKind::OpenParen)) {
		result.params = parse_params();
	}
	if (accept(TokenKind::Assign)) {
		result.value = parse_expression();
	} else if (accept(TokenKind::Arrow) || accept(TokenKind::PaperArrow)) {
		result.body = parse_body({});
	}
	return result;
}

std::vector<AstParam> Parser::parse_params() {
	std::vector<AstParam> params;
	take();
	while (is(TokenKind::Name) && !_panic) {
		AstParam param;
		param.offset = peek().offset;
		param.name = take_name("the name of a parameter");
		for (const AstParam &other : params) {
			if (other.name == param.name) {
				error("duplicate-name", _tokens[_at - 1], "two parameters are called `" + std::string(param.name) + "`");
			}
		}
		params.push_back(param);
		if (!accept(TokenKind::Comma)) {
			break;
		}
		if (!is(TokenKind::Name)) {
			unexpected("the name of a parameter");
		}
	}
	expect(TokenKind::CloseParen, "after the parameters");
	return params;
}

std::vector<AstLocal> Parser::parse_with() {
	std::vector<AstLocal> locals;
	take();
	take();
	++_brackets;
	while (is(TokenKind::Name) && !_panic) {
		AstLocal local;
		local.offset = peek().offset;
		local.name = take_name("a name");
		expect(TokenKind::WithAssign, "after the name of a local value");
		local.value = parse_expression();
		locals.push_back(local);
		accept(TokenKind::Comma);
	}
	--_brackets;
	expect(TokenKind::CloseParen, "after the local values");
	return locals;
}

void Parser::parse_value(AstItem::Kind kind) { // attr and const
	AstItem item;
	item.kind = kind;
	item.offset = peek().offset;
	item.annotations = std::move(_annotations);
	item.style = _ast.styles.empty() ? no_node : uint32_t(_ast.styles.size() - 1);
	_annotations.clear();
	item.name = take_name("a name");
	if (is(TokenKind::OpenParen)) {
		item.has_params = true;
		item.params = parse_params();
	}
	if (is_with(_at)) {
		item.locals = parse_with();
	}
	if (!_panic && expect(TokenKind::Assign, "after the name of a value")) {
		item.value = parse_expression();
	}
	if (item.value != no_node) {
		_ast.items.push_back(std::move(item));
	}
}

void Parser::parse_definition(bool is_start, bool is_extension) { // rules, plain values, functions
	AstItem item;
	item.is_start = is_start;
	item.is_extension = is_extension;
	item.offset = peek().offset;
	item.annotations = std::move(_annotations);
	item.style = _ast.styles.empty() ? no_node : uint32_t(_ast.styles.size() - 1);
	_annotations.clear();
	item.name = take_name("the name of a rule");
	if (is(TokenKind::OpenParen)) {
		item.has_params = true;
		item.params = parse_params();
	}
	if (!_panic && is_with(_at)) {
		item.locals = parse_with();
	}
	if (_panic) {
		return;
	}
	item.has_paper_arrow = is(TokenKind::PaperArrow);
	if (accept(TokenKind::Arrow) || accept(TokenKind::PaperArrow)) {
		item.kind = AstItem::Kind::Rule;
		item.body = parse_body({});
	} else if (is_start || is_extension) {
		expect(TokenKind::Arrow, "after the name of a rule");
	} else if (expect(TokenKind::Assign, "after the name of a value")) {
		item.kind = AstItem::Kind::Plain;
		item.value = parse_expression();
	}
	// A rule whose body went wrong is still there: its callers are not wrong because of that.
	if (item.body != no_node || item.value != no_node) {
		_ast.items.push_back(std::move(item));
	}
}

// The arguments are kept as text: they describe, they do not compute.
void Parser::parse_annotation() {
	AstAnnotation annotation;
	annotation.offset = take().offset;
	annotation.name = take_name("the name of an annotation");
	if (is(TokenKind::OpenParen) && !_panic) {
		const uint32_t close = peek().match;
		if (close == 0) {
			error("syntax", peek(), "this `(` is never closed");
			return;
		}
		for (uint32_t start = _at + 1; start < close;) {
			uint32_t end = start;
			while (end < close && _tokens[end].kind != TokenKind::Comma) {
				const bool opens = _tokens[end].match > end;
				end = (opens ? _tokens[end].match : end) + 1;
			}
			if (end == start + 1 && _tokens[start].kind == TokenKind::String) {
				annotation.arguments.emplace_back(decode_string(_tokens[start]));
			} else if (end > start) {
				const Token &last = _tokens[end - 1];
				annotation.arguments.emplace_back(
						_source.text().substr(_tokens[start].offset, last.offset + last.length - _tokens[start].offset));
			}
			start = end + 1;
		}
		_at = close + 1;
	}
	if (!_panic) {
		_annotations.push_back(std::move(annotation));
	}
}

} // namespace pcg
