#include "core/geometry/roof_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

// Roofs that are given by one or two planes over the outline instead of one for each edge.
namespace pcg {

namespace {

constexpr double tiny = 1e-9;

// One plane that rises along `normal` from the line normal . p = offset; with a ridge two that fall to both sides of it from `half` away.
// Equal points have equal heights to the last bit, so that planes and walls fit together.
struct Profile {
	glm::dvec2 normal;
	double offset;
	double rise;
	bool has_ridge = false;
	double half = 0.0;

	double distance(glm::dvec2 p) const {
		const double result = glm::dot(normal, p) - offset;
		return std::abs(result) < tiny ? 0.0 : result;
	}
	double height(glm::dvec2 p) const {
		const double result = rise * (has_ridge ? half - std::abs(distance(p)) : distance(p));
		return std::abs(result) < tiny ? 0.0 : result;
	}
};

// The edge of the outline that runs from one point to the other; `fallback` if none does.
uint32_t find_edge(const RoofOutline &outline, glm::dvec2 from, glm::dvec2 to, uint32_t fallback) {
	uint32_t index = 0;
	for (const Loop2 &loop : outline) {
		for (size_t i = 0; i < loop.size(); ++i, ++index) {
			if (glm::distance(loop[i], from) < tiny && glm::distance(loop[(i + 1) % loop.size()], to) < tiny) {
				return index;
			}
		}
	}
	return fallback;
}

// The outline starts at its lowest edge: an eave where there is one.
void start_at_eave(RoofLoop &outline) {
	size_t best = 0;
	double lowest = std::numeric_limits<double>::infinity();
	for (size_t i = 0; i < outline.size(); ++i) {
		const double height = outline[i].z + outline[(i + 1) % outline.size()].z;
		if (height < lowest - tiny) {
			lowest = height;
			best = i;
		}
	}
	std::rotate(outline.begin(), outline.begin() + long(best), outline.end());
}

void add_plane(Roof &roof, const RoofOutline &part, const Profile &profile, const RoofOutline &eaves) {
	if (part.empty() || part[0].size() < 3) {
		return;
	}
	RoofFace face;
	for (size_t l = 0; l < part.size(); ++l) {
		RoofLoop loop;
		for (const glm::dvec2 &point : part[l]) {
			loop.push_back({ point, profile.height(point) });
		}
		if (l == 0) {
			start_at_eave(loop);
			face.edge = find_edge(eaves, loop[0], loop[1], 0);
			face.outline = std::move(loop);
		} else {
			face.holes.push_back(std::move(loop));
		}
	}
	roof.faces.push_back(std::move(face));
}

// Corners of the outline that lie on the ridge become corners of what runs past them, so that both planes and the walls share them.
void add_corners_on_ridge(Loop2 &part, const Loop2 &outline, const Profile &profile) {
	for (const glm::dvec2 &corner : outline) {
		if (profile.distance(corner) != 0.0) {
			continue;
		}
		for (size_t i = 0; i < part.size(); ++i) {
			const glm::dvec2 a = part[i], b = part[(i + 1) % part.size()], side = b - a;
			const double share = glm::dot(corner - a, side) / std::max(glm::dot(side, side), tiny);
			if (glm::distance(a + side * share, corner) < tiny && share > tiny && share < 1.0 - tiny) {
				part.insert(part.begin() + long(i) + 1, &corner, &corner + 1);
				break;
			}
		}
	}
}

// What of the outline lies on one side of the ridge.
std::vector<RoofOutline> side_of_ridge(const RoofOutline &outline, const Profile &profile, double sign) {
	std::vector<RoofOutline> parts = cut_outline(outline, sign * profile.normal, sign * profile.offset);
	for (RoofOutline &part : parts) {
		for (Loop2 &loop : part) {
			for (const Loop2 &corners : outline) {
				add_corners_on_ridge(loop, corners, profile);
			}
		}
	}
	return parts;
}

// The wall between the base and the roof along one edge, with the ridge's point where the edge crosses it.
void add_wall(Roof &roof, uint32_t edge, const RoofLoop &top) {
	RoofFace wall{ RoofPart::Gable, edge, { { top.front().x, top.front().y, 0.0 }, { top.back().x, top.back().y, 0.0 } }, {} };
	for (size_t i = top.size(); i-- > 0;) {
		if (top[i].z > tiny) {
			wall.outline.push_back(top[i]);
		}
	}
	if (wall.outline.size() > 2) {
		roof.faces.push_back(std::move(wall));
	}
}

void add_walls(Roof &roof, const RoofOutline &outline, const Profile &profile) {
	uint32_t index = 0;
	for (const Loop2 &loop : outline) {
		for (size_t i = 0; i < loop.size(); ++i, ++index) {
			const glm::dvec2 a = loop[i], b = loop[(i + 1) % loop.size()];
			RoofLoop top = { { a, profile.height(a) } };
			const double da = glm::dot(profile.normal, a) - profile.offset, db = glm::dot(profile.normal, b) - profile.offset;
			if (profile.has_ridge && ((da > tiny && db < -tiny) || (da < -tiny && db > tiny))) {
				const glm::dvec2 ridge = a + (b - a) * (da / (da - db));
				top.push_back({ ridge, profile.height(ridge) });
			}
			top.push_back({ b, profile.height(b) });
			add_wall(roof, index, top);
		}
	}
}

void sort_by_edge(Roof &roof) {
	std::stable_sort(roof.faces.begin(), roof.faces.end(), [](const RoofFace &a, const RoofFace &b) { return a.edge < b.edge; });
}

void extent(const Loop2 &loop, glm::dvec2 normal, double &low, double &high) {
	low = std::numeric_limits<double>::infinity();
	high = -low;
	for (const glm::dvec2 &point : loop) {
		low = std::min(low, glm::dot(normal, point));
		high = std::max(high, glm::dot(normal, point));
	}
}

bool is_usable(const RoofOutline &outline) { return !outline.empty() && outline[0].size() >= 3; }

// A convex outline with the edges along the ridge moved outwards by `eaves`, the others by `gables`.
RoofOutline overhanging(const RoofOutline &outline, glm::dvec2 along, double eaves, double gables) {
	const Loop2 &loop = outline[0];
	const size_t count = loop.size();
	const auto outwards = [&](size_t i) {
		const glm::dvec2 side = glm::normalize(loop[(i + 1) % count] - loop[i % count]);
		const bool is_eave = std::abs(glm::dot(side, along)) > 0.7071;
		return glm::dvec2(side.y, -side.x) * (is_eave ? eaves : gables);
	};
	Loop2 result;
	for (size_t i = 0; i < count; ++i) {
		const glm::dvec2 before = outwards(i + count - 1), after = outwards(i);
		const glm::dvec2 side = loop[i] - loop[(i + count - 1) % count], next = loop[(i + 1) % count] - loop[i];
		const double bend = side.x * next.y - side.y * next.x;
		// Where the two lines that were moved meet.
		const glm::dvec2 gap = after - before;
		const double share = std::abs(bend) > 1e-9 * glm::length(side) * glm::length(next) ? (gap.x * next.y - gap.y * next.x) / bend : 0.0;
		result.push_back(loop[i] + before + side * share);
	}
	return { result };
}

// The same upside down, for negative slopes: z turns round, and with it the way that faces run.
void turn_over(Roof &roof) {
	const auto turn = [](RoofLoop &loop) {
		for (glm::dvec3 &point : loop) {
			point.z = -point.z;
		}
		std::reverse(loop.begin(), loop.end());
		std::rotate(loop.begin(), loop.end() - 2, loop.end()); // the first edge stays the first
	};
	for (RoofFace &face : roof.faces) {
		turn(face.outline);
		std::for_each(face.holes.begin(), face.holes.end(), turn);
	}
}

} // namespace

RoofFace roof_bottom(const RoofOutline &outline) {
	RoofFace bottom{ RoofPart::Bottom, 0, {}, {} };
	for (size_t l = 0; l < outline.size(); ++l) {
		RoofLoop loop;
		for (const glm::dvec2 &point : outline[l]) {
			loop.push_back({ point, 0.0 });
		}
		std::ranges::reverse(loop);
		std::rotate(loop.begin(), loop.end() - 2, loop.end()); // the first edge stays the first
		if (l == 0) {
			bottom.outline = std::move(loop);
		} else {
			bottom.holes.push_back(std::move(loop));
		}
	}
	return bottom;
}

Roof roof_along(const RoofOutline &outline, RoofSlope slope, glm::dvec2 direction, double overhang_eaves, double overhang_gables) {
	Roof roof;
	if (!is_usable(outline) || glm::dot(direction, direction) < tiny) {
		roof.is_complete = false;
		return roof;
	}
	const glm::dvec2 along = glm::normalize(direction), across(-along.y, along.x);
	double low, high;
	extent(outline[0], across, low, high);
	const double middle = (low + high) / 2.0, half = (high - low) / 2.0;
	const double rise = slope.is_height ? slope.value / half : std::tan(glm::radians(slope.value));
	const Profile profile{ across, middle, rise, true, half };
	const bool has_overhang = overhang_eaves > tiny || overhang_gables > tiny;
	const RoofOutline eaves = has_overhang ? overhanging(outline, along, overhang_eaves / std::sqrt(1.0 + rise * rise), overhang_gables) : outline;
	for (const double sign : { -1.0, 1.0 }) {
		for (const RoofOutline &part : side_of_ridge(eaves, profile, sign)) {
			add_plane(roof, part, profile, eaves);
		}
	}
	add_walls(roof, outline, profile);
	sort_by_edge(roof);
	roof.faces.push_back(roof_bottom(outline));
	return roof;
}

Roof roof_shed(const RoofOutline &outline, RoofSlope slope, int edge) {
	Roof roof;
	if (!is_usable(outline)) {
		roof.is_complete = false;
		return roof;
	}
	const Loop2 &loop = outline[0];
	const int count = int(loop.size());
	const size_t first = size_t((edge % count + count) % count);
	const glm::dvec2 a = loop[first], b = loop[(first + 1) % loop.size()];
	const glm::dvec2 along = glm::normalize(b - a), across(-along.y, along.x);
	double low, high;
	extent(loop, across, low, high);
	const double value = std::abs(slope.value);
	const double rise = slope.is_height ? value / (high - low) : std::tan(glm::radians(value));
	// A concave outline may lie partly before the edge: the plane starts at its lowest point.
	const Profile profile{ across, low, rise };
	add_walls(roof, outline, profile);
	add_plane(roof, outline, profile, outline);
	roof.faces.push_back(roof_bottom(outline));
	if (slope.value < 0.0) {
		turn_over(roof);
	}
	return roof;
}

} // namespace pcg
