#include "core/lang/lexer.h"

#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <string>

namespace pcg {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_name_part(char c) { return is_letter(c) || is_digit(c) || c == '$'; }

class Lexer {
public:
	Lexer(const Source &source, bool has_time_units, Diagnostics &diagnostics)
			: _source(source), _text(source.text()), _has_time_units(has_time_units), _diagnostics(diagnostics) {}

	TokenList run();

private:
	char at(size_t offset) const { return offset < _text.size() ? _text[offset] : '\0'; }
	bool starts_with(std::string_view prefix) const { return _text.substr(_at, prefix.size()) == prefix; }
	void error(std::string_view id, size_t offset, std::string message, std::string hint = {});
	void skip_space();
	bool skip_comment();
	void add(TokenKind kind, size_t length);
	void match_bracket(TokenKind kind);
	void close_before_rule();
	void read_name();
	void read_number();
	void read_time(size_t number_end);
	double out_of_range(size_t end);
	void read_string();
	bool read_symbol();
	void read_unknown();
	size_t elementwise_length(size_t dot) const;

	const Source &_source;
	std::string_view _text;
	bool _has_time_units;
	Diagnostics &_diagnostics;
	size_t _at = 0;
	bool _starts_line = true;
	bool _is_done = false;
	uint32_t _error_count = 0;
	std::vector<uint32_t> _open;
	TokenList _list;
};

void Lexer::error(std::string_view id, size_t offset, std::string message, std::string hint) {
	// Megabytes of what no rule file holds need not be told to the end.
	constexpr uint32_t most = 50;
	if (++_error_count >= most) {
		_list.is_cut_short = true;
		_is_done = true;
	}
	_diagnostics.add(_source.diagnostic(Severity::Error, id, uint32_t(offset), std::move(message), std::move(hint)));
}

bool Lexer::skip_comment() {
	if (at(_at) == '#' || starts_with("//")) {
		while (_at < _text.size() && _text[_at] != '\n' && _text[_at] != '\r') {
			++_at;
		}
		return true;
	}
	if (!starts_with("/*")) {
		return false;
	}
	const size_t end = _text.find("*/", _at + 2);
	if (end == std::string_view::npos) {
		error("open-comment", _at, "this comment is never closed", "close it with */");
		_list.is_cut_short = true;
		_at = _text.size();
		return true;
	}
	_starts_line |= _text.substr(_at, end - _at).find('\n') != std::string_view::npos;
	_at = end + 2;
	return true;
}

void Lexer::skip_space() {
	while (_at < _text.size()) {
		const char c = _text[_at];
		if (c == '\n' || c == '\r') {
			_starts_line = true;
			++_at;
		} else if (c == ' ' || c == '\t' || c == '\f' || c == '\v') {
			++_at;
		} else if (!skip_comment()) {
			return;
		}
	}
}

void Lexer::add(TokenKind kind, size_t length) {
	Token token;
	token.kind = kind;
	token.offset = uint32_t(_at);
	token.length = uint32_t(length);
	token.starts_line = _starts_line;
	token.touches_previous = !_list.tokens.empty() && _list.tokens.back().offset + _list.tokens.back().length == _at;
	_list.tokens.push_back(token);
	_starts_line = false;
	_at += length;
	match_bracket(kind);
}

// `Name -->` at the start of a line begins a rule: what is open there was forgotten to be closed, and must not find its partner in a later rule.
// Only the lists behind imports hold rules inside of parentheses.
void Lexer::close_before_rule() {
	const std::vector<Token> &tokens = _list.tokens;
	if (_open.empty() || tokens.size() < 2) {
		return;
	}
	const Token &last = tokens[tokens.size() - 2];
	const Token &name = last.kind == TokenKind::CloseParen && last.match > 0 ? tokens[last.match - 1] : last;
	const bool is_in_import = _open.front() > 0 && tokens[_open.front() - 1].kind == TokenKind::String;
	if (name.kind == TokenKind::Name && name.starts_line && !is_in_import) {
		_open.clear();
	}
}

void Lexer::match_bracket(TokenKind kind) {
	std::vector<Token> &tokens = _list.tokens;
	const uint32_t here = uint32_t(tokens.size() - 1);
	if (kind == TokenKind::Arrow || kind == TokenKind::PaperArrow) {
		close_before_rule();
		return;
	}
	if (kind == TokenKind::OpenParen || kind == TokenKind::OpenBrace || kind == TokenKind::OpenBracket) {
		_open.push_back(here);
		if (_open.size() > max_nesting) {
			error("nested-too-deeply", tokens[here].offset, "brackets nested deeper than " + std::to_string(max_nesting) + " levels",
					"give the inner part a rule or function of its own");
			_list.is_cut_short = true;
			_list.is_too_deep = true;
			_is_done = true;
		}
		return;
	}
	if (kind != TokenKind::CloseParen && kind != TokenKind::CloseBrace && kind != TokenKind::CloseBracket) {
		return;
	}
	const TokenKind opener = TokenKind(uint8_t(kind) - 1);
	for (size_t i = _open.size(); i-- > 0;) {
		if (tokens[_open[i]].kind == opener) {
			tokens[_open[i]].match = here;
			tokens[here].match = _open[i];
			_open.resize(i);
			return;
		}
	}
}

// Of the operator that follows a dot, 0 if none does: `1.==1` is `1 .== 1`, but `Wall.//` is a leaf symbol and a comment.
size_t Lexer::elementwise_length(size_t dot) const {
	const char a = at(dot + 1), b = at(dot + 2);
	if ((a == '=' && b == '=') || (a == '!' && b == '=') || (a == '<' && b == '=') || (a == '>' && b == '=') || (a == '&' && b == '&') ||
			(a == '|' && b == '|')) {
		return 3;
	}
	if (a == '/' && (b == '/' || b == '*')) {
		return 0;
	}
	if (a == '-' && (b == '-' || b == '>')) {
		return 0;
	}
	return a == '+' || a == '-' || a == '*' || a == '/' || a == '%' || a == '<' || a == '>' || a == '!' ? 2 : 0;
}

void Lexer::read_name() {
	size_t end = _at;
	for (;;) {
		while (is_name_part(at(end))) {
			++end;
		}
		if (at(end) != '.' || !is_letter(at(end + 1))) {
			break;
		}
		++end;
	}
	const bool is_leaf = at(end) == '.' && at(end + 1) != '.' && !is_digit(at(end + 1)) && elementwise_length(end) == 0;
	add(TokenKind::Name, end - _at + (is_leaf ? 1 : 0));
}

void Lexer::read_number() {
	size_t end = _at;
	while (is_digit(at(end))) {
		++end;
	}
	if (at(end) == '.' && at(end + 1) != '.' && elementwise_length(end) == 0) {
		++end;
		while (is_digit(at(end))) {
			++end;
		}
	}
	const size_t sign = at(end + 1) == '+' || at(end + 1) == '-' ? 1 : 0;
	if ((at(end) == 'e' || at(end) == 'E') && is_digit(at(end + 1 + sign))) {
		end += 2 + sign;
		while (is_digit(at(end))) {
			++end;
		}
	}
	if (_has_time_units && is_letter(at(end))) {
		read_time(end);
		return;
	}
	const std::string digits(_text.substr(_at, end - _at));
	double value = 0.0;
	const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), value);
	value = parsed.ec == std::errc::result_out_of_range ? out_of_range(end) : value;
	add(TokenKind::Number, end - _at);
	_list.tokens.back().number = value;
}

