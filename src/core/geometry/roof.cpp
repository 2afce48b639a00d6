#include "core/geometry/roof.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "core/geometry/inverted.h"
#include "core/geometry/roof_planes.h"
#include "core/geometry/straight_skeleton.h"

namespace pcg {

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

double top_of(const StraightSkeleton &skeleton) {
	double top = 0.0;
	for (const SkeletonFace &face : skeleton.faces) {
		for (const SkeletonVertex &vertex : face.outline) {
			top = std::max(top, vertex.time);
		}
	}
	return top;
}

using PointKey = std::pair<int64_t, int64_t>;

// A tenth of a millimetre: finer than any roof detail, coarser than the skeleton's rounding.
PointKey key_of(glm::dvec2 point) {
	const auto round = [](double value) { return int64_t(value * 1e4 + (value < 0.0 ? -0.5 : 0.5)); };
	return { round(point.x), round(point.y) };
}

// Ridge vertices (where planes meet above the eaves) all at their mean height, and with them the tops of gables.
void level_ridge(RoofFaces &faces) {
	double eaves = endless;
	std::map<PointKey, double> heights;
	for (const RoofFace &face : faces) {
		eaves = face.part == RoofPart::Plane ? std::min(eaves, face.outline[0].z) : eaves;
	}
	const auto is_ridge = [&](const RoofFace &face, const glm::dvec3 &point) {
		return face.part == RoofPart::Plane ? point.z > eaves + 1e-9 : &point == &face.outline.back();
	};
	for (const RoofFace &face : faces) {
		for (const glm::dvec3 &point : face.outline) {
			if (face.part == RoofPart::Plane && is_ridge(face, point)) {
				heights[key_of(point)] = point.z;
			}
		}
	}
	double sum = 0.0;
	for (const auto &[key, height] : heights) {
		sum += height;
	}
	for (RoofFace &face : faces) {
		for (glm::dvec3 &point : face.outline) {
			if (is_ridge(face, point)) {
				point.z = sum / double(heights.size());
			}
		}
	}
}

bool is_hip_end(const RoofFace &face) { return face.part == RoofPart::Plane && face.outline.size() == 3; }

// The corners of roof planes: those in one place have one number, which they keep when they are moved.
class RoofCorners {
public:
	explicit RoofCorners(RoofFaces &faces) : _faces(faces) {
		SmallVector<PointKey, 16> keys;
		for (const RoofFace &face : faces) {
			_first.push_back(uint32_t(_numbers.size()));
			for (const glm::dvec3 &point : face.outline) {
				const PointKey key = key_of(point);
				uint32_t number = 0;
				while (number < keys.size() && keys[number] != key) {
					++number;
				}
				if (number == keys.size()) {
					keys.push_back(key);
					_uses.push_back(0);
				}
				++_uses[number];
				_numbers.push_back(number);
			}
		}
	}

