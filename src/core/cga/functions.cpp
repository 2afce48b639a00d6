#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "core/cga/color.h"
#include "core/cga/components.h"
#include "core/cga/context.h"
#include "core/cga/measure.h"
#include "core/cga/operations/operations.h"

// Functions of the shape grammar (CGA reference, sections 8.1 and 8.3).
namespace pcg::cga {

namespace {

const Shape &shape_of(Vm &vm) {
	return Context::of(vm).shape;
}

std::string_view text_at(const Args &args, size_t i) {
	return args[i].is_text() ? args[i].text->view : std::string_view();
}

template <double (*measure)(const Shape &)> Value measured(Vm &vm, const Args &) { return Value::of(measure(shape_of(vm))); }

constexpr std::string_view side_words =
		"front back left right top bottom side vertical aslant horizontal nutant all object.front object.back object.left object.right object.top "
		"object.bottom object.side world.south world.north world.west world.east world.up world.down world.side street.front street.back street.left "
		"street.right street.side border inside";

std::string_view nth_word(std::string_view words, uint32_t index) {
	for (; index > 0; --index) {
		words.remove_prefix(std::min(words.find(' ') + 1, words.size()));
	}
	return words.substr(0, words.find(' '));
}

Value area_of_side(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	const Geometry *geometry = baked(context.shape, context.arena);
	const Selector selector = selector_of(nth_word(side_words, args[0].word));
	double sum = 0.0;
	if (geometry != nullptr) {
		for (const ComponentInfo &info : components_of(*geometry, ComponentKind::Faces)) {
			if (matches(selector, info.component, context.shape, context.lot())) {
				sum += face_area(context.shape, context.shape.geometry->faces[info.face]);
			}
		}
	}
	return Value::of(sum);
}

Value has_side(Vm &vm, const Args &args) {
	return Value::of(area_of_side(vm, args).number > 0.0);
}

Value height(Vm &vm, const Args &) {
	const Shape &shape = shape_of(vm);
	if (shape.geometry == nullptr) {
		return Value::of(0.0);
	}
	const Frame frame = shape.frame();
	double low = INFINITY, high = -INFINITY;
	for (uint32_t i = 0; i < shape.geometry->point_count; ++i) {
		const double y = frame.to_parent(shape.to_scope(shape.geometry->points[i])).y;
		low = std::min(low, y);
		high = std::max(high, y);
	}
	return Value::of(high - low);
}

Value face_count(Vm &vm, const Args &) {
	const Geometry *geometry = shape_of(vm).geometry;
	return Value::of(geometry != nullptr ? double(geometry->face_count) : 0.0);
}
Value hole_count(Vm &vm, const Args &) {
	const Geometry *geometry = shape_of(vm).geometry;
	return Value::of(geometry != nullptr ? double(geometry->loop_count - geometry->face_count) : 0.0);
}
template <ComponentKind kind> Value component_count(Vm &vm, const Args &) {
	const Geometry *geometry = shape_of(vm).geometry;
	return Value::of(geometry != nullptr ? double(components_of(*geometry, kind).size()) : 0.0);
}

Value concave(Vm &vm, const Args &) { return Value::of(is_concave(shape_of(vm))); }
Value closed(Vm &vm, const Args &) { return Value::of(shape_of(vm).geometry != nullptr && shape_of(vm).geometry->is_closed); }
Value rectangular(Vm &vm, const Args &args) { return Value::of(is_rectangular(shape_of(vm), args.number_or(0, 0.0))); }
Value planar(Vm &vm, const Args &args) { return Value::of(is_planar(shape_of(vm), args.number_or(0, 0.0))); }

// --- Conversions and text

Value to_text(Vm &vm, const Args &args) { return Value::of(vm.make_text(value_text(args[0]))); }

Value to_number(Vm &, const Args &args) {
	if (args[0].is_number()) {
		return args[0];
	}
	if (args[0].is_bool()) {
		return Value::of(args[0].boolean ? 1.0 : 0.0);
	}
	std::string_view text = text_at(args, 0);
	text.remove_prefix(std::min(text.find_first_not_of(" \t+"), text.size()));
	double result = NAN;
	std::from_chars(text.data(), text.data() + text.size(), result);
	return Value::of(result);
}

Value text_length(Vm &, const Args &args) { return Value::of(double(text_at(args, 0).size())); }

Value substring(Vm &vm, const Args &args) {
	const std::string_view text = text_at(args, 0);
	const auto position = [&](double value) { return value > 0.0 ? size_t(std::min(value, double(text.size()))) : size_t(0); };
	const size_t from = position(args[1].number), to = position(args[2].number);
	return Value::of(vm.make_text(to > from ? text.substr(from, to - from) : std::string_view()));
}

Value find(Vm &, const Args &args) {
	const std::string_view text = text_at(args, 0), wanted = text_at(args, 1);
	double left = args.number_or(2, 0.0);
	for (size_t at = text.find(wanted); at != std::string_view::npos; at = text.find(wanted, at + 1)) {
		if (left-- <= 0.0) {
			return Value::of(double(at));
		}
	}
	return Value::of(-1.0);
}

template <int channel> Value color_channel(Vm &, const Args &args) {
	glm::vec4 color(1.0f);
	return Value::of(parse_color(text_at(args, 0), color) ? double(color[channel]) : 0.0);
}

void add_geometry_functions(Dialect &dialect) {
	using enum ParamKind;
	auto &functions = dialect.functions;
	const ParamSpec side = { "selector", Word, side_words };
	functions.push_back({ "geometry.area", {}, ValueType::Number, measured<surface_area>, "Area of all faces, square metres." });
	functions.push_back({ "geometry.area", { side }, ValueType::Number, area_of_side, "Area of the faces that the selector of comp(f) would take." });
	functions.push_back({ "geometry.volume", {}, ValueType::Number, measured<volume>, "Volume of a closed surface, cubic metres; else 0." });
	functions.push_back({ "geometry.height", {}, ValueType::Number, height, "Extent along the world's vertical, metres." });
	functions.push_back({ "geometry.boundaryLength", {}, ValueType::Number, measured<boundary_length>, "Length of all outlines and holes, metres." });
	functions.push_back({ "geometry.nFaces", {}, ValueType::Number, face_count, "Number of faces." });
	functions.push_back({ "geometry.nHoles", {}, ValueType::Number, hole_count, "Number of holes in faces." });
	functions.push_back({ "geometry.nEdges", {}, ValueType::Number, component_count<ComponentKind::Edges>, "Number of edges; shared ones count once." });
	functions.push_back({ "geometry.nVertices", {}, ValueType::Number, component_count<ComponentKind::Vertices>, "Number of vertices; shared ones count once." });
	functions.push_back({ "geometry.isConcave", {}, ValueType::Bool, concave, "Whether any face is concave." });
	functions.push_back({ "geometry.isClosedSurface", {}, ValueType::Bool, closed, "Whether the faces enclose a volume." });
	functions.push_back({ "geometry.isRectangular", { { "toleranceDeg", Number, {}, true } }, ValueType::Bool, rectangular, "Whether every face has four right angles." });
	functions.push_back({ "geometry.isPlanar", { { "tolerance", Number, {}, true } }, ValueType::Bool, planar, "Whether every face lies in a plane, within metres." });
	functions.push_back({ "geometry.isOriented", { side }, ValueType::Bool, has_side, "Whether the selector of comp(f) would take any face." });
}

} // namespace

void add_functions(Dialect &dialect) {
	using enum ParamKind;
	add_geometry_functions(dialect);
	auto &functions = dialect.functions;
	const ParamSpec text = { "text", Text };
	functions.push_back({ "str", { { "value", Any } }, ValueType::Text, to_text, "The value as text." });
	functions.push_back({ "float", { { "value", Any } }, ValueType::Number, to_number, "The number at the start of a text; not a number if there is none." });
	functions.push_back({ "len", { text }, ValueType::Number, text_length, "Length of a text." });
	functions.push_back({ "substring", { text, { "from", Number }, { "to", Number } }, ValueType::Text, substring, "The characters from one position to before another." });
	functions.push_back({ "find", { text, { "part", Text }, { "occurrence", Number, {}, true } }, ValueType::Number, find, "Where a part begins, or -1." });
	functions.push_back({ "colorHexToR", { text }, ValueType::Number, color_channel<0>, "Red of \"#rrggbb\", 0 to 1." });
	functions.push_back({ "colorHexToG", { text }, ValueType::Number, color_channel<1>, "Green of \"#rrggbb\", 0 to 1." });
	functions.push_back({ "colorHexToB", { text }, ValueType::Number, color_channel<2>, "Blue of \"#rrggbb\", 0 to 1." });
}

} // namespace pcg::cga
