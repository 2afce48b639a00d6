#include "core/cga/trim.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/cga/roof_edges.h"
#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

constexpr double horizontal_sine = 0.64278760968653933 - 1e-9; // of 40 degrees, which is vertical whatever rounding says
constexpr double margin = 1e-6; // metres that may stick out

// The other face with the edge from `to` to `from`, or either way round where normals disagree; nullptr if there is none.
const GeometryFace *neighbor_at(const Geometry &geometry, uint32_t own, glm::dvec3 from, glm::dvec3 to) {
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		const GeometryFace &face = geometry.faces[f];
		for (uint32_t l = 0; l < face.loop_count && f != own; ++l) {
			const auto loop = geometry.loop(face.first_loop + l);
			for (size_t i = 0; i < loop.size(); ++i) {
				const glm::dvec3 &a = loop[i], &b = loop[i + 1 < loop.size() ? i + 1 : 0];
				if ((a == to && b == from) || (a == from && b == to)) {
					return &face;
				}
			}
		}
	}
	return nullptr;
}

// In the face's plane, across the edge, into the face: whichever way the edge runs in that face.
glm::dvec3 inward(const Geometry &geometry, const GeometryFace &face, glm::dvec3 from, glm::dvec3 to) {
	const glm::dvec3 across = glm::normalize(glm::cross(face_normal(geometry, face), to - from));
	for (uint32_t l = 0; l < face.loop_count; ++l) {
		const auto loop = geometry.loop(face.first_loop + l);
		for (size_t i = 0; i < loop.size(); ++i) {
			if (loop[i] == to && loop[(i + 1) % loop.size()] == from) {
				return -across;
			}
		}
	}
	return across;
}

} // namespace

const TrimSource *Trimmer::source_of(const Shape &shape, const Geometry &baked_geometry, bool keeps_axes, Arena &arena) {
	return arena.make(TrimSource{ &baked_geometry, shape.frame(), ++_last_id, keeps_axes, shape.trim, shape.trim_face });
}

void Trimmer::add_plane(const TrimSource &source, const GeometryFace &face, const GeometryFace &other, glm::dvec3 from, glm::dvec3 to, const glm::dmat3 &pivot) {
	const glm::dvec3 difference = inward(*source.geometry, face, from, to) - inward(*source.geometry, other, from, to);
	const double length = glm::length(difference);
	if (!(length > 1e-9)) { // folded onto each other
		return;
	}
	const glm::dvec3 edge = glm::normalize(to - from);
	TrimPlane plane;
	plane.is_horizontal = std::abs(glm::dot(pivot[1], edge)) < horizontal_sine;
	if (plane.is_horizontal && is_shed_roof(*source.geometry)) {
		return;
	}
	plane.plane.normal = source.frame.axes * (difference / length);
	plane.plane.offset = glm::dot(plane.plane.normal, source.frame.to_parent(from));
	_known.push_back(plane);
}

// The edge's angle is measured in the pivot that comp(f) gives the face.
void Trimmer::add_planes(const TrimSource &source, uint32_t index) {
	const Geometry &geometry = *source.geometry;
	const GeometryFace &face = geometry.faces[index];
	const auto outline = geometry.outline(face);
	if (outline.size() < 3) {
		return;
	}
	const glm::dmat3 pivot = source.keeps_axes ? glm::dmat3(1.0) : axes_from_z(face_normal(geometry, face), outline[1] - outline[0]);
	for (uint32_t l = 0; l < face.loop_count; ++l) {
		const auto loop = geometry.loop(face.first_loop + l);
		for (size_t i = 0; i < loop.size(); ++i) {
			const glm::dvec3 from = loop[i], to = loop[(i + 1) % loop.size()];
			if (const GeometryFace *other = neighbor_at(geometry, index, from, to)) {
				add_plane(source, face, *other, from, to, pivot);
			}
		}
	}
}

const std::vector<Trimmer::TrimPlane> &Trimmer::planes(const TrimSource &source, uint32_t face) {
	if (_known_id != source.id || _known_face != face) {
		_known_id = source.id;
		_known_face = face;
		_known.clear();
		uint32_t at = face;
		for (const TrimSource *s = &source; s != nullptr; at = s->outer_face, s = s->outer) {
			add_planes(*s, at);
		}
	}
	return _known;
}

bool Trimmer::trim(Shape &shape, Clipper &clipper, Arena &arena) {
	if (shape.trim == nullptr || shape.geometry == nullptr || (!shape.trims_vertically && !shape.trims_horizontally)) {
		return false;
	}
	const Frame frame = shape.frame();
	bool is_cut = false;
	for (const TrimPlane &trim : planes(*shape.trim, shape.trim_face)) {
		if (!(trim.is_horizontal ? shape.trims_horizontally : shape.trims_vertically)) {
			continue;
		}
		const glm::dvec3 normal = glm::transpose(frame.axes) * trim.plane.normal;
		const double offset = trim.plane.offset - glm::dot(trim.plane.normal, frame.origin);
		double least = -offset;
		for (int axis = 0; axis < 3; ++axis) { // the corner of the bounds that lies deepest
			const double a = normal[axis] * shape.to_scope(shape.geometry->low)[axis], b = normal[axis] * shape.to_scope(shape.geometry->high)[axis];
			least += std::min(a, b);
		}
		if (least >= -margin) {
			continue;
		}
		const Geometry *geometry = baked(shape, arena);
		const Geometry *rest = clipper.clip(*geometry, { normal, offset }, arena);
		is_cut |= rest != geometry;
		shape.geometry = rest;
		shape.geometry_offset = glm::dvec3(0.0);
		shape.geometry_scale = glm::dvec3(1.0);
		if (rest == nullptr) {
			return true;
		}
	}
	return is_cut;
}

} // namespace pcg::cga
