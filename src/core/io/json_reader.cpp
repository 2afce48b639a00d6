#include "core/io/json_reader.h"

#include <algorithm>
#include <cmath>

#include "core/base/utf8.h"
#include "core/io/json_place.h"

namespace pcg {

namespace {

using Json = nlohmann::json;

// Builds nothing; only learns where a text stops being JSON.
class ErrorFinder : public nlohmann::json_sax<Json> {
public:
	bool null() override { return true; }
	bool boolean(bool) override { return true; }
	bool number_integer(number_integer_t) override { return true; }
	bool number_unsigned(number_unsigned_t) override { return true; }
	bool number_float(number_float_t, const string_t &) override { return true; }
	bool string(string_t &) override { return true; }
	bool binary(binary_t &) override { return true; }
	bool start_object(size_t) override { return true; }
	bool key(string_t &) override { return true; }
	bool end_object() override { return true; }
	bool start_array(size_t) override { return true; }
	bool end_array() override { return true; }
	bool parse_error(size_t position, const std::string &token, const nlohmann::detail::exception &exception) override {
		constexpr int number_overflow = 406; // the library's
		at = position;
		if (exception.id == number_overflow) {
			number = token;
		}
		return false;
	}

	size_t at = 0; // bytes read, the offending one included
	std::string number; // just read, and larger than any that can be kept; empty: something else is wrong
};

void set_place(Diagnostic &diagnostic, std::string_view text, size_t at) {
	const std::string_view before = text.substr(0, at);
	const size_t line_start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
	const size_t line_end = std::min(text.find('\n', at), text.size());
	constexpr size_t longest = 2000; // a file without line breaks need not be shown
	diagnostic.line = uint32_t(1 + std::count(before.begin(), before.end(), '\n'));
	diagnostic.column = uint32_t(count_characters(before.substr(line_start)) + 1);
	diagnostic.source = at - line_start < longest ? std::string(first_bytes(text.substr(line_start, line_end - line_start), longest)) : std::string();
}

Diagnostic overflow_diagnostic(std::string_view text, const std::string &file, const ErrorFinder &finder) {
	constexpr size_t shown = 40; // characters; a number may have thousands of digits
	const std::string number = finder.number.size() > shown ? finder.number.substr(0, shown) + ".." : finder.number;
	Diagnostic diagnostic{ Severity::Error, "bad-json", file, 0, 0, "the number " + number + " is too large: no more than 1.7e308 can be kept",
		"correct this value in the file", {} };
	set_place(diagnostic, text, std::min(finder.at, text.size()) - std::min(finder.number.size(), finder.at));
	return diagnostic;
}

Diagnostic parse_diagnostic(std::string_view text, const std::string &file, const ErrorFinder &finder) {
	if (!finder.number.empty()) {
		return overflow_diagnostic(text, file, finder);
	}
	const size_t at = std::min(finder.at > 0 ? finder.at - 1 : 0, text.size());
	Diagnostic diagnostic{ Severity::Error, "bad-json", file, 0, 0, {}, "a comma, a quote or a bracket may be missing before it", {} };
	const char c = at < text.size() ? text[at] : '\0';
	if (at >= text.size()) {
		diagnostic.message = "this is not JSON: the file ends where a value or a closing bracket is missing";
		diagnostic.hint = "was the file written to its end?";
	} else if (c > ' ' && c < 0x7F) {
		diagnostic.message = std::string("this is not JSON: `") + c + "` is out of place here";
	} else {
		diagnostic.message = "this is not JSON: there is a character that cannot stand here";
		diagnostic.hint = "is this a text in UTF-8?";
	}
	set_place(diagnostic, text, at);
	return diagnostic;
}

std::string number_text(double value) {
	char text[32];
	std::snprintf(text, sizeof(text), "%.10g", value);
	return text;
}

} // namespace

std::optional<Json> parse_json(std::string_view text, const std::string &file, Diagnostics &diagnostics) {
	ErrorFinder finder;
	if (!Json::sax_parse(text.begin(), text.end(), &finder)) {
		diagnostics.add(parse_diagnostic(text, file, finder));
		return std::nullopt;
	}
	Json document = Json::parse(text.begin(), text.end(), nullptr, false);
	if (document.is_discarded()) {
		diagnostics.add({ Severity::Error, "bad-json", file, 0, 0, "this is not JSON", {}, {} });
		return std::nullopt;
	}
	return document;
}

bool JsonValue::is_object() const {
	if (!_value->is_object()) {
		error("expected an object { .. }");
	}
	return _value->is_object();
}

std::optional<std::string> JsonValue::text() const {
	if (!_value->is_string() || _value->get_ref<const std::string &>().empty()) {
		error("expected a text in quotes that is not empty");
		return std::nullopt;
	}
	return _value->get<std::string>();
}

std::optional<double> JsonValue::number(double low, double high) const {
	if (_value->is_number()) {
		const double number = _value->get<double>();
		if (number >= low && number <= high) {
			return number;
		}
	}
	error("expected a number from " + number_text(low) + " to " + number_text(high));
	return std::nullopt;
}

std::optional<int64_t> JsonValue::whole_number(int64_t low, int64_t high) const {
	const bool is_too_large = _value->is_number_unsigned() && _value->get<uint64_t>() > uint64_t(INT64_MAX);
	if (_value->is_number_integer() && !is_too_large) {
		const int64_t number = _value->get<int64_t>();
		if (number >= low && number <= high) {
			return number;
		}
	}
	error("expected a whole number from " + std::to_string(low) + " to " + std::to_string(high));
	return std::nullopt;
}

std::optional<glm::vec3> JsonValue::point() const {
	const auto is_coordinate = [](const Json &value) { return value.is_number() && std::abs(value.get<double>()) <= 1e7; };
	if (!_value->is_array() || _value->size() != 3 || !std::all_of(_value->begin(), _value->end(), is_coordinate)) {
		error("expected three numbers [x, y, z] in metres, each within +-1e7");
		return std::nullopt;
	}
	return glm::vec3((*_value)[0].get<float>(), (*_value)[1].get<float>(), (*_value)[2].get<float>());
}

std::optional<std::vector<JsonValue>> JsonValue::elements() const {
	if (!_value->is_array()) {
		error("expected a list [ .. ]");
		return std::nullopt;
	}
	std::vector<JsonValue> values;
	for (size_t i = 0; i < _value->size(); ++i) {
		values.emplace_back((*_value)[i], _path + "[" + std::to_string(i) + "]", *_file, _text, *_diagnostics);
	}
	return values;
}

std::optional<JsonValue> JsonValue::member(std::string_view key) const {
	const auto found = _value->find(key);
	if (!_value->is_object() || found == _value->end()) {
		return std::nullopt;
	}
	return JsonValue(*found, _path.empty() ? std::string(key) : _path + "." + std::string(key), *_file, _text, *_diagnostics);
}

std::optional<JsonValue> JsonValue::required(std::string_view key) const {
	const std::optional<JsonValue> found = member(key);
	if (!found) {
		error("`" + std::string(key) + "` is missing");
	}
	return found;
}

void JsonValue::allow_only(const std::vector<std::string_view> &keys) const {
	for (const auto &[key, value] : _value->items()) {
		if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
			const std::string_view meant = closest_name(key, keys);
			warning("unknown-key", "`" + key + "` is not known here and is ignored",
					meant.empty() ? std::string() : "did you mean `" + std::string(meant) + "`?");
		}
	}
}

void JsonValue::error(std::string message, std::string hint) const {
	tell(Severity::Error, "bad-value", std::move(message), hint.empty() ? "correct this value in the file" : std::move(hint));
}

void JsonValue::warning(std::string_view id, std::string message, std::string hint) const {
	tell(Severity::Warning, id, std::move(message), std::move(hint));
}

void JsonValue::tell(Severity severity, std::string_view id, std::string message, std::string hint) const {
	const std::string place = _path.empty() ? "the whole file" : _path;
	Diagnostic diagnostic{ severity, id, *_file, 0, 0, place + ": " + message, std::move(hint), {} };
	if (!_text.empty()) {
		set_place(diagnostic, _text, std::min(find_json_place(_text, _path), _text.size()));
	}
	_diagnostics->add(std::move(diagnostic));
}

} // namespace pcg
