#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "core/base/diagnostic.h"

// Typed access to a parsed JSON document that reports what is wrong with file and path; nothing here throws or aborts on any input.
namespace pcg {

// The document, or nothing and an error with line and column.
std::optional<nlohmann::json> parse_json(std::string_view text, const std::string &file, Diagnostics &diagnostics);

// A value and where it stands. Cheap to copy as long as the document lives.
class JsonValue {
public:
	// `text`: what the document was read from, for lines and columns.
	JsonValue(const nlohmann::json &value, std::string path, const std::string &file, std::string_view text, Diagnostics &diagnostics) :
			_value(&value), _path(std::move(path)), _file(&file), _text(text), _diagnostics(&diagnostics) {}

	// Each returns false or nothing after reporting an error.
	bool is_object() const;
	std::optional<std::string> text() const;
	std::optional<double> number(double low, double high) const;
	std::optional<int64_t> whole_number(int64_t low, int64_t high) const;
	std::optional<glm::vec3> point() const; // three numbers, each within +-1e7 m
	// Elements of an array; nothing if it is not one.
	std::optional<std::vector<JsonValue>> elements() const;

	bool is_number() const { return _value->is_number(); }
	bool is_text() const { return _value->is_string(); }
	bool is_null() const { return _value->is_null(); }
	// Of an object. `member` is nothing without an error if it is missing; `required` reports that.
	std::optional<JsonValue> member(std::string_view key) const;
	std::optional<JsonValue> required(std::string_view key) const;
	// Warns about members with other names.
	void allow_only(const std::vector<std::string_view> &keys) const;
	void error(std::string message, std::string hint = {}) const;
	void warning(std::string_view id, std::string message, std::string hint = {}) const;

private:
	void tell(Severity severity, std::string_view id, std::string message, std::string hint) const;

	const nlohmann::json *_value;
	std::string _path;
	const std::string *_file;
	std::string_view _text;
	Diagnostics *_diagnostics;
};

} // namespace pcg
