#include "core/io/obj.h"

#include <charconv>
#include <cmath>

#include "core/io/atomic_file.h"

namespace pcg {

namespace {

constexpr size_t max_errors = 20; // then the file is something else

class ObjParser {
public:
	ObjParser(std::string_view text, const std::string &file, Diagnostics &diagnostics) :
			_text(text), _file(file), _diagnostics(diagnostics) {}

	std::optional<ObjPolygons> parse() {
		for (size_t start = 0; start < _text.size() && _errors < max_errors;) {
			const size_t end = std::min(_text.find('\n', start), _text.size());
			++_line;
			_line_text = _text.substr(start, end - start);
			_rest = _line_text;
			parse_line();
			start = end + 1;
		}
		if (_errors == 0 && _polygons.faces.empty()) {
			_line = 0;
			error("there is no face in this file", "a footprint needs lines such as `v 0 0 0` and `f 1 2 3 4`");
		}
		return _errors == 0 ? std::optional(std::move(_polygons)) : std::nullopt;
	}

private:
	void parse_line() {
		const std::string_view keyword = next_word();
		if (keyword == "v") {
			parse_vertex();
		} else if (keyword == "f") {
			parse_face();
		}
	}

	// Words are parted by blanks; a comment ends the line.
	std::string_view next_word() {
		const size_t start = std::min(_rest.find_first_not_of(" \t\r"), _rest.size());
		const size_t end = std::min(_rest.find_first_of(" \t\r", start), _rest.size());
		const std::string_view word = _rest.substr(start, end - start);
		_rest = word.starts_with('#') ? std::string_view() : _rest.substr(end);
		return word.starts_with('#') ? std::string_view() : word;
	}

	void parse_vertex() {
		double numbers[3];
		for (double &number : numbers) {
			const std::string_view word = next_word();
			const std::from_chars_result result = std::from_chars(word.data(), word.data() + word.size(), number);
			if (word.empty() || result.ec != std::errc() || result.ptr != word.data() + word.size() || !(std::abs(number) <= 1e7)) {
				error("a vertex needs three numbers within +-1e7", "write `v x y z`");
				number = 0.0;
				break;
			}
		}
		_vertices.push_back({ numbers[0], numbers[1], numbers[2] });
	}

	void parse_face() {
		std::vector<glm::dvec3> corners;
		for (std::string_view word = next_word(); !word.empty(); word = next_word()) {
			// "vertex/texture/normal": only the first number matters here.
			const std::string_view digits = word.substr(0, word.find('/'));
			long long number = 0;
			const std::from_chars_result result = std::from_chars(digits.data(), digits.data() + digits.size(), number);
			const long long count = (long long)(_vertices.size());
			const long long index = number < 0 ? count + number : number - 1;
			if (result.ec != std::errc() || result.ptr != digits.data() + digits.size() || index < 0 || index >= count) {
				error("`" + std::string(word.substr(0, 40)) + "` is not one of the " + std::to_string(count) + " vertices so far",
						"vertices count from 1, or from -1 backwards");
				return;
			}
			corners.push_back(_vertices[size_t(index)]);
		}
		if (corners.size() < 3) {
			error("a face needs at least three corners", "write `f 1 2 3`");
			return;
		}
		_polygons.faces.push_back(std::move(corners));
	}

	void error(std::string message, std::string hint) {
		++_errors;
		Diagnostic diagnostic{ Severity::Error, "bad-obj", _file, _line, _line > 0 ? 1u : 0u, std::move(message), std::move(hint), {} };
		diagnostic.source = _line > 0 ? std::string(_line_text.substr(0, 200)) : std::string();
		_diagnostics.add(std::move(diagnostic));
	}

	std::string_view _text;
	const std::string &_file;
	Diagnostics &_diagnostics;
	std::string_view _line_text, _rest;
	uint32_t _line = 0;
	size_t _errors = 0;
	std::vector<glm::dvec3> _vertices;
	ObjPolygons _polygons;
};

} // namespace

std::optional<ObjPolygons> parse_obj(std::string_view text, const std::string &file, Diagnostics &diagnostics) {
	return ObjParser(text, file, diagnostics).parse();
}

std::optional<ObjPolygons> load_obj(const std::string &path, Diagnostics &diagnostics) {
	const Result<std::string> text = read_file(path);
	if (!text) {
		diagnostics.add(text.diagnostic());
		return std::nullopt;
	}
	return parse_obj(*text, path, diagnostics);
}

} // namespace pcg
