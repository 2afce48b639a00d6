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

// height(p) = rise * distance(p) with distance = normal . p - offset, never below 0 by construction.
struct RoofPlane {
	glm::dvec2 normal;
	double offset;
	double rise;

	double height(glm::dvec2 p) const { return rise * (glm::dot(normal, p) - offset); }
};

using Loop = std::vector<glm::dvec2>;

// Sutherland-Hodgman against one line: right for convex loops, and for others up to edges that run along the line.
Loop clip(const Loop &loop, glm::dvec2 normal, double offset) {
	Loop kept;
	for (size_t i = 0; i < loop.size(); ++i) {
		const glm::dvec2 a = loop[i], b = loop[(i + 1) % loop.size()];
		const double da = glm::dot(normal, a) - offset, db = glm::dot(normal, b) - offset;
		if (da >= -tiny) {
			kept.push_back(a);
		}
		if ((da > tiny && db < -tiny) || (da < -tiny && db > tiny)) {
			kept.push_back(a + (b - a) * (da / (da - db)));
		}
	}
	return kept;
}

// The outline starts at its lowest edge: an eave where there is one.
void start_at_eave(std::vector<glm::dvec3> &outline) {
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

void add_plane(Roof &roof, const Loop &part, const RoofPlane &plane) {
	if (part.size() < 3) {
		return;
	}
	RoofFace face{ RoofPart::Plane, 0, {}, {} };
	for (const glm::dvec2 &point : part) {
		face.outline.push_back({ point, std::max(0.0, plane.height(point)) });
	}
	start_at_eave(face.outline);
	roof.faces.push_back(std::move(face));
}

// The wall below the roof along one edge, with the ridge's point where the edge crosses it.
void add_wall(Roof &roof, uint32_t edge, const std::vector<glm::dvec3> &top) {
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

void add_bottom(Roof &roof, const Loop &loop) {
	RoofFace bottom{ RoofPart::Bottom, 0, {}, {} };
	for (const glm::dvec2 &point : loop) {
		bottom.outline.push_back({ point, 0.0 });
	}
	std::reverse(bottom.outline.begin() + 1, bottom.outline.end());
	roof.faces.push_back(std::move(bottom));
}

void extent(const Loop &loop, glm::dvec2 normal, double &low, double &high) {
	low = std::numeric_limits<double>::infinity();
	high = -low;
	for (const glm::dvec2 &point : loop) {
		low = std::min(low, glm::dot(normal, point));
		high = std::max(high, glm::dot(normal, point));
	}
}

bool is_usable(const RoofOutline &outline) { return !outline.empty() && outline[0].size() >= 3; }

} // namespace

Roof roof_along(const RoofOutline &outline, RoofSlope slope, glm::dvec2 direction) {
	Roof roof;
	if (!is_usable(outline) || glm::dot(direction, direction) < tiny) {
		roof.is_complete = false;
		return roof;
	}
	const Loop &loop = outline[0];
	const glm::dvec2 along = glm::normalize(direction), across(-along.y, along.x);
	double low, high;
	extent(loop, across, low, high);
	const double middle = (low + high) / 2.0, half = (high - low) / 2.0;
	const double rise = slope.is_height ? slope.value / half : std::tan(glm::radians(slope.value));
	const RoofPlane near{ across, low, rise }, far{ -across, -high, rise };
	add_plane(roof, clip(loop, -across, -middle), near);
	add_plane(roof, clip(loop, across, middle), far);
	for (uint32_t i = 0; i < loop.size(); ++i) {
		const glm::dvec2 a = loop[i], b = loop[(i + 1) % loop.size()];
		const double da = glm::dot(across, a) - middle, db = glm::dot(across, b) - middle;
		std::vector<glm::dvec3> top = { { a, rise * (half - std::abs(da)) } };
		if ((da > tiny && db < -tiny) || (da < -tiny && db > tiny)) {
			top.push_back({ a + (b - a) * (da / (da - db)), rise * half });
		}
		top.push_back({ b, rise * (half - std::abs(db)) });
		add_wall(roof, i, top);
	}
	add_bottom(roof, loop);
	return roof;
}

Roof roof_shed(const RoofOutline &outline, RoofSlope slope, uint32_t edge) {
	Roof roof;
	if (!is_usable(outline)) {
		roof.is_complete = false;
		return roof;
	}
	const Loop &loop = outline[0];
	const glm::dvec2 a = loop[edge % loop.size()], b = loop[(edge + 1) % loop.size()];
	const glm::dvec2 along = glm::normalize(b - a), across(-along.y, along.x);
	double low, high;
	extent(loop, across, low, high);
	const double rise = slope.is_height ? slope.value / (high - low) : std::tan(glm::radians(slope.value));
	// A concave outline may lie partly before the edge: the plane starts at its lowest point.
	const RoofPlane plane{ across, low, rise };
	add_plane(roof, loop, plane);
	for (uint32_t i = 0; i < loop.size(); ++i) {
		const glm::dvec2 p = loop[i], q = loop[(i + 1) % loop.size()];
		add_wall(roof, i, { { p, plane.height(p) }, { q, plane.height(q) } });
	}
	add_bottom(roof, loop);
	return roof;
}

} // namespace pcg