// Told of the number that ends there, which is none then.
double Lexer::out_of_range(size_t end) {
	error("number-range", _at, "the number `" + std::string(_text.substr(_at, end - _at)) + "` is beyond what a number can hold", "at most about 1e308");
	return NAN;
}

// 8h, 5m, 30s, 8h30m: units from large to small, each once.
void Lexer::read_time(size_t number_end) {
	static constexpr std::array<std::pair<char, double>, 3> units = { { { 'h', 3600.0 }, { 'm', 60.0 }, { 's', 1.0 } } };
	double seconds = 0.0;
	size_t unit = 0;
	size_t start = _at, end = number_end;
	bool is_good = true, is_in_range = true;
	while (is_good) {
		while (unit < units.size() && units[unit].first != at(end)) {
			++unit;
		}
		double value = 0.0;
		is_in_range &= std::from_chars(_text.data() + start, _text.data() + end, value).ec != std::errc::result_out_of_range;
		is_good = unit < units.size();
		if (is_good) {
			seconds += value * units[unit++].second;
			start = ++end;
			while (is_digit(at(end)) || (at(end) == '.' && is_digit(at(end + 1)))) {
				++end;
			}
		}
		if (end == start) {
			break;
		}
	}
	is_good = is_good && !is_name_part(at(end));
	while (is_name_part(at(end))) {
		++end;
	}
	if (!is_good) {
		seconds = NAN;
		error("bad-unit", _at, "`" + std::string(_text.substr(_at, end - _at)) + "` is not a time",
				"units are h, m and s, larger ones first: 8h, 5m, 30s, 8h30m");
	} else if (!is_in_range || !std::isfinite(seconds)) {
		seconds = out_of_range(end);
	}
	add(TokenKind::Number, end - _at);
	_list.tokens.back().number = seconds;
}

void Lexer::read_string() {
	size_t end = _at + 1;
	while (end < _text.size() && _text[end] != '"') {
		end += _text[end] == '\\' ? 2 : 1;
	}
	if (end >= _text.size()) {
		error("open-string", _at, "this text is never closed", "close it with \"");
		_list.is_cut_short = true;
		_is_done = true;
		end = _text.size() - 1;
	}
	add(TokenKind::String, end + 1 - _at);
}

struct Symbol {
	std::string_view text;
	TokenKind kind;
};

