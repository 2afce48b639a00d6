#include <algorithm>
#include <cmath>

#include "core/cga/context.h"
#include "core/cga/operations/operations.h"
#include "core/cga/uv.h"

// setupProjection and projectUV (CGA reference, section 7.4).
namespace pcg::cga {

namespace {

// Two letters of each word, the first for u; `x` and `z` are old: the faces that look along that axis.
constexpr std::string_view axes_words = "scope.xy scope.xz scope.yx scope.yz scope.zx scope.zy world.xy world.xz world.yx world.yz world.zx world.zy "
										"x y z";
struct ProjectionAxes {
	bool is_world;
	int u, v;
};
constexpr ProjectionAxes axes_of_word[] = { { false, 0, 1 }, { false, 0, 2 }, { false, 1, 0 }, { false, 1, 2 }, { false, 2, 0 }, { false, 2, 1 },
	{ true, 0, 1 }, { true, 0, 2 }, { true, 1, 0 }, { true, 1, 2 }, { true, 2, 0 }, { true, 2, 1 }, { false, 2, 1 }, { false, 0, 2 }, { false, 0, 1 } };

// Origin and axes in the derivation's coordinates; sizes of the scope along them.
struct ProjectionFrame {
	Frame frame;
	glm::dvec3 size;
};

ProjectionFrame frame_of(const Context &context, bool is_world) {
	const Frame scope = context.shape.frame();
	if (!is_world) {
		return { scope, context.shape.size };
	}
	ProjectionFrame result = { { glm::dmat3(1.0), -context.lot().origin }, glm::dvec3(0.0) };
	for (int axis = 0; axis < 3; ++axis) {
		for (int own = 0; own < 3; ++own) {
			result.size[axis] += std::abs(scope.axes[own][axis] * context.shape.size[own]);
		}
	}
	return result;
}

// Metres of one tile. 0: the axis has no picture.
double tile_size(Context &context, const Value &value, double size) {
	const double wanted = context.finite(value);
	if (value.size_kind == SizeKind::Relative) {
		return wanted * size;
	}
	if (value.size_kind == SizeKind::Flexible && wanted != 0.0) { // a whole number of tiles
		const double count = std::max(1.0, std::round(std::abs(size / wanted)));
		return std::copysign(size / count, wanted * (size < 0.0 ? -1.0 : 1.0));
	}
	return wanted;
}

Flow setup_projection(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	const int set = uv_set_of(context, args[0]);
	if (set < 0) {
		return Flow::Next;
	}
	const ProjectionAxes axes = axes_of_word[args[1].word];
	const auto [frame, size] = frame_of(context, axes.is_world);
	const double width = tile_size(context, args[2], size[axes.u]), height = tile_size(context, args[3], size[axes.v]);
	const bool is_old = args.count() == 5;
	const double width_offset = args.count() > 5 ? context.length(args[4], size[axes.u]) : 0.0;
	const double height_offset = args.count() > 5 ? context.length(args[5], size[axes.v]) : 0.0;
	const double third = is_old ? context.finite(args[4]) : args.count() > 6 ? context.finite(args[6]) : 0.0;
	if (width == 0.0 || height == 0.0) {
		vm.warn("bad-tile-size", "a tile of this projection has no size; that axis of the picture is not laid out",
				"a relative size (') of a scope that is flat along this axis is 0: choose other axes");
	}
	Projection projection;
	const glm::dvec3 along_u = frame.axes[axes.u] + third * frame.axes[3 - axes.u - axes.v];
	if (width != 0.0) {
		projection.u = along_u / width;
		projection.u0 = -(glm::dot(along_u, frame.origin) + width_offset) / width;
	}
	if (height != 0.0) {
		projection.v = frame.axes[axes.v] / height;
		projection.v0 = -(glm::dot(frame.axes[axes.v], frame.origin) + height_offset) / height;
	}
	Shape &shape = context.shape;
	Projections *projections = context.arena.make(shape.projections != nullptr ? *shape.projections : Projections());
	projections->sets[set] = context.arena.make(projection);
	shape.projections = projections;
	return Flow::Next;
}

// The same map, from the coordinates of the geometry.
Projection from_geometry(const Projection &projection, const Shape &shape) {
	const Frame frame = shape.frame();
	const auto turned = [&](glm::dvec3 row) { return glm::transpose(frame.axes) * row; };
	const glm::dvec3 u = turned(projection.u), v = turned(projection.v);
	return { u * shape.geometry_scale, v * shape.geometry_scale, projection.u0 + glm::dot(projection.u, frame.origin) + glm::dot(u, shape.geometry_offset),
		projection.v0 + glm::dot(projection.v, frame.origin) + glm::dot(v, shape.geometry_offset) };
}

Flow project_uv(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	Shape &shape = context.shape;
	const int set = uv_set_of(context, args[0]);
	if (set < 0 || shape.geometry == nullptr) {
		return Flow::Next;
	}
	const Projection *projection = shape.projections != nullptr ? shape.projections->sets[set] : nullptr;
	if (projection == nullptr) {
		vm.warn("no-projection", "nothing was set up for texture coordinate set " + std::to_string(set) + "; there is nothing to project",
				"call setupProjection() for this set first, on this shape or on one that it is made of");
		return Flow::Next;
	}
	const Geometry &geometry = *shape.geometry;
	const Projection local = from_geometry(*projection, shape);
	glm::dvec2 *uvs = context.arena.allocate<glm::dvec2>(geometry.point_count);
	for (uint32_t i = 0; i < geometry.point_count; ++i) {
		uvs[i] = local.at(geometry.points[i]);
	}
	shape.geometry = with_uvs(geometry, size_t(set), uvs, context.arena);
	return Flow::Next;
}

} // namespace

void add_projection_operations(Dialect &dialect) {
	using enum ParamKind;
	auto &operations = dialect.operations;
	const ParamSpec set = { "uvSet", Number };
	const std::vector<ParamSpec> basic = { set, { "axes", Word, axes_words }, { "width", Size }, { "height", Size } };
	const auto with = [&](std::vector<ParamSpec> more) {
		std::vector<ParamSpec> params = basic;
		params.insert(params.end(), more.begin(), more.end());
		return params;
	};
	operations.push_back({ "setupProjection", basic, BlockKind::None, setup_projection,
			"Lays a picture in space for projectUV(): its u and v run along two axes of the scope or the world, from the origin, and one tile is width x "
			"height metres; '1 is the scope's size, ~2 as many tiles of about 2 m as fit, less than 0 mirrors." });
	operations.push_back({ "setupProjection", with({ { "uwFactor", Number } }), BlockKind::None, setup_projection,
			"The old form: the third axis adds to u, times uwFactor." });
	operations.push_back({ "setupProjection", with({ { "widthOffset", Size }, { "heightOffset", Size }, { "uwFactor", Number, {}, true } }), BlockKind::None,
			setup_projection, "The same with the picture's origin moved by offsets in metres; the third axis adds to u, times uwFactor." });
	operations.push_back({ "projectUV", { set }, BlockKind::None, project_uv,
			"Makes texture coordinates by the projection that setupProjection() left with this shape or with one that it was cut from." });
}

} // namespace pcg::cga