	uint32_t number(size_t face, size_t corner) const { return _numbers[_first[face] + corner]; }
	// How many of the planes use it: three at a simple end of a ridge, four or more where ridges meet.
	uint32_t uses(uint32_t number) const { return _uses[number]; }
	void move(uint32_t number, glm::dvec3 to) {
		for (size_t f = 0; f < _faces.size(); ++f) {
			for (size_t i = 0; i < _faces[f].outline.size() && _faces[f].part == RoofPart::Plane; ++i) { // walls stay where they are
				if (_numbers[_first[f] + i] == number) {
					_faces[f].outline[i] = to;
				}
			}
		}
	}

private:
	RoofFaces &_faces;
	SmallVector<uint32_t, 6> _first; // of each face, in _numbers
	SmallVector<uint32_t, 24> _numbers; // face by face, corner by corner
	SmallVector<uint32_t, 16> _uses; // by number
};

// The direction in which the ridge arrives at the apex of a hip end, from the neighbouring planes; zero if there is none.
glm::dvec3 ridge_direction(const RoofFaces &faces, const RoofCorners &corners, size_t end) {
	const glm::dvec3 apex = faces[end].outline[2];
	for (size_t f = 0; f < faces.size(); ++f) {
		const size_t count = faces[f].outline.size();
		for (size_t i = 0; i < count && count > 3; ++i) {
			const size_t next = i + 1 < count ? i + 1 : 0;
			const bool is_apex_first = corners.number(f, i) == corners.number(end, 2), is_apex_second = corners.number(f, next) == corners.number(end, 2);
			const glm::dvec3 other = faces[f].outline[is_apex_first ? next : i];
			if (is_apex_first != is_apex_second && other.z > faces[end].outline[0].z + 1e-6) {
				return apex - other;
			}
		}
	}
	return glm::dvec3(0.0);
}

// Where the line from `point` along `direction` meets the upright plane through a-b, seen from above; `point` if they are parallel.
glm::dvec3 meet_wall(glm::dvec3 point, glm::dvec3 direction, glm::dvec2 a, glm::dvec2 b) {
	const glm::dvec2 side = b - a, normal(side.y, -side.x);
	const double rate = glm::dot(glm::dvec2(direction), normal);
	return std::abs(rate) < 1e-12 ? point : point + direction * (glm::dot(a - glm::dvec2(point), normal) / rate);
}

// The eave of the plane beside a hip end, at its first or second corner; `fallback` if that plane has none there.
glm::dvec3 eave_direction(const RoofFaces &faces, const RoofCorners &corners, size_t end, size_t corner, glm::dvec3 fallback) {
	for (size_t f = 0; f < faces.size(); ++f) {
		if (f != end && faces[f].part == RoofPart::Plane && corners.number(f, 1 - corner) == corners.number(end, corner)) {
			return faces[f].outline[1] - faces[f].outline[0];
		}
	}
	return fallback;
}

// End points of an edge that counts through all loops.
std::pair<glm::dvec2, glm::dvec2> edge_of(const RoofOutline &outline, uint32_t edge) {
	for (const auto &loop : outline) {
		if (edge < loop.size()) {
			return { loop[edge], loop[(edge + 1) % loop.size()] };
		}
		edge -= uint32_t(loop.size());
	}
	return {};
}

// By more than three degrees.
bool leaves(glm::dvec3 line, glm::dvec2 side) {
	const double across = side.x * line.y - side.y * line.x;
	return std::abs(across) > 0.05 * glm::length(glm::dvec2(line)) && across != 0.0;
}

// Stands the triangular ends upright on the walls: ridge and eaves run on to a line that is `beyond` the wall, so that planes stay planes.
void raise_gables(RoofFaces &faces, const RoofOutline &outline, double beyond) {
	RoofCorners numbered(faces);
	for (size_t f = 0; f < faces.size(); ++f) {
		RoofFace &end = faces[f];
		if (!is_hip_end(end) || numbered.uses(numbered.number(f, 2)) != 3) {
			continue;
		}
		const glm::dvec3 ridge = ridge_direction(faces, numbered, f);
		const auto [start, stop] = edge_of(outline, end.edge);
		const glm::dvec2 side = glm::normalize(stop - start), gap = glm::dvec2(side.y, -side.x) * beyond;
		const glm::dvec3 top = meet_wall(end.outline[2], ridge, start, stop);
		const double along = glm::dot(glm::dvec2(top) - start, side);
		const glm::dvec3 directions[] = { eave_direction(faces, numbered, f, 0, ridge), eave_direction(faces, numbered, f, 1, ridge), ridge };
		// Beside an inner corner the ridge would miss its wall; a wall that goes straight on is no end.
		const bool is_end = along > 0.0 && along < glm::distance(start, stop) && top.z > 0.0;
		if (!is_end || !std::ranges::all_of(directions, [&](glm::dvec3 line) { return leaves(line, side); })) {
			continue;
		}
		const RoofLoop corners = end.outline;
		for (size_t i = 0; i < corners.size(); ++i) {
			numbered.move(numbered.number(f, i), meet_wall(corners[i], directions[i], start + gap, stop + gap));
		}
		end = { RoofPart::Gable, end.edge, { { start, 0.0 }, { stop, 0.0 }, top }, {} };
	}
}

// A square-like outline has a point where others have a ridge. The planes of edges 0 and 2 share it as a ridge of a millimetre, so that the ends
// 1 and 3 become gables like any other.
void open_point_ridge(RoofFaces &faces) {
	bool is_point = faces.size() == 4 && std::all_of(faces.begin(), faces.end(), is_hip_end);
	for (size_t i = 0; i < 4 && is_point; ++i) {
		const glm::dvec2 before(faces[i].outline[1] - faces[i].outline[0]), next = faces[(i + 1) % 4].outline[1] - faces[(i + 1) % 4].outline[0];
		is_point = before.x * next.y > before.y * next.x; // convex
	}
	if (!is_point) {
		return;
	}
	const glm::dvec3 apex = faces[0].outline[2], start = faces[0].outline[0];
	const glm::dvec2 side = glm::normalize(glm::dvec2(faces[0].outline[1] - start)), inwards(-side.y, side.x);
	const glm::dvec2 opposite = glm::normalize(glm::dvec2(faces[2].outline[1] - faces[2].outline[0]));
	const glm::dvec2 along = glm::normalize(side - opposite); // both planes meet in the middle between their eaves
	const double rise = (apex.z - start.z) / glm::dot(inwards, glm::dvec2(apex - start));
	const glm::dvec3 half_ridge = glm::dvec3(along, rise * glm::dot(inwards, along)) * 5e-4;
	const glm::dvec3 right = apex + half_ridge, left = apex - half_ridge;
	faces[0].outline = { faces[0].outline[0], faces[0].outline[1], right, left };
	faces[2].outline = { faces[2].outline[0], faces[2].outline[1], left, right };
	faces[1].outline[2] = right;
	faces[3].outline[2] = left;
}

// Roof planes over the skeleton of the outline grown by the overhang; heights are 0 above the original edges.
RoofFaces hip_planes(const RoofOutline &outline, RoofSlope slope, double overhang, bool &is_complete) {
	double rise = slope.is_height ? 0.0 : std::tan(glm::radians(slope.value));
	if (slope.is_height) {
		const double top = top_of(straight_skeleton(outline, {}, endless));
		rise = top > 0.0 ? slope.value / top : 0.0;
	}
	const double asked = overhang / std::sqrt(1.0 + rise * rise); // horizontal part of the overhang
	const OutlineWithEdges eaves = asked > 1e-9 ? grow_outline(outline, asked) : OutlineWithEdges{ outline, {} };
	const double reach = eaves.edges.empty() ? 0.0 : asked;
	const StraightSkeleton skeleton = straight_skeleton(eaves.loops, {}, endless);
	is_complete = skeleton.is_complete;
	RoofFaces faces;
	for (const SkeletonFace &swept : skeleton.faces) {
		RoofFace face{ RoofPart::Plane, eaves.edges.empty() ? swept.edge : eaves.edges[swept.edge], {}, {} };
		for (const SkeletonVertex &vertex : swept.outline) {
			face.outline.push_back({ vertex.position, (vertex.time - reach) * rise });
		}
		faces.push_back(std::move(face));
	}
	if (!std::ranges::is_sorted(faces, {}, &RoofFace::edge)) {
		std::ranges::stable_sort(faces, {}, &RoofFace::edge);
	}
	return faces;
}

RoofFaces gable_planes(const RoofOutline &outline, RoofSlope slope, double overhang_eaves, double overhang_gables, bool is_even, bool &is_complete) {
	RoofFaces faces = hip_planes(outline, slope, overhang_eaves, is_complete);
	open_point_ridge(faces);
	raise_gables(faces, outline, overhang_gables);
	if (is_even && !faces.empty()) {
		level_ridge(faces);
	}
	return faces;
}

// The angle that makes a gable roof as high as it was told: its ridge rises towards the wider end.
RoofSlope with_angle(const RoofOutline &outline, RoofSlope slope, bool is_even) {
	if (!slope.is_height) {
		return slope;
	}
	bool is_complete = true;
	double top = 0.0;
	for (const RoofFace &face : gable_planes(outline, { 45.0, false }, 0.0, 0.0, is_even, is_complete)) {
		for (const glm::dvec3 &point : face.outline) {
			top = std::max(top, point.z);
		}
	}
	return top > 0.0 ? RoofSlope{ glm::degrees(std::atan(slope.value / top)), false } : slope;
}

} // namespace

