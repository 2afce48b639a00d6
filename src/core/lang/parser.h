#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/lang/ast.h"
#include "core/lang/dialect.h"
#include "core/lang/lexer.h"
#include "core/lang/source.h"

// Tokens to tree. The grammar is the same for all dialects (CGA reference, section 1.2; PCG language, section 1); what a name is, and whether a
// construct means anything in a dialect, is the compiler's business. After an error the parser goes on at the next place that looks like a
// beginning, and says nothing about what it skipped.
namespace pcg {

// Words that mean something to the grammar where they stand; elsewhere all but `case` and `else` may be names.
constexpr std::string_view keywords[] = { "attr", "case", "const", "else", "extends", "extension", "false", "import", "inline", "start", "style", "true",
	"version", "with" };

Ast parse(const Source &source, const Dialect &dialect, Diagnostics &diagnostics);

class Parser {
public:
	Parser(const Source &source, const TokenList &list, const Dialect &dialect, Diagnostics &diagnostics)
			: _source(source), _list(list), _tokens(list.tokens), _dialect(dialect), _diagnostics(diagnostics) {}
	Ast run();

private:
	// parser.cpp: tokens and errors
	const Token &peek(uint32_t ahead = 0) const { return _tokens[std::min<size_t>(_at + ahead, _tokens.size() - 1)]; }
	bool is(TokenKind kind, uint32_t ahead = 0) const { return peek(ahead).kind == kind; }
	bool is_word(std::string_view word, uint32_t ahead = 0) const { return is(TokenKind::Name, ahead) && text(peek(ahead)) == word; }
	std::string_view text(const Token &token) const { return _source.text().substr(token.offset, token.length); }
	const Token &take() { return _tokens[_at + 1 < _tokens.size() ? _at++ : _at]; }
	bool accept(TokenKind kind);
	bool expect(TokenKind kind, std::string_view where);
	void expect_condition_end();
	void error(std::string_view id, const Token &token, std::string message, std::string hint = {});
	void unexpected(std::string_view wanted);
	std::string found_text(const Token &token) const;
	bool is_keyword(std::string_view name) const;
	std::string_view take_name(std::string_view what);
	NodeRange add_children(const std::vector<uint32_t> &list);

	bool starts_item() const;
	bool starts_definition(uint32_t at) const;
	uint32_t behind_name(uint32_t name) const;
	bool is_with(uint32_t at) const;
	void synchronize();

	// parse_item.cpp
	void parse_item();
	bool parse_keyword_item();
	void parse_version();
	bool continues_imports() const;
	void parse_import();
	void parse_style();
	void parse_value(AstItem::Kind kind);
	void parse_value_of(AstItem &item);
	void parse_definition(bool is_start, bool is_extension);
	void parse_annotation();
	std::vector<AstParam> parse_params();
	std::vector<AstLocal> parse_with();
	std::vector<AstOverride> parse_overrides();
	AstOverride parse_override();

	// parse_body.cpp
	struct Chains { // which chains are open around a body, inside of the innermost bracket
		bool in_case = false;
		bool in_chance = false;
	};
	uint32_t parse_body(Chains chains);
	bool ends_body(const Chains &chains, bool has_commands) const;
	bool starts_chance() const;
	uint32_t parse_case(Chains chains);
	uint32_t parse_chance(Chains chains);
	uint32_t parse_branch(uint32_t condition, uint32_t offset, Chains chains);
	uint32_t parse_command();
	uint32_t add_nothing();
	uint32_t parse_call();
	uint32_t parse_inline();
	uint32_t parse_import_call_command(Command command);
	uint32_t parse_group();
	uint32_t add(Command command);
	uint32_t add_body(const std::vector<uint32_t> &commands);

	// parse_block.cpp
	uint32_t parse_rule_as_block();
	uint32_t parse_block(bool has_conditions);
	void recover_in_block(uint32_t open);
	uint32_t find_separator(bool in_body) const;
	uint32_t parse_entry(bool has_conditions);
	void parse_head(AstEntry &entry);
	void parse_condition(AstEntry &entry);

	// parse_expression.cpp
	uint32_t parse_expression();
	uint32_t parse_case_expression();
	uint32_t parse_chance_expression(uint32_t share);
	uint32_t parse_binary(int lowest);
	uint32_t parse_unary();
	uint32_t parse_postfix();
	uint32_t parse_primary();
	bool is_compared_wrongly() const;
	uint32_t parse_name();
	std::vector<uint32_t> parse_arguments();
	bool is_import_call(uint32_t open) const;
	uint32_t parse_import_call(std::string_view name);
	std::string_view decode_string(const Token &token);
	uint32_t add(Expr expr);
	uint32_t error_expr();

	// parse_array.cpp
	uint32_t parse_components(Expr call);
	uint32_t parse_array();
	uint32_t parse_array_row(uint32_t offset);
	uint32_t parse_array_element();

	// Counts how deep the parser is in its own calls: chains of `case`, minus signs and the like nest without brackets.
	// A bracket costs up to three of these levels, so brackets reach their own limit first.
	static constexpr uint32_t max_depth = 3 * max_nesting + 20;
	class Depth {
	public:
		explicit Depth(Parser &parser) : _parser(parser) { ++_parser._depth; }
		~Depth() { --_parser._depth; }
		// False, with an error, when it is too deep to go on.
		bool is_fine();

	private:
		Parser &_parser;
	};

	// The inside of a bracket, where no item can begin; one that is never closed does not count.
	class Inside {
	public:
		Inside(Parser &parser, uint32_t open) : _parser(parser), _count(parser._tokens[open].match != 0 ? 1 : 0) {
			_parser._brackets += _count;
		}
		~Inside() { _parser._brackets -= _count; }

	private:
		Parser &_parser;
		uint32_t _count;
	};
	void recover_behind(uint32_t open);

	const Source &_source;
	const TokenList &_list;
	const std::vector<Token> &_tokens;
	const Dialect &_dialect;
	Diagnostics &_diagnostics;
	Ast _ast;
	uint32_t _at = 0;
	uint32_t _brackets = 0; // open ones: inside of them no item can begin
	uint32_t _depth = 0;
	uint32_t _error_count = 0;
	bool _panic = false; // after an error, until the parser has found a beginning again
	std::vector<AstAnnotation> _annotations; // of the item to come
};

} // namespace pcg
