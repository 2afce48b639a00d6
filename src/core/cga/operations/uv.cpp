#include "core/cga/uv.h"

#include <algorithm>
#include <cmath>

#include "core/cga/context.h"
#include "core/cga/operations/operations.h"

// Moving, scaling and turning texture coordinates (CGA reference, section 7.5).
namespace pcg::cga {

namespace {

// The set that the first argument names, if the shape has it.
bool find_set(Vm &vm, const Args &args, size_t &set) {
	Context &context = Context::of(vm);
	const int found = uv_set_of(context, args[0]);
	if (found < 0 || context.shape.geometry == nullptr) {
		return false;
	}
	set = size_t(found);
	if (context.shape.geometry->uvs(set) == nullptr) {
		vm.warn("no-uvs", "there are no texture coordinates in set " + std::to_string(found), "projectUV() makes some; streets and assets bring their own");
		return false;
	}
	return true;
}

template <typename Map> void map_uvs(Context &context, size_t set, Map map) {
	const Geometry &geometry = *context.shape.geometry;
	glm::dvec2 *uvs = context.arena.allocate<glm::dvec2>(geometry.point_count);
	for (uint32_t i = 0; i < geometry.point_count; ++i) {
		uvs[i] = map(geometry.uvs(set)[i]);
	}
	context.shape.geometry = with_uvs(geometry, set, uvs, context.arena);
}

Flow translate_uv(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	size_t set = 0;
	if (find_set(vm, args, set)) {
		const glm::dvec2 shift(context.finite(args[1]), context.finite(args[2]));
		map_uvs(context, set, [&](glm::dvec2 uv) { return uv + shift; });
	}
	return Flow::Next;
}

Flow scale_uv(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	size_t set = 0;
	if (find_set(vm, args, set)) {
		const glm::dvec2 factor(context.finite(args[1]), context.finite(args[2]));
		map_uvs(context, set, [&](glm::dvec2 uv) { return uv * factor; });
	}
	return Flow::Next;
}

Flow rotate_uv(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	size_t set = 0;
	if (find_set(vm, args, set)) {
		const glm::dmat3 turn = rotation_from_euler({ 0.0, 0.0, context.finite(args[1]) });
		map_uvs(context, set, [&](glm::dvec2 uv) { return glm::dvec2(turn[0].x * uv.x + turn[1].x * uv.y, turn[0].y * uv.x + turn[1].y * uv.y); });
	}
	return Flow::Next;
}

enum NormalizeMode : uint32_t { Both, Uniform, OnlyU, OnlyV }; // order of the words

glm::dvec2 normalized(glm::dvec2 uv, const UvRange &range, uint32_t mode) {
	const glm::dvec2 size = range.size();
	const double largest = std::max(size.x, size.y);
	for (int axis = 0; axis < 2; ++axis) {
		const bool is_kept = (mode == OnlyU && axis == 1) || (mode == OnlyV && axis == 0);
		const double length = mode == Uniform ? largest : size[axis];
		if (!is_kept) {
			uv[axis] = length > 0.0 ? (uv[axis] - range.low[axis]) / length : uv[axis] - range.low[axis];
		}
	}
	return uv;
}

Flow normalize_uv(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	size_t set = 0;
	if (!find_set(vm, args, set)) {
		return Flow::Next;
	}
	const uint32_t mode = args[1].word;
	const Geometry &geometry = *context.shape.geometry;
	const glm::dvec2 *source = geometry.uvs(set);
	glm::dvec2 *uvs = context.arena.allocate<glm::dvec2>(geometry.point_count);
	const bool is_separate = args[2].word == 0;
	UvRange range = uv_range(geometry, set);
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		const GeometryFace &face = geometry.faces[f];
		const uint32_t first = geometry.first_point(face.first_loop);
		if (is_separate) {
			range = uv_range(geometry, face, source);
		}
		for (uint32_t i = first; i < first + geometry.face_point_count(face); ++i) {
			uvs[i] = normalized(source[i], range, mode);
		}
	}
	context.shape.geometry = with_uvs(geometry, set, uvs, context.arena);
	return Flow::Next;
}

// Tiles on a surface that is `metres` long. 0: the axis stays.
double tile_count(Context &context, const Value &value, double metres) {
	const double wanted = context.finite(value);
	if (wanted == 0.0) {
		return 0.0;
	}
	if (value.size_kind == SizeKind::Relative) {
		return 1.0 / wanted;
	}
	const double count = metres / wanted;
	return value.size_kind == SizeKind::Flexible ? std::copysign(std::max(1.0, std::round(std::abs(count))), count) : count;
}

Flow tile_uv(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	size_t set = 0;
	if (!find_set(vm, args, set)) {
		return Flow::Next;
	}
	const UvRange range = uv_range(*context.shape.geometry, set);
	const glm::dvec2 metres = range.size() * uv_stretch(context.shape, set);
	const double counts[2] = { tile_count(context, args[1], metres.x), tile_count(context, args[2], metres.y) };
	map_uvs(context, set, [&](glm::dvec2 uv) {
		for (int axis = 0; axis < 2; ++axis) {
			if (counts[axis] != 0.0 && range.size()[axis] > 0.0) {
				uv[axis] = (uv[axis] - range.low[axis]) / range.size()[axis] * counts[axis];
			}
		}
		return uv;
	});
	return Flow::Next;
}

Flow delete_uv(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	const int set = uv_set_of(context, args[0]);
	if (set >= 0 && context.shape.geometry != nullptr && context.shape.geometry->uvs(size_t(set)) != nullptr) {
		context.shape.geometry = with_uvs(*context.shape.geometry, size_t(set), nullptr, context.arena);
	}
	return Flow::Next;
}

Flow copy_uv(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	size_t from = 0;
	const int to = uv_set_of(context, args[1]);
	if (to >= 0 && find_set(vm, args, from)) {
		context.shape.geometry = with_uvs(*context.shape.geometry, size_t(to), context.shape.geometry->uvs(from), context.arena);
	}
	return Flow::Next;
}

} // namespace

