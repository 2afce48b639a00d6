#include "core/lang/value.h"

namespace pcg {

std::string_view type_name(ValueType type) {
	switch (type) {
		case ValueType::Void:
			return "nothing";
		case ValueType::Number:
			return "a number";
		case ValueType::Bool:
			return "true or false";
		case ValueType::Text:
			return "text";
		case ValueType::Word:
			return "a word";
		case ValueType::Rule:
			return "a rule";
		case ValueType::Chunk:
			return "a condition";
		case ValueType::Array:
			return "an array";
		case ValueType::Attribute:
		case ValueType::Variable:
			return "a name";
	}
	return "nothing";
}

} // namespace pcg
