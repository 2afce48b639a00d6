#pragma once

#include "core/cga/derivation.h"

// Instances as what they stand for.
namespace pcg::cga {

inline glm::vec3 placed(const ModelInstance &instance, glm::vec3 point) {
	return glm::vec3(instance.origin + instance.axes * glm::dvec3(point));
}

// Appends the faces of an instance of the model, placed. What the model's meshes have is not looked at.
void append(Mesh &target, const DerivationResult &model, const ModelInstance &instance);

// All instances written into the meshes that they belong to.
DerivationResult written_out(DerivationResult model);

} // namespace pcg::cga
