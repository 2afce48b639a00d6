#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/lang/value.h"

// One rule language, several dialects: CGA writes geometry, PCG agendas write days. A dialect is a table of built-ins; arity checks,
// "did you mean", completion and the reference pages are all derived from it.
namespace pcg {

class Vm;
struct Block;

// What an operation asks of the interpreter: go on, stop here until resumed (PCG language, section 6), or give this run up.
enum class Flow : uint8_t { Next, Pause, Stop };

enum class ParamKind : uint8_t {
	Any,
	Number,
	Bool,
	Text,
	Size, // a number with ' or ~ allowed
	Word, // one of ParamSpec::words, written bare; arrives as its index
	WordOrNumber,
	Predicate, // arrives unevaluated as a Chunk (paper, "Generation of the agendas")
	Rule, // the name of a rule; arrives as its RuleId
	Array, // of numbers, truth values or texts
	Target, // a name that the operation writes to: arrives as ValueType::Attribute or, of a writable variable, ValueType::Variable
};

// The type that a parameter asks for at run time; Void: any.
constexpr ValueType wanted_type(ParamKind kind) {
	switch (kind) {
		case ParamKind::Number:
		case ParamKind::Size:
			return ValueType::Number;
		case ParamKind::Bool:
			return ValueType::Bool;
		case ParamKind::Text:
			return ValueType::Text;
		case ParamKind::Array:
			return ValueType::Array;
		default:
			return ValueType::Void;
	}
}

struct ParamSpec {
	std::string_view name;
	ParamKind kind = ParamKind::Any;
	std::string_view words = {}; // "x y z"; index 0, 1, 2
	bool is_optional = false; // only at the end of the list
	bool is_repeated = false; // the last parameter, any number of times
};

// What a built-in receives. `block` only for operations that take one; `user` is what the host registered with the spec.
struct Args {
	std::span<const Value> values;
	const Block *block = nullptr;
	const Block *second_block = nullptr; // name(..) { .. } { .. }
	const void *user = nullptr;
	size_t count() const { return values.size(); }
	const Value &operator[](size_t i) const { return values[i]; }
	// Only after the arity and kind checks of the compiler, which also happen at run time for values not known before.
	double number(size_t i) const { return values[i].number; }
	double number_or(size_t i, double fallback) const { return i < values.size() ? values[i].number : fallback; }
};

using FunctionHandler = Value (*)(Vm &vm, const Args &args);
using OperationHandler = Flow (*)(Vm &vm, const Args &args);
using VariableHandler = Value (*)(Vm &vm);

// Overloads are several specs of one name with different numbers of arguments.
struct FunctionSpec {
	std::string_view name;
	std::vector<ParamSpec> params;
	ValueType result = ValueType::Number;
	FunctionHandler handler = nullptr;
	std::string_view help; // one or two sentences: meaning, units, errors
	bool is_pure = false; // same arguments, same value, no host: folded at compile time
	const void *user = nullptr;
	bool has_block = false; // name(..) { selector : value | .. }: entries whose bodies are values
};

enum class BlockKind : uint8_t {
	None,
	Predicates, // { expr : body | .. }: members
	Sizes, // { size : body | .. }*: split
	Selectors, // { selector : body | .. }, also '=' and '=:': comp, setback
	Bodies, // { body | .. }: scatter; with a single body also days(mask) { body }
};

// When an operation means something (PCG language, sections 5 and 6). CGA has one phase only.
enum class Phase : uint8_t { Generation = 1, Simulation = 2, Both = 3 };

// What is wrong with a call, as a diagnostic says it.
struct CallProblem {
	std::string_view id;
	std::string message;
	std::string hint;
	int argument = -1; // told at its place; -1: at the call
};

// What is known of a call when it is compiled; Void: shows only while it runs.
struct KnownCall {
	std::string_view operation;
	std::span<const Value> arguments;
	std::span<const Value> around; // first arguments of the calls of the same operation in whose blocks it stands, the outermost first
};

// What it finds is a warning.
using ConstantCheck = std::optional<CallProblem> (*)(const KnownCall &call);

struct OperationSpec {
	std::string_view name;
	std::vector<ParamSpec> params;
	BlockKind block = BlockKind::None;
	OperationHandler handler = nullptr;
	std::string_view help;
	Phase phase = Phase::Generation;
	const void *user = nullptr;
	ConstantCheck check = nullptr;
	bool takes_rule = false; // a command behind it is its block: `union Rule` is `union { Rule }`
};

// Read-only built-in: `age`, `scope.sx`.
struct VariableSpec {
	std::string_view name;
	ValueType type = ValueType::Number;
	VariableHandler handler = nullptr;
	std::string_view help;
	bool is_writable = false; // set(name, ..) is handed to the dialect's operation `set`, or with dynamic locals makes a local of that name
};

// What stands in front of a rule or attribute: `@Range(0, 1)`.
struct AnnotationSpec {
	std::string_view name; // without the @
	std::string_view arguments; // as in "(\"text\")"; empty: none
	std::string_view help;
};

struct Dialect {
	std::string_view name; // "cga", "pcg"
	std::string_view title; // "CGA shape grammar"

	// Dynamic (PCG): locals made by set() and parameters are seen by the rules called after it; a plain `name = expr` is a value that is
	// evaluated once. Lexical (CGA): parameters are seen by their own body only, set() is an operation of the dialect, a plain
	// `name = expr` is a function evaluated at every use, and imported files take the importer's attributes of the same name.
	enum class Locals : uint8_t { Dynamic, Lexical } locals = Locals::Lexical;
	// A rule call runs the rule (PCG), or is handed to VmHost::call_rule, which makes a new shape (CGA).
	enum class RuleCalls : uint8_t { Run, ByHost } rule_calls = RuleCalls::Run;
	// A called name that is nothing: an error (PCG), or a leaf shape with a warning unless it ends in a dot (CGA). The same goes for other
	// names and for division by zero: an error that ends the run (PCG), or a warning and a harmless value (CGA; x / 0 is infinite).
	enum class UnknownNames : uint8_t { Error, LeafSymbol } unknown_names = UnknownNames::Error;
	bool is_strict() const { return unknown_names == UnknownNames::Error; }
	bool has_time_units = false; // 8h30m, 5m, 30s

	// Words that within the expressions of a selector block stand for a function of this name, called with the word as its text.
	std::vector<std::string_view> selector_words;
	std::string_view selector_function;

	std::vector<AnnotationSpec> annotations; // known ones; others may stand beside them where the dialect is not strict, or lists none

	std::vector<FunctionSpec> functions;
	std::vector<OperationSpec> operations;
	std::vector<VariableSpec> variables;

	// Indices, or -1. With a name that exists but not for that many arguments, -1 too: see `has_operation`.
	int find_function(std::string_view name, size_t argument_count) const;
	int find_operation(std::string_view name, size_t argument_count) const;
	int find_variable(std::string_view name) const;
	bool has_function(std::string_view name) const;
	bool has_operation(std::string_view name) const;
	// Whether an operation of this name is one with OperationSpec::takes_rule.
	bool takes_rule(std::string_view operation_name) const;
	// Whether an operation of this name has a block of conditions.
	bool takes_conditions(std::string_view operation_name) const;
};

// Those of start rules and of attributes: shared by all dialects.
void add_annotations(Dialect &dialect);
// abs min max floor .. rand p: shared by all dialects. `rand` draws from Vm::random().
void add_math_functions(Dialect &dialect);

} // namespace pcg
