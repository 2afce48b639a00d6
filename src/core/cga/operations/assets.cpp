#include <algorithm>
#include <iterator>
#include <string>

#include "core/cga/asset_store.h"
#include "core/cga/context.h"
#include "core/cga/operations/inserted.h"
#include "core/cga/operations/operations.h"
#include "core/cga/primitives.h"

// i(file) and the built-in bodies (CGA reference, sections 5.1 and 5.2).
namespace pcg::cga {

namespace {

constexpr double default_sides = 16.0;

void trim_inserted(Context &context) {
	context.trimmer.trim(context.shape, context.clipper, context.arena);
}

Flow trim(Vm &vm, const Args &) {
	trim_inserted(Context::of(vm));
	return Flow::Next;
}

// builtin:cube, builtin:cube:notex and so on; nullptr: there is none of that name.
const Geometry *builtin_geometry(Context &context, std::string_view name) {
	const std::string_view kind = name.substr(0, name.find(':'));
	const uint32_t sides = uint32_t(default_sides);
	const auto body = [&](PrimitiveKind primitive, uint32_t a, uint32_t b) { return context.assets.primitive(primitive, a, b, context.arena); };
	return name == "cube:notex" ? body(PrimitiveKind::PlainCube, 0, 0)
			: kind == "cube" ? body(PrimitiveKind::Cube, 0, 0)
			: kind == "cylinder" ? body(PrimitiveKind::Cylinder, sides, 0)
			: kind == "sphere" ? body(PrimitiveKind::Sphere, sides, sides)
			: kind == "cone" ? body(PrimitiveKind::Cone, sides, 0)
			: kind == "disk" ? body(PrimitiveKind::Disk, sides, 1)
			: kind == "quad" ? body(PrimitiveKind::Quad, 1, 0)
							 : nullptr;
}

} // namespace

bool is_built_in(std::string_view name) {
	constexpr std::string_view names[] = { "cube", "cylinder", "sphere", "cone", "disk", "quad", "default", "uvtest.png", "unknowntexture.png" };
	constexpr std::string_view begin = "builtin:";
	return name == "builtin:cube:notex" || (name.starts_with(begin) && std::ranges::find(names, name.substr(begin.size())) != std::end(names));
}

const Geometry *inserted_geometry(Vm &vm, std::string_view name, AssetStore::Up up) {
	constexpr std::string_view builtin = "builtin:";
	Context &context = Context::of(vm);
	const Geometry *box = context.assets.primitive(PrimitiveKind::Cube, 0, 0, context.arena);
	if (name.starts_with(builtin)) {
		const Geometry *geometry = builtin_geometry(context, name.substr(builtin.size()));
		if (geometry == nullptr) {
			vm.warn("missing-asset", "there is no \"" + std::string(name) + "\"; a box stands in its place", "built in are cube, cylinder, sphere, cone, disk and quad");
		}
		return geometry != nullptr ? geometry : box;
	}
	AssetStore::Model &model = context.assets.model(name, vm.place().file);
	const bool has_problem = model.asset != nullptr && !model.asset->problem.empty();
	if (model.asset == nullptr && context.assets.is_first_time(model)) {
		vm.warn_each("missing-asset", "there is no asset \"" + std::string(name) + "\"; a box stands in its place",
				"names are sought in the project's folder assets, in the project itself and beside the rule file; with / in front from the workspace");
	} else if (has_problem && context.assets.is_first_time(model)) {
		const bool is_lost = model.asset->mesh.is_empty();
		vm.warn_each("broken-asset", "\"" + std::string(name) + "\" cannot be read" + (is_lost ? "; a box stands in its place: " : " as a whole: ") + model.asset->problem,
				"open it in a modelling program and save it again");
	}
	const Geometry *geometry = context.assets.geometry(model, up, context.model);
	return geometry != nullptr ? geometry : box;
}

namespace {

Flow insert(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	Shape &shape = context.shape;
	const std::string_view name = args[0].is_text() ? args[0].text->view : std::string_view();
	const bool is_z_up = args.count() > 1 && args[1].word == 1;
	const Geometry *geometry = inserted_geometry(vm, name, is_z_up ? AssetStore::Up::Z : AssetStore::Up::Y);
	enum Mode : uint32_t { Align, KeepSizeAndPosition, KeepSizeAlignPosition };
	const uint32_t mode = args.count() > 2 ? args[2].word : uint32_t(Align);
	if (mode == KeepSizeAlignPosition) {
		place_on_floor(shape, geometry, geometry->high - geometry->low);
	} else {
		shape.size = mode == KeepSizeAndPosition ? glm::dvec3(0.0) : shape.size;
		fit_to_scope(shape, geometry);
	}
	trim_inserted(context);
	return Flow::Next;
}

uint32_t count_at(Context &context, const Args &args, size_t i) {
	const double value = i < args.count() ? context.finite(args[i]) : default_sides;
	return value > 0.0 && value < 1e6 ? uint32_t(value) : 0;
}

// With a radius the body stands on the middle of the scope's floor; without one it fills the scope.
Flow put(Context &context, const Geometry *geometry, const Args &args, size_t radius_at, bool is_round_upwards) {
	Shape &shape = context.shape;
	if (args.count() <= radius_at) {
		fit_to_scope(shape, geometry);
	} else {
		const double diameter = 2.0 * context.finite(args[radius_at]);
		const double height = args.count() > radius_at + 1 ? context.finite(args[radius_at + 1]) : is_round_upwards ? diameter : shape.size.y;
		place_on_floor(shape, geometry, glm::dvec3(diameter, height, diameter) * (geometry->high - geometry->low));
	}
	trim_inserted(context);
	return Flow::Next;
}

Flow cube(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	const Geometry *geometry = context.assets.primitive(PrimitiveKind::Cube, 0, 0, context.arena);
	if (args.count() == 3) {
		place_on_floor(context.shape, geometry, context.lengths(args, 0));
	} else {
		fit_to_scope(context.shape, geometry);
	}
	trim_inserted(context);
	return Flow::Next;
}

// The plane of flat bodies: of the two scope sizes that are not 0, else the floor.
int flat_axis(const Shape &shape) {
	int zeros = 0, axis = 1;
	for (int i = 0; i < 3; ++i) {
		zeros += shape.size[i] == 0.0 ? 1 : 0;
		axis = shape.size[i] == 0.0 ? i : axis;
	}
	return zeros == 1 ? axis : 1;
}

Flow put_flat(Context &context, const Geometry *geometry, int normal, bool has_size, double width, double length) {
	Shape &shape = context.shape;
	shape.size[normal] = 0.0;
	if (has_size) {
		glm::dvec3 size(0.0);
		size[normal == 0 ? 1 : 0] = width;
		size[normal == 2 ? 1 : 2] = length;
		place_in_plane(shape, geometry, size * (geometry->high - geometry->low), normal);
	} else {
		fit_to_scope(shape, geometry);
	}
	trim_inserted(context);
	return Flow::Next;
}

Flow quad(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	const int normal = flat_axis(context.shape);
	const bool has_size = args.count() == 2;
	const double width = has_size ? context.length(args[0], context.shape.size[normal == 0 ? 1 : 0]) : 0.0;
	const double length = has_size ? context.length(args[1], context.shape.size[normal == 2 ? 1 : 2]) : 0.0;
	return put_flat(context, context.assets.primitive(PrimitiveKind::Quad, uint32_t(normal), 0, context.arena), normal, has_size, width, length);
}

Flow disk(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	const int normal = flat_axis(context.shape);
	const bool has_size = args.count() == 2;
	const double diameter = has_size ? 2.0 * context.finite(args[1]) : 0.0;
	return put_flat(context, context.assets.primitive(PrimitiveKind::Disk, count_at(context, args, 0), uint32_t(normal), context.arena), normal, has_size, diameter, diameter);
}

Flow cylinder(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	return put(context, context.assets.primitive(PrimitiveKind::Cylinder, count_at(context, args, 0), 0, context.arena), args, 1, false);
}

Flow cone(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	return put(context, context.assets.primitive(PrimitiveKind::Cone, count_at(context, args, 0), 0, context.arena), args, 1, false);
}

Flow sphere(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	return put(context, context.assets.primitive(PrimitiveKind::Sphere, count_at(context, args, 0), count_at(context, args, 1), context.arena), args, 2, true);
}

} // namespace

void add_asset_operations(Dialect &dialect) {
	using enum ParamKind;
	auto &operations = dialect.operations;
	const ParamSpec sides = { "sides", Number, {}, true }, radius = { "radius", Number, {}, true }, height = { "height", Number, {}, true };
	operations.push_back({ "i",
			{ { "file", Text }, { "up", Word, "yUp zUp", true }, { "mode", Word, "alignSizeAndPosition keepSizeAndPosition keepSizeAlignPosition", true },
					{ "cleanup", Word, "numericalCleanup noCleanup", true } },
			BlockKind::None, insert,
			"Replaces the geometry by a model (.obj, .glb, .gltf) that fills the scope; sizes of 0 follow from the model. \"builtin:cube\" is a box. "
			"keepSizeAndPosition leaves the model as it is, keepSizeAlignPosition puts it on the middle of the scope's floor. Models are never cleaned up." });
	operations.push_back({ "trim", {}, BlockKind::None, trim,
			"Cuts the geometry by the planes that comp(f) put through the edges of its face, as far as trim.vertical and trim.horizontal are on." });
	operations.push_back({ "primitiveCube", {}, BlockKind::None, cube, "A box that fills the scope." });
	operations.push_back({ "primitiveCube", { { "x", Size }, { "y", Size }, { "z", Size } }, BlockKind::None, cube, "A box on the middle of the scope's floor." });
	operations.push_back({ "primitiveQuad", {}, BlockKind::None, quad, "A rectangle that fills the scope." });
	operations.push_back({ "primitiveQuad", { { "width", Size }, { "length", Size } }, BlockKind::None, quad, "A rectangle of that size." });
	operations.push_back({ "primitiveDisk", { sides, radius }, BlockKind::None, disk, "A round plate." });
	operations.push_back({ "primitiveCylinder", { sides, radius, height }, BlockKind::None, cylinder, "A cylinder that fills the scope or has the given size." });
	operations.push_back({ "primitiveCone", { sides, radius, height }, BlockKind::None, cone, "A cone that fills the scope or has the given size." });
	operations.push_back({ "primitiveSphere", { sides, { "divisions", Number, {}, true }, radius }, BlockKind::None, sphere,
			"A sphere that fills the scope or has the given radius." });
	add_along_uv_operations(dialect);
}

} // namespace pcg::cga
