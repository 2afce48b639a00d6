#include <cmath>

#include "core/cga/context.h"
#include "core/cga/operations/operations.h"
#include "core/cga/primitives.h"
#include "core/ports/asset_provider.h"

// i(file) and the built-in bodies (CGA reference, sections 5.1 and 5.2).
namespace pcg::cga {

namespace {

constexpr double default_sides = 16.0;

const Geometry *geometry_of(const Asset &asset, Context &context) {
	GeometryBuilder builder;
	std::vector<uint16_t> materials;
	for (const Material &material : asset.materials) {
		materials.push_back(context.model.materials().asset_material(material));
	}
	for (const MeshFace &face : asset.mesh.faces) {
		for (uint32_t i = 0; i < face.loop_count; ++i) {
			for (const glm::vec3 &point : asset.mesh.loop(face.first_loop + i)) {
				builder.add_point(glm::dvec3(point));
			}
			builder.end_loop();
		}
		builder.end_face(FaceTag::None, face.material < materials.size() ? materials[face.material] : uint16_t(0));
	}
	const Geometry *geometry = builder.finish(context.arena, false);
	if (geometry == nullptr) {
		return nullptr;
	}
	Geometry instance = *geometry;
	instance.is_instance = true;
	return context.arena.make(instance);
}

void trim_inserted(Context &context) {
	context.trimmer.trim(context.shape, context.clipper, context.arena);
}

Flow trim(Vm &vm, const Args &) {
	trim_inserted(Context::of(vm));
	return Flow::Next;
}

Flow insert(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	const std::string_view name = args[0].is_text() ? args[0].text->view : std::string_view();
	const Geometry *geometry = nullptr;
	if (!name.starts_with("builtin:cube")) {
		const AssetProvider *assets = context.options().assets;
		const Asset *asset = assets != nullptr ? assets->find(name, vm.program().files[vm.place().file]) : nullptr;
		if (asset != nullptr) {
			geometry = geometry_of(*asset, context);
		} else {
			vm.warn("missing-asset", "there is no asset \"" + std::string(name) + "\"; a box stands in its place");
		}
	}
	fit_to_scope(context.shape, geometry != nullptr ? geometry : make_cube(context.arena));
	trim_inserted(context);
	return Flow::Next;
}

uint32_t count_at(Context &context, const Args &args, size_t i) {
	const double value = i < args.count() ? context.finite(args[i]) : default_sides;
	return value > 0.0 && value < 1e6 ? uint32_t(value) : 0;
}

// With a radius the scope gets that size, around the middle of its floor; without one the body fills the scope.
Flow put(Context &context, const Geometry *geometry, const Args &args, size_t radius_at, bool is_round_upwards) {
	Shape &shape = context.shape;
	if (args.count() > radius_at) {
		const double diameter = 2.0 * context.finite(args[radius_at]);
		const double height = args.count() > radius_at + 1 ? context.finite(args[radius_at + 1]) : is_round_upwards ? diameter : shape.size.y;
		const glm::dvec3 size(diameter, height, diameter);
		shape.position += shape.rotation * glm::dvec3(0.5 * (shape.size.x - size.x), 0.0, 0.5 * (shape.size.z - size.z));
		shape.size = size;
	}
	fit_to_scope(shape, geometry);
	trim_inserted(context);
	return Flow::Next;
}

Flow cube(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	Shape &shape = context.shape;
	if (args.count() == 3) {
		const glm::dvec3 size = context.lengths(args, 0);
		shape.position += shape.rotation * glm::dvec3(0.5 * (shape.size.x - size.x), 0.0, 0.5 * (shape.size.z - size.z));
		shape.size = size;
	}
	fit_to_scope(shape, make_cube(context.arena));
	trim_inserted(context);
	return Flow::Next;
}

Flow quad(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	Shape &shape = context.shape;
	const int normal = shape.size.y == 0.0 ? 1 : shape.size.z == 0.0 ? 2 : shape.size.x == 0.0 ? 0 : 1;
	const int a = normal == 0 ? 2 : 0, b = normal == 1 ? 2 : 1;
	if (args.count() == 2) {
		glm::dvec3 size(0.0);
		size[a] = context.length(args[0], shape.size[a]);
		size[b] = context.length(args[1], shape.size[b]);
		shape.position += shape.rotation * glm::dvec3(0.5 * (shape.size.x - size.x), 0.0, 0.5 * (shape.size.z - size.z));
		shape.size = size;
	}
	shape.size[normal] = 0.0;
	fit_to_scope(shape, make_quad(normal, context.arena));
	shape.size[normal] = 0.0;
	trim_inserted(context);
	return Flow::Next;
}

Flow disk(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	context.shape.size.y = 0.0;
	put(context, make_disk(count_at(context, args, 0), context.arena), args, 1, false);
	context.shape.size.y = 0.0;
	return Flow::Next;
}

Flow cylinder(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	return put(context, make_cylinder(count_at(context, args, 0), context.arena), args, 1, false);
}

Flow cone(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	return put(context, make_cone(count_at(context, args, 0), context.arena), args, 1, false);
}

Flow sphere(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	return put(context, make_sphere(count_at(context, args, 0), count_at(context, args, 1), context.arena), args, 2, true);
}

} // namespace

void add_asset_operations(Dialect &dialect) {
	using enum ParamKind;
	auto &operations = dialect.operations;
	const ParamSpec sides = { "sides", Number, {}, true }, radius = { "radius", Number, {}, true }, height = { "height", Number, {}, true };
	operations.push_back({ "i", { { "file", Text } }, BlockKind::None, insert,
			"Replaces the geometry by an asset that fills the scope; sizes of 0 follow from the asset. \"builtin:cube\" is a box." });
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
}

} // namespace pcg::cga
