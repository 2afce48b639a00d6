#pragma once

#include "core/geometry/material.h"

namespace pcg {

// What metallic-roughness models, as engines and glTF have them, show of a material. Where a rule gave no roughness, a specular colour stands for
// less of it: by the Phong exponent, and down to a mirror by the reflectivity.
float shown_roughness(const Material &material);
// Without a colour an emissive map shines as it is.
glm::vec3 shown_emissive(const Material &material);

} // namespace pcg
