#include "core/cga/frames.h"

#include <cmath>
#include <iterator>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/cga/context.h"
#include "core/cga/operations/operations.h"
#include "core/geometry/polygon.h"

// Operations that give the scope other axes while the geometry stays (CGA reference, section 3).
namespace pcg::cga {

namespace {

// `kept` is projected; where it lies along the axis the third one is, so that a wall whose first edge is upright stays flat in its scope.
glm::dvec3 kept_direction(glm::dvec3 axis, glm::dvec3 kept, glm::dvec3 instead) {
	return glm::length(glm::cross(axis, kept)) > 1e-9 ? kept : instead;
}

// One axis of the scope goes to that of the system, the rest turns along as little as it can.
glm::dmat3 aligned_axes(const glm::dmat3 &system, const glm::dmat3 &old, uint32_t axis) {
	if (axis == 1) {
		return axes_from_y(system[1], kept_direction(system[1], old[0], glm::cross(system[1], old[2])));
	}
	if (axis == 2) {
		return axes_from_z(system[2], kept_direction(system[2], old[0], glm::cross(old[1], system[2])));
	}
	// x is z without its part along the axis
	const glm::dmat3 from_z = axes_from_z(system[0], kept_direction(system[0], old[2], glm::cross(system[0], old[1])));
	const glm::dvec3 z = from_z[0];
	return glm::dmat3(system[0], glm::cross(z, system[0]), z);
}

void align_to_axes(Context &context, uint32_t word) {
	Shape &shape = context.shape;
	const bool is_object = word >= 8;
	const uint32_t axis = word % 4;
	const glm::dmat3 system = is_object ? context.lot().object_axes : glm::dmat3(1.0);
	const glm::dmat3 axes = axis == 3 ? system : aligned_axes(system, shape.frame().axes, axis);
	align_scope(shape, axes, context.builder, context.arena);
}

Flow align_to_world(Vm &vm, const Args &) {
	align_to_axes(Context::of(vm), 3);
	return Flow::Next;
}

Flow align_to_system(Vm &vm, const Args &args) {
	align_to_axes(Context::of(vm), args[0].word);
	return Flow::Next;
}

Flow align_to_face(Vm &vm, const Args &args) {
	using enum FaceChoice::Kind;
	static constexpr FaceChoice::Kind faces[] = { Lowest, Largest, Any };
	static constexpr EdgeChoice::Kind edges[] = { EdgeChoice::Kind::Lowest, EdgeChoice::Kind::Longest };
	Context &context = Context::of(vm);
	const FaceChoice face = args[1].is_number() ? FaceChoice{ Index, context.finite(args[1]) } : FaceChoice{ faces[args[1].word], 0.0 };
	const EdgeChoice edge = args[2].is_number() ? EdgeChoice{ EdgeChoice::Kind::Index, context.finite(args[2]) } : EdgeChoice{ edges[args[2].word], 0.0 };
	align_scope_to_geometry(context.shape, args[0].word == 1, face, edge, context.builder, context.arena);
	return Flow::Next;
}

// Of files before 2010.1.
Flow align_to_edge(Vm &vm, const Args &args) {
	using enum EdgeChoice::Kind;
	static constexpr EdgeChoice::Kind edges[] = { Auto, Lowest, Longest };
	Context &context = Context::of(vm);
	const bool is_index = args[1].is_number();
	const EdgeChoice edge = is_index ? EdgeChoice{ Index, context.finite(args[1]) } : EdgeChoice{ edges[args[1].word], 0.0 };
	const FaceChoice face = { is_index ? FaceChoice::Kind::Index : FaceChoice::Kind::Any, 0.0 };
	align_scope_to_geometry(context.shape, args[0].word == 1, face, edge, context.builder, context.arena);
	return Flow::Next;
}

Flow align_to_rectangle(Vm &vm, const Args &args) {
	static constexpr int axes[][2] = { { 0, 1 }, { 1, 0 }, { 0, 2 }, { 2, 0 }, { 1, 2 }, { 2, 1 } };
	Context &context = Context::of(vm);
	const auto &[longer, shorter] = axes[args[0].word];
	align_scope_to_rectangle(context.shape, longer, shorter, context.builder, context.arena);
	return Flow::Next;
}

Flow pivot(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	const double corner = std::trunc(context.finite(args[1]));
	if (!(corner >= 0.0 && corner <= 7.0)) {
		vm.warn("bad-corner", "corners of a scope are numbered from 0 to 7; the pivot stays where it is");
		return Flow::Next;
	}
	set_pivot(context.shape, PivotOrder(args[0].word), uint32_t(corner), context.builder, context.arena);
	return Flow::Next;
}

Flow mirror_axes(Vm &vm, const Args &args) {
	for (int axis = 0; axis < 3; ++axis) {
		if (args[size_t(axis)].boolean) {
			mirror_scope(Context::of(vm).shape, axis);
		}
	}
	return Flow::Next;
}

Flow mirror(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	mirror_geometry(context.shape, { args[0].boolean, args[1].boolean, args[2].boolean }, context.builder, context.arena);
	return Flow::Next;
}

} // namespace

void add_frame_operations(Dialect &dialect) {
	using enum ParamKind;
	auto &operations = dialect.operations;
	const ParamSpec up = { "up", Word, "yUp zUp" };
	const std::vector<ParamSpec> flips = { { "x", Bool }, { "y", Bool }, { "z", Bool } };
	operations.push_back({ "alignScopeToAxes", {}, BlockKind::None, align_to_world, "Turns the scope to the world's axes and puts the pivot at its corner; the geometry stays." });
	operations.push_back({ "alignScopeToAxes", { { "axes", Word, "x y z xyz world.x world.y world.z world.xyz object.x object.y object.z object.xyz" } },
			BlockKind::None, align_to_system, "The same for one axis of the world or of the object's system; with x z is kept as far as it can, with y and z x is." });
	operations.push_back({ "alignScopeToGeometry", { up, { "face", WordOrNumber, "world.lowest largest any" }, { "edge", WordOrNumber, "world.lowest longest" } },
			BlockKind::None, align_to_face,
			"Turns the scope to a face: x along one of its edges, y or z its normal; the geometry stays. Numbers below 0 count from the end; `any` is the face "
			"that the edge selector likes best." });
	operations.push_back({ "alignScopeToGeometry", { up, { "edge", WordOrNumber, "auto world.lowest longest" } }, BlockKind::None, align_to_edge,
			"The form of old files: an edge of the first face; auto takes the lowest edge, or the longest where all are equally low." });
	operations.push_back({ "alignScopeToGeometryBBox", { { "axes", Word, "xy yx xz zx yz zy" } }, BlockKind::None, align_to_rectangle,
			"Turns two axes of the scope about the third until they span the smallest rectangle around the geometry; the first one becomes the longer side." });
	operations.push_back({ "setPivot", { { "axes", Word, "xyz yzx zxy" }, { "corner", Number } }, BlockKind::None, pivot,
			"Puts the pivot to a corner of the scope, 0 to 7, with its axes into the box; the geometry stays." });
	operations.push_back({ "mirrorScope", flips, BlockKind::None, mirror_axes, "Puts the scope's origin to the other end of an axis and makes its size negative; the geometry stays." });
	operations.push_back({ "mirror", flips, BlockKind::None, mirror, "Mirrors the geometry inside of the scope; its faces still look outwards." });
}

} // namespace pcg::cga
