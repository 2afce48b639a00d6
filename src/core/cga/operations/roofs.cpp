#include "core/geometry/roof.h"

#include <cmath>

#include <glm/matrix.hpp>

#include "core/cga/context.h"
#include "core/cga/edges.h"
#include "core/cga/operations/operations.h"
#include "core/geometry/polygon.h"

// Roofs over each face (CGA reference, section 5.4).
namespace pcg::cga {

namespace {

struct RoofArgs {
	RoofSlope slope;
	double first = 0.0, second = 0.0; // overhangs
	bool is_even = false;
	int edge = -1;
	glm::dvec2 along{ 1.0, 0.0 }; // x of the scope, in the face
};

using RoofMaker = Roof (*)(const RoofOutline &outline, const RoofArgs &args);

RoofOutline flat_outline(const Geometry &geometry, const GeometryFace &face, const Frame &frame) {
	RoofOutline outline;
	for (uint32_t i = 0; i < face.loop_count; ++i) {
		outline.emplace_back();
		for (const glm::dvec3 &point : geometry.loop(face.first_loop + i)) {
			const glm::dvec3 local = frame.to_local(point);
			outline.back().push_back({ local.x, local.y });
		}
	}
	return outline;
}

void add_loop(GeometryBuilder &builder, const RoofLoop &loop, const Frame &frame) {
	for (const glm::dvec3 &point : loop) {
		builder.add_point(frame.to_parent(point));
	}
	builder.end_loop();
}

// The original face is face 0: CityEngine's own files drop it so, with comp(f) { 0 : NIL | .. }.
void add_roof_faces(GeometryBuilder &builder, const Roof &roof, const Frame &frame, uint16_t material) {
	for (const bool is_bottom : { true, false }) {
		for (const RoofFace &part : roof.faces) {
			if ((part.part == RoofPart::Bottom) != is_bottom) {
				continue;
			}
			add_loop(builder, part.outline, frame);
			for (const auto &hole : part.holes) {
				add_loop(builder, hole, frame);
			}
			builder.end_face(FaceTag::None, material);
		}
	}
}

// Over a level face, as most are, the scope stands upright as it is: nothing is turned, only put into its coordinates.
void put_upright(Context &context, const glm::dmat3 &axes) {
	Shape &shape = context.shape;
	if (axes != glm::dmat3(1.0)) {
		turn_scope(shape, axes, context.builder, context.arena);
		return;
	}
	shape.geometry = baked(shape, context.arena);
	shape.geometry_offset = glm::dvec3(0.0);
}

Flow make_roof(Context &context, RoofArgs args, RoofMaker maker) {
	Shape &shape = context.shape;
	const Geometry *geometry = baked(shape, context.arena);
	if (geometry == nullptr) {
		return Flow::Next;
	}
	GeometryBuilder &builder = context.builder;
	builder.clear();
	bool is_complete = true;
	for (uint32_t f = 0; f < geometry->face_count; ++f) {
		const GeometryFace &face = geometry->faces[f];
		const auto points = geometry->outline(face);
		if (points.size() < 3) {
			continue;
		}
		const Frame frame = { axes_from_z(face_normal(*geometry, face), points[1] - points[0]), points[0] };
		const glm::dvec2 along(frame.axes[0].x, frame.axes[1].x);
		args.along = glm::dot(along, along) > 1e-12 ? along : glm::dvec2(1.0, 0.0);
		const Roof roof = maker(flat_outline(*geometry, face, frame), args);
		is_complete &= roof.is_complete;
		add_roof_faces(builder, roof, frame, face.material);
	}
	if (!is_complete) {
		context.vm.warn("broken-roof", "this roof is incomplete: its outline crosses itself or is too small");
	}
	const glm::dvec3 normal = face_normal(*geometry, geometry->faces[0]);
	if (const Geometry *roof = builder.finish(context.arena, false)) {
		Geometry *result = context.arena.make(*roof);
		result->is_closed = is_complete && has_paired_edges(*roof); // overhangs leave it open
		set_geometry(shape, result);
		put_upright(context, axes_from_y(normal, { 1.0, 0.0, 0.0 }));
	}
	return Flow::Next;
}

// Angles outside of (0, 90) and heights that are not positive make no roof; a shed may also fall.
bool read_slope(Context &context, const Value &value, bool is_height, bool may_fall, RoofSlope &slope) {
	slope = { context.finite(value), is_height };
	const double size = may_fall ? std::abs(slope.value) : slope.value;
	if (size > 0.0 && (is_height || size < 89.9)) {
		return true;
	}
	context.vm.warn("bad-roof-slope", "a roof needs an angle between 0 and 90 degrees or a positive height; the face is left as it is");
	return false;
}

Roof hip(const RoofOutline &outline, const RoofArgs &args) {
	return roof_hip(outline, args.slope, args.first, args.is_even);
}
Roof gable(const RoofOutline &outline, const RoofArgs &args) {
	return roof_gable(outline, args.slope, args.first, args.second, args.is_even, args.edge);
}
Roof ridge(const RoofOutline &outline, const RoofArgs &args) {
	return roof_ridge(outline, args.slope, args.along);
}
Roof shed(const RoofOutline &outline, const RoofArgs &args) {
	return roof_shed(outline, args.slope, std::abs(args.first) < 1e6 ? int(args.first) : 0);
}
Roof pyramid(const RoofOutline &outline, const RoofArgs &args) {
	return roof_pyramid(outline, args.slope);
}

// Arguments from `first` on: overhangs, even, edge. `user` of the spec is the maker.
template <RoofMaker maker> Flow roof(Vm &vm, const Args &args, bool is_height, size_t first) {
	Context &context = Context::of(vm);
	RoofArgs roof_args;
	if (!read_slope(context, args[first], is_height, maker == shed, roof_args.slope)) {
		return Flow::Next;
	}
	size_t numbers = 0;
	for (size_t i = first + 1; i < args.count(); ++i) {
		if (args[i].is_bool()) {
			roof_args.is_even = args[i].boolean;
			numbers = 2;
		} else {
			const double value = context.finite(args[i]);
			(numbers == 0 ? roof_args.first : roof_args.second) = numbers < 2 ? value : roof_args.second;
			roof_args.edge = numbers == 2 ? int(value) : roof_args.edge;
			++numbers;
		}
	}
	return make_roof(context, roof_args, maker);
}

template <RoofMaker maker> Flow by_angle(Vm &vm, const Args &args) {
	return roof<maker>(vm, args, false, 0);
}
template <RoofMaker maker> Flow by_word(Vm &vm, const Args &args) {
	return roof<maker>(vm, args, args[0].word == 1, 1);
}

template <RoofMaker maker> void add_roof(Dialect &dialect, std::string_view name, std::vector<ParamSpec> more, std::string_view help) {
	using enum ParamKind;
	std::vector<ParamSpec> with_angle = { { "angle", Number } };
	std::vector<ParamSpec> with_word = { { "kind", Word, "byAngle byHeight" }, { "value", Number } };
	with_angle.insert(with_angle.end(), more.begin(), more.end());
	with_word.insert(with_word.end(), more.begin(), more.end());
	dialect.operations.push_back({ name, with_word, BlockKind::None, by_word<maker>, help });
	dialect.operations.push_back({ name, with_angle, BlockKind::None, by_angle<maker>, help });
}

} // namespace

void add_roof_operations(Dialect &dialect) {
	using enum ParamKind;
	const ParamSpec even = { "even", Bool, {}, true };
	const ParamSpec edge = { "edge", Number, {}, true };
	add_roof<hip>(dialect, "roofHip", { { "overhang", Number, {}, true }, even }, "A roof with a sloped plane on each edge.");
	add_roof<gable>(dialect, "roofGable", { { "overhangX", Number, {}, true }, { "overhangY", Number, {}, true }, even, edge },
			"A roof with upright gables at its ends.");
	add_roof<ridge>(dialect, "roofRidge", {}, "Two planes to one ridge that runs as x of the scope does; the walls follow the outline.");
	add_roof<shed>(dialect, "roofShed", { edge }, "One plane that rises from an edge, or falls from it if the angle is negative; edges below 0 count from the last.");
	add_roof<pyramid>(dialect, "roofPyramid", {}, "Triangles to a point above the middle.");
}

} // namespace pcg::cga
