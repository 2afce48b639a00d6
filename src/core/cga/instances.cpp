#include "core/cga/instances.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace pcg::cga {

void append(Mesh &target, const DerivationResult &model, const ModelInstance &instance) {
	const ModelPrototype &prototype = model.prototypes[instance.prototype];
	const size_t first_corner = target.positions.size(), first_face = target.faces.size();
	const bool has_normals = !target.normals.empty() || !prototype.mesh->normals.empty();
	pcg::append(target, *prototype.mesh);
	const glm::dmat3 turn = glm::transpose(glm::inverse(instance.axes));
	const auto turned = [&](glm::vec3 normal) { return glm::vec3(glm::normalize(turn * glm::dvec3(normal))); };
	for (size_t i = first_corner; i < target.positions.size(); ++i) {
		target.positions[i] = placed(instance, target.positions[i]);
		if (has_normals) {
			target.normals[i] = turned(target.normals[i]);
		}
	}
	for (size_t i = first_face; i < target.faces.size(); ++i) {
		target.faces[i].normal = turned(target.faces[i].normal);
		target.faces[i].material = prototype.materials[target.faces[i].material];
	}
}

DerivationResult written_out(DerivationResult model) {
	for (const ModelInstance &instance : model.instances) {
		append(instance.object < 0 ? model.mesh : model.objects[size_t(instance.object)].mesh, model, instance);
	}
	model.instances.clear();
	model.prototypes.clear();
	return model;
}

} // namespace pcg::cga
