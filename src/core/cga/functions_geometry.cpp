#include <algorithm>
#include <cmath>

#include "core/cga/components.h"
#include "core/cga/context.h"
#include "core/cga/measure.h"
#include "core/cga/operations/operations.h"

// What rules ask of the shape's geometry (CGA reference, section 8.3).
namespace pcg::cga {

namespace {

const Shape &shape_of(Vm &vm) {
	return Context::of(vm).shape;
}

template <double (*measure)(const Shape &)> Value measured(Vm &vm, const Args &) { return Value::of(measure(shape_of(vm))); }
template <bool (*measure)(const Shape &)> Value answered(Vm &vm, const Args &) { return Value::of(measure(shape_of(vm))); }

constexpr std::string_view side_words =
		"front back left right top bottom side vertical aslant horizontal nutant all surface object.front object.back object.left object.right object.top "
		"object.bottom object.side world.south world.north world.west world.east world.up world.down world.side street.front street.back street.left "
		"street.right street.side border inside";

Selector nth_selector(uint32_t index) {
	std::string_view words = side_words;
	for (; index > 0; --index) {
		words.remove_prefix(std::min(words.find(' ') + 1, words.size()));
	}
	return selector_of(words.substr(0, words.find(' ')));
}

// Calls `use` with the numbers of the faces that the selector takes.
template <typename Use> void for_each_selected(Context &context, Selector selector, Use use) {
	const Geometry *geometry = baked(context.shape, context.arena);
	if (geometry == nullptr) {
		return;
	}
	for (const ComponentInfo &info : components_of(*geometry, ComponentKind::Faces)) {
		if (matches(selector, info.component, context.shape, context.lot())) {
			use(info.face);
		}
	}
}

Value area_of_side(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	const Selector selector = nth_selector(args[0].word);
	double sum = 0.0;
	if (context.selection().component != nullptr) {
		sum = context.selects(selector) ? surface_area(context.shape) : 0.0;
	} else {
		for_each_selected(context, selector, [&](uint32_t face) { sum += face_area(context.shape, context.shape.geometry->faces[face]); });
	}
	return Value::of(sum);
}

// While comp() asks for a component, its direction counts as the whole shape sees it.
Value has_side(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	const Selector selector = nth_selector(args[0].word);
	if (context.selection().component != nullptr) {
		return Value::of(context.selects(selector));
	}
	bool result = false;
	for_each_selected(context, selector, [&](uint32_t) { result = true; });
	return Value::of(result);
}

Value lowest(Vm &vm, const Args &) {
	const Context &context = Context::of(vm);
	return Value::of(context.shape.geometry != nullptr ? vertical_extent(context.shape).first + context.lot().origin.y : 0.0);
}
Value height(Vm &vm, const Args &) {
	const auto [low, high] = vertical_extent(shape_of(vm));
	return Value::of(high - low);
}

Value slope_angle(Vm &vm, const Args &args) {
	const SlopeAngles angles = steepest_slope(shape_of(vm));
	return Value::of(args[0].word == 0 ? angles.slope : args[0].word == 1 ? angles.azimuth : 90.0 - angles.slope);
}

Value hole_count(Vm &vm, const Args &) {
	const Geometry *geometry = shape_of(vm).geometry;
	return Value::of(geometry != nullptr ? double(geometry->loop_count - geometry->face_count) : 0.0);
}
template <ComponentKind kind> Value component_count(Vm &vm, const Args &) {
	const Geometry *geometry = shape_of(vm).geometry;
	return Value::of(geometry != nullptr ? double(components_of(*geometry, kind).size()) : 0.0);
}

Value vertices(Vm &vm, const Args &) {
	const Geometry *geometry = shape_of(vm).geometry;
	return Value::of(geometry != nullptr ? double(vertex_count(*geometry)) : 0.0);
}

Value rectangular(Vm &vm, const Args &args) { return Value::of(is_rectangular(shape_of(vm), args.number_or(0, 0.0))); }
Value planar(Vm &vm, const Args &args) { return Value::of(is_planar(shape_of(vm), args.number_or(0, 0.25))); }
Value instanced(Vm &vm, const Args &) {
	const Geometry *geometry = shape_of(vm).geometry;
	return Value::of(geometry != nullptr && geometry->inserted == geometry);
}

} // namespace

void add_geometry_functions(Dialect &dialect) {
	auto &functions = dialect.functions;
	const ParamSpec side = { "selector", ParamKind::Word, side_words };
	const ParamSpec degrees = { "toleranceDeg", ParamKind::Number, {}, true };
	const auto add = [&](std::string_view name, std::vector<ParamSpec> params, ValueType type, FunctionHandler handler, std::string_view help) {
		functions.push_back({ name, std::move(params), type, handler, help });
	};
	add("geometry.area", {}, ValueType::Number, measured<surface_area>, "Area of all faces, square metres.");
	add("geometry.area", { side }, ValueType::Number, area_of_side, "Area of the faces that the selector of comp(f) would take.");
	add("geometry.volume", {}, ValueType::Number, measured<volume>, "Volume of a closed surface, cubic metres; else 0.");
	add("geometry.height", {}, ValueType::Number, height, "Extent along the world's vertical, metres.");
	add("geometry.lowerheight", {}, ValueType::Number, lowest, "Height of the lowest point in the world, metres.");
	add("geometry.angle", { { "what", ParamKind::Word, "maxSlope azimuth zenith" } }, ValueType::Number, slope_angle,
			"Of the steepest face, degrees: its slope to the horizontal; where it faces, clockwise from north; or 90 less its slope.");
	add("geometry.boundaryLength", {}, ValueType::Number, measured<boundary_length>, "Length of the edges that belong to one face only, metres.");
	add("geometry.nFaces", {}, ValueType::Number, measured<face_count>, "Number of faces.");
	add("geometry.nHoles", {}, ValueType::Number, hole_count, "Number of holes in faces.");
	add("geometry.nEdges", {}, ValueType::Number, component_count<ComponentKind::Edges>, "Number of edges; shared ones count once.");
	add("geometry.nVertices", {}, ValueType::Number, vertices, "Number of vertices; shared ones count once.");
	add("geometry.isConcave", {}, ValueType::Bool, answered<is_concave>, "Whether any face is concave.");
	add("geometry.isClosedSurface", {}, ValueType::Bool, answered<is_closed_surface>, "Whether every edge belongs to two faces.");
	add("geometry.isRectangular", { degrees }, ValueType::Bool, rectangular, "Whether every face has four right angles.");
	add("geometry.isPlanar", { degrees }, ValueType::Bool, planar, "Whether the corners of every face turn in one plane; 0.25 degrees if nothing is given.");
	add("geometry.isOriented", { side }, ValueType::Bool, has_side, "Whether the selector of comp(f) would take any face.");
	add("geometry.isInstanced", {}, ValueType::Bool, instanced, "Whether the geometry is an asset or a built-in body as it was inserted, not cut or changed since.");
}

} // namespace pcg::cga
