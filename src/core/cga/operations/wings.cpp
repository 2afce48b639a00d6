#include <algorithm>
#include <array>

#include "core/cga/components.h"
#include "core/cga/operations/face_pieces.h"
#include "core/cga/operations/operations.h"
#include "core/geometry/inner_rectangle.h"
#include "core/geometry/setback.h"

// Operations that part each face into a shape and a remainder (CGA reference, sections 4.5 and 4.7).
namespace pcg::cga {

namespace {

// The two kinds of pieces of all faces.
struct ShapeAndRest {
	SmallVector<FlatFace, 1> faces;
	FacePieces shape, rest;
};

Flow run_both(Context &context, const Block &block, const ShapeAndRest &pieces) {
	Context::Children children(context);
	for (const BlockEntry &entry : context.vm.entries(block)) {
		const bool is_shape = is_word(context, entry, "shape");
		if (!is_shape && !is_word(context, entry, "remainder")) {
			context.vm.warn("unknown-selector", "only `shape` and `remainder` can be selected here");
			continue;
		}
		if (run_pieces(context, children, children.parent(), entry, seen(is_shape ? pieces.shape : pieces.rest)) != Flow::Next) {
			return Flow::Stop;
		}
	}
	return Flow::Next;
}

Loops2 begun_at_first_edge(Loops2 polygon, const FlatFace &face) {
	polygon[0] = begun_near(polygon[0], face.loops()[0][0], face.loops()[0][1]);
	return polygon;
}

// --- shapeL, shapeU, shapeO

// Strips that meet on a straight edge leave a point there that is no corner of the face.
Loops2 without_seams(const Loops2 &polygon, const FlatFace &face) {
	Loops2 result;
	for (const Loop2 &loop : polygon) {
		const Loop2 corners = without_straight_points(loop, 1e-7);
		const auto is_seam = [&](glm::dvec2 point) {
			const auto has = [&](const Loop2 &points) { return std::ranges::find(points, point) != points.end(); };
			return !has(corners) && std::ranges::none_of(face.loops(), has);
		};
		result.push_back(loop);
		if (corners.size() < loop.size()) {
			erase_if(result.back(), is_seam);
		}
	}
	return result;
}

struct Wing {
	SelectorKind side;
	double depth;
};

double depth_of(std::span<const Wing> wings, const Component &edge, const Shape &shape) {
	const auto wing = std::ranges::find(wings, scope_side(edge, shape), &Wing::side);
	return wing != wings.end() ? wing->depth : 0.0;
}

Flow make_wings(Context &context, const Block *block, std::span<const Wing> wings) {
	context.mark_replaced();
	const Geometry *geometry = baked(context.shape, context.arena);
	if (geometry == nullptr || block == nullptr) {
		return Flow::Next;
	}
	ShapeAndRest pieces{ flat_faces(*geometry), {}, {} };
	std::vector<ComponentInfo> edges = components_of(*geometry, ComponentKind::FaceEdges);
	std::erase_if(edges, [&](const ComponentInfo &info) { return geometry->outline(geometry->faces[info.face]).size() < 3; });
	uint32_t first = 0;
	for (const FlatFace &face : pieces.faces) {
		SmallVector<double, 8> depths;
		for (uint32_t i = 0; i < face.edge_count(); ++i) {
			depths.push_back(depth_of(wings, edges[first + i].component, context.shape));
		}
		first += face.edge_count();
		Setback result = set_back(face.loops(), depths);
		if (!result.is_complete) {
			context.vm.warn("broken-outline", "the outline of this face crosses itself; it gets no wings");
		}
		for (const Loops2 &polygon : joined_strips(result)) {
			pieces.shape.push_back({ &face, begun_at_first_edge(without_seams(polygon, face), face) });
		}
		for (Loops2 &polygon : result.rest) {
			pieces.rest.push_back({ &face, std::move(polygon) });
		}
	}
	return run_both(context, *block, pieces);
}

Flow shape_l(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	const std::array wings = { Wing{ SelectorKind::Front, setback_distance(context, args[0]) }, Wing{ SelectorKind::Left, setback_distance(context, args[1]) } };
	return make_wings(context, args.block, wings);
}

Flow shape_u(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	const std::array wings = { Wing{ SelectorKind::Front, setback_distance(context, args[0]) }, Wing{ SelectorKind::Right, setback_distance(context, args[1]) },
		Wing{ SelectorKind::Left, setback_distance(context, args[2]) } };
	return make_wings(context, args.block, wings);
}

Flow shape_o(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	const std::array wings = { Wing{ SelectorKind::Front, setback_distance(context, args[0]) }, Wing{ SelectorKind::Right, setback_distance(context, args[1]) },
		Wing{ SelectorKind::Back, setback_distance(context, args[2]) }, Wing{ SelectorKind::Left, setback_distance(context, args[3]) } };
	return make_wings(context, args.block, wings);
}

// --- innerRectangle

constexpr uint32_t most_corners = 1000; // of a face in which a rectangle is looked for, which takes the square of that and more

Loop2 rectangle_in(Context &context, const FlatFace &face, bool is_along_edges) {
	if (face.edge_count() > most_corners) {
		context.vm.warn("too-many-edges", "this face has too many edges to look for the largest rectangle in it", "simplify it first");
		return {};
	}
	const Loop2 rectangle = is_along_edges ? largest_rectangle_along_edges(face.loops()) : largest_rectangle(face.loops());
	return rectangle.empty() ? rectangle : begun_near(rectangle, face.loops()[0][0], face.loops()[0][1]);
}

Flow inner_rectangle(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	context.mark_replaced();
	const Geometry *geometry = baked(context.shape, context.arena);
	if (geometry == nullptr || args.block == nullptr) {
		return Flow::Next;
	}
	ShapeAndRest pieces{ flat_faces(*geometry, FlatFace::View::AlongAxis), {}, {} };
	for (const FlatFace &face : pieces.faces) {
		const Loop2 rectangle = rectangle_in(context, face, args[0].word == 1);
		if (rectangle.empty()) {
			pieces.rest.push_back({ &face, face.loops() });
			continue;
		}
		pieces.shape.push_back({ &face, { rectangle } });
		for (const Loops2 &polygon : overlay(face.loops(), { rectangle }, OverlayKind::Difference)) {
			pieces.rest.push_back({ &face, begun_at_first_edge(polygon, face) });
		}
	}
	return run_both(context, *args.block, pieces);
}

Flow inner_rect(Vm &vm, const Args &) {
	Context &context = Context::of(vm);
	const Geometry *geometry = baked(context.shape, context.arena);
	if (geometry == nullptr) {
		return Flow::Next;
	}
	context.builder.begin(*geometry);
	for (const FlatFace &face : flat_faces(*geometry, FlatFace::View::AlongAxis)) {
		const Loop2 rectangle = rectangle_in(context, face, false);
		if (!rectangle.empty()) {
			face.add(context.builder, rectangle);
		}
	}
	replace_faces(context);
	return Flow::Next;
}

} // namespace

void add_wing_operations(Dialect &dialect) {
	dialect.selector_words.push_back("shape");
	using enum ParamKind;
	auto &operations = dialect.operations;
	const ParamSpec front = { "frontWidth", Number }, right = { "rightWidth", Number }, back = { "backWidth", Number }, left = { "leftWidth", Number };
	operations.push_back({ "shapeL", { front, left }, BlockKind::Selectors, shape_l,
			"Cuts an L off each face: strips along the edges that look to the scope's front and left. `shape` is the L, `remainder` the rest." });
	operations.push_back({ "shapeU", { front, right, left }, BlockKind::Selectors, shape_u, "As shapeL, along front, right and left." });
	operations.push_back({ "shapeO", { front, right, back, left }, BlockKind::Selectors, shape_o, "As shapeL, along all four sides." });
	operations.push_back({ "innerRectangle", { { "alignment", Word, "scope edge" } }, BlockKind::Selectors, inner_rectangle,
			"The largest rectangle in each face, along the scope's axes or along one of the face's longer edges: `shape` is the rectangle, "
			"`remainder` what is around it." });
	operations.push_back({ "innerRect", {}, BlockKind::None, inner_rect, "Puts the largest rectangle along the scope's axes in the place of each face." });
}

} // namespace pcg::cga
