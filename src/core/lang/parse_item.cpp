#include "core/lang/parser.h"

// Items of a file: rules, values, imports, styles, annotations.
namespace pcg {

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
	} else if (is_word("import") && (is_name_next || is(TokenKind::String, 1) || is(TokenKind::At, 1))) {
		parse_import();
	} else if (continues_imports()) {
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

// Until CityEngine 2019 one `import` could stand before several files, with annotations between them.
bool Parser::continues_imports() const {
	if (_ast.imports.empty() || !is(TokenKind::Name)) {
		return false;
	}
	const uint32_t match = is(TokenKind::OpenParen, 1) ? peek(1).match : _at; // of the styles
	const uint32_t colon = match - _at + 1;
	return match >= _at && is(TokenKind::Colon, colon) && is(TokenKind::String, colon + 1);
}

void Parser::parse_import() {
	AstImport import;
	import.offset = peek().offset;
	if (is_word("import") && !is(TokenKind::Colon, 1)) {
		take();
	}
	while (is(TokenKind::At)) {
		parse_annotation();
	}
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
	const Inside inside(*this, open);
	while (!is(TokenKind::CloseParen) && !is(TokenKind::End) && !_panic) {
		overrides.push_back(parse_override());
		if (!is(TokenKind::CloseParen) && !_panic) {
			expect(TokenKind::Comma, "between overrides");
		}
	}
	recover_behind(open);
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
	const Inside inside(*this, _at);
	take();
	while (is(TokenKind::Name) && !_panic) {
		AstLocal local;
		local.offset = peek().offset;
		local.name = take_name("a name");
		expect(TokenKind::WithAssign, "after the name of a local value");
		local.value = parse_expression();
		locals.push_back(local);
		accept(TokenKind::Comma);
	}
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
		parse_value_of(item);
	}
	if (item.value != no_node) {
		_ast.items.push_back(std::move(item));
	}
}

void Parser::parse_value_of(AstItem &item) {
	const uint32_t begin = peek().offset;
	item.value = parse_expression();
	const Token &last = _tokens[_at - 1]; // `=` at least came before
	item.value_text = last.offset >= begin ? _source.text().substr(begin, last.offset + last.length - begin) : std::string_view();
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
		parse_value_of(item);
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
