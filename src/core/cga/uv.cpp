#include "core/cga/uv.h"

#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/cga/context.h"
#include "core/geometry/polygon.h"
#include "core/geometry/triangulate.h"

namespace pcg::cga {

namespace {

// Sums up the stretch of triangles.
struct Stretch {
	glm::dvec2 sum{ 0.0 };
	double weight = 0.0;

	void add(const glm::dvec3 points[3], const glm::dvec2 uvs[3], double share) {
		const glm::dvec2 a = uvs[1] - uvs[0], b = uvs[2] - uvs[0];
		const double area = a.x * b.y - a.y * b.x; // twice, in the texture
		if (!(std::abs(area) > 1e-18)) {
			return;
		}
		const glm::dvec3 p = points[1] - points[0], q = points[2] - points[0];
		sum += share * std::abs(area) * glm::dvec2(glm::length((p * b.y - q * a.y) / area), glm::length((q * a.x - p * b.x) / area));
		weight += share * std::abs(area);
	}
};

class FaceTriangles {
public:
	// In scope coordinates. Indices into `points`.
	const std::vector<uint32_t> &of(const Shape &shape, const GeometryFace &face) {
		const Geometry &geometry = *shape.geometry;
		const uint32_t first = geometry.first_point(face.first_loop), count = geometry.face_point_count(face);
		points.clear();
		for (uint32_t i = 0; i < count; ++i) {
			points.push_back(shape.to_scope(geometry.points[first + i]));
		}
		_triangles.clear();
		share = 1.0;
		if (count == 4 && face.loop_count == 1) { // the most frequent one, by both diagonals: fair to both ends of a bent quad
			_triangles = { 0, 1, 2, 0, 2, 3, 1, 2, 3, 1, 3, 0 };
			share = 0.5;
			return _triangles;
		}
		const glm::dvec3 normal = loop_normal(std::span(points).first(geometry.outline(face).size()));
		_flat.clear();
		_ends.clear();
		for (const glm::dvec3 &point : points) {
			_flat.push_back(flatten(point, normal));
		}
		for (uint32_t l = 0; l < face.loop_count; ++l) {
			_ends.push_back(geometry.loop_ends[face.first_loop + l] - first);
		}
		triangulate(_flat, _ends, _triangles);
		return _triangles;
	}

	std::vector<glm::dvec3> points;
	double share = 1.0; // what each triangle counts for: quads are covered twice

private:
	std::vector<glm::dvec2> _flat;
	std::vector<uint32_t> _ends, _triangles;
};

} // namespace

int uv_set_of(Context &context, const Value &value) {
	const double number = context.finite(value);
	const int set = number >= 0.0 && number < double(uv_set_count) ? int(number) : -1;
	if (set >= 0 && double(set) == number) {
		return set;
	}
	context.vm.warn("bad-uv-set", "texture coordinate sets are numbered from 0 to 9", "0 is the colour map's, 2 the dirt map's");
	return -1;
}

void UvRange::add(glm::dvec2 uv) {
	if (has_uv(uv)) {
		low = is_empty ? uv : glm::min(low, uv);
		high = is_empty ? uv : glm::max(high, uv);
		is_empty = false;
	}
}

UvRange uv_range(const Geometry &geometry, size_t set) {
	UvRange range;
	const glm::dvec2 *uvs = geometry.uvs(set);
	for (uint32_t i = 0; uvs != nullptr && i < geometry.point_count; ++i) {
		range.add(uvs[i]);
	}
	return range;
}

UvRange uv_range(const Geometry &geometry, const GeometryFace &face, const glm::dvec2 *uvs) {
	UvRange range;
	const uint32_t first = geometry.first_point(face.first_loop);
	for (uint32_t i = first; i < first + geometry.face_point_count(face); ++i) {
		range.add(uvs[i]);
	}
	return range;
}

glm::dvec2 uv_stretch(const Shape &shape, size_t set) {
	const glm::dvec2 *uvs = shape.geometry != nullptr ? shape.geometry->uvs(set) : nullptr;
	Stretch stretch;
	FaceTriangles triangles;
	for (uint32_t f = 0; uvs != nullptr && f < shape.geometry->face_count; ++f) {
		const GeometryFace &face = shape.geometry->faces[f];
		const glm::dvec2 *face_uvs = uvs + shape.geometry->first_point(face.first_loop);
		const std::vector<uint32_t> &indices = triangles.of(shape, face);
		for (size_t i = 0; i + 2 < indices.size(); i += 3) {
			const glm::dvec3 corners[3] = { triangles.points[indices[i]], triangles.points[indices[i + 1]], triangles.points[indices[i + 2]] };
			const glm::dvec2 corner_uvs[3] = { face_uvs[indices[i]], face_uvs[indices[i + 1]], face_uvs[indices[i + 2]] };
			stretch.add(corners, corner_uvs, triangles.share);
		}
	}
	return stretch.weight > 0.0 ? stretch.sum / stretch.weight : glm::dvec2(0.0);
}

} // namespace pcg::cga
