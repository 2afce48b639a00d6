#include "core/io/obj.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/utf8.h"
#include "core/io/atomic_file.h"

namespace pcg {

namespace {

constexpr size_t max_errors = 20; // then the file is something else
constexpr size_t max_corners = 100'000; // of one face

class ObjParser {
public:
	ObjParser(std::string_view text, const std::string &file, Diagnostics &diagnostics, size_t max_faces) :
			_text(text), _file(file), _diagnostics(diagnostics), _max_faces(max_faces) {}

	ObjModel parse() {
		for (size_t start = 0; start < _text.size() && _errors < max_errors;) {
			const size_t end = std::min(_text.find('\n', start), _text.size());
			++_line;
			_line_text = _text.substr(start, end - start);
			start = end + 1;
			if (!continue_line(start)) {
				_rest = _line_text;
			}
			parse_line();
		}
		return std::move(_model);
	}

private:
	// A line that ends in \ goes on in the next one. `start` moves behind the last of them.
	bool continue_line(size_t &start) {
		if (!ends_in_backslash(_line_text)) {
			return false;
		}
		_long_line = _line_text;
		while (ends_in_backslash(_long_line) && start < _text.size()) {
			_long_line.erase(_long_line.find_last_of('\\'));
			const size_t end = std::min(_text.find('\n', start), _text.size());
			_long_line += ' ';
			_long_line += _text.substr(start, end - start);
			start = end + 1;
			++_line;
		}
		_rest = _long_line;
		return true;
	}

	static bool ends_in_backslash(std::string_view line) {
		line = line.substr(0, line.find_last_not_of('\r') + 1);
		return line.ends_with('\\');
	}

