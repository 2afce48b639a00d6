#include "core/geometry/solid.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/geometry/polygon.h"
#include "core/geometry/triangulate.h"

namespace pcg {

namespace {

constexpr double tolerance = solid_tolerance;
constexpr size_t max_pieces = 1024; // of one triangle; finer than that nothing is told apart

using Piece = std::vector<glm::dvec3>; // a convex polygon

struct Box {
	glm::dvec3 low, high;

	template <typename Points> static Box of(const Points &points) {
		Box box = { points[0], points[0] };
		for (const glm::dvec3 &point : points) {
			box = { glm::min(box.low, point), glm::max(box.high, point) };
		}
		return box;
	}
	bool is_near(const Box &other) const {
		for (int axis = 0; axis < 3; ++axis) {
			if (low[axis] > other.high[axis] + tolerance || other.low[axis] > high[axis] + tolerance) {
				return false;
			}
		}
		return true;
	}
};

Box box_of(const SolidTriangle &triangle) {
	return Box::of(std::array<glm::dvec3, 3>{ triangle.a, triangle.b, triangle.c });
}

// The plane of a triangle and the planes through its edges, which look inwards.
struct Facet {
	glm::dvec3 corners[3];
	glm::dvec3 normal;
	glm::dvec3 inward[3];

	explicit Facet(const SolidTriangle &triangle) : corners{ triangle.a, triangle.b, triangle.c }, normal(0.0), inward{} {
		const glm::dvec3 area = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
		const double length = glm::length(area);
		normal = length > 0.0 ? area / length : glm::dvec3(0.0);
		for (int i = 0; i < 3; ++i) {
			const glm::dvec3 across = glm::cross(normal, corners[(i + 1) % 3] - corners[i]);
			const double size = glm::length(across);
			inward[i] = size > 0.0 ? across / size : glm::dvec3(0.0);
		}
	}
	double height(glm::dvec3 point) const { return glm::dot(normal, point - corners[0]); }
	double depth(int edge, glm::dvec3 point) const { return glm::dot(inward[edge], point - corners[edge]); }
	bool is_flat() const { return normal == glm::dvec3(0.0); }
	bool holds(glm::dvec3 point) const {
		return std::abs(height(point)) <= tolerance && depth(0, point) >= -tolerance && depth(1, point) >= -tolerance && depth(2, point) >= -tolerance;
	}
};

// Both sides of a plane; a side that only touches it is empty.
void cut(const Piece &piece, glm::dvec3 normal, glm::dvec3 origin, Piece &front, Piece &back) {
	front.clear();
	back.clear();
	for (size_t i = 0; i < piece.size(); ++i) {
		const glm::dvec3 a = piece[i], b = piece[(i + 1) % piece.size()];
		const double da = glm::dot(normal, a - origin), db = glm::dot(normal, b - origin);
		if (da >= 0.0) {
			front.push_back(a);
		}
		if (da <= 0.0) {
			back.push_back(a);
		}
		if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) {
			const glm::dvec3 point = a + (b - a) * (da / (da - db));
			front.push_back(point);
			back.push_back(point);
		}
	}
}

struct Extent {
	double least = 0.0, most = 0.0;

	bool crosses() const { return least < -tolerance && most > tolerance; }
	bool is_zero() const { return least >= -tolerance && most <= tolerance; }
};

template <typename Measure> Extent extent_of(const Piece &piece, Measure measure) {
	Extent extent = { INFINITY, -INFINITY };
	for (const glm::dvec3 &point : piece) {
		const double value = measure(point);
		extent = { std::min(extent.least, value), std::max(extent.most, value) };
	}
	return extent;
}

// Whether the line in which the piece crosses the facet's plane runs through the facet.
bool passes_through(const Piece &piece, const Facet &facet) {
	glm::dvec3 ends[2];
	int found = 0;
	for (size_t i = 0; i < piece.size() && found < 2; ++i) {
		const glm::dvec3 a = piece[i], b = piece[(i + 1) % piece.size()];
		const double da = facet.height(a), db = facet.height(b);
		if ((da > 0.0) != (db > 0.0)) {
			ends[found++] = a + (b - a) * (da / (da - db));
		}
	}
	double from = 0.0, to = 1.0;
	for (int edge = 0; edge < 3 && found == 2; ++edge) {
		const double d0 = facet.depth(edge, ends[0]), d1 = facet.depth(edge, ends[1]);
		if (d0 < 0.0 && d1 < 0.0) {
			return false;
		}
		if (d0 * d1 < 0.0) {
			const double at = d0 / (d0 - d1);
			from = d0 < 0.0 ? std::max(from, at) : from;
			to = d1 < 0.0 ? std::min(to, at) : to;
		}
	}
	return found == 2 && (to - from) * glm::distance(ends[0], ends[1]) > tolerance;
}

// Cuts the pieces of one triangle along everything of a closed surface that they meet, so that afterwards each lies on one side of it.
class Cutter {
public:
	explicit Cutter(const SolidTriangle &triangle) : _pieces{ { triangle.a, triangle.b, triangle.c } } {}

