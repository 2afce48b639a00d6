#pragma once

#include <vector>

#include "core/geometry/mesh.h"

// What `// expect` lines say of faces and outlines.
namespace pcg {

double face_area(const Mesh &mesh, const MeshFace &face);
// Mean of the corners of its outline.
glm::dvec3 middle(const Mesh &mesh, const MeshFace &face);
double polygon_area(const std::vector<glm::vec3> &polygon); // in plan

} // namespace pcg
