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
void add_without(const WalkablePiece &piece, const Polygon &hole, std::vector<WalkablePiece> &parts) {
	Polygon rest = piece.polygon;
	std::vector<WalkablePiece> outside;
	for (size_t i = 0; i < hole.size() && !rest.empty(); ++i) {
		const glm::vec3 a = hole[i], b = hole[(i + 1) % hole.size()];
		if (Polygon beyond = part(rest, a, b, -1.0f); !beyond.empty()) {
			outside.push_back({ std::move(beyond), piece.cost });
		}
		rest = part(rest, a, b, 1.0f);
	}
	if (rest.empty()) { // they do not meet: in one piece
		parts.push_back(piece);
	} else {
		parts.insert(parts.end(), std::make_move_iterator(outside.begin()), std::make_move_iterator(outside.end()));
	}
}

std::vector<Polygon> convex_holes(const GroundPatch &patch) {
	Loops2 kept;
	for (const Polygon &outline : patch.kept) {
		kept.push_back(to_plan(outline));
	}
	const Loops2 whole{ to_plan(patch.outline) };
	std::vector<Polygon> holes;
	for (const Loops2 &polygon : kept.empty() ? Polygons2{ whole } : overlay(whole, kept, OverlayKind::Difference)) {
		for (const Loops2 &part : convex_parts(polygon, INFINITY)) {
			Polygon &hole = holes.emplace_back();
			for (const glm::dvec2 &corner : part[0]) {
				hole.push_back({ float(corner.x), patch.outline[0].y, float(-corner.y) });
			}
		}
	}
	return holes;
}

} // namespace

void apply_patches(std::vector<WalkablePiece> &ground, std::span<const GroundPatch> patches, float cost) {
	std::vector<WalkablePiece> left;
	for (const GroundPatch &patch : patches) {
		for (const Polygon &hole : patch.outline.size() < 3 ? std::vector<Polygon>() : convex_holes(patch)) {
			left.clear();
			for (const WalkablePiece &piece : ground) {
				add_without(piece, hole, left);
			}
			std::swap(ground, left);
		}
		for (const Polygon &piece : patch.pieces) {
			ground.push_back({ piece, cost });
		}
	}
}

} // namespace pcg