	void cut_along(const Facet &facet) {
		const size_t count = _pieces.size();
		for (size_t i = 0; i < count && _pieces.size() < max_pieces; ++i) {
			const Extent heights = extent_of(_pieces[i], [&](glm::dvec3 p) { return facet.height(p); });
			if (heights.is_zero()) {
				cut_out(i, facet);
			} else if (heights.crosses() && passes_through(_pieces[i], facet)) {
				split(i, facet.normal, facet.corners[0]);
			}
		}
	}
	const std::vector<Piece> &pieces() const { return _pieces; }

private:
	// The piece lies in the facet's plane: parts beside the facet become pieces of their own.
	void cut_out(size_t index, const Facet &facet) {
		for (int edge = 0; edge < 3; ++edge) {
			const Extent depths = extent_of(_pieces[index], [&](glm::dvec3 p) { return facet.depth(edge, p); });
			if (depths.most <= tolerance) {
				return;
			}
		}
		for (int edge = 0; edge < 3; ++edge) {
			const Extent depths = extent_of(_pieces[index], [&](glm::dvec3 p) { return facet.depth(edge, p); });
			if (depths.most <= tolerance) { // what was left has gone to other pieces
				return;
			}
			if (depths.crosses()) {
				split(index, facet.inward[edge], facet.corners[edge]);
			}
		}
	}
	// The front stays in its place.
	void split(size_t index, glm::dvec3 normal, glm::dvec3 origin) {
		cut(_pieces[index], normal, origin, _front, _back);
		if (_front.size() >= 3 && _back.size() >= 3) {
			_pieces[index] = _front;
			_pieces.push_back(_back);
		}
	}

