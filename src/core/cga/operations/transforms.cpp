#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include "core/cga/context.h"
#include "core/cga/operations/operations.h"

// Moving, turning and sizing the scope; the geometry goes along unless the operation says otherwise (CGA reference, section 3).
namespace pcg::cga {

namespace {

enum System { Scope, Pivot, Object, World }; // order of the words

Flow translate_scope(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	Shape &shape = context.shape;
	shape.position += shape.rotation * context.lengths(args, 0);
	return Flow::Next;
}

// Axes of a system, in the pivot's coordinates.
glm::dmat3 axes_of(System system, const Context &context) {
	const Shape &shape = context.shape;
	const glm::dmat3 to_pivot = glm::transpose(shape.pivot->axes);
	switch (system) {
		case Scope:
			return shape.rotation;
		case Object:
			return to_pivot * context.lot().object_axes;
		case World:
			return to_pivot;
		default:
			return glm::dmat3(1.0);
	}
}

Flow translate(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	Shape &shape = context.shape;
	const bool is_relative = args[0].word == 1;
	const System system = System(args[1].word);
	const glm::dvec3 vector = axes_of(system, context) * context.lengths(args, 2);
	if (is_relative || system == Scope) {
		shape.position += vector;
	} else if (system == Pivot) {
		shape.position = vector;
	} else { // a place in the object's or the world's system, as seen from the pivot
		const glm::dvec3 world = shape.pivot->axes * vector - (system == World ? context.lot().origin : glm::dvec3(0.0));
		shape.position = shape.pivot->to_local(world);
	}
	return Flow::Next;
}

glm::dvec3 angles(Context &context, const Args &args, size_t first) {
	return { context.finite(args[first]), context.finite(args[first + 1]), context.finite(args[first + 2]) };
}

Flow rotate_at_origin(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	context.shape.rotation = rotation_from_euler(angles(context, args, 0)) * context.shape.rotation;
	return Flow::Next;
}

Flow rotate_about(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	Shape &shape = context.shape;
	const bool is_about_center = args[0].word == 1;
	const glm::dmat3 turned = rotation_from_euler(angles(context, args, 1)) * shape.rotation;
	if (is_about_center) {
		shape.position += shape.rotation * (0.5 * shape.size) - turned * (0.5 * shape.size);
	}
	shape.rotation = turned;
	return Flow::Next;
}

Flow rotate(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	Shape &shape = context.shape;
	const bool is_relative = args[0].word == 1;
	const glm::dmat3 axes = axes_of(System(args[1].word), context);
	const glm::dmat3 turn = axes * rotation_from_euler(angles(context, args, 2)) * glm::transpose(axes);
	shape.rotation = is_relative ? turn * shape.rotation : turn * axes;
	return Flow::Next;
}

Flow rotate_scope(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	Shape &shape = context.shape;
	const glm::dmat3 turned = rotation_from_euler(angles(context, args, 0)) * shape.rotation;
	turn_scope(shape, glm::transpose(shape.rotation) * turned, context.builder, context.arena);
	return Flow::Next;
}

// A size that was 0 has nothing to scale: the geometry stays flat.
Flow size_scope(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	Shape &shape = context.shape;
	const glm::dvec3 size = context.lengths(args, 0);
	for (int axis = 0; axis < 3; ++axis) {
		const double factor = shape.size[axis] != 0.0 ? size[axis] / shape.size[axis] : 1.0;
		shape.geometry_offset[axis] *= factor;
		shape.geometry_scale[axis] *= factor;
	}
	shape.size = size;
	return Flow::Next;
}

Flow center(Vm &vm, const Args &args) {
	static constexpr bool chosen[][3] = { { true, false, false }, { false, true, false }, { false, false, true }, { true, true, false }, { true, false, true },
		{ false, true, true }, { true, true, true } };
	Context &context = Context::of(vm);
	Shape &shape = context.shape;
	const Shape &saved = context.saved_shape();
	const Frame frame = shape.frame();
	const glm::dvec3 from = frame.to_parent(0.5 * shape.size);
	const glm::dvec3 to = saved.frame().to_parent(0.5 * saved.size);
	glm::dvec3 shift = glm::transpose(frame.axes) * (to - from);
	for (int axis = 0; axis < 3; ++axis) {
		shift[axis] = chosen[args[0].word][axis] ? shift[axis] : 0.0;
	}
	shape.position += shape.rotation * shift;
	return Flow::Next;
}

} // namespace

void add_transform_operations(Dialect &dialect) {
	using enum ParamKind;
	const std::vector<ParamSpec> sizes = { { "x", Size }, { "y", Size }, { "z", Size } };
	const std::vector<ParamSpec> turns = { { "x", Number }, { "y", Number }, { "z", Number } };
	const ParamSpec mode = { "mode", Word, "abs rel" };
	const ParamSpec system = { "system", Word, "scope pivot object world" };
	auto &operations = dialect.operations;
	operations.push_back({ "t", sizes, BlockKind::None, translate_scope, "Moves the scope along its own axes. '0.5 is half of its size on that axis." });
	operations.push_back({ "s", sizes, BlockKind::None, size_scope,
			"Sets the size of the scope; the geometry is scaled with it about the scope's origin. '0.5 is half of the present size." });
	operations.push_back({ "r", turns, BlockKind::None, rotate_at_origin, "Turns the scope about its origin: degrees about x, then y, then z of the pivot." });
	operations.push_back({ "r", { { "center", Word, "scopeOrigin scopeCenter" }, turns[0], turns[1], turns[2] }, BlockKind::None, rotate_about,
			"The same about the origin or the centre of the scope." });
	operations.push_back({ "translate", { mode, system, sizes[0], sizes[1], sizes[2] }, BlockKind::None, translate,
			"Moves the scope by (rel) or to (abs) a vector of the given coordinate system." });
	operations.push_back({ "rotate", { mode, system, turns[0], turns[1], turns[2] }, BlockKind::None, rotate,
			"Turns the scope about its origin, from where it is (rel) or from the given system's axes (abs)." });
	operations.push_back({ "rotateScope", turns, BlockKind::None, rotate_scope, "Turns the scope but not the geometry; the scope is fitted anew." });
	operations.push_back({ "center", { { "axes", Word, "x y z xy xz yz xyz" } }, BlockKind::None, center,
			"Moves the scope so that its centre is that of the shape with which this body or bracket began." });
}

} // namespace pcg::cga
