#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/lang/source.h"

// Text to tokens. White space, line breaks and comments only separate them (PCG language, section 1; CGA reference, section 1.1).
namespace pcg {

enum class TokenKind : uint8_t {
	End,
	Name, // dots inside belong to it: scope.sx, imp.Rule; a leaf symbol ends in one: Wall.
	Number,
	String,
	Arrow, // -->
	PaperArrow, // ->
	OpenParen,
	CloseParen,
	OpenBrace,
	CloseBrace,
	OpenBracket,
	CloseBracket,
	Comma,
	Semicolon,
	Colon,
	Bar,
	Assign, // =
	ConnectedAssign, // =: of component selectors
	WithAssign, // :=
	At,
	Quote, // ' relative
	Tilde, // ~ flexible
	Dot, // before the rule of a dynamic import: imp(a = 1).Rule
	Ellipsis,
	Caret, // in annotations: shape=Name^2
	// Operators from here on; the element-wise ones of arrays carry `is_elementwise`.
	Plus,
	Minus,
	Star,
	Slash,
	Percent,
	Not,
	And,
	Or,
	Equal,
	NotEqual,
	Less,
	LessEqual,
	Greater,
	GreaterEqual,
};

struct Token {
	TokenKind kind = TokenKind::End;
	bool touches_previous = false;
	bool starts_line = false;
	bool is_elementwise = false;
	uint32_t offset = 0;
	uint32_t length = 0;
	uint32_t match = 0; // of a bracket: index of its partner; 0 if it has none
	double number = 0.0; // of a Number, in seconds if it carries a unit; NaN: it is none, which was told
};

struct TokenList {
	std::vector<Token> tokens; // the last one is End
	bool is_too_deep = false; // brackets beyond max_nesting: not worth parsing
	bool is_cut_short = false; // the lexer gave up and has said why: what the parser misses at the end follows from that
};

// Brackets deeper than this are refused: no rule needs them, and a parser that follows them runs out of stack.
constexpr uint32_t max_nesting = 100;

TokenList tokenize(const Source &source, bool has_time_units, Diagnostics &diagnostics);

// "`-->`", "a name": for messages.
std::string_view token_kind_name(TokenKind kind);

} // namespace pcg
