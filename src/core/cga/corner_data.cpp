#include "core/cga/corner_data.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

// A corner as seen from the point: lengths and angles in the plane of the face.
struct Spoke {
	glm::dvec3 vector{ 0.0 };
	double length = 0.0;
};

double half_tangent(const Spoke &a, const Spoke &b, glm::dvec3 normal) {
	const double sine = glm::dot(glm::cross(a.vector, b.vector), normal);
	const double cosine = glm::dot(a.vector, b.vector);
	return (a.length * b.length - cosine) / sine; // tan(t / 2) = (1 - cos t) / sin t
}

// The point lies on this edge: the weights of its ends.
bool is_on_edge(const Spoke &a, const Spoke &b, glm::dvec3 normal, double margin) {
	const double edge = glm::length(b.vector - a.vector);
	const double height = std::abs(glm::dot(glm::cross(a.vector, b.vector), normal));
	return height <= margin * std::max(edge, margin) && glm::dot(a.vector, b.vector) <= 0.0;
}

class FaceWeights {
public:
	FaceWeights(const Geometry &geometry, const GeometryFace &face, glm::dvec3 point, std::vector<double> &weights)
			: _geometry(geometry), _face(face), _first(geometry.first_point(face.first_loop)), _normal(face_normal(geometry, face)), _weights(weights) {
		_weights.assign(geometry.face_point_count(face), 0.0);
		for (uint32_t i = 0; i < _weights.size(); ++i) {
			const glm::dvec3 vector = geometry.points[_first + i] - point;
			const glm::dvec3 flat = vector - glm::dot(vector, _normal) * _normal;
			_spokes.push_back({ flat, glm::length(flat) });
			_largest = std::max(_largest, _spokes.back().length);
		}
	}

	void run() {
		if (find_on_edge()) {
			return;
		}
		for_each_edge([&](uint32_t a, uint32_t b) {
			const double tangent = half_tangent(_spokes[a], _spokes[b], _normal);
			if (std::isfinite(tangent)) { // in line with the edge but outside of it: both halves are 0
				_weights[a] += tangent / _spokes[a].length;
				_weights[b] += tangent / _spokes[b].length;
			}
		});
		double sum = 0.0;
		for (const double weight : _weights) {
			sum += weight;
		}
		if (!std::isfinite(sum) || std::abs(sum) < 1e-300) { // an outline without area
			take_nearest();
			return;
		}
		for (double &weight : _weights) {
			weight /= sum;
		}
	}

private:
	template <typename Use> void for_each_edge(Use use) const {
		for (uint32_t l = 0; l < _face.loop_count; ++l) {
			const uint32_t first = _geometry.first_point(_face.first_loop + l) - _first;
			const uint32_t end = _geometry.loop_ends[_face.first_loop + l] - _first;
			for (uint32_t i = first; i < end; ++i) {
				use(i, i + 1 < end ? i + 1 : first);
			}
		}
	}

	bool find_on_edge() {
		const double margin = 1e-10 * _largest;
		bool is_found = false;
		for_each_edge([&](uint32_t a, uint32_t b) {
			if (!is_found && is_on_edge(_spokes[a], _spokes[b], _normal, margin)) {
				const double sum = _spokes[a].length + _spokes[b].length;
				const double share = sum > 0.0 ? _spokes[a].length / sum : 0.0;
				_weights[a] += 1.0 - share;
				_weights[b] += share;
				is_found = true;
			}
		});
		return is_found;
	}

	void take_nearest() {
		std::ranges::fill(_weights, 0.0);
		const auto nearest = std::ranges::min_element(_spokes, {}, &Spoke::length);
		_weights[size_t(nearest - _spokes.begin())] = 1.0;
	}

	const Geometry &_geometry;
	const GeometryFace &_face;
	uint32_t _first;
	glm::dvec3 _normal;
	std::vector<double> &_weights;
	std::vector<Spoke> _spokes;
	double _largest = 0.0;
};

class Carrier {
public:
	Carrier(const Geometry &source, std::span<const glm::dvec3> points, std::span<const CornerOrigin> origins)
			: _source(source), _points(points), _origins(origins) {}

	// One value for each point; `nothing` where none comes along.
	template <typename T> const T *carry(const T *values, T nothing, Arena &arena) {
		T *result = arena.allocate<T>(_points.size());
		bool is_carried = false;
		for (size_t i = 0; i < _origins.size(); ++i) {
			const CornerOrigin &origin = _origins[i];
			if (origin.a == CornerOrigin::none) {
				result[i] = nothing;
				continue;
			}
			is_carried = true;
			if (origin.b == CornerOrigin::none) {
				result[i] = values[origin.a];
			} else if (origin.b != CornerOrigin::in_face) {
				result[i] = values[origin.a] + (values[origin.b] - values[origin.a]) * origin.share;
			} else {
				result[i] = value_in_face(values, origin.a, _points[i]);
			}
		}
		std::fill(result + _origins.size(), result + _points.size(), nothing);
		return is_carried ? result : nullptr;
	}

private:
	template <typename T> T value_in_face(const T *values, uint32_t number, glm::dvec3 point) {
		const GeometryFace &face = _source.faces[number];
		mean_value_weights(_source, face, point, _weights);
		T sum(0.0);
		for (size_t i = 0; i < _weights.size(); ++i) {
			sum += _weights[i] * values[_source.first_point(face.first_loop) + i];
		}
		return sum;
	}

	const Geometry &_source;
	std::span<const glm::dvec3> _points;
	std::span<const CornerOrigin> _origins;
	std::vector<double> _weights;
};

const glm::dvec3 *turned(const glm::dvec3 *normals, size_t count, const glm::dmat3 &turn, Arena &arena) {
	if (normals == nullptr) {
		return nullptr;
	}
	glm::dvec3 *result = arena.allocate<glm::dvec3>(count);
	for (size_t i = 0; i < count; ++i) {
		const glm::dvec3 normal = turn * normals[i];
		const double length = glm::length(normal);
		result[i] = length > 1e-12 ? normal / length : glm::dvec3(0.0);
	}
	return result;
}

} // namespace

const CornerData *carry_corner_data(const Geometry &source, std::span<const glm::dvec3> points, std::span<const CornerOrigin> origins,
		const glm::dmat3 &turn, Arena &arena) {
	Carrier carrier(source, points, origins);
	CornerData data;
	bool is_empty = true;
	for (size_t set = 0; set < source.corners->set_end; ++set) {
		if (source.corners->uvs[set] != nullptr) {
			data.put(set, carrier.carry(source.corners->uvs[set], no_uv(), arena));
			is_empty &= data.uvs[set] == nullptr;
		}
	}
	if (source.corners->normals != nullptr) {
		data.normals = turned(carrier.carry(source.corners->normals, glm::dvec3(0.0), arena), points.size(), turn, arena);
		is_empty &= data.normals == nullptr;
	}
	return is_empty ? nullptr : arena.make(data);
}

void mean_value_weights(const Geometry &geometry, const GeometryFace &face, glm::dvec3 point, std::vector<double> &weights) {
	FaceWeights(geometry, face, point, weights).run();
}

} // namespace pcg::cga
