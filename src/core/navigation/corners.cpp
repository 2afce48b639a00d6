#include "core/navigation/corners.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "core/base/parallel.h"
#include "core/base/shrink.h"
#include "core/navigation/nav_mesh.h"
#include "core/navigation/plan.h"

namespace pcg {

namespace {

constexpr float turn = 2.0f * std::numbers::pi_v<float>;
constexpr float seam = 0.02f; // radians; walls that are thinner are rounding
constexpr float flat = 0.01f; // radians; walls that bend less do not bend
constexpr float grazing = 0.01f; // radians; who walks along a wall so closely touches it
constexpr size_t batch = 1024; // places that a thread looks at at a time
constexpr float weld = 100.0f; // ends of gaps in the same square centimetre are one
constexpr float wall_length = 32767.0f; // of directions in whole numbers

// What a polygon takes of the directions around a point, in radians, counter-clockwise seen from above.
struct Arc {
	float from = 0.0f, to = 0.0f;
};

float angle_of(glm::vec3 direction) { return std::atan2(-direction.z, direction.x); }

// `is_off` is set where the point does not lie on the polygon's outline.
Arc arc_of(const auto &outline, glm::vec3 point, bool &is_off) {
	const size_t count = outline.size();
	size_t nearest = 0;
	float best = INFINITY;
	Arc arc;
	for (size_t i = 0; i < count; ++i) {
		const glm::vec3 here = outline[i], next = outline[(i + 1) % count];
		if (plan_distance(here, point) < touch) {
			arc = { angle_of(next - here), angle_of(outline[(i + count - 1) % count] - here) };
			return { arc.from, arc.to < arc.from ? arc.to + turn : arc.to };
		}
		const float distance = distance_to_segment(point, here, next);
		nearest = distance < best ? i : nearest;
		best = std::fmin(best, distance);
	}
	is_off |= best > 2.0f * touch;
	const float from = angle_of(outline[(nearest + 1) % count] - outline[nearest]);
	return { from, from + turn / 2.0f };
}

// The directions that no arc takes.
std::vector<Arc> blocked(std::vector<Arc> &arcs) {
	std::sort(arcs.begin(), arcs.end(), [](Arc a, Arc b) { return a.from < b.from; });
	float end = -INFINITY;
	for (const Arc &arc : arcs) {
		end = std::fmax(end, arc.to - turn);
	}
	std::vector<Arc> gaps;
	for (const Arc &arc : arcs) {
		if (arc.from > end + seam) {
			gaps.push_back({ end, arc.from });
		}
		end = std::fmax(end, arc.to);
	}
	return gaps;
}

// One end of a gap: the left one of link `end / 2`, or the right one if odd.
struct End {
	int64_t x, z, y; // in centimetres; floors in metres
	uint32_t end, polygon;

	auto place() const { return std::tie(x, z, y); }
};

uint32_t point_of(const NavMesh &mesh, uint32_t end) {
	const NavLink &link = mesh.links()[end / 2];
	return end % 2 == 0 ? link.left : link.right;
}

std::vector<End> sorted_ends(const NavMesh &mesh) {
	std::vector<End> ends;
	ends.reserve(2 * mesh.links().size());
	for (uint32_t polygon = 0; polygon < mesh.polygon_count(); ++polygon) {
		for (uint32_t end = 2 * mesh.first_link(polygon); end < 2 * mesh.first_link(polygon + 1); ++end) {
			const glm::vec3 p = mesh.point(point_of(mesh, end));
			ends.push_back({ std::llround(p.x * weld), std::llround(p.z * weld), std::llround(p.y), end, polygon });
		}
	}
	std::sort(ends.begin(), ends.end(), [](const End &a, const End &b) { return std::tie(a.x, a.z, a.y, a.end) < std::tie(b.x, b.z, b.y, b.end); });
	return ends;
}

// In the order of a curve that fills the plan (Morton 1966): of numbers that are given along it those of neighbours seldom lie far apart.
bool is_before_on_curve(const End &a, const End &b) {
	const uint64_t x = uint64_t(a.x ^ b.x), z = uint64_t(a.z ^ b.z);
	if (x == 0 && z == 0) {
		return a.y < b.y;
	}
	return x < z && x < (x ^ z) ? a.z < b.z : a.x < b.x; // by the axis along which the highest bit differs
}

// Ends at one place each.
std::vector<std::span<const End>> places_of(const std::vector<End> &ends) {
	std::vector<std::span<const End>> places;
	for (size_t first = 0, last = 0; first < ends.size(); first = last) {
		while (last < ends.size() && ends[last].place() == ends[first].place()) {
			++last;
		}
		places.push_back({ ends.data() + first, last - first });
	}
	std::sort(places.begin(), places.end(), [](std::span<const End> a, std::span<const End> b) { return is_before_on_curve(a[0], b[0]); });
	return places;
}

// Points of the mesh in their new order: first those that stand for the corners at the chosen places, by their first ends, then the others there, of which
// it is told whose they are, then the rest.
std::vector<uint32_t> number_points(const NavMesh &mesh, std::span<const std::span<const End>> places, std::span<const size_t> chosen,
		std::vector<uint32_t> &order) {
	std::vector<bool> is_numbered(mesh.point_count());
	const auto number = [&](uint32_t point) {
		const bool is_new = !is_numbered[point];
		if (is_new) {
			is_numbered[point] = true;
			order.push_back(point);
		}
		return is_new;
	};
	for (const size_t place : chosen) {
		number(point_of(mesh, places[place][0].end));
	}
	std::vector<uint32_t> beside;
	for (uint32_t corner = 0; corner < chosen.size(); ++corner) {
		for (const End &end : places[chosen[corner]]) {
			if (number(point_of(mesh, end.end))) {
				beside.push_back(corner);
			}
		}
	}
	for (uint32_t point = 0; point < mesh.point_count(); ++point) {
		number(point);
	}
	shrink(beside);
	return beside;
}

} // namespace

bool add_touching(const NavMesh &mesh, glm::vec3 point, float margin, std::vector<uint32_t> &polygons) {
	bool is_uncertain = false;
	for (size_t i = 0; i < polygons.size(); ++i) {
		for (uint32_t link = mesh.first_link(polygons[i]); link < mesh.first_link(polygons[i] + 1); ++link) {
			const NavLink &gap = mesh.links()[link];
			const float distance = distance_to_segment(point, mesh.point(gap.left), mesh.point(gap.right));
			if (distance < touch) {
				if (std::find(polygons.begin(), polygons.end(), gap.target) == polygons.end()) {
					polygons.push_back(gap.target);
				}
			} else {
				is_uncertain |= distance < margin;
			}
		}
	}
	return is_uncertain;
}

// Goes through some of the places where gaps end.
struct Corners::Finder {
	const NavMesh &mesh;
	float margin;
	std::vector<Walls> corners;
	std::vector<size_t> places; // of the corners
	CornerPolygons corner_polygons;
	std::vector<uint32_t> polygons;
	std::vector<Arc> arcs;