	void parse_line() {
		const std::string_view keyword = next_word();
		if (keyword == "v") {
			parse_vertex();
		} else if (keyword == "vt") {
			parse_uv();
		} else if (keyword == "vn") {
			glm::dvec3 normal(0.0);
			for (int axis = 0; axis < 3 && read_number(next_word(), normal[axis]); ++axis) {
			}
			_model.normals.push_back(normal);
		} else if (keyword == "f" || keyword == "fo") {
			parse_face();
		} else if (keyword == "usemtl") {
			use_material(rest_of_line());
		} else if (keyword == "mtllib") {
			_model.libraries.emplace_back(rest_of_line());
		} else if (keyword == "o" || keyword == "g") {
			++_group;
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

	// Names may hold blanks.
	std::string_view rest_of_line() const {
		const size_t start = std::min(_rest.find_first_not_of(" \t\r"), _rest.size());
		return _rest.substr(start, _rest.find_last_not_of(" \t\r") + 1 - start);
	}

	static bool read_number(std::string_view word, double &number) {
		word.remove_prefix(word.starts_with('+') ? 1 : 0);
		const std::from_chars_result result = std::from_chars(word.data(), word.data() + word.size(), number);
		return !word.empty() && result.ec == std::errc() && result.ptr == word.data() + word.size() && std::abs(number) <= 1e7;
	}

	void parse_vertex() {
		double numbers[3] = {};
		for (double &number : numbers) {
			if (!read_number(next_word(), number)) {
				error("a vertex needs three numbers within +-1e7", "write `v x y z`");
				number = 0.0;
				break;
			}
		}
		_model.positions.push_back({ numbers[0], numbers[1], numbers[2] });
	}

	void parse_uv() {
		glm::dvec2 uv(0.0);
		if (!read_number(next_word(), uv.x) || !std::isfinite(uv.x)) {
			error("a texture coordinate needs numbers within +-1e7", "write `vt u v`");
			uv.x = 0.0;
		}
		const std::string_view second = next_word();
		if (!second.empty() && !read_number(second, uv.y)) {
			uv.y = 0.0;
		}
		_model.uvs.push_back(uv);
	}

	// Counted from 1, or backwards from -1. False: there is no such one.
	static bool read_index(std::string_view digits, size_t count, uint32_t &index) {
		long long number = 0;
		const std::from_chars_result result = std::from_chars(digits.data(), digits.data() + digits.size(), number);
		const long long from_zero = number < 0 ? (long long)(count) + number : number - 1;
		index = uint32_t(from_zero);
		return result.ec == std::errc() && result.ptr == digits.data() + digits.size() && from_zero >= 0 && from_zero < (long long)(count);
	}

	// "vertex/texture/normal"; a normal that does not exist is read over.
	bool read_corner(std::string_view word) {
		ObjModel::Corner corner;
		if (!read_index(word.substr(0, word.find('/')), _model.positions.size(), corner.position)) {
			error("`" + std::string(first_bytes(word, 40)) + "` is not one of the " + std::to_string(_model.positions.size()) + " vertices so far",
					"vertices count from 1, or from -1 backwards");
			return false;
		}
		const size_t slash = word.find('/');
		const std::string_view uv = slash == std::string_view::npos ? std::string_view() : word.substr(slash + 1, word.find('/', slash + 1) - slash - 1);
		if (!uv.empty() && !read_index(uv, _model.uvs.size(), corner.uv)) {
			error("`" + std::string(first_bytes(word, 40)) + "` is not one of the " + std::to_string(_model.uvs.size()) + " texture coordinates so far",
					"they count from 1, or from -1 backwards");
			return false;
		}
		const size_t second = slash == std::string_view::npos ? slash : word.find('/', slash + 1);
		if (second != std::string_view::npos && !read_index(word.substr(second + 1), _model.normals.size(), corner.normal)) {
			corner.normal = ObjModel::none;
		}
		_model.corners.push_back(corner);
		return true;
	}

	void parse_face() {
		const size_t first = _model.corners.size();
		bool is_right = true;
		for (std::string_view word = next_word(); is_right && !word.empty(); word = next_word()) {
			is_right = read_corner(word);
		}
		const size_t count = _model.corners.size() - first;
		if (is_right && (count < 3 || count > max_corners)) {
			error(count < 3 ? "a face needs at least three corners" : "a face with more than 100000 corners", "write `f 1 2 3`");
			is_right = false;
		}
		if (is_right && _model.faces.size() >= _max_faces) {
			error("more than " + std::to_string(_max_faces) + " faces", "use a simpler model");
			_errors = max_errors;
			is_right = false;
		}
		if (!is_right) {
			_model.corners.resize(first);
			return;
		}
		_model.faces.push_back({ uint32_t(first), uint32_t(count), _material, _group });
	}

	void use_material(std::string_view name) {
		auto &names = _model.material_names;
		const auto found = std::ranges::find(names, name);
		_material = uint32_t(found - names.begin());
		if (found == names.end()) {
			names.emplace_back(name);
		}
	}

	void error(std::string message, std::string hint) {
		++_errors;
		Diagnostic diagnostic{ Severity::Error, "bad-obj", _file, _line, 1, std::move(message), std::move(hint), {} };
		diagnostic.source = std::string(first_bytes(_line_text, 200));
		_diagnostics.add(std::move(diagnostic));
	}

	std::string_view _text;
	const std::string &_file;
	Diagnostics &_diagnostics;
	size_t _max_faces;
	std::string_view _line_text, _rest;
	std::string _long_line;
	uint32_t _line = 0;
	uint32_t _material = ObjModel::none;
	uint32_t _group = 0;
	size_t _errors = 0;
	ObjModel _model;
};

} // namespace

ObjModel parse_obj_model(std::string_view text, const std::string &file, Diagnostics &diagnostics, size_t max_faces) {
	return ObjParser(text, file, diagnostics, max_faces).parse();
}

std::optional<ObjPolygons> parse_obj(std::string_view text, const std::string &file, Diagnostics &diagnostics) {
	const size_t errors = diagnostics.error_count();
	const ObjModel model = parse_obj_model(text, file, diagnostics);
	if (diagnostics.error_count() == errors && model.faces.empty()) {
		diagnostics.add({ Severity::Error, "bad-obj", file, 0, 0, "there is no face in this file", "a footprint needs lines such as `v 0 0 0` and `f 1 2 3 4`", {} });
	}
	if (diagnostics.error_count() > errors) {
		return std::nullopt;
	}
	ObjPolygons polygons;
	for (const ObjModel::Face &face : model.faces) {
		auto &polygon = polygons.faces.emplace_back();
		auto &uvs = polygons.uvs.emplace_back();
		for (uint32_t i = 0; i < face.corner_count; ++i) {
			const ObjModel::Corner &corner = model.corners[face.first_corner + i];
			polygon.push_back(model.positions[corner.position]);
			if (corner.uv != ObjModel::none) {
				uvs.push_back(model.uvs[corner.uv]);
			}
		}
		if (uvs.size() < polygon.size()) {
			uvs.clear();
		}
	}
	return polygons;
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
