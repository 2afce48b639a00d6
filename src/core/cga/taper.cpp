#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "core/cga/extrude.h"
#include "core/cga/frames.h"
#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

using Loop = std::vector<glm::dvec3>;

// The other way around with the same first edge: [0 1 2 3] becomes [1 0 3 2]. Doing it twice changes nothing.
void reverse_keeping_first_edge(Loop &loop) {
	std::ranges::reverse(loop);
	std::rotate(loop.begin(), loop.end() - 2, loop.end());
}

// Where a corner of a loop that was reversed so stood before.
uint32_t reversed_index(size_t index, size_t count) {
	return uint32_t((count + 1 - index) % count);
}

// Of the triangles of the fan around the first point, weighted by their signed area. False: there is no area.
bool center_of_gravity(std::span<const glm::dvec3> loop, glm::dvec3 &center) {
	const glm::dvec3 normal = loop_normal(loop);
	glm::dvec3 sum(0.0);
	double weight = 0.0;
	for (size_t i = 1; i + 1 < loop.size(); ++i) {
		const double area = glm::dot(glm::cross(loop[i] - loop[0], loop[i + 1] - loop[0]), normal);
		sum += area * (loop[0] + loop[i] + loop[i + 1]) / 3.0;
		weight += area;
	}
	center = sum / weight;
	return std::abs(weight) > 1e-12;
}

} // namespace

bool taper(Shape &shape, double height, GeometryBuilder &builder, Arena &arena) {
	const Geometry *geometry = baked(shape, arena);
	glm::dvec3 center;
	if (geometry == nullptr || geometry->point_count < 3 || !center_of_gravity(geometry->outline(geometry->faces[0]), center)) {
		return false;
	}
	const auto outline = geometry->outline(geometry->faces[0]);
	const glm::dvec3 normal = face_normal(*geometry, geometry->faces[0]);
	const glm::dvec3 apex = center + normal * height;
	Loop base(outline.begin(), outline.end());
	if (height < 0.0) {
		reverse_keeping_first_edge(base);
	}
	const uint16_t material = geometry->faces[0].material;
	builder.clear();
	Loop bottom = base;
	reverse_keeping_first_edge(bottom);
	builder.add_loop(bottom);
	builder.end_face(FaceTag::None, material);
	for (size_t i = 0; i < base.size(); ++i) {
		builder.add_loop(Loop{ base[i], base[(i + 1) % base.size()], apex });
		builder.end_face(FaceTag::None, material);
	}
	set_geometry(shape, builder.finish(arena, true));
	turn_scope_to(shape, normal, builder, arena);
	if (height < 0.0) {
		mirror_scope(shape, 1);
	}
	return true;
}

void reverse_normals(Shape &shape, GeometryBuilder &builder, Arena &arena) {
	if (shape.geometry == nullptr) {
		return;
	}
	const Geometry &geometry = *shape.geometry;
	builder.begin(geometry, glm::dmat3(-1.0));
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		const GeometryFace &face = geometry.faces[f];
		for (uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
			const uint32_t first = geometry.first_point(l), count = geometry.loop_ends[l] - first;
			for (uint32_t i = 0; i < count; ++i) {
				const uint32_t corner = first + reversed_index(i, count);
				builder.add_corner(geometry.points[corner], corner);
			}
			builder.end_loop(1);
		}
		builder.end_face(face.tag, face.material);
	}
	shape.geometry = builder.finish(arena, false); // inside out: cuts of it have no caps
}

} // namespace pcg::cga
