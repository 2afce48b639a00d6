#include "core/cga/instance_table.h"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

// Least and most by which a face grows where the axes are scaled so.
std::pair<double, double> growth(glm::dvec3 scale) {
	double sizes[3] = { std::abs(scale.x), std::abs(scale.y), std::abs(scale.z) };
	std::ranges::sort(sizes);
	return { sizes[0] * sizes[1], sizes[1] * sizes[2] };
}

// The geometry under which the table knows it: a cut of a block is the block, scaled.
const Geometry *uncut(const Geometry &geometry) {
	const Geometry *whole = geometry.inserted;
	const bool is_cut = whole != nullptr && geometry.is_block && geometry.corners == nullptr && geometry.points == whole->points && geometry.faces == whole->faces;
	return is_cut ? whole : &geometry;
}

} // namespace

std::vector<uint16_t> materials_in(const Geometry &geometry) {
	std::vector<uint16_t> materials;
	for (uint32_t i = 0; i < geometry.face_count; ++i) {
		if (std::ranges::find(materials, geometry.faces[i].material) == materials.end()) {
			materials.push_back(geometry.faces[i].material);
		}
	}
	return materials;
}

void InstanceTable::begin() {
	for (auto &[geometry, model] : _models) {
		model.prototypes.clear();
	}
}

void InstanceTable::add_model(const Geometry &geometry, const glm::dmat3 &turn, std::shared_ptr<const Mesh> mesh) {
	Model &model = _models[&geometry];
	model.mesh = std::move(mesh);
	model.materials = materials_in(geometry);
	model.turn = turn;
	for (uint32_t i = 0; i < geometry.face_count; ++i) {
		const double size = glm::length(area_vector(geometry.outline(geometry.faces[i])));
		if (size > least_face_size) {
			model.least_kept = std::min(model.least_kept, size);
		} else {
			model.most_lost = std::max(model.most_lost, size);
		}
	}
}

bool InstanceTable::add(const Shape &shape, const Frame &frame, MaterialTable &materials, DerivationResult &result) {
	const auto found = _models.find(uncut(*shape.geometry));
	if (found == _models.end()) {
		return false;
	}
	Model &model = found->second;
	const glm::dvec3 scale = shape.geometry_scale;
	const glm::dmat3 axes = frame.axes * glm::dmat3(glm::dvec3(scale.x, 0.0, 0.0), glm::dvec3(0.0, scale.y, 0.0), glm::dvec3(0.0, 0.0, scale.z));
	const glm::dvec3 origin = frame.to_parent(shape.geometry_offset);
	const auto [least, most] = growth(scale);
	// Written out, the same faces would have an area.
	const bool has_same_faces = model.least_kept * least > least_face_size && model.most_lost * most <= least_face_size;
	if (!has_same_faces || !(glm::determinant(axes) > 0.0) || !std::isfinite(glm::dot(axes * glm::dvec3(1.0), glm::dvec3(1.0)) + glm::dot(origin, glm::dvec3(1.0)))) {
		return false;
	}
	_looked_up.clear();
	for (const uint16_t material : model.materials) {
		_looked_up.push_back(materials.index_of(*shape.look, material));
	}
	const auto [prototype, is_new] = model.prototypes.try_emplace(_looked_up, uint32_t(result.prototypes.size()));
	if (is_new) {
		result.prototypes.push_back({ model.mesh, _looked_up });
	}
	result.instances.push_back({ prototype->second, shape.object, axes * model.turn, origin });
	result.face_count += model.mesh->faces.size();
	return true;
}

} // namespace pcg::cga
