#include "appearance_expectations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace pcg {

namespace {

constexpr std::array<const char *, texture_use_count> map_names = { "colormap", "bumpmap", "dirtmap", "specularmap", "opacitymap", "normalmap",
	"emissivemap", "occlusionmap", "roughnessmap", "metallicmap" };

double map_value(const TextureMap &map, const std::string &key) {
	return key == "su" ? map.scale_u
			: key == "sv" ? map.scale_v
			: key == "tu" ? map.shift_u
			: key == "tv" ? map.shift_v
			: key == "rw" ? map.turn
						  : NAN;
}

} // namespace

glm::dvec3 material_value(const Material &material, const std::string &key) {
	return key == "red" ? glm::dvec3(material.color.r)
			: key == "green" ? glm::dvec3(material.color.g)
			: key == "blue" ? glm::dvec3(material.color.b)
			: key == "opacity" ? glm::dvec3(material.color.a)
			: key == "ambient" ? glm::dvec3(material.ambient)
			: key == "specular" ? glm::dvec3(material.specular)
			: key == "emissive" ? glm::dvec3(material.emissive)
			: key == "shininess" ? glm::dvec3(material.shininess)
			: key == "reflectivity" ? glm::dvec3(material.reflectivity)
			: key == "bumpValue" ? glm::dvec3(material.bump_value)
			: key == "metallic" ? glm::dvec3(material.metallic)
			: key == "roughness" ? glm::dvec3(material.roughness)
			: key == "doubleSided" ? glm::dvec3(material.is_double_sided)
			: key == "maps" ? glm::dvec3(double(material.maps.size()))
								   : glm::dvec3(NAN);
}

glm::dvec3 corner_uv(const Mesh &mesh, const MeshFace &face, const std::string &key) {
	const size_t set = key.size() > 4 ? size_t(key[2] - '0') : uv_set_count;
	if (set >= uv_set_count || mesh.uvs[set].empty()) {
		return glm::dvec3(NAN);
	}
	const size_t corner = mesh.first_corner(face.first_loop) + size_t(std::stoi(key.substr(4)));
	return corner < mesh.uvs[set].size() ? glm::dvec3(mesh.uvs[set][corner], 0.0) : glm::dvec3(NAN);
}

bool has_texture(const cga::DerivationResult &model, std::istringstream &line) {
	std::string use, file;
	line >> use >> file;
	std::vector<std::pair<std::string, double>> keys;
	double number = 0.0, wanted_faces = NAN;
	for (std::string key; line >> key >> number;) {
		if (key == "faces") {
			wanted_faces = number;
		} else {
			keys.emplace_back(key, number);
		}
	}
	const auto found = std::ranges::find(map_names, use);
	if (found == map_names.end()) {
		return false;
	}
	const auto fits = [&](const MeshFace &face) {
		const TextureMap *map = model.materials[face.material].map(TextureUse(found - map_names.begin()));
		return map != nullptr && map->file == file &&
				std::ranges::all_of(keys, [&](const auto &pair) { return std::abs(map_value(*map, pair.first) - pair.second) < 1e-4; });
	};
	const double count = double(std::ranges::count_if(model.mesh.faces, fits));
	return std::isnan(wanted_faces) ? count > 0.0 : count == wanted_faces;
}

} // namespace pcg