// The front that grows from the hole is the outline grown, and its holes shrunk.
OutlineWithEdges grow_outline(const RoofOutline &outline, double distance) {
	if (!can_grow(outline)) {
		return { outline, {} };
	}
	const Inverted inverted = invert(outline, distance);
	const StraightSkeleton skeleton = straight_skeleton(inverted.loops, inverted.speeds(1.0), distance);
	OutlineWithEdges grown;
	SmallVector<const SkeletonFront *, 2> fronts;
	for (const SkeletonFront &front : skeleton.fronts) {
		if (!inverted.is_frame(front.edges)) {
			fronts.push_back(&front);
		}
	}
	std::ranges::stable_sort(fronts, {}, [](const SkeletonFront *front) { return signed_area(front->points); }); // the outline first
	for (const SkeletonFront *front : fronts) {
		const size_t count = front->points.size();
		grown.loops.emplace_back(front->points.rbegin(), front->points.rend());
		for (size_t i = 0; i < count; ++i) {
			grown.edges.push_back(inverted.sources[front->edges[(2 * count - 2 - i) % count]]);
		}
	}
	return grown.loops.empty() ? OutlineWithEdges{ outline, {} } : grown;
}

Roof roof_hip(const RoofOutline &outline, RoofSlope slope, double overhang, bool is_even) {
	Roof roof;
	roof.faces = hip_planes(outline, slope, overhang, roof.is_complete);
	if (is_even && !roof.faces.empty()) {
		level_ridge(roof.faces);
	}
	roof.faces.push_back(roof_bottom(outline));
	return roof;
}

