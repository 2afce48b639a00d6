#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/lang/opcode.h"
#include "core/lang/program.h"
#include "core/lang/rule_set.h"

// Rule set to program: resolves every name, folds constants, lays out the code. Reports all that is wrong in one pass.
namespace pcg {

// Null if there were errors.
std::shared_ptr<const Program> compile(const RuleSet &set, const Dialect &dialect, Diagnostics &diagnostics);

class Compiler {
public:
	Compiler(const RuleSet &set, const Dialect &dialect, Diagnostics &diagnostics);
	std::shared_ptr<const Program> run();

private:
	// What the piece of text that is being compiled can see.
	struct Scope {
		const Ast *ast = nullptr;
		const Source *source = nullptr;
		uint32_t file = 0;
		uint32_t space = 0;
		std::vector<std::string_view> locals; // parameters, then `with` values
		bool is_attribute = false; // evaluated at no fixed moment: sees no dynamic locals
		bool is_selector = false; // in the expression of a selector
	};
	// Code of one chunk while it grows; nested ones are finished first.
	struct Builder {
		std::vector<Instruction> code;
		std::vector<SourcePlace> places;
		uint32_t depth = 0; // values on the stack here
		uint32_t max_depth = 0;
	};
	// Of a value: what it certainly is, Void if that shows only while running.
	using Known = ValueType;

	// compiler.cpp: declarations
	void declare();
	size_t winner_of(const Definition &definition) const;
	void declare_rule(Definition &definition);
	void declare_attribute(Definition &definition);
	void declare_function(Definition &definition);
	void collect_slots();
	uint32_t slot(std::string_view name);
	std::vector<Annotation> annotations_of(const Definition &definition) const;
	void add_params(Callable &callable, std::span<const AstParam> params);
	void compile_definitions();
	void compile_definition(const Definition &definition);
	static bool is_constant(const Definition &definition) {
		return definition.kind == Definition::Kind::Attribute && definition.item->kind == AstItem::Kind::Constant;
	}
	void open_scope(const Definition &definition);
	void compile_rule(const Definition &definition);
	void compile_value(const Definition &definition);
	// compile_import.cpp: values that an import has of its own
	bool is_given_here(uint32_t definition) const;
	uint32_t own_value_of(uint32_t definition);
	void compile_own_values();
	void compile_locals(const AstItem &item);
	void finish();

	// compiler.cpp: code
	void begin_chunk() { _builders.emplace_back(); }
	Chunk end_chunk(OpCode last, uint32_t offset);
	uint32_t emit(OpCode code, uint32_t offset, int effect, uint32_t operand = 0, uint32_t extra = 0, size_t count = 0);
	uint32_t emit_jump(OpCode code, uint32_t offset, int effect, uint32_t extra = 0);
	void land(uint32_t jump); // lets the jump end here
	void emit_constant(const Value &value, uint32_t offset);
	bool ends_in_constant(uint32_t begin, Value &value) const; // all code since `begin` is one constant
	void drop_code(uint32_t begin, uint32_t depth);
	uint32_t here() const { return uint32_t(_builders.back().code.size()); }
	uint32_t constant(const Value &value);
	uint32_t symbol(std::string_view text);

	// compile_messages.cpp
	SourcePlace place(uint32_t offset) const;
	void report(Severity severity, std::string_view id, uint32_t offset, std::string message, std::string hint = {});
	void error(std::string_view id, uint32_t offset, std::string message, std::string hint = {}) {
		report(Severity::Error, id, offset, std::move(message), std::move(hint));
	}
	void warn(std::string_view id, uint32_t offset, std::string message, std::string hint = {}) {
		report(Severity::Warning, id, offset, std::move(message), std::move(hint));
	}
	// An error in a strict dialect, else a warning.
	void complain(std::string_view id, uint32_t offset, std::string message, std::string hint = {}) {
		report(is_strict() ? Severity::Error : Severity::Warning, id, offset, std::move(message), std::move(hint));
	}
	bool is_strict() const { return _dialect.is_strict(); }
	// Says that `name` is unknown, unless that follows from something told before.
	void unknown(std::string_view what, std::string_view name, uint32_t offset, bool wants_command);
	bool is_dynamic() const { return _dialect.locals == Dialect::Locals::Dynamic; }
	std::string did_you_mean(std::string_view name, bool wants_command) const;
	std::vector<std::string_view> command_names() const;
	std::vector<std::string_view> value_names() const;
	bool is_full() const { return _diagnostics.is_full(is_strict() ? Severity::Error : Severity::Warning); } // what it complains of is only counted

	// compile_expression.cpp
	Known expression(uint32_t expr);
	Known unknown_value(uint32_t offset); // a harmless value in place of what was diagnosed
	Known binary_chain(uint32_t expr);
	Known binary(const Expr &expr, Known left, uint32_t begin, uint32_t depth);
	Known logical(const Expr &expr);
	Known unary(const Expr &expr);
	Known case_expression(const Expr &expr);
	Known chance_expression(const Expr &expr);
	Known array(const Expr &expr);
	void array_row(const Expr &row);
	Known range(const Expr &expr);
	Known index(const Expr &expr);
	Known components(const Expr &expr);
	Known call(const Expr &expr);
	Known user_call(const Expr &expr, uint32_t definition);
	Known import_call(const Expr &expr);
	Known call_builtin(uint32_t function, std::string_view name, NodeRange arguments, uint32_t offset);
	Known size_expression(uint32_t expr); // with ' or ~ allowed
	bool fold_unary(TokenKind op, uint32_t begin, uint32_t depth, uint32_t offset);
	bool fold_binary(TokenKind op, uint32_t begin, uint32_t depth, uint32_t offset);
	bool fold_call(const FunctionSpec &spec, uint32_t begin, uint32_t depth, size_t count, uint32_t offset);
	Chunk value_chunk(uint32_t expr, bool is_size);
	bool makes_no_frames() const;
	void share(uint32_t expr);
	void warn_shares(std::span<const uint32_t> shares);

