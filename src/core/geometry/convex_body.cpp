#include "core/geometry/convex_body.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/base/small_vector.h"

namespace pcg {

namespace {

constexpr double tolerance = solid_tolerance;
constexpr double sure = 100.0 * tolerance; // what is as long as that is no matter of tolerance

} // namespace

ConvexBody::Extent ConvexBody::heights(const Side &side, std::span<const glm::dvec3> points) {
	double least = INFINITY, most = -INFINITY;
	for (const glm::dvec3 &point : points) {
		const double height = glm::dot(side.normal, point) - side.offset;
		least = height < least ? height : least;
		most = most < height ? height : most;
	}
	return { least, most };
}

ConvexBody::ConvexBody(const Solid &closed) {
	if (closed.triangles.size() > max_triangles) {
		return;
	}
	for (const SolidTriangle &triangle : closed.triangles) {
		for (const glm::dvec3 &corner : { triangle.a, triangle.b, triangle.c }) {
			if (std::ranges::find(_corners, corner) == _corners.end()) {
				_corners.push_back(corner);
			}
		}
		const glm::dvec3 area = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
		const double length = glm::length(area);
		const glm::dvec3 normal = area / length;
		const Side side = { normal, glm::dot(normal, triangle.a) };
		const auto is_same = [&](const Side &other) { return glm::dot(other.normal, normal) > 1.0 - 1e-12 && std::abs(other.offset - side.offset) < 1e-9; };
		if (length > 0.0 && std::ranges::none_of(_sides, is_same)) {
			_sides.push_back(side);
		}
	}
	if (std::ranges::any_of(_sides, [&](const Side &side) { return !(heights(side, _corners).most <= 0.01 * tolerance); })) {
		_sides.clear();
	}
}

ConvexBody::Relation ConvexBody::relation_to(std::span<const glm::dvec3> corners, bool is_rectangle) const {
	for (size_t i = 0; i < _sides.size(); ++i) {
		const Extent extent = heights(_sides[i], corners);
		if (extent.least > tolerance) {
			return Relation::Apart;
		}
		if (is_rectangle && extent.least >= -tolerance) { // its plane leads away, or is that of the side
			return extent.most > sure ? Relation::Apart : extent.most <= tolerance ? contact(i, corners) : Relation::Unknown;
		}
	}
	return Relation::Unknown;
}

// The rectangle lies in the plane of a side: two convex outlines are apart where an edge of one has all of the other before it.
ConvexBody::Relation ConvexBody::contact(size_t side, std::span<const glm::dvec3> rectangle) const {
	const glm::dvec3 normal = _sides[side].normal;
	const glm::dvec3 area = glm::cross(rectangle[1] - rectangle[0], rectangle[2] - rectangle[1]);
	if (!(std::abs(glm::dot(area, normal)) > 0.999 * glm::length(area))) {
		return Relation::Unknown;
	}
	double shallowest = INFINITY; // how far they reach over each other, by the edge that says least
	for (size_t i = 0; i < _sides.size() && shallowest > tolerance; ++i) {
		const double slant = glm::dot(_sides[i].normal, normal), in_plane = std::sqrt(std::max(0.0, 1.0 - slant * slant));
		if (in_plane > 1e-3) { // else it has no edge with this one
			shallowest = std::min(shallowest, -heights(_sides[i], rectangle).least / in_plane);
		}
	}
	if (shallowest <= tolerance) {
		return Relation::Apart;
	}
	SmallVector<glm::dvec3, 8> outline; // the corners of the side
	for (const glm::dvec3 &corner : _corners) {
		if (std::abs(glm::dot(normal, corner) - _sides[side].offset) <= tolerance) {
			outline.push_back(corner);
		}
	}
	const glm::dvec3 middle = 0.5 * (rectangle[0] + rectangle[2]);
	for (size_t i = 0; i < rectangle.size(); ++i) {
		const glm::dvec3 from = rectangle[i], way = glm::normalize(glm::cross(rectangle[i + 1 < rectangle.size() ? i + 1 : 0] - from, normal));
		const glm::dvec3 outwards = glm::dot(way, from - middle) > 0.0 ? way : -way;
		double reach = -INFINITY; // of the side over this edge
		for (const glm::dvec3 &corner : outline) {
			reach = std::max(reach, -glm::dot(outwards, corner - from));
		}
		shallowest = std::min(shallowest, reach);
	}
	return shallowest <= tolerance ? Relation::Apart : shallowest > sure ? Relation::Contact : Relation::Unknown;
}

} // namespace pcg