Roof roof_gable(const RoofOutline &outline, RoofSlope slope, double overhang_eaves, double overhang_gables, bool is_even, int edge) {
	if (edge >= 0 && outline.size() == 1 && !outline[0].empty()) {
		const size_t count = outline[0].size();
		const glm::dvec2 a = outline[0][size_t(edge) % count], b = outline[0][(size_t(edge) + 1) % count];
		return roof_along(outline, slope, b - a, overhang_eaves, overhang_gables);
	}
	Roof roof;
	roof.faces = gable_planes(outline, with_angle(outline, slope, is_even), overhang_eaves, overhang_gables, is_even, roof.is_complete);
	roof.faces.push_back(roof_bottom(outline));
	return roof;
}

Roof roof_ridge(const RoofOutline &outline, RoofSlope slope, glm::dvec2 direction) { return roof_along(outline, slope, direction); }

Roof roof_pyramid(const RoofOutline &outline, RoofSlope slope) {
	Roof roof;
	if (outline.empty() || outline[0].size() < 3) {
		roof.is_complete = false;
		return roof;
	}
	const Loop2 &loop = outline[0];
	glm::dvec2 middle(0.0);
	for (const glm::dvec2 &point : loop) {
		middle += point / double(loop.size());
	}
	const glm::dvec2 side = glm::normalize(loop[1] - loop[0]);
	const double inset = glm::dot(glm::dvec2(-side.y, side.x), middle - loop[0]);
	const double height = slope.is_height ? slope.value : inset * std::tan(glm::radians(slope.value));
	for (size_t i = 0; i < loop.size(); ++i) {
		const glm::dvec2 a = loop[i], b = loop[(i + 1) % loop.size()];
		roof.faces.push_back({ RoofPart::Plane, uint32_t(i), { { a, 0.0 }, { b, 0.0 }, { middle, height } }, {} });
	}
	roof.faces.push_back(roof_bottom({ loop }));
	return roof;
}

} // namespace pcg
