#include "core/cga/trim.h"

#include <array>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/cga/append.h"
#include "core/cga/roof_edges.h"
#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

constexpr double horizontal_sine = 0.64278760968653933 - 1e-9; // of 40 degrees, which is vertical whatever rounding says
constexpr double margin = 1e-6; // metres that may stick out
constexpr double flat = 1e-3; // radians between faces that lie in one plane
constexpr double straight = 1e-4; // radians between edges that lie in one line

Plane opposite(const Plane &plane) {
	return { -plane.normal, -plane.offset };
}

// The least and the most of a direction among the corners of the bounds.
std::pair<double, double> extent(const Shape &shape, glm::dvec3 direction) {
	const glm::dvec3 low = direction * shape.to_scope(shape.geometry->low), high = direction * shape.to_scope(shape.geometry->high);
	const glm::dvec3 least = glm::min(low, high), most = glm::max(low, high);
	return { least.x + least.y + least.z, most.x + most.y + most.z };
}

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

// A corner that points into the face ends the plane there: beyond it the face goes on.
void Trimmer::limit(TrimPlane &plane, const TrimSource &source, const GeometryFace &face, const Edge &edge) {
	const glm::dvec3 normal = face_normal(*source.geometry, face), ahead = edge.to - edge.from;
	const auto points_in = [&](glm::dvec3 a, glm::dvec3 b) { return glm::dot(glm::cross(a, b), normal) < -straight * glm::length(a) * glm::length(b); };
	plane.along = source.frame.axes * glm::normalize(ahead);
	if (points_in(edge.from - edge.before, ahead)) {
		plane.low = glm::dot(plane.along, source.frame.to_parent(edge.from));
	}
	if (points_in(ahead, edge.behind - edge.to)) {
		plane.high = glm::dot(plane.along, source.frame.to_parent(edge.to));
	}
}

void Trimmer::add_plane(const TrimSource &source, const GeometryFace &face, const GeometryFace &other, const Edge &edge, const glm::dmat3 &pivot) {
	const glm::dvec3 own = inward(*source.geometry, face, edge.from, edge.to), across = inward(*source.geometry, other, edge.from, edge.to);
	const double length = glm::length(own - across);
	if (!(length > 1e-9) || glm::length(own + across) < flat) { // folded onto each other, or one plane
		return;
	}
	TrimPlane plane;
	plane.is_horizontal = std::abs(glm::dot(pivot[1], glm::normalize(edge.to - edge.from))) < horizontal_sine;
	if (plane.is_horizontal && is_shed_roof(*source.geometry)) {
		return;
	}
	plane.plane.normal = source.frame.axes * ((own - across) / length);
	plane.plane.offset = glm::dot(plane.plane.normal, source.frame.to_parent(edge.from));
	limit(plane, source, face, edge);
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
			const auto corner = [&](size_t j) { return loop[j % loop.size()]; };
			const Edge edge{ corner(i + loop.size() - 1), corner(i), corner(i + 1), corner(i + 2) };
			if (const GeometryFace *other = neighbor_at(geometry, index, edge.from, edge.to)) {
				add_plane(source, face, *other, edge, pivot);
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

Trimmer::TrimPlane Trimmer::in_scope(const TrimPlane &plane, const Frame &frame) {
	TrimPlane result = plane;
	result.plane.normal = glm::transpose(frame.axes) * plane.plane.normal;
	result.plane.offset -= glm::dot(plane.plane.normal, frame.origin);
	result.along = glm::transpose(frame.axes) * plane.along;
	result.low -= glm::dot(plane.along, frame.origin);
	result.high -= glm::dot(plane.along, frame.origin);
	return result;
}

// Of what a limited plane cuts through, the part beyond it goes as far as the plane reaches.
const Geometry *Trimmer::cut(const Geometry &geometry, const TrimPlane &plane, Clipper &clipper, Arena &arena) {
	if (!plane.is_limited()) {
		return clipper.clip(geometry, plane.plane, arena);
	}
	const std::array<Plane, 3> wedge{ opposite(plane.plane), Plane{ plane.along, plane.low }, opposite({ plane.along, plane.high }) };
	std::array<const Geometry *, 3> parts{};
	const Geometry *rest = &geometry;
	for (size_t i = 0; i < wedge.size(); ++i) {
		if (!std::isfinite(wedge[i].offset)) {
			continue;
		}
		const Geometry *inner = clipper.clip(*rest, wedge[i], arena);
		parts[i] = inner != rest ? clipper.clip(*rest, opposite(wedge[i]), arena) : nullptr;
		if (inner == nullptr || parts[0] == nullptr) {
			return &geometry;
		}
		rest = inner;
	}
	Appender appender(arena, parts);
	for (const Geometry *part : parts) {
		if (part != nullptr) {
			appender.add(*part, Frame());
		}
	}
	return appender.finish();
}

bool Trimmer::trim(Shape &shape, Clipper &clipper, Arena &arena) {
	if (shape.trim == nullptr || shape.geometry == nullptr || (!shape.trims_vertically && !shape.trims_horizontally)) {
		return false;
	}
	const Frame frame = shape.frame();
	bool is_cut = false;
	for (const TrimPlane &known : planes(*shape.trim, shape.trim_face)) {
		if (!(known.is_horizontal ? shape.trims_horizontally : shape.trims_vertically)) {
			continue;
		}
		const TrimPlane plane = in_scope(known, frame);
		const auto [from, to] = extent(shape, plane.along);
		if (extent(shape, plane.plane.normal).first >= plane.plane.offset - margin || to < plane.low + margin || from > plane.high - margin) {
			continue;
		}
		const Geometry *geometry = baked(shape, arena);
		const Geometry *rest = cut(*geometry, plane, clipper, arena);
		if (rest == geometry) {
			continue;
		}
		is_cut = true;
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
