#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

// Places and turns. World > pivot > scope > geometry; all matrices have their axes as columns, right-handed.
namespace pcg::cga {

struct Frame {
	glm::dmat3 axes{ 1.0 };
	glm::dvec3 origin{ 0.0 };

	glm::dvec3 to_parent(glm::dvec3 point) const { return origin + axes * point; }
	glm::dvec3 to_local(glm::dvec3 point) const { return glm::transpose(axes) * (point - origin); }
};

inline Frame operator*(const Frame &parent, const Frame &child) {
	return { parent.axes * child.axes, parent.to_parent(child.origin) };
}

// Degrees; about x first, then y, then z, in fixed axes (CGA reference: cga_eulerAngles).
glm::dmat3 rotation_from_euler(glm::dvec3 degrees);
glm::dvec3 euler_from_rotation(const glm::dmat3 &rotation);

} // namespace pcg::cga
