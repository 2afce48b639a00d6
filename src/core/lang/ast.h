#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/lang/lexer.h"
#include "core/lang/value.h"

// One file as it was written: nodes by index in flat arrays, names as views of the source. CGA reference, section 1.2.
namespace pcg {

constexpr uint32_t no_node = 0xFFFFFFFF;

// A run of children in Ast::children.
struct NodeRange {
	uint32_t first = 0;
	uint32_t count = 0;
};

enum class ExprKind : uint8_t {
	Error, // was diagnosed
	Number,
	Text,
	Name, // also true, false and words such as `front`
	Call, // children: arguments
	Unary, // `op`: Minus, Plus or Not
	Binary,
	Case, // children: condition, value, condition, value .. value; the last one is the else
	Chance, // the same with shares in percent
	Size, // '0.5 and ~1 in front of a whole expression
	Array, // children: rows, each an Array of elements
	Element, // a:b:c inside of an array: children 2 or 3
	Index, // children: array, index
	Components, // comp(fe) { selector : expr | .. }: children: kind and options; `block`
	ImportCall, // imp(a = 1).f(x): `name` the import, `block` the index in Ast::import_calls
};

struct Expr {
	ExprKind kind = ExprKind::Error;
	TokenKind op = TokenKind::End;
	SizeKind size_kind = SizeKind::Absolute;
	bool is_elementwise = false;
	uint32_t offset = 0; // in the source
	uint32_t block = no_node;
	NodeRange children;
	double number = 0.0;
	std::string_view name; // of Name and Call; the decoded text of Text
};

enum class CommandKind : uint8_t {
	Call, // rule, operation or NIL; `arguments`, `block`, `second_block`
	Group, // [ body ]
	Case, // `branches`; the last one has no condition if there is an else
	Chance,
	Inline, // `body`
	ImportCall, // imp(a = 1).Rule(x): `block` is the index in Ast::import_calls
};

struct Command {
	CommandKind kind = CommandKind::Call;
	bool has_arguments = false; // parentheses were written
	uint32_t offset = 0;
	std::string_view name;
	NodeRange arguments; // Exprs
	NodeRange branches; // indices in Ast::branches
	uint32_t block = no_node;
	uint32_t second_block = no_node;
	uint32_t body = no_node;
};

struct Branch {
	uint32_t condition = no_node; // no_node: else
	uint32_t body = no_node;
	uint32_t offset = 0;
};

struct AstBody {
	NodeRange commands;
};

struct AstEntry {
	enum class Kind : uint8_t { Body, Repeat, Group } kind = Kind::Body;
	TokenKind separator = TokenKind::Colon; // Colon, Assign or ConnectedAssign
	uint32_t offset = 0;
	uint32_t head = no_node; // Expr; no_node: the entry is a body alone
	uint32_t depth = no_node; // Expr: size : depth : body
	uint32_t body = no_node; // in Components an Expr
	uint32_t block = no_node; // of Repeat and Group
};

struct AstBlock {
	NodeRange entries;
	bool is_repeated = false;
	uint32_t offset = 0;
};

struct AstAnnotation {
	std::string_view name;
	std::vector<std::string> arguments;
	uint32_t offset = 0;
};

struct AstLocal { // with ( name := value )
	std::string_view name;
	uint32_t value = no_node;
	uint32_t offset = 0;
};

struct AstParam {
	std::string_view name;
	uint32_t offset = 0;
};

struct AstItem {
	enum class Kind : uint8_t { Rule, Attribute, Constant, Plain } kind = Kind::Rule;
	bool has_params = false; // Plain and Constant: a function
	bool is_start = false; // start Name --> ..
	bool is_extension = false;
	bool has_paper_arrow = false;
	uint32_t offset = 0;
	std::string_view name;
	uint32_t style = no_node; // index in Ast::styles
	std::vector<AstParam> params;
	std::vector<AstLocal> locals;
	std::vector<AstAnnotation> annotations;
	uint32_t value = no_node; // Expr, of all but rules
	std::string_view value_text; // the value as it was written
	uint32_t body = no_node; // of rules
};

// In `import id : "file" (name, name = expr, Rule --> body)` and in dynamic import calls.
struct AstOverride {
	std::string_view name;
	uint32_t offset = 0;
	uint32_t value = no_node; // Expr
	uint32_t body = no_node;
	std::vector<AstParam> params;
	bool is_protected() const { return value == no_node && body == no_node; }
};

struct AstImport {
	std::string_view id; // empty: into the same space
	std::string path;
	uint32_t offset = 0;
	uint32_t path_offset = 0;
	bool has_override_list = false; // "()" alone protects everything
	std::vector<std::string_view> styles;
	std::vector<AstOverride> overrides;
	std::vector<AstAnnotation> annotations;
};

struct AstStyle {
	std::string_view name;
	std::string_view base;
	uint32_t offset = 0;
};

struct AstImportCall {
	std::string_view import;
	std::vector<AstOverride> overrides;
};

struct Ast {
	std::string_view version;
	std::vector<Expr> exprs;
	std::vector<Command> commands;
	std::vector<Branch> branches;
	std::vector<AstBody> bodies;
	std::vector<AstEntry> entries;
	std::vector<AstBlock> blocks;
	std::vector<uint32_t> children;
	std::vector<AstItem> items;
	std::vector<AstImport> imports;
	std::vector<AstStyle> styles;
	std::vector<AstImportCall> import_calls;
	std::deque<std::string> texts; // decoded strings
	bool is_abandoned = false; // nothing of the file was read
	std::vector<std::string_view> lost_names; // of items that had to be skipped: whoever uses them is not wrong because of that

	std::span<const uint32_t> list(NodeRange range) const { return { children.data() + range.first, range.count }; }
};

} // namespace pcg