void add_uv_operations(Dialect &dialect) {
	using enum ParamKind;
	auto &operations = dialect.operations;
	const ParamSpec set = { "uvSet", Number }, u = { "u", Number }, v = { "v", Number };
	operations.push_back({ "translateUV", { set, u, v }, BlockKind::None, translate_uv, "Adds to the texture coordinates of a set." });
	operations.push_back({ "offsetUV", { set, u, v }, BlockKind::None, translate_uv, "The old name of translateUV." });
	operations.push_back({ "scaleUV", { set, u, v }, BlockKind::None, scale_uv, "Multiplies the texture coordinates of a set: 2 makes pictures half as large." });
	operations.push_back({ "rotateUV", { set, { "degrees", Number } }, BlockKind::None, rotate_uv, "Turns the texture coordinates of a set about (0, 0)." });
	operations.push_back({ "normalizeUV", { set, { "mode", Word, "uv uvUniform u v" }, { "faces", Word, "separatePerFace collectiveAllFaces" } }, BlockKind::None,
			normalize_uv, "Brings the texture coordinates of a set into 0 to 1: both axes, both by one factor, or one of them; each face by itself or all together." });
	operations.push_back({ "tileUV", { set, { "width", Size }, { "height", Size } }, BlockKind::None, tile_uv,
			"Scales the texture coordinates of a set so that a tile is so many metres on the surface, beginning where the surface begins; ~2 makes a whole "
			"number of tiles, '0.5 two tiles, 0 leaves the axis." });
	operations.push_back({ "deleteUV", { set }, BlockKind::None, delete_uv, "Takes a set of texture coordinates away; its map then uses set 0." });
	operations.push_back({ "copyUV", { { "from", Number }, { "to", Number } }, BlockKind::None, copy_uv, "Copies texture coordinates from one set to another." });
}

} // namespace pcg::cga
