#pragma once

#include <sstream>
#include <string>

#include "core/cga/derivation.h"

// What `// expect` lines say of materials, pictures and texture coordinates. The format is in tests/rules/cga/README.md.
namespace pcg {

// "roughness", "specular" ..; NaN: there is no such thing.
glm::dvec3 material_value(const Material &material, const std::string &key);
// "uv0.2": the third corner's coordinates in set 0.
glm::dvec3 corner_uv(const Mesh &mesh, const MeshFace &face, const std::string &key);
// "colormap brick.png faces 2 su 0.5": so many faces have a material with that picture. Without "faces": at least one has.
bool has_texture(const cga::DerivationResult &model, std::istringstream &line);

} // namespace pcg
