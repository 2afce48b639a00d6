#include "core/cga/roof_edges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <glm/geometric.hpp>

#include "core/cga/components.h"
#include "core/cga/edges.h"

// Eaves, hips, valleys and ridges (CGA reference: op_comp, roof edges).
namespace pcg::cga {

namespace {

constexpr double down = -0.98; // y of a normal: the face below a roof, which is none of its planes

class RoofEdges {
public:
	explicit RoofEdges(const Geometry &geometry) : _geometry(geometry), _grouped(grouped_edges(geometry)) {
		for (uint32_t f = 0; f < geometry.face_count; ++f) {
			_normals.push_back(face_normal(geometry, geometry.faces[f]));
		}
	}

	void name(std::vector<ComponentInfo> &edges) {
		for_each_edge_group(_grouped, [&](std::span<const FaceEdge> group) {
			const std::vector<FaceEdge> planes = planes_of(group);
			if (planes.size() == 1 && is_eave(planes[0])) {
				_eave_points.push_back(FaceEdge::key_of(planes[0].from));
				_eave_points.push_back(FaceEdge::key_of(planes[0].to));
			}
		});
		std::ranges::sort(_eave_points);
		_is_shed = is_shed_roof(_geometry);
		std::map<decltype(FaceEdge().key()), ComponentInfo *> by_ends;
		for (ComponentInfo &info : edges) {
			by_ends[FaceEdge{ info.from, info.to, 0, 0, 0, 0 }.key()] = &info;
		}
		for_each_edge_group(_grouped, [&](std::span<const FaceEdge> group) { name_edge(*by_ends.at(group[0].key()), planes_of(group)); });
	}

private:
	std::vector<FaceEdge> planes_of(std::span<const FaceEdge> group) const {
		std::vector<FaceEdge> planes;
		for (const FaceEdge &edge : group) {
			if (_normals[edge.face].y > down) {
				planes.push_back(edge);
			}
		}
		return planes;
	}

	// Level, and the lowest of its face.
	bool is_eave(const FaceEdge &edge) const {
		double low = edge.from.y;
		for (const glm::dvec3 &point : _geometry.outline(_geometry.faces[edge.face])) {
			low = std::min(low, point.y);
		}
		const double margin = 1e-6 + 1e-6 * glm::distance(edge.from, edge.to);
		return std::abs(edge.from.y - edge.to.y) <= margin && edge.from.y - low <= margin;
	}

	bool touches_eave(const FaceEdge &edge) const {
		return std::ranges::binary_search(_eave_points, FaceEdge::key_of(edge.from)) || std::ranges::binary_search(_eave_points, FaceEdge::key_of(edge.to));
	}

	void name_edge(ComponentInfo &info, const std::vector<FaceEdge> &planes) const {
		using enum SelectorKind;
		if (planes.size() == 1 && is_eave(planes[0])) {
			info.component.roof_edge = Eave;
			info.runs_back = info.from != planes[0].from;
		} else if (planes.size() == 2 && !_is_shed) {
			const glm::dvec3 along = planes[0].to - planes[0].from;
			const double bend = glm::dot(glm::cross(_normals[planes[0].face], _normals[planes[1].face]), along);
			info.component.roof_edge = bend < -1e-9 * glm::length(along) ? Valley : touches_eave(planes[0]) ? Hip : Ridge;
			info.runs_back = info.from.y > info.to.y + 1e-9;
		}
	}

	const Geometry &_geometry;
	std::vector<FaceEdge> _grouped;
	std::vector<glm::dvec3> _normals;
	std::vector<decltype(FaceEdge::key_of(glm::dvec3()))> _eave_points;
	bool _is_shed = false;
};

} // namespace

bool is_shed_roof(const Geometry &geometry) {
	constexpr double margin = 1e-6; // of a unit normal
	size_t slopes = 0;
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		const double up = face_normal(geometry, geometry.faces[f]).y;
		const bool is_wall = std::abs(up) <= margin, is_floor = up <= margin - 1.0;
		if (!is_wall && !is_floor && (up < 0.0 || up >= 1.0 - margin || ++slopes > 1)) {
			return false;
		}
	}
	return slopes == 1;
}

void name_roof_edges(const Geometry &geometry, std::vector<ComponentInfo> &edges) {
	RoofEdges(geometry).name(edges);
}

} // namespace pcg::cga
