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

using Loop = std::vector<glm::dvec3>;

bool is_usable(glm::dvec3 point) {
	const glm::dvec3 size = glm::abs(point);
	return size.x < largest_coordinate && size.y < largest_coordinate && size.z < largest_coordinate; // false for NaN too
}

Loop cleaned(const Loop &loop) {
	Loop result;
	for (const glm::dvec3 &point : loop) {
		if (is_usable(point) && (result.empty() || glm::distance(point, result.back()) > least_edge)) {
			result.push_back(point);
		}
	}
	while (result.size() > 1 && glm::distance(result.back(), result.front()) <= least_edge) {
		result.pop_back();
	}
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
	std::vector<glm::dvec2> flat;
	for (const glm::dvec3 &point : loop) {
		flat.push_back(flatten(point, normal));
	}
	return is_self_intersecting(flat);
}

// Usable faces only; the first loop of each is the outline.
std::vector<std::vector<Loop>> usable_faces(const InitialShape &source, Diagnostics &diagnostics) {
	std::vector<std::vector<Loop>> faces;
	for (const InitialShape::Face &face : source.faces) {
		Loop outline = cleaned(face.outline);
		if (!has_area(outline)) {
			continue;
		}
		if (crosses_itself(outline)) {
			diagnostics.warning("crossing-outline", "the outline of " + (source.name.empty() ? "the lot" : source.name) + " crosses itself",
					"draw it so that no two of its edges meet between their ends");
		}
		const glm::dvec3 normal = loop_normal(outline);
		faces.push_back({ std::move(outline) });
		for (const Loop &hole : face.holes) {
			Loop clean_hole = cleaned(hole);
			if (has_area(clean_hole)) {
				if (glm::dot(area_vector(clean_hole), normal) > 0.0) {
					std::ranges::reverse(clean_hole);
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

} // namespace

InitialShape InitialShape::of(std::vector<glm::dvec3> outline, uint64_t seed) {
	InitialShape shape;
	shape.faces.push_back({ std::move(outline), {} });
	shape.seed = seed;
	return shape;
}

InitialShape InitialShape::rectangle(double width, double depth, uint64_t seed) {
	return of({ { 0.0, 0.0, 0.0 }, { width, 0.0, 0.0 }, { width, 0.0, -depth }, { 0.0, 0.0, -depth } }, seed);
}

bool make_initial_shape(const InitialShape &source, Arena &arena, Lot &lot, Shape &shape, Diagnostics &diagnostics) {
	const auto faces = usable_faces(source, diagnostics);
	if (faces.empty()) {
		diagnostics.error("bad-initial-shape", "the initial shape has no polygon with an area",
				"give at least three different points with finite coordinates that do not lie on one line");
		return false;
	}
	const Loop &first = faces[0][0];
	lot.origin = first[0];
	lot.object_axes = axes_from_y(loop_normal(first), first[1] - first[0]);
	lot.street_axes = street_axes(source, lot);

	const glm::dmat3 to_object = glm::transpose(lot.object_axes);
	GeometryBuilder builder;
	for (const auto &face : faces) {
		for (const Loop &loop : face) {
			for (const glm::dvec3 &point : loop) {
				glm::dvec3 local = to_object * (point - lot.origin);
				local.y = std::abs(local.y) < 1e-9 ? 0.0 : local.y; // a flat lot stays flat whichever way it lies
				builder.add_point(local);
			}
			builder.end_loop();
		}
		builder.end_face();
	}
	shape.pivot = arena.make(Frame{ lot.object_axes, glm::dvec3(0.0) });
	set_geometry(shape, builder.finish(arena, false));
	lot.center = shape.frame().to_parent(0.5 * shape.size);
	return true;
}

} // namespace pcg::cga
