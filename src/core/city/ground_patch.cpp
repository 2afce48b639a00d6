#include "core/city/ground_patch.h"

#include <cmath>
#include <iterator>

#include "core/city/plan_layout.h"
#include "core/geometry/convex_parts.h"

namespace pcg {

namespace {

using Polygon = std::vector<glm::vec3>;

constexpr float sliver = 1e-3f; // metres; a corner this near to a line lies on it

// Metres left of the line from `a` to `b`, seen from above.
float side(glm::vec3 a, glm::vec3 b, glm::vec3 point) {
	const float x = b.x - a.x, z = b.z - a.z, length = std::hypot(x, z);
	return length > 0.0f ? (z * (point.x - a.x) - x * (point.z - a.z)) / length : 0.0f;
}

// The part of a convex polygon on the left of the line (`sign` = 1) or on the right (-1); empty if it is no wider than a sliver.
Polygon part(const Polygon &polygon, glm::vec3 a, glm::vec3 b, float sign) {
	Polygon kept;
	bool has_area = false;
	for (size_t i = 0; i < polygon.size(); ++i) {
		const glm::vec3 corner = polygon[i], next = polygon[(i + 1) % polygon.size()];
		const float here = side(a, b, corner) * sign, there = side(a, b, next) * sign;
		has_area |= here > sliver;
		if (here >= 0.0f) {
			kept.push_back(corner);
		}
		if ((here > 0.0f && there < 0.0f) || (here < 0.0f && there > 0.0f)) {
			kept.push_back(corner + (next - corner) * (here / (here - there)));
		}
	}
	return has_area && kept.size() >= 3 ? kept : Polygon();
}

// `polygon` without the convex `hole`, in convex parts.
void add_without(const Polygon &polygon, const Polygon &hole, std::vector<Polygon> &parts) {
	Polygon rest = polygon;
	std::vector<Polygon> outside;
	for (size_t i = 0; i < hole.size() && !rest.empty(); ++i) {
		const glm::vec3 a = hole[i], b = hole[(i + 1) % hole.size()];
		if (Polygon beyond = part(rest, a, b, -1.0f); !beyond.empty()) {
			outside.push_back(std::move(beyond));
		}
		rest = part(rest, a, b, 1.0f);
	}
	if (rest.empty()) { // they do not meet: in one piece
		parts.push_back(polygon);
	} else {
		parts.insert(parts.end(), std::make_move_iterator(outside.begin()), std::make_move_iterator(outside.end()));
	}
}

std::vector<Polygon> convex(const Polygon &outline) {
	std::vector<Polygon> parts;
	if (outline.size() < 3) {
		return parts;
	}
	for (const Loops2 &loops : convex_parts({ to_plan(outline) }, INFINITY)) {
		Polygon &convex_part = parts.emplace_back();
		for (const glm::dvec2 &corner : loops[0]) {
			convex_part.push_back({ float(corner.x), outline[0].y, float(-corner.y) });
		}
	}
	return parts;
}

} // namespace

void apply_patches(std::vector<WalkablePiece> &ground, std::span<const GroundPatch> patches, float cost) {
	std::vector<WalkablePiece> left;
	std::vector<Polygon> parts;
	for (const GroundPatch &patch : patches) {
		for (const Polygon &hole : convex(patch.outline)) {
			left.clear();
			for (const WalkablePiece &piece : ground) {
				parts.clear();
				add_without(piece.polygon, hole, parts);
				for (Polygon &polygon : parts) {
					left.push_back({ std::move(polygon), piece.cost });
				}
			}
			std::swap(ground, left);
		}
		for (const Polygon &piece : patch.pieces) {
			ground.push_back({ piece, cost });
		}
	}
}

std::vector<Polygon> pieces_within(std::span<const Polygon> pieces, const Polygon &outline) {
	std::vector<Polygon> within;
	for (const Polygon &window : convex(outline)) {
		for (Polygon rest : pieces) {
			for (size_t i = 0; i < window.size() && !rest.empty(); ++i) {
				rest = part(rest, window[i], window[(i + 1) % window.size()], 1.0f);
			}
			if (!rest.empty()) {
				within.push_back(std::move(rest));
			}
		}
	}
	return within;
}

std::vector<Polygon> pieces_without(std::vector<Polygon> pieces, std::span<const Polygon> outlines) {
	for (const Polygon &outline : outlines) {
		for (const Polygon &hole : convex(outline)) {
			std::vector<Polygon> left;
			for (const Polygon &piece : pieces) {
				add_without(piece, hole, left);
			}
			pieces = std::move(left);
		}
	}
	return pieces;
}

} // namespace pcg
