#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/regex.h"
#include "core/base/utf8.h"
#include "core/cga/functions/functions.h"
#include "core/lang/vm.h"

// Conversions and texts (CGA reference, section 8.1). Places in a text count characters, not bytes.
namespace pcg::cga {

double number_of(std::string_view text) {
	text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n+"), text.size()));
	double result = NAN;
	const auto parsed = std::from_chars(text.data(), text.data() + text.size(), result);
	return parsed.ec == std::errc::result_out_of_range ? (text.starts_with('-') ? -INFINITY : INFINITY) : result;
}

std::string_view text_at(const Args &args, size_t i) {
	return i < args.count() && args[i].is_text() ? args[i].text->view : std::string_view();
}

namespace {

Value make(Vm &vm, std::string_view text) { return Value::of(vm.make_text(text)); }

double characters(std::string_view text) { return double(count_characters(text)); }

// Where the character of that number begins; the end of the text for larger numbers.
size_t byte_of(std::string_view text, double character) {
	return byte_of_character(text, character >= 1.0 ? size_t(std::min(character, double(text.size()))) : 0);
}

Value to_text(Vm &vm, const Args &args) { return make(vm, value_text(args[0])); }

Value to_number(Vm &, const Args &args) {
	if (args[0].is_text()) {
		return Value::of(number_of(text_at(args, 0)));
	}
	return args[0].is_bool() ? Value::of(args[0].boolean ? 1.0 : 0.0) : args[0].is_number() ? args[0] : Value::of(NAN);
}

Value to_bool(Vm &, const Args &args) {
	const Value &value = args[0];
	if (value.is_text()) {
		std::string text(value.text->view);
		std::ranges::transform(text, text.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
		double number = 1.0;
		const auto parsed = std::from_chars(text.data(), text.data() + text.size(), number);
		const bool is_zero = parsed.ec == std::errc() && parsed.ptr == text.data() + text.size() && number == 0.0;
		return Value::of(text != "f" && text != "false" && !is_zero);
	}
	return value.is_bool() ? value : Value::of(value.is_number() && value.number != 0.0);
}

// floatArray(values) and the like: each element as float() and the like have it.
template <auto convert, ValueType element> Value convert_each(Vm &vm, const Args &args) {
	std::vector<Value> values;
	for (uint32_t i = 0; i < args[0].array->size(); ++i) {
		values.push_back(convert(vm, { { args[0].array->values + i, 1 } }));
	}
	return Value::of(vm.make_array(values, args[0].array->rows, element));
}

Value text_length(Vm &, const Args &args) { return Value::of(characters(text_at(args, 0))); }

Value substring(Vm &vm, const Args &args) {
	const std::string_view text = text_at(args, 0);
	const size_t from = byte_of(text, args[1].number), to = byte_of(text, args[2].number);
	return make(vm, to > from ? text.substr(from, to - from) : std::string_view());
}

Value place_of(std::string_view text, size_t byte) {
	return Value::of(byte == std::string_view::npos ? -1.0 : characters(text.substr(0, byte)));
}

// Places that overlap an earlier one do not count, as in count().
Value find(Vm &, const Args &args) {
	const std::string_view text = text_at(args, 0), wanted = text_at(args, 1);
	const size_t step = std::max<size_t>(wanted.size(), 1);
	double left = args.number_or(2, 0.0);
	size_t at = left >= 0.0 ? text.find(wanted) : std::string_view::npos;
	while (at != std::string_view::npos && left-- >= 1.0) {
		at = text.find(wanted, at + step);
	}
	return place_of(text, at);
}

// Where a part begins for the last time, counted from the front: parts do not lie over each other, and an empty one is nowhere.
size_t last_of(std::string_view text, std::string_view wanted) {
	size_t last = std::string_view::npos;
	for (size_t at = 0; !wanted.empty() && (at = text.find(wanted, at)) != std::string_view::npos; at += wanted.size()) {
		last = at;
	}
	return last;
}

Value find_last(Vm &, const Args &args) { return place_of(text_at(args, 0), last_of(text_at(args, 0), text_at(args, 1))); }

Value count(Vm &, const Args &args) {
	const std::string_view text = text_at(args, 0), wanted = text_at(args, 1);
	double found = 0.0;
	for (size_t at = 0; !wanted.empty() && (at = text.find(wanted, at)) != std::string_view::npos; at += wanted.size()) {
		++found;
	}
	return Value::of(found);
}

Value replace(Vm &vm, const Args &args) {
	const std::string_view text = text_at(args, 0), wanted = text_at(args, 1), by = text_at(args, 2);
	std::string result;
	size_t start = 0;
	constexpr size_t longest = size_t(1) << 20;
	for (size_t at = 0; !wanted.empty() && result.size() < longest && (at = text.find(wanted, start)) != std::string_view::npos;) {
		result.append(text, start, at - start).append(by);
		start = at + wanted.size();
	}
	return make(vm, result.append(text.substr(start)));
}

// What is not found cuts nothing off, as in CityEngine's own library: the first item of "a" is "a".
Value prefix(Vm &vm, const Args &args) {
	const std::string_view text = text_at(args, 0), wanted = text_at(args, 1);
	return make(vm, wanted.empty() ? text : text.substr(0, std::min(text.find(wanted), text.size())));
}

Value suffix(Vm &vm, const Args &args) {
	const std::string_view text = text_at(args, 0);
	const size_t at = last_of(text, text_at(args, 1));
	return make(vm, at == std::string_view::npos ? text : text.substr(at + text_at(args, 1).size()));
}

// Behind the first `left` up to the last `right`.
Value range(Vm &vm, const Args &args) {
	const std::string_view text = text_at(args, 0), left = text_at(args, 1), right = text_at(args, 2);
	const size_t found = text.find(left);
	const size_t begin = found == std::string_view::npos ? 0 : found + left.size(), end = std::min(last_of(text, right), text.size());
	return make(vm, end > begin ? text.substr(begin, end - begin) : std::string_view());
}

struct Cut {
	size_t at = 0, length = 0;
};

// The next place where the text is cut; npos: none.
Cut next_cut(std::string_view text, size_t start, std::string_view delimiter, const Regex *regex) {
	if (regex == nullptr) {
		return { text.find(delimiter, start), delimiter.size() };
	}
	for (size_t at = start; at < text.size(); ++at) {
		const size_t length = regex->match_at(text, at);
		if (length != std::string_view::npos && length > 0) {
			return { at, length };
		}
	}
	return { std::string_view::npos, 0 };
}

// An empty delimiter cuts between all characters and at both ends, as CityEngine does.
Value split_characters(Vm &vm, std::string_view text) {
	std::vector<Value> parts = { make(vm, "") };
	for (size_t i = 0; i < text.size() && parts.size() < max_array_size;) {
		size_t end = i + 1;
		while (end < text.size() && !starts_character(text[end])) {
			++end;
		}
		parts.push_back(make(vm, text.substr(i, end - i)));
		i = end;
	}
	parts.push_back(make(vm, ""));
	return Value::of(vm.make_array(parts));
}

Value split_string(Vm &vm, const Args &args) {
	const std::string_view text = text_at(args, 0), delimiter = text_at(args, 1);
	if (delimiter.empty()) {
		return split_characters(vm, text);
	}
	std::optional<Regex> regex;
	if (delimiter.starts_with('$')) {
		regex = Regex::compile(delimiter.substr(1));
		if (!regex) {
			vm.warn("bad-pattern", "`" + std::string(delimiter) + "` is no pattern that is understood here", "a pattern is written \"$[;,]\"");
		}
	}
	std::vector<Value> parts;
	size_t start = 0;
	while (parts.size() + 1 < max_array_size) {
		const Cut cut = next_cut(text, start, delimiter, regex ? &*regex : nullptr);
		if (cut.at == std::string_view::npos) {
			break;
		}
		parts.push_back(make(vm, text.substr(start, cut.at - start)));
		start = cut.at + cut.length;
	}
	parts.push_back(make(vm, text.substr(start)));
	return Value::of(vm.make_array(parts));
}

} // namespace

void add_text_functions(Dialect &dialect) {
	using enum ParamKind;
	auto &functions = dialect.functions;
	const ParamSpec text = { "text", Text }, part = { "part", Text };
	functions.push_back({ "str", { { "value", Any } }, ValueType::Text, to_text, "The value as text." });
	functions.push_back({ "float", { { "value", Any } }, ValueType::Number, to_number,
			"The number at the start of a text, 1 or 0 of a truth value; not a number if there is none." });
	functions.push_back({ "bool", { { "value", Any } }, ValueType::Bool, to_bool,
			"False of 0 and of the texts \"f\", \"false\", \"0\", \"0.0\"; else true." });
	const ParamSpec array = { "values", Array };
	functions.push_back({ "floatArray", { array }, ValueType::Array, convert_each<to_number, ValueType::Number>, "Each element as float() has it." });
	functions.push_back({ "boolArray", { array }, ValueType::Array, convert_each<to_bool, ValueType::Bool>, "Each element as bool() has it." });
	functions.push_back({ "stringArray", { array }, ValueType::Array, convert_each<to_text, ValueType::Text>, "Each element as str() has it." });
	functions.push_back({ "sel", { text }, ValueType::Text, to_text, "A selector or the name of an attribute, made of a text." });
	functions.push_back({ "len", { text }, ValueType::Number, text_length, "Length of a text in characters." });
	functions.push_back({ "substring", { text, { "from", Number }, { "to", Number } }, ValueType::Text, substring,
			"The characters from one place to before another, counted from 0." });
	functions.push_back({ "find", { text, part, { "occurrence", Number, {}, true } }, ValueType::Number, find,
			"Where a part begins for the n-th time, n from 0; -1 if it does not." });
	functions.push_back({ "findLast", { text, part }, ValueType::Number, find_last, "Where a part begins for the last time; -1 if it does not." });
	functions.push_back({ "count", { text, part }, ValueType::Number, count, "How often a part occurs, without overlaps." });
	functions.push_back({ "replace", { text, part, { "by", Text } }, ValueType::Text, replace, "The text with all occurrences of a part replaced." });
	functions.push_back({ "getPrefix", { text, part }, ValueType::Text, prefix, "What stands before the first occurrence of a part; the whole text if there is none." });
	functions.push_back({ "getSuffix", { text, part }, ValueType::Text, suffix, "What stands behind the last occurrence of a part; the whole text if there is none." });
	functions.push_back({ "getRange", { text, { "left", Text }, { "right", Text } }, ValueType::Text, range,
			"What stands between the first occurrence of one part and the last of another; what is not found cuts nothing off." });
	functions.push_back({ "splitString", { text, { "delimiter", Text } }, ValueType::Array, split_string,
			"The pieces between the delimiters, as an array. A delimiter that begins with $ is a pattern." });
}

} // namespace pcg::cga
