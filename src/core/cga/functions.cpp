#include <algorithm>
#include <cmath>
#include <string>

#include "core/cga/components.h"
#include "core/cga/context.h"
#include "core/cga/measure.h"
#include "core/cga/functions/functions.h"
#include "core/cga/operations/operations.h"

// Functions of the shape grammar (CGA reference, sections 8.1 and 8.3).
namespace pcg::cga {

namespace {

const Shape &shape_of(Vm &vm) {
	return Context::of(vm).shape;
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
	add_geometry_functions(dialect);
	add_text_functions(dialect);
	add_list_functions(dialect);
	add_color_functions(dialect);
	add_array_functions(dialect);
	add_flow_functions(dialect);
}

} // namespace pcg::cga