	// compile_name.cpp
	Known name(const Expr &expr);
	bool local_name(const Expr &expr);
	Known global_name(const Expr &expr, bool is_required);
	bool is_selector_word(std::string_view name) const;
	bool is_value_name(std::string_view name) const;
	Known unknown_global(const Expr &expr);

	// compile_call.cpp: arguments of built-ins
	uint32_t arguments(const std::vector<ParamSpec> &params, std::string_view name, NodeRange list); // gives the mask of what to check
	bool argument(const ParamSpec &param, std::string_view name, size_t position, uint32_t expr); // whether it must be checked
	bool value_argument(const ParamSpec &param, std::string_view name, size_t position, uint32_t expr);
	bool word_argument(const ParamSpec &param, const Expr &expr);
	void rule_argument(const Expr &expr);
	void target_argument(const Expr &expr);
	bool text_as_word(const ParamSpec &param, uint32_t expr);
	bool selector_argument(const Expr &expr, OpCode code, std::string_view words); // sel("..")
	uint32_t replaced_by_caller(uint32_t definition) const;
	uint32_t begin_import(uint32_t import_call, uint32_t offset); // gives the space of the import, no_node if there is none
	int choose_function(std::string_view name, NodeRange list) const;
	int choose_operation(std::string_view name, NodeRange list) const;
	template <typename Spec> int choose(const std::vector<Spec> &specs, std::string_view name, NodeRange list) const;
	bool words_fit(const std::vector<ParamSpec> &params, NodeRange list) const;
	bool is_broken(NodeRange list) const; // was diagnosed by the parser
	void wrong_count(std::string_view name, NodeRange list, uint32_t offset);
	std::string forms_of(std::string_view name) const;

	// compile_body.cpp
	void body(uint32_t body);
	void command(const Command &command);
	void call_command(const Command &command);
	void rule_call(uint32_t definition, const Command &command);
	void operation_call(int operation, const Command &command);
	void unknown_command(const Command &command);
	void leaf_call(const Command &command);
	void set_local(const Command &command);
	void case_command(const Command &command);
	void chance_command(const Command &command);
	uint32_t block(uint32_t block, BlockKind kind);
	BlockEntry block_entry(const AstEntry &entry, BlockKind kind);
	bool check_head(const AstEntry &entry, BlockKind kind);
	BlockEntry entry_with_head(const AstEntry &entry, BlockKind kind);
	Chunk missing_size(const AstEntry &entry);
	bool is_older_than(double version) const; // the file that is being compiled
	void inline_command(const Command &command);
	void import_command(const Command &command);
	Chunk body_chunk(uint32_t body, uint32_t offset);
	void rule_arguments(NodeRange list);

	// check_declarations.cpp
	void check_annotations();
	void check_annotation(const AstAnnotation &annotation, std::span<const AstAnnotation> before);
	void mark_start_rules();
	uint32_t mark_start_rules(bool in_main_file); // how many there are
	void check_start_rule(const Definition &definition);

	// check_program.cpp: warnings about what is sound but has no effect
	void warn_unreachable(bool is_decided, uint32_t offset);
	void warn_indented(uint32_t first_case, uint32_t offset);
	bool is_always_true(const Value &condition, uint32_t offset); // warns of one that is always false
	uint32_t check_constants(uint32_t operation, const Command &command);
	Value constant_of(Chunk chunk) const; // Void if it is more than a constant
	void warn_unused_and_phases();
	struct Reached { // by rule
		std::vector<bool> generation;
		std::vector<bool> simulation;
	};
	Reached reached_rules() const;
	void warn_phases(const Reached &reached);
	void warn_at(std::string_view id, const SourcePlace &at, std::string message, std::string hint);

	const RuleSet &_set;
	const Dialect &_dialect;
	Diagnostics &_diagnostics;
	std::shared_ptr<Program> _program;
	std::vector<Definition> _definitions; // the rule set's, with indices
	std::vector<Callable> _functions;
	std::vector<Builder> _builders;
	Scope _scope;
	std::unordered_map<std::string, uint32_t> _symbols;
	std::unordered_map<std::string_view, uint32_t> _slots;
	std::unordered_map<std::string, uint32_t> _leaves; // "Wall/2" to rule
	struct OwnValue {
		uint32_t definition; // of an attribute of an import that the importing file gives
		uint32_t attribute; // the one that holds what the import has of its own
	};
	std::vector<OwnValue> _own_values;
	uint32_t _current_value = no_node; // definition of the attribute that is being compiled
	std::vector<Value> _constant_values; // by attribute: of constants that are plain values, Void of all others
	bool _has_value_blocks = false; // the block that is being compiled is a function's

	// Who calls what, for warnings: edges from rule to rule, by how the called one runs.
	struct Edge {
		uint32_t from;
		uint32_t to;
		bool is_delayed; // given to an operation as a Rule argument: runs in the other phase
	};
	struct OperationUse {
		uint32_t rule;
		uint32_t operation;
		SourcePlace place;
	};
	struct OpenBlock { // of an operation, around what is being compiled
		uint32_t operation;
		Value first_argument; // Void: not known, or none
	};
	uint32_t _current_rule = no_node;
	std::vector<OpenBlock> _open_blocks;
	std::vector<Value> _constant_arguments; // of the call whose arguments were compiled last; Void what is not known
	std::vector<Edge> _edges;
	std::vector<OperationUse> _uses;
};

} // namespace pcg
