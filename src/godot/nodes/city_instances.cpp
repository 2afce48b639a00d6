#include "godot/nodes/city_instances.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <godot_cpp/classes/multi_mesh.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>

#include "godot/convert.h"

using namespace godot;

namespace pcg {

namespace {

constexpr double alike = 1e-5; // part of a length that may differ between places that are stretched alike

bool is_stretched(const glm::dmat3 &axes) {
	const double x = glm::length(axes[0]), y = glm::length(axes[1]), z = glm::length(axes[2]);
	return std::abs(x - y) > 1e-4 * x || std::abs(x - z) > 1e-4 * x;
}

Basis to_basis(const glm::dmat3 &axes) {
	return Basis(to_godot(glm::vec3(axes[0])), to_godot(glm::vec3(axes[1])), to_godot(glm::vec3(axes[2])));
}

glm::vec4 color_of(const cga::DerivationResult &model, const cga::ModelInstance &place) {
	return model.materials[model.prototypes[place.prototype].materials[0]].color;
}

// As the engine wants it: the rows of the transform, then the colour.
void write_place(const Transform3D &transform, float *out) {
	for (int row = 0; row < 3; ++row) {
		const Vector3 axes = transform.basis.rows[row];
		*out++ = float(axes.x);
		*out++ = float(axes.y);
		*out++ = float(axes.z);
		*out++ = float(transform.origin[row]);
	}
}

} // namespace

const CityInstances::Prototype &CityInstances::prototype(const cga::DerivationResult &model, const cga::ModelPrototype &source) {
	std::vector<Material> materials;
	std::vector<SurfaceLook> looks;
	bool is_tinted = !source.materials.empty();
	for (const uint32_t index : source.materials) {
		const Material &material = model.materials[index];
		materials.push_back(material);
		looks.push_back({ &_materials.of(material), { material.color.r, material.color.g, material.color.b, material.color.a } });
		is_tinted = is_tinted && looks.back().second == looks.front().second;
	}
	for (size_t i = 0; is_tinted && i < looks.size(); ++i) {
		looks[i].second = {};
	}
	const auto [place, is_new] = _prototypes.try_emplace({ source.mesh.get(), looks });
	if (is_new) {
		place->second = { _materials.to_godot(*source.mesh, materials, is_tinted), is_tinted };
	}
	return place->second;
}

CityInstances::Group &CityInstances::group_of(std::vector<Group> &groups, const Prototype &prototype, const cga::ModelInstance &place) {
	Group wanted;
	wanted.prototype = &prototype;
	const double unit = alike * std::max({ glm::length(place.axes[0]), glm::length(place.axes[1]), glm::length(place.axes[2]) });
	for (size_t i = 0; i < 9 && is_stretched(place.axes); ++i) {
		wanted.axes[i] = std::llround(place.axes[int(i / 3)][int(i % 3)] / unit);
	}
	const auto found = std::ranges::find_if(groups, [&](const Group &group) { return group.prototype == wanted.prototype && group.axes == wanted.axes; });
	return found != groups.end() ? *found : groups.emplace_back(std::move(wanted));
}

MultiMeshInstance3D *CityInstances::make_node(const cga::DerivationResult &model, const Group &group, Vector3 offset) {
	const cga::ModelInstance &first = *group.places[0];
	const bool is_tinted = group.prototype->is_tinted;
	const int64_t stride = is_tinted ? 16 : 12;
	PackedFloat32Array places;
	places.resize(int64_t(group.places.size()) * stride);
	float *out = places.ptrw();
	for (const cga::ModelInstance *place : group.places) {
		const glm::dvec3 way = place->origin - first.origin;
		write_place(group.is_stretched() ? Transform3D(Basis(), to_godot(glm::vec3(glm::inverse(first.axes) * way)))
										 : Transform3D(to_basis(place->axes), to_godot(glm::vec3(way))),
				out);
		const glm::vec4 color = color_of(model, *place);
		for (int i = 0; i < 4 && is_tinted; ++i) {
			out[12 + i] = color[i];
		}
		out += stride;
	}
	Ref<MultiMesh> all;
	all.instantiate();
	all->set_transform_format(MultiMesh::TRANSFORM_3D);
	all->set_use_colors(is_tinted);
	all->set_mesh(group.prototype->mesh);
	all->set_instance_count(int(group.places.size()));
	all->set_buffer(places);
	MultiMeshInstance3D *node = memnew(MultiMeshInstance3D);
	node->set_multimesh(all);
	node->set_transform(Transform3D(group.is_stretched() ? to_basis(first.axes) : Basis(), to_godot(glm::vec3(first.origin)) + offset));
	return node;
}

std::vector<MultiMeshInstance3D *> CityInstances::make(const cga::DerivationResult &model, int32_t object, Vector3 offset) {
	std::vector<Group> groups;
	std::vector<const Prototype *> known(model.prototypes.size());
	for (const cga::ModelInstance &place : model.instances) {
		if (place.object != object) {
			continue;
		}
		const Prototype *&found = known[place.prototype];
		found = found != nullptr ? found : &prototype(model, model.prototypes[place.prototype]);
		if (found->mesh.is_valid()) {
			group_of(groups, *found, place).places.push_back(&place);
		}
	}
	std::vector<MultiMeshInstance3D *> nodes;
	for (const Group &group : groups) {
		nodes.push_back(make_node(model, group, offset));
	}
	return nodes;
}

} // namespace pcg