	void look_at(size_t place, std::span<const End> here) {
		polygons.clear();
		for (const End &end : here) {
			if (std::find(polygons.begin(), polygons.end(), end.polygon) == polygons.end()) {
				polygons.push_back(end.polygon);
			}
		}
		Walls walls;
		const glm::vec3 position = mesh.point(point_of(mesh, here[0].end));
		const bool is_uncertain = add_touching(mesh, position, margin, polygons);
		const bool is_mixed = std::ranges::any_of(polygons, [&](uint32_t polygon) { return mesh.cost(polygon) != mesh.cost(polygons[0]); });
		if (!is_uncertain && !is_mixed && !juts_out(position, walls)) {
			return;
		}
		corner_polygons.add(polygons);
		corners.push_back(walls);
		places.push_back(place);
	}

	// Finds the walls. False if none juts out: all around is free, or the wall runs straight on or recedes.
	bool juts_out(glm::vec3 position, Walls &found) {
		arcs.clear();
		bool is_off = false;
		for (const uint32_t polygon : polygons) {
			arcs.push_back(arc_of(mesh.corners(polygon), position, is_off));
		}
		const std::vector<Arc> walls = blocked(arcs);
		if (walls.size() != 1 || is_off) {
			return !walls.empty() || is_off;
		}
		if (walls[0].to - walls[0].from > turn / 2.0f - flat) {
			return false;
		}
		const auto whole = [](float part) { return int16_t(std::lround(part * wall_length)); };
		const Arc wall = walls[0];
		found = { whole(std::cos(wall.from)), whole(-std::sin(wall.from)), whole(std::cos(wall.to)), whole(-std::sin(wall.to)) };
		return true;
	}
};

Corners::Corners(const NavMesh &mesh, float margin, CornerPolygons &polygons, std::vector<uint32_t> &order) {
	const std::vector<End> ends = sorted_ends(mesh);
	const std::vector<std::span<const End>> places = places_of(ends);
	std::vector<Finder> finders((places.size() + batch - 1) / batch, { mesh, margin / 2.0f + touch, {}, {}, {}, {}, {} }); // gaps lie midway between sides
	parallel_for(finders.size(), {}, [&](size_t index) {
		for (size_t place = index * batch; place < std::min((index + 1) * batch, places.size()); ++place) {
			finders[index].look_at(place, places[place]);
		}
	});
	std::vector<size_t> chosen; // places
	for (const Finder &found : finders) {
		_walls.insert(_walls.end(), found.corners.begin(), found.corners.end());
		chosen.insert(chosen.end(), found.places.begin(), found.places.end());
		for (uint32_t i = 0; i < found.corners.size(); ++i) {
			polygons.add(found.corner_polygons.of(i));
		}
	}
	shrink(_walls);
	_count = uint32_t(_walls.size());
	_beside = number_points(mesh, places, chosen, order);
}

// The walls have to lie on one side of the way.
bool Corners::is_bend(uint32_t corner, glm::vec3 way) const {
	const Walls &walls = _walls[corner];
	const float slack = grazing * wall_length * std::sqrt(way.x * way.x + way.z * way.z);
	const float first = walls.first_x * way.z - walls.first_z * way.x, second = walls.second_x * way.z - walls.second_z * way.x;
	return (first >= -slack && second >= -slack) || (first <= slack && second <= slack);
}

} // namespace pcg