// Grouped by first character, longer ones before their beginnings.
constexpr Symbol symbols[] = { { "-->", TokenKind::Arrow }, { "->", TokenKind::PaperArrow }, { "-", TokenKind::Minus },
	{ "...", TokenKind::Ellipsis }, { ".", TokenKind::Dot }, { "==", TokenKind::Equal }, { "=:", TokenKind::ConnectedAssign },
	{ "=", TokenKind::Assign }, { ":=", TokenKind::WithAssign }, { ":", TokenKind::Colon }, { "!=", TokenKind::NotEqual },
	{ "!", TokenKind::Not }, { "<=", TokenKind::LessEqual }, { "<", TokenKind::Less }, { ">=", TokenKind::GreaterEqual },
	{ ">", TokenKind::Greater }, { "&&", TokenKind::And }, { "||", TokenKind::Or }, { "|", TokenKind::Bar }, { "(", TokenKind::OpenParen },
	{ ")", TokenKind::CloseParen }, { "{", TokenKind::OpenBrace }, { "}", TokenKind::CloseBrace }, { "[", TokenKind::OpenBracket },
	{ "]", TokenKind::CloseBracket }, { ",", TokenKind::Comma }, { ";", TokenKind::Semicolon }, { "@", TokenKind::At },
	{ "'", TokenKind::Quote }, { "~", TokenKind::Tilde }, { "+", TokenKind::Plus }, { "*", TokenKind::Star }, { "/", TokenKind::Slash },
	{ "%", TokenKind::Percent }, { "^", TokenKind::Caret } };

// By character: where its group begins, plus one; 0 for characters that begin no symbol.
constexpr std::array<uint8_t, 128> make_symbol_groups() {
	std::array<uint8_t, 128> groups = {};
	for (size_t i = std::size(symbols); i-- > 0;) {
		groups[size_t(symbols[i].text[0])] = uint8_t(i + 1);
	}
	return groups;
}
constexpr std::array<uint8_t, 128> symbol_groups = make_symbol_groups();

bool Lexer::read_symbol() {
	const size_t elementwise = at(_at) == '.' ? elementwise_length(_at) : 0;
	const size_t start = elementwise > 0 ? 1 : 0;
	const uint8_t first = uint8_t(at(_at + start));
	for (size_t i = first < 128 ? symbol_groups[first] : 0; i > 0 && i <= std::size(symbols) && symbols[i - 1].text[0] == char(first); ++i) {
		const Symbol &symbol = symbols[i - 1];
		if (_text.substr(_at + start, symbol.text.size()) == symbol.text && (start == 0 || symbol.text.size() == elementwise - 1)) {
			add(symbol.kind, symbol.text.size() + start);
			_list.tokens.back().is_elementwise = start > 0;
			return true;
		}
	}
	return false;
}

void Lexer::read_unknown() {
	const size_t start = _at;
	const auto is_foreign = [](char c) { return uint8_t(c) >= 0x80; };
	++_at;
	while (is_foreign(_text[start]) && is_foreign(at(_at))) {
		++_at;
	}
	const std::string found(_text.substr(start, _at - start));
	if (is_foreign(found[0])) {
		error("unexpected-character", start, "`" + found + "` can only stand in text and comments", "typographic quotes or dashes?");
	} else {
		const bool is_visible = found[0] > ' ' && found[0] < 0x7F;
		error("unexpected-character", start, is_visible ? "unexpected `" + found + "`" : "unexpected control character");
	}
}

TokenList Lexer::run() {
	_list.tokens.reserve(std::min<size_t>(_text.size() / 4 + 16, 1 << 16));
	for (skip_space(); _at < _text.size() && !_is_done; skip_space()) {
		const char c = _text[_at];
		if (is_letter(c)) {
			read_name();
		} else if (is_digit(c) || (c == '.' && is_digit(at(_at + 1)))) {
			read_number();
		} else if (c == '"') {
			read_string();
		} else if (!read_symbol()) {
			read_unknown();
		}
	}
	_at = std::min(_at, _text.size());
	// "Missing at the end" is best shown behind the last token, not behind the blank lines after it.
	const uint32_t end = _list.tokens.empty() ? 0 : _list.tokens.back().offset + _list.tokens.back().length;
	add(TokenKind::End, 0);
	_list.tokens.back().offset = end;
	_list.tokens.back().touches_previous = false;
	return std::move(_list);
}

} // namespace

TokenList tokenize(const Source &source, bool has_time_units, Diagnostics &diagnostics) {
	return Lexer(source, has_time_units, diagnostics).run();
}

std::string_view token_kind_name(TokenKind kind) {
	switch (kind) {
		case TokenKind::End:
			return "the end of the file";
		case TokenKind::Name:
			return "a name";
		case TokenKind::Number:
			return "a number";
		case TokenKind::String:
			return "text in \"\"";
		default:
			break;
	}
	for (const Symbol &symbol : symbols) {
		if (symbol.kind == kind) {
			return symbol.text;
		}
	}
	return "";
}

} // namespace pcg
