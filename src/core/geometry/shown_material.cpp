#include "core/geometry/shown_material.h"

#include <algorithm>
#include <cmath>

namespace pcg {

// A Phong exponent n is a microfacet width of sqrt(2 / (n + 2)), and that is the square of the roughness (Walter et al. 2007).
float shown_roughness(const Material &material) {
	const float gloss = std::clamp(std::max({ material.specular.r, material.specular.g, material.specular.b }), 0.0f, 1.0f);
	if (material.roughness < 1.0f || gloss == 0.0f) {
		return material.roughness;
	}
	constexpr float mirror = 0.05f;
	const float phong = std::pow(2.0f / (std::clamp(material.shininess, 0.0f, 128.0f) + 2.0f), 0.25f);
	const float shown = phong + (mirror - phong) * std::clamp(material.reflectivity, 0.0f, 1.0f);
	return 1.0f + (shown - 1.0f) * gloss;
}

glm::vec3 shown_emissive(const Material &material) {
	const bool is_dark = material.emissive == glm::vec3(0.0f);
	return is_dark && material.map(TextureUse::Emissive) != nullptr ? glm::vec3(1.0f) : material.emissive;
}

} // namespace pcg
