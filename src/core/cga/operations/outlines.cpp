#include "core/cga/operations/face_pieces.h"
#include "core/cga/operations/operations.h"
#include "core/cga/rectify.h"
#include "core/geometry/convex_parts.h"
#include "core/geometry/polygon.h"
#include "core/geometry/setback.h"

// Operations that change the outlines of faces in their plane (CGA reference, sections 4.6, 4.8 and 6).
namespace pcg::cga {

namespace {

enum class Keep : uint32_t { All, Inside, Border };

Flow offset(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	const Geometry *geometry = baked(context.shape, context.arena);
	const double distance = context.finite(args[0]);
	const Keep keep = args.count() > 1 ? Keep(args[1].word) : Keep::All;
	if (geometry == nullptr) {
		return Flow::Next;
	}
	if (args.count() > 1) { // what is left out stands in the way all the same
		context.record_occluder();
	}
	context.builder.clear();
	if (distance <= 0.0) { // texture coordinates end at the outline
		context.builder.begin(*geometry);
	}
	bool is_complete = true;
	for (const FlatFace &face : flat_faces(*geometry)) {
		const Setback result =
				distance > 0.0 ? grow(face.loops(), distance) : set_back(face.loops(), SmallVector<double, 8>(face.edge_count(), -distance));
		is_complete &= result.is_complete;
		for (size_t i = 0; keep != Keep::Border && i < result.rest.size(); ++i) {
			face.add(context.builder, result.rest[i], FaceTag::Inside);
		}
		for (size_t i = 0; keep != Keep::Inside && i < result.strips.size(); ++i) {
			face.add(context.builder, result.strips[i].polygon, FaceTag::Border);
		}
	}
	if (!is_complete) {
		vm.warn("broken-outline", "the outline of this face crosses itself or has a corner sharper than a tenth of a degree; it is not moved");
	}
	replace_faces(context); // nothing is left: the geometry stays
	return Flow::Next;
}

Flow convexify(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	const Geometry *geometry = baked(context.shape, context.arena);
	if (geometry == nullptr) {
		return Flow::Next;
	}
	const double longest = args.count() > 0 ? context.finite(args[0]) : 1e12;
	context.builder.begin(*geometry);
	for (const FlatFace &face : flat_faces(*geometry)) {
		for (const Loops2 &part : convex_parts(face.loops(), longest)) {
			face.add(context.builder, part);
		}
	}
	replace_faces(context);
	return Flow::Next;
}

Flow delete_holes(Vm &vm, const Args &) {
	Context &context = Context::of(vm);
	const Geometry *geometry = baked(context.shape, context.arena);
	if (geometry == nullptr || geometry->loop_count == geometry->face_count) {
		return Flow::Next;
	}
	context.builder.begin(*geometry);
	for (const FlatFace &face : flat_faces(*geometry)) {
		face.add(context.builder, face.loops()[0], face.face().tag);
	}
	replace_faces(context);
	return Flow::Next;
}

// Every face as it is seen from above the plane y = 0, looking up.
Loops2 seen_from_above(const Geometry &geometry) {
	constexpr glm::dvec3 up(0.0, 1.0, 0.0);
	Loops2 loops;
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		const GeometryFace &face = geometry.faces[f];
		bool is_reversed = false;
		for (uint32_t i = 0; i < face.loop_count; ++i) {
			Loop2 loop;
			for (const glm::dvec3 &point : geometry.loop(face.first_loop + i)) {
				loop.push_back(flatten(point, up));
			}
			is_reversed = i == 0 ? signed_area(loop) < 0.0 : is_reversed;
			loops.emplace_back(is_reversed ? Loop2(loop.rbegin(), loop.rend()) : loop);
		}
	}
	return loops;
}

Flow footprint(Vm &vm, const Args &) {
	Context &context = Context::of(vm);
	const Geometry *geometry = baked(context.shape, context.arena);
	if (geometry == nullptr) {
		return Flow::Next;
	}
	if (geometry->point_count > 20'000) {
		vm.warn("too-many-edges", "this geometry has too many edges for a footprint; it stays as it is", "reduce it first, or use the scope's base");
		return Flow::Next;
	}
	context.builder.clear();
	for (const Loops2 &polygon : overlay(seen_from_above(*geometry), {}, OverlayKind::Union)) {
		for (const Loop2 &loop : polygon) {
			for (const glm::dvec2 &point : without_straight_points(loop, 1e-7)) {
				context.builder.add_point({ point.y, 0.0, point.x });
			}
			context.builder.end_loop();
		}
		context.builder.end_face();
	}
	replace_faces(context);
	return Flow::Next;
}

Flow rectify(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	const double angle = context.finite(args[0]);
	if (!(angle >= 0.0 && angle <= 45.0)) {
		vm.warn("bad-angle", "rectify takes an angle from 0 to 45 degrees; the shape stays as it is");
		return Flow::Next;
	}
	if (const Geometry *geometry = baked(context.shape, context.arena)) {
		rectify(*geometry, angle, context.builder);
		replace_faces(context, geometry->is_closed);
	}
	return Flow::Next;
}

} // namespace

void add_outline_operations(Dialect &dialect) {
	using enum ParamKind;
	auto &operations = dialect.operations;
	operations.push_back({ "offset", { { "distance", Number }, { "keepFaces", Word, "all inside border", true } }, BlockKind::None, offset,
			"Moves the outline of each face inwards (distance below 0) or outwards, corners mitred. The result is the moved face (`inside` for comp) "
			"and a face along each edge (`border`), or only one of the two." });
	operations.push_back({ "convexify", { { "maxLength", Number, {}, true } }, BlockKind::None, convexify,
			"Cuts concave faces into convex ones along diagonals, with a length only along shorter ones." });
	operations.push_back({ "deleteHoles", {}, BlockKind::None, delete_holes, "Closes the holes of all faces." });
	operations.push_back({ "footprint", {}, BlockKind::None, footprint, "The outline of the shape as seen from above, on the bottom of its scope." });
	operations.push_back({ "rectify", { { "angle", Number } }, BlockKind::None, rectify,
			"Turns edges that are off the scope's axes by less than this angle (degrees, up to 45) parallel to them." });
}

} // namespace pcg::cga
