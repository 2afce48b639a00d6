#include "core/io/asset_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>

#include "core/geometry/polygon.h"
#include "core/io/built_in_pictures.h"
#include "core/io/mtl.h"
#include "core/io/obj.h"
#include "core/lang/source.h"

namespace pcg {

namespace {

bool has_ending(const std::string &path, std::string_view ending) {
	if (path.size() < ending.size()) {
		return false;
	}
	return std::equal(ending.begin(), ending.end(), path.end() - std::ptrdiff_t(ending.size()),
			[](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? char(b + 32) : b); });
}

// The libraries' materials by name; libraries that are missing leave a problem.
std::map<std::string, Material> read_libraries(const FileTree &files, const std::string &path, const ObjModel &model, const AssetLimits &limits, Asset &asset) {
	std::map<std::string, Material> materials;
	for (const std::string &name : model.libraries) {
		const std::string library = resolve_import(path, name);
		const Result<std::string> text = files.read(library, limits.bytes);
		if (!text) {
			asset.problem = "its materials are missing: there is no " + name;
			continue;
		}
		for (Material &material : parse_mtl(*text, library)) {
			materials.emplace(material.name, std::move(material));
		}
	}
	return materials;
}

void add_face(const ObjModel &model, const ObjModel::Face &face, uint32_t material, Mesh &mesh) {
	std::vector<glm::dvec3> points;
	for (uint32_t i = 0; i < face.corner_count; ++i) {
		points.push_back(model.positions[model.corners[face.first_corner + i].position]);
	}
	mesh.positions.insert(mesh.positions.end(), points.begin(), points.end());
	mesh.loop_ends.push_back(uint32_t(mesh.positions.size()));
	mesh.faces.push_back({ uint32_t(mesh.loop_ends.size()) - 1, 1, material, glm::vec3(loop_normal(points)) });
}

// By group: whether all of its corners have what `member` says; if not, none of them has (CGA reference: op_i, mesh consistency).
std::vector<bool> complete_groups(const ObjModel &model, uint32_t ObjModel::Corner::*member) {
	std::vector<bool> is_complete;
	for (const ObjModel::Face &face : model.faces) {
		is_complete.resize(std::max<size_t>(is_complete.size(), face.group + size_t(1)), true);
		for (uint32_t i = 0; i < face.corner_count; ++i) {
			if (model.corners[face.first_corner + i].*member == ObjModel::none) {
				is_complete[face.group] = false;
			}
		}
	}
	return is_complete;
}

void add_corner_data(const ObjModel &model, Mesh &mesh) {
	const std::vector<bool> has_uvs = complete_groups(model, &ObjModel::Corner::uv), has_normals = complete_groups(model, &ObjModel::Corner::normal);
	const bool any_uvs = std::ranges::find(has_uvs, true) != has_uvs.end(), any_normals = std::ranges::find(has_normals, true) != has_normals.end();
	for (const ObjModel::Face &face : model.faces) {
		for (uint32_t i = 0; i < face.corner_count; ++i) {
			const ObjModel::Corner &corner = model.corners[face.first_corner + i];
			if (any_uvs) {
				mesh.uvs[0].push_back(has_uvs[face.group] ? glm::vec2(model.uvs[corner.uv]) : glm::vec2(NAN));
			}
			if (any_normals) {
				const glm::dvec3 normal = has_normals[face.group] ? model.normals[corner.normal] : glm::dvec3(0.0);
				mesh.normals.push_back(glm::length(normal) > 0.0 ? glm::vec3(glm::normalize(normal)) : glm::vec3(NAN));
			}
		}
	}
}

} // namespace

Asset read_obj_asset(const FileTree &files, const std::string &path, const AssetLimits &limits) {
	Asset asset;
	const Result<std::string> text = files.read(path, limits.bytes);
	if (!text) {
		asset.problem = text.diagnostic().message;
		return asset;
	}
	Diagnostics diagnostics;
	const ObjModel model = parse_obj_model(*text, path, diagnostics, limits.faces);
	const std::map<std::string, Material> library = read_libraries(files, path, model, limits, asset);
	for (const std::string &name : model.material_names) {
		const auto found = library.find(name);
		asset.materials.push_back(found != library.end() ? found->second : Material{ .name = name });
	}
	const uint32_t plain = uint32_t(asset.materials.size()); // of faces without a material
	asset.materials.emplace_back();
	for (const ObjModel::Face &face : model.faces) {
		add_face(model, face, face.material == ObjModel::none ? plain : face.material, asset.mesh);
	}
	add_corner_data(model, asset.mesh);
	if (diagnostics.has_errors()) {
		const Diagnostic &first = diagnostics.list().front();
		asset.problem = "line " + std::to_string(first.line) + ": " + first.message;
	} else if (model.faces.empty()) {
		asset.problem = "there is no face in it";
	}
	return asset;
}

void complete_corners(Mesh &mesh) {
	const size_t count = mesh.positions.size();
	for (std::vector<glm::vec2> &uvs : mesh.uvs) {
		uvs.resize(uvs.empty() ? 0 : count, glm::vec2(NAN));
	}
	mesh.normals.resize(mesh.normals.empty() ? 0 : count, glm::vec3(NAN));
	bool is_flat = true; // files give normals to flat faces too, which need none
	for (const MeshFace &face : mesh.faces) {
		const uint32_t first = mesh.first_corner(face.first_loop);
		for (uint32_t i = first; i < mesh.loop_ends[face.first_loop] && !mesh.normals.empty(); ++i) {
			is_flat = is_flat && !(glm::dot(mesh.normals[i], face.normal) < 0.9998f); // a degree
		}
	}
	if (is_flat) {
		mesh.normals.clear();
	}
}

Result<std::string> read_picture(const FileTree &files, const std::string &name, size_t limit) {
	if (const std::optional<Picture> picture = built_in_picture(name)) {
		return encode_png(*picture);
	}
	const size_t mark = name.rfind('#');
	size_t index = 0;
	if (mark == std::string::npos || files.has_file(name)) {
		return files.read(name, limit);
	}
	const std::string path = name.substr(0, mark);
	const auto [end, error] = std::from_chars(name.data() + mark + 1, name.data() + name.size(), index);
	const bool is_inner = error == std::errc() && end == name.data() + name.size() && (has_ending(path, ".glb") || has_ending(path, ".gltf"));
	return is_inner ? read_gltf_picture(files, path, index, limit) : files.read(name, limit);
}

Asset read_asset(const FileTree &files, const std::string &path, const AssetLimits &limits) {
	if (has_ending(path, ".obj")) {
		return read_obj_asset(files, path, limits);
	}
	if (has_ending(path, ".glb") || has_ending(path, ".gltf")) {
		return read_gltf_asset(files, path, limits);
	}
	Asset asset;
	asset.problem = "models are read from .obj, .glb and .gltf files";
	return asset;
}

} // namespace pcg
