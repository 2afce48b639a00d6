#include "core/cga/flat_face.h"

#include <glm/geometric.hpp>

#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

// The vector in the plane of `normal` that is seen as `flat` along the normal's longest axis.
glm::dvec3 lifted(glm::dvec2 flat, glm::dvec3 normal) {
	for (int axis = 0; axis < 3; ++axis) {
		glm::dvec3 unit(0.0), other(0.0);
		unit[(axis + 1) % 3] = 1.0;
		other[(axis + 2) % 3] = 1.0;
		glm::dvec3 lost(0.0);
		lost[axis] = 1.0;
		if (flatten(lost, normal) == glm::dvec2(0.0)) {
			const double sign = flatten(unit, normal).x; // 1, or 0 where the two are swapped
			const glm::dvec3 seen = sign > 0.5 ? unit * flat.x + other * flat.y : unit * flat.y + other * flat.x;
			return seen - lost * (glm::dot(normal, seen) / normal[axis]);
		}
	}
	return glm::dvec3(0.0);
}

} // namespace

FlatFace::FlatFace(const Geometry &geometry, uint32_t face, View view) : _geometry(&geometry), _face(face) {
	const GeometryFace &source = geometry.faces[face];
	const auto outline = geometry.outline(source);
	const glm::dvec3 normal = loop_normal(outline);
	const glm::dmat3 axes = axes_from_z(normal, outline[1] - outline[0]);
	const bool is_own = view == View::Own;
	_origin = outline[0];
	_x = is_own ? axes[0] : lifted({ 1.0, 0.0 }, normal);
	_y = is_own ? axes[1] : lifted({ 0.0, 1.0 }, normal);
	for (uint32_t i = 0; i < source.loop_count; ++i) {
		_loops.emplace_back();
		for (const glm::dvec3 &point : geometry.loop(source.first_loop + i)) {
			const glm::dvec3 way = point - _origin;
			_loops.back().push_back(is_own ? glm::dvec2(glm::dot(axes[0], way), glm::dot(axes[1], way)) : flatten(way, normal));
		}
		_edge_count += uint32_t(_loops.back().size());
	}
}

glm::dvec2 FlatFace::flat(glm::dvec3 point) const {
	const glm::dvec3 way = point - _origin;
	return { glm::dot(_x, way), glm::dot(_y, way) };
}

void FlatFace::add_point(GeometryBuilder &builder, glm::dvec2 point) const {
	uint32_t corner = _geometry->first_point(face().first_loop);
	for (const Loop2 &loop : _loops) {
		for (const glm::dvec2 &known : loop) {
			if (known.x == point.x && known.y == point.y) {
				builder.add_corner(_geometry->points[corner], corner);
				return;
			}
			++corner;
		}
	}
	builder.add_inside(_origin + _x * point.x + _y * point.y, _face);
}

void FlatFace::add_loop(GeometryBuilder &builder, const Loop2 &loop) const {
	for (const glm::dvec2 &point : loop) {
		add_point(builder, point);
	}
	builder.end_loop();
}

void FlatFace::add(GeometryBuilder &builder, const Loops2 &polygon, FaceTag tag) const {
	for (const Loop2 &loop : polygon) {
		add_loop(builder, loop);
	}
	builder.end_face(tag, face().material);
}

void FlatFace::add(GeometryBuilder &builder, const Loop2 &outline, FaceTag tag) const {
	add_loop(builder, outline);
	builder.end_face(tag, face().material);
}

} // namespace pcg::cga
