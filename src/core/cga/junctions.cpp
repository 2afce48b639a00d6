#include "core/cga/junctions.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pcg::cga {

namespace {

class Junctions {
public:
	Junctions(const Geometry &geometry, double distance, double angle, GeometryBuilder &builder)
			: _geometry(geometry), _builder(builder), _distance(std::max(distance, 1e-9 * glm::distance(geometry.low, geometry.high))),
			  _cosine(angle >= 180.0 ? -2.0 : std::cos(angle * 0.017453292519943295)) {
		const glm::dvec3 size = geometry.high - geometry.low;
		_axis = size.y > size.x ? 1 : 0;
		_axis = size.z > size[_axis] ? 2 : _axis;
		for (uint32_t f = 0; f < geometry.face_count; ++f) {
			const GeometryFace &face = geometry.faces[f];
			_normals.push_back(face_normal(geometry, face));
			const uint32_t first = geometry.first_point(face.first_loop);
			for (uint32_t i = first; i < first + geometry.face_point_count(face); ++i) {
				_corners.push_back({ geometry.points[i], f });
			}
		}
		std::ranges::sort(_corners, {}, [this](const Corner &corner) { return corner.point[_axis]; });
	}

	const Geometry *run(Arena &arena) {
		_builder.begin(_geometry);
		for (uint32_t f = 0; f < _geometry.face_count; ++f) {
			const GeometryFace &face = _geometry.faces[f];
			for (uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
				add_loop(f, l);
			}
			_builder.end_face(face.tag, face.material);
		}
		return _is_changed ? _builder.finish(arena, _geometry.is_closed) : &_geometry;
	}

private:
	struct Corner {
		glm::dvec3 point;
		uint32_t face;
	};
	struct Junction {
		double share; // of the way along the edge
		glm::dvec3 point;
	};

	void add_loop(uint32_t face, uint32_t loop) {
		const uint32_t first = _geometry.first_point(loop), end = _geometry.loop_ends[loop];
		for (uint32_t i = first; i < end; ++i) {
			const uint32_t next = i + 1 == end ? first : i + 1;
			_builder.add_corner(_geometry.points[i], i);
			if (end - first >= 3) {
				find(face, _geometry.points[i], _geometry.points[next]);
				for (const Junction &junction : _found) {
					_builder.add_between(junction.point, i, next, junction.share);
					_is_changed = true;
				}
			}
		}
		_builder.end_loop(std::min<size_t>(end - first, 3));
	}

	void find(uint32_t face, glm::dvec3 from, glm::dvec3 to) {
		_found.clear();
		const double length = glm::distance(from, to);
		if (length <= 2.0 * _distance) {
			return;
		}
		const glm::dvec3 way = (to - from) / length;
		const double low = std::min(from[_axis], to[_axis]) - _distance, high = std::max(from[_axis], to[_axis]) + _distance;
		for (auto corner = std::ranges::lower_bound(_corners, low, {}, [this](const Corner &c) { return c.point[_axis]; });
				corner != _corners.end() && corner->point[_axis] <= high; ++corner) {
			const double along = glm::dot(corner->point - from, way);
			if (corner->face != face && along > _distance && along < length - _distance &&
					glm::distance(from + way * along, corner->point) <= _distance && glm::dot(_normals[face], _normals[corner->face]) > _cosine) {
				_found.push_back({ along / length, corner->point });
			}
		}
		std::ranges::sort(_found, {}, &Junction::share);
		const auto doubles = std::ranges::unique(_found, [&](const Junction &a, const Junction &b) { return (b.share - a.share) * length <= _distance; });
		_found.erase(doubles.begin(), doubles.end());
	}

	const Geometry &_geometry;
	GeometryBuilder &_builder;
	double _distance, _cosine;
	int _axis = 0; // the longest one
	std::vector<glm::dvec3> _normals; // of the faces
	std::vector<Corner> _corners; // along the axis
	std::vector<Junction> _found; // on the present edge
	bool _is_changed = false;
};

} // namespace

const Geometry *with_junctions(const Geometry &geometry, double distance, double angle, GeometryBuilder &builder, Arena &arena) {
	return Junctions(geometry, distance, angle, builder).run(arena);
}

} // namespace pcg::cga
