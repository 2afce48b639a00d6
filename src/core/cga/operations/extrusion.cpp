#include "core/cga/context.h"
#include "core/cga/extrude.h"
#include "core/cga/operations/operations.h"

// extrude, taper, reverseNormals (CGA reference, sections 5.3, 5.4, 6).
namespace pcg::cga {

namespace {

Flow extrude_along(Context &context, ExtrudeDirection direction, const Value &height) {
	const double metres = context.length(height, context.shape.size.y);
	if (context.shape.geometry != nullptr && !extrude(context.shape, direction, metres, context.is_paper_rule(), context.builder, context.arena)) {
		context.vm.warn("cannot-extrude", "the face cannot be extruded in this direction: the direction lies in its plane");
	}
	return Flow::Next;
}

Flow extrude_normal(Vm &vm, const Args &args) {
	return extrude_along(Context::of(vm), ExtrudeDirection::FaceNormal, args[0]);
}

Flow extrude_typed(Vm &vm, const Args &args) {
	using enum ExtrudeDirection;
	static constexpr ExtrudeDirection directions[] = { FaceNormal, VertexNormal, WorldY, WorldUpFlatTop, WorldX, WorldY, WorldZ, ScopeX, ScopeY, ScopeZ };
	return extrude_along(Context::of(vm), directions[args[0].word], args[1]);
}

Flow taper_face(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	taper(context.shape, context.length(args[0], context.shape.size.y), context.builder, context.arena);
	return Flow::Next;
}

Flow reverse(Vm &vm, const Args &) {
	Context &context = Context::of(vm);
	reverse_normals(context.shape, context.builder, context.arena);
	return Flow::Next;
}

} // namespace

void add_extrusion_operations(Dialect &dialect) {
	using enum ParamKind;
	auto &operations = dialect.operations;
	operations.push_back({ "extrude", { { "height", Size } }, BlockKind::None, extrude_normal,
			"Raises each face along its normal to a prism. In rules written with --> y turns to that direction; in rules written with -> (the "
			"paper's listings) the scope keeps its axes and a negative height makes a hollow seen from inside." });
	operations.push_back({ "extrude",
			{ { "direction", Word, "face.normal vertex.normal world.up world.up.flatTop world.x world.y world.z x y z" }, { "height", Size } },
			BlockKind::None, extrude_typed, "The same along one direction: straight up, to a level top, along the mean normals of the vertices so that faces stay together, or (old forms) along an axis of the world or of the scope." });
	operations.push_back({ "taper", { { "height", Size } }, BlockKind::None, taper_face, "A pyramid over the first face, its point above the centre of gravity." });
	operations.push_back({ "reverseNormals", {}, BlockKind::None, reverse, "Turns all faces around." });
}

} // namespace pcg::cga
