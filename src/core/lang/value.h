#pragma once

#include <cstdint>
#include <string>
#include <string_view>

// What expressions of the rule languages yield: 16 bytes, copied freely. Text and arrays live in the program's constants or in the arena of the
// run that made them, never longer than that run.
namespace pcg {

// Attribute and Variable are names that are written to (ParamKind::Target).
enum class ValueType : uint8_t { Void, Number, Bool, Text, Word, Rule, Chunk, Array, Attribute, Variable };

// How a number was written where sizes are allowed: 3 (metres), '0.5 (of the scope), ~1 (a weight). CGA reference: op_split.
enum class SizeKind : uint8_t { Absolute, Relative, Flexible };

constexpr uint32_t no_symbol = 0xFFFFFFFF;

// Constants of a program carry their index in the program's text table as a symbol, so that a host can look names up once per program
// instead of once per use; text made at run time has `no_symbol`.
struct Text {
	std::string_view view;
	uint32_t symbol = no_symbol;
};

struct Value;

// Rows of equal length, one behind the other. CGA reference: arrayTypes.
struct ArrayData {
	const Value *values = nullptr;
	uint32_t rows = 1;
	uint32_t columns = 0;
	ValueType element = ValueType::Number; // or Bool, or Text: what lies outside of the array is 0, false or ""

	uint32_t size() const { return rows * columns; }
};

// More elements than any rule set needs; longer arrays are refused. CGA reference: func_array.
constexpr uint32_t max_array_size = 100'000;

struct Value {
	ValueType type = ValueType::Void;
	SizeKind size_kind = SizeKind::Absolute; // of a Number
	union {
		double number = 0.0;
		bool boolean;
		const Text *text;
		uint32_t word; // index in the parameter's list of words
		uint32_t rule; // RuleId
		uint32_t index; // of an Attribute in Program::attributes, of a Variable in Dialect::variables
		uint32_t chunk; // address of an expression that is evaluated by whoever receives it (a predicate)
		const ArrayData *array;
	};

	static Value of(double number_value) {
		Value value;
		value.type = ValueType::Number;
		value.number = number_value;
		return value;
	}
	static Value of(bool boolean_value) {
		Value value;
		value.type = ValueType::Bool;
		value.boolean = boolean_value;
		return value;
	}
	static Value of(const Text *text_value) {
		Value value;
		value.type = ValueType::Text;
		value.text = text_value;
		return value;
	}
	static Value of(const ArrayData *array_value) {
		Value value;
		value.type = ValueType::Array;
		value.array = array_value;
		return value;
	}
	// For the types whose payload is a whole number: Word, Rule, Chunk, Attribute, Variable.
	static Value of_index(ValueType index_type, uint32_t index_value) {
		Value value;
		value.type = index_type;
		value.index = index_value;
		return value;
	}
	bool is_void() const { return type == ValueType::Void; }
	bool is_number() const { return type == ValueType::Number; }
	bool is_bool() const { return type == ValueType::Bool; }
	bool is_text() const { return type == ValueType::Text; }
	bool is_array() const { return type == ValueType::Array; }
};
static_assert(sizeof(Value) == 16);

// "number", "true or false", "text" ..: for messages.
std::string_view type_name(ValueType type);
// As `+` with text writes it: 1, 0.3, true, (2)[1,2]; arrays of several rows one row a line (CGA reference: func_array).
std::string value_text(const Value &value);

} // namespace pcg
