#include "core/cga/rectify.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

// Corners by place: equal ones have one number.
std::vector<uint32_t> numbered(const Geometry &geometry) {
	std::vector<uint32_t> order(geometry.point_count);
	std::iota(order.begin(), order.end(), 0u);
	const auto key = [&](uint32_t i) { return std::tuple(geometry.points[i].x, geometry.points[i].y, geometry.points[i].z); };
	std::ranges::stable_sort(order, {}, key);
	std::vector<uint32_t> numbers(geometry.point_count);
	for (size_t i = 0; i < order.size(); ++i) {
		numbers[order[i]] = i > 0 && geometry.points[order[i]] == geometry.points[order[i - 1]] ? numbers[order[i - 1]] : order[i];
	}
	return numbers;
}

int main_axis(const Geometry &geometry) {
	glm::dvec3 sum(0.0);
	for (uint32_t i = 0; i < geometry.face_count; ++i) {
		sum += glm::abs(area_vector(geometry.outline(geometry.faces[i])));
	}
	return sum.y >= sum.x && sum.y >= sum.z ? 1 : sum.z >= sum.x ? 2 : 0;
}

// Corners that must agree in one coordinate, and what they agree on: the mean of the edges between them by length.
class Lines {
public:
	explicit Lines(uint32_t count) : _parent(count), _sum(count, 0.0), _weight(count, 0.0) { std::iota(_parent.begin(), _parent.end(), 0u); }

	void join(uint32_t a, uint32_t b, double place, double weight) {
		const uint32_t root = find(a), other = find(b);
		if (root != other) {
			_parent[other] = root;
			_sum[root] += _sum[other];
			_weight[root] += _weight[other];
		}
		_sum[root] += place * weight;
		_weight[root] += weight;
	}
	double place(uint32_t corner, double otherwise) {
		const uint32_t root = find(corner);
		return _weight[root] > 0.0 ? _sum[root] / _weight[root] : otherwise;
	}

private:
	uint32_t find(uint32_t corner) {
		while (_parent[corner] != corner) {
			_parent[corner] = _parent[_parent[corner]];
			corner = _parent[corner];
		}
		return corner;
	}

	std::vector<uint32_t> _parent;
	std::vector<double> _sum, _weight;
};

} // namespace

void rectify(const Geometry &geometry, double angle, GeometryBuilder &builder) {
	const std::vector<uint32_t> numbers = numbered(geometry);
	const int axis = main_axis(geometry), u = (axis + 1) % 3, v = (axis + 2) % 3;
	const double most = std::tan(angle * 0.017453292519943295);
	Lines along_u(geometry.point_count), along_v(geometry.point_count);
	for (uint32_t l = 0; l < geometry.loop_count; ++l) {
		const uint32_t first = geometry.first_point(l), count = geometry.loop_ends[l] - first;
		for (uint32_t i = 0; i < count; ++i) {
			const uint32_t a = numbers[first + i], b = numbers[first + (i + 1) % count];
			const glm::dvec3 middle = 0.5 * (geometry.points[a] + geometry.points[b]), way = geometry.points[b] - geometry.points[a];
			const double du = std::abs(way[u]), dv = std::abs(way[v]);
			if (dv < most * du) {
				along_u.join(a, b, middle[v], du);
			} else if (du < most * dv) {
				along_v.join(a, b, middle[u], dv);
			}
		}
	}
	builder.begin(geometry);
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		const GeometryFace &face = geometry.faces[f];
		for (uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
			for (uint32_t i = geometry.first_point(l); i < geometry.loop_ends[l]; ++i) {
				glm::dvec3 point = geometry.points[i];
				point[v] = along_u.place(numbers[i], point[v]);
				point[u] = along_v.place(numbers[i], point[u]);
				builder.add_corner(point, i);
			}
			builder.end_loop();
		}
		builder.end_face(face.tag, face.material);
	}
}

} // namespace pcg::cga