	std::vector<Piece> _pieces;
	Piece _front, _back;
};

struct Findings {
	bool has_inside = false, has_outside = false;
	bool has_contact_same = false, has_contact_opposite = false; // by the side that the surfaces look to
	bool has_contact = false; // of any kind
};

// Sum of the angles under which the point sees the surface, in turns of the sphere (Van Oosterom and Strackee).
double winding(const Solid &solid, glm::dvec3 point) {
	double sum = 0.0;
	for (const SolidTriangle &triangle : solid.triangles) {
		const glm::dvec3 a = triangle.a - point, b = triangle.b - point, c = triangle.c - point;
		const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
		const double volume = glm::dot(a, glm::cross(b, c));
		const double base = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
		sum += std::atan2(volume, base);
	}
	return sum / 6.283185307179586;
}

bool is_around(const Solid &solid, glm::dvec3 point) {
	return std::abs(winding(solid, point)) > 0.5;
}

void judge(const Piece &piece, glm::dvec3 normal, const Solid &closed, const std::vector<Facet> &near, Findings &findings) {
	glm::dvec3 middle(0.0);
	for (const glm::dvec3 &point : piece) {
		middle += point / double(piece.size());
	}
	for (const Facet &facet : near) {
		if (facet.holds(middle)) {
			const double turn = glm::dot(facet.normal, normal);
			findings.has_contact = true;
			findings.has_contact_same |= turn > 0.99;
			findings.has_contact_opposite |= turn < -0.99;
			return;
		}
	}
	(is_around(closed, middle) ? findings.has_inside : findings.has_outside) = true;
}

bool is_sliver(const Piece &piece) {
	double length = 0.0;
	for (size_t i = 0; i < piece.size(); ++i) {
		length += glm::distance(piece[i], piece[(i + 1) % piece.size()]);
	}
	return glm::length(area_vector(piece)) <= tolerance * length;
}

void examine(const SolidTriangle &triangle, const Solid &closed, const std::vector<Facet> &facets, Findings &findings) {
	const Facet own(triangle);
	const Box box = box_of(triangle);
	std::vector<Facet> near;
	for (const Facet &facet : facets) {
		if (!facet.is_flat() && box.is_near(Box::of(facet.corners))) {
			near.push_back(facet);
		}
	}
	Cutter cutter(triangle);
	for (const Facet &facet : near) {
		cutter.cut_along(facet);
	}
	for (const Piece &piece : cutter.pieces()) {
		if (!is_sliver(piece)) {
			judge(piece, own.normal, closed, near, findings);
		}
	}
}

Findings find(const Solid &surface, const Solid &closed) {
	const std::vector<Facet> facets(closed.triangles.begin(), closed.triangles.end());
	Box box = box_of(closed.triangles[0]);
	for (const SolidTriangle &triangle : closed.triangles) {
		const Box other = box_of(triangle);
		box = { glm::min(box.low, other.low), glm::max(box.high, other.high) };
	}
	Findings findings;
	for (const SolidTriangle &triangle : surface.triangles) {
		if (box.is_near(box_of(triangle))) {
			examine(triangle, closed, facets, findings);
		} else {
			findings.has_outside = true;
		}
	}
	return findings;
}

// Whether the whole of `inner`, whose surface does not cross the other's, lies in it: told by any part that does not lie on its surface.
bool lies_within(const Solid &inner, const Solid &outer) {
	for (const SolidTriangle &triangle : inner.triangles) {
		const PointPlace place = place_in(outer, (triangle.a + triangle.b + triangle.c) / 3.0);
		if (place != PointPlace::Surface) {
			return place == PointPlace::Inside;
		}
	}
	return false;
}

} // namespace

void Solid::add_polygon(std::span<const glm::dvec3> points, std::span<const uint32_t> loop_ends) {
	const glm::dvec3 normal = loop_normal(points.first(loop_ends[0]));
	Loop2 flat;
	for (const glm::dvec3 &point : points) {
		flat.push_back(flatten(point, normal));
	}
	std::vector<uint32_t> indices;
	triangulate(flat, loop_ends, indices);
	for (size_t i = 0; i + 2 < indices.size(); i += 3) {
		triangles.push_back({ points[indices[i]], points[indices[i + 1]], points[indices[i + 2]] });
	}
}

PointPlace place_in(const Solid &closed, glm::dvec3 point) {
	for (const SolidTriangle &triangle : closed.triangles) {
		const Facet facet(triangle);
		if (!facet.is_flat() && facet.holds(point)) {
			return PointPlace::Surface;
		}
	}
	return is_around(closed, point) ? PointPlace::Inside : PointPlace::Outside;
}

SolidRelation relate_points(std::span<const glm::dvec3> points, const Solid &closed) {
	SolidRelation relation;
	relation.is_inside = !points.empty();
	for (const glm::dvec3 &point : points) {
		const PointPlace place = place_in(closed, point);
		relation.is_inside &= place != PointPlace::Outside;
		relation.overlaps |= place == PointPlace::Inside;
	}
	relation.touches = relation.overlaps;
	return relation;
}

SolidRelation relate(const Solid &surface, const Solid &closed) {
	SolidRelation relation;
	if (surface.triangles.empty() || closed.triangles.empty()) {
		return relation;
	}
	const Findings findings = find(surface, closed);
	relation.is_inside = !findings.has_outside && (findings.has_inside || findings.has_contact);
	relation.overlaps = findings.has_inside;
	if (surface.is_closed && !relation.overlaps) {
		// Volumes on the same side of a common face share what lies behind it.
		relation.overlaps = findings.has_contact_same || lies_within(closed, surface);
	}
	relation.touches = relation.overlaps || findings.has_contact_same || findings.has_contact_opposite;
	return relation;
}

} // namespace pcg
