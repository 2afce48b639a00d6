#include "core/cga/initial_shape.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

constexpr double least_edge = 1e-6; // metres
constexpr size_t checked_points = 2000; // larger outlines are not tested for crossings, which takes the square of that
constexpr double largest_coordinate = 1e9;

using Loop = SmallVector<glm::dvec3, 8>;

bool is_usable(glm::dvec3 point) {
	const glm::dvec3 size = glm::abs(point);
	return size.x < largest_coordinate && size.y < largest_coordinate && size.z < largest_coordinate; // false for NaN too
}

struct TexturedLoop {
	Loop points;
	std::vector<glm::dvec2> uvs; // as many, no_uv() where nothing is known; empty: nothing at all
};
using LotFaces = SmallVector<SmallVector<TexturedLoop, 1>, 1>; // the first loop of each is the outline

// `first_uv`: of the loop in the face's list.
TexturedLoop cleaned(std::span<const glm::dvec3> loop, std::span<const glm::dvec2> uvs, size_t first_uv) {
	TexturedLoop result;
	Loop &points = result.points;
	for (size_t i = 0; i < loop.size(); ++i) {
		if (is_usable(loop[i]) && (points.empty() || glm::distance(loop[i], points.back()) > least_edge)) {
			points.push_back(loop[i]);
			if (!uvs.empty()) {
				result.uvs.push_back(first_uv + i < uvs.size() ? uvs[first_uv + i] : no_uv());
			}
		}
	}
	while (points.size() > 1 && glm::distance(points.back(), points.front()) <= least_edge) {
		points.pop_back();
	}
	result.uvs.resize(std::min(result.uvs.size(), points.size()));
	return result;
}

bool has_area(const Loop &loop) {
	return loop.size() >= 3 && glm::length(area_vector(loop)) > 1e-9;
}

bool crosses_itself(const Loop &loop) {
	if (loop.size() < 4 || loop.size() > checked_points) {
		return false;
	}
	const glm::dvec3 normal = loop_normal(loop);
	Loop2 flat;
	for (const glm::dvec3 &point : loop) {
		flat.push_back(flatten(point, normal));
	}
	return is_self_intersecting(flat);
}

LotFaces usable_faces(const InitialShape &source, Diagnostics &diagnostics) {
	LotFaces faces;
	for (const InitialShape::Face &face : source.faces) {
		TexturedLoop outline = cleaned(face.outline, face.uvs, 0);
		if (!has_area(outline.points)) {
			continue;
		}
		if (crosses_itself(outline.points)) {
			diagnostics.warning("crossing-outline", "the outline of " + (source.name.empty() ? "the lot" : source.name) + " crosses itself",
					"draw it so that no two of its edges meet between their ends");
		}
		const glm::dvec3 normal = loop_normal(outline.points);
		faces.emplace_back().push_back(std::move(outline));
		size_t first_uv = face.outline.size();
		for (const std::vector<glm::dvec3> &hole : face.holes) {
			TexturedLoop clean_hole = cleaned(hole, face.uvs, first_uv);
			first_uv += hole.size();
			if (has_area(clean_hole.points)) {
				if (glm::dot(area_vector(clean_hole.points), normal) > 0.0) {
					std::ranges::reverse(clean_hole.points);
					std::ranges::reverse(clean_hole.uvs);
				}
				faces.back().push_back(std::move(clean_hole));
			}
		}
	}
	return faces;
}

glm::dmat3 street_axes(const InitialShape &source, const Lot &lot) {
	const auto widest = std::ranges::max_element(source.street_widths);
	if (widest == source.street_widths.end() || !(*widest > 0.0f)) {
		return lot.object_axes;
	}
	const std::vector<glm::dvec3> &outline = source.faces[0].outline;
	const size_t edge = size_t(widest - source.street_widths.begin());
	if (edge >= outline.size()) {
		return lot.object_axes;
	}
	return axes_from_y(lot.object_axes[1], outline[(edge + 1) % outline.size()] - outline[edge]);
}

// In the object's system.
const Geometry *object_geometry(const LotFaces &faces, const Lot &lot, GeometryBuilder &builder, Arena &arena) {
	std::vector<glm::dvec2> uvs;
	size_t points = 0;
	for (const auto &face : faces) {
		for (const TexturedLoop &loop : face) {
			if (!loop.uvs.empty()) {
				uvs.resize(points, no_uv());
				uvs.insert(uvs.end(), loop.uvs.begin(), loop.uvs.end());
			}
			points += loop.points.size();
		}
	}
	if (!uvs.empty()) {
		uvs.resize(points, no_uv());
	}
	CornerData corners;
	corners.put(0, uvs.data());
	Geometry source;
	source.corners = std::ranges::any_of(uvs, has_uv) ? &corners : nullptr;
	const glm::dmat3 to_object = glm::transpose(lot.object_axes);
	builder.begin(source);
	uint32_t corner = 0;
	for (const auto &face : faces) {
		for (const TexturedLoop &loop : face) {
			for (const glm::dvec3 &point : loop.points) {
				glm::dvec3 local = to_object * (point - lot.origin);
				local.y = std::abs(local.y) < 1e-9 ? 0.0 : local.y; // a flat lot stays flat whichever way it lies
				builder.add_corner(local, corner++);
			}
			builder.end_loop();
		}
		builder.end_face();
	}
	return builder.finish(arena, false);
}

} // namespace

InitialShape InitialShape::of(std::vector<glm::dvec3> outline, uint64_t seed) {
	InitialShape shape;
	shape.faces.push_back({ std::move(outline), {}, {} });
	shape.seed = seed;
	return shape;
}

InitialShape InitialShape::rectangle(double width, double depth, uint64_t seed) {
	return of({ { 0.0, 0.0, 0.0 }, { width, 0.0, 0.0 }, { width, 0.0, -depth }, { 0.0, 0.0, -depth } }, seed);
}

bool make_initial_shape(const InitialShape &source, GeometryBuilder &builder, Arena &arena, Lot &lot, Shape &shape, Diagnostics &diagnostics) {
	const LotFaces faces = usable_faces(source, diagnostics);
	if (faces.empty()) {
		diagnostics.error("bad-initial-shape", "the initial shape has no polygon with an area",
				"give at least three different points with finite coordinates that do not lie on one line; an outline that crosses itself can have no area either");
		return false;
	}
	const Loop &first = faces[0][0].points;
	lot.origin = first[0];
	lot.object_axes = axes_from_y(loop_normal(first), first[1] - first[0]);
	lot.street_axes = street_axes(source, lot);

	shape.pivot = arena.make(Frame{ lot.object_axes, glm::dvec3(0.0) });
	set_geometry(shape, object_geometry(faces, lot, builder, arena));
	lot.center = shape.frame().to_parent(0.5 * shape.size);
	return true;
}

} // namespace pcg::cga
