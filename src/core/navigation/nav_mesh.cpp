#include "core/navigation/nav_mesh.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "core/base/hash_index.h"
#include "core/base/shrink.h"
#include "core/navigation/corner_graph.h"
#include "core/navigation/nav_links.h"
#include "core/navigation/plan.h"

namespace pcg {

namespace {

constexpr float min_area = 1e-4f; // square metres
constexpr float max_coordinate = 1e6f; // metres; beyond it floats are coarser than a step

// Of the plan; positive for counter-clockwise seen from above.
double plan_area(const auto &corners) {
	double doubled = 0.0;
	for (size_t i = 1; i + 1 < corners.size(); ++i) {
		const glm::vec3 a = corners[i] - corners[0], b = corners[i + 1] - corners[0];
		doubled += double(b.x) * a.z - double(a.x) * b.z;
	}
	return doubled / 2.0;
}

bool is_usable(const NavRegion &region, const std::vector<uint32_t> &polygon) {
	return polygon.size() >= 3 && std::all_of(polygon.begin(), polygon.end(), [&](uint32_t index) {
		if (index >= region.vertices.size()) {
			return false;
		}
		const glm::vec3 v = region.vertices[index];
		return std::abs(v.x) < max_coordinate && std::abs(v.y) < max_coordinate && std::abs(v.z) < max_coordinate;
	});
}

// Height of the plane through the polygon at (x, z).
float height_at(const auto &corners, float x, float z) {
	for (size_t i = 1; i + 1 < corners.size(); ++i) {
		const glm::vec3 a = corners[i] - corners[0], b = corners[i + 1] - corners[0];
		const float determinant = a.x * b.z - a.z * b.x;
		if (std::abs(determinant) > min_area) {
			const float dx = x - corners[0].x, dz = z - corners[0].z;
			const float s = (dx * b.z - dz * b.x) / determinant, t = (dz * a.x - dx * a.z) / determinant;
			return corners[0].y + s * a.y + t * b.y;
		}
	}
	return corners[0].y;
}

uint32_t find_root(std::vector<uint32_t> &parents, uint32_t item) {
	while (parents[item] != item) {
		parents[item] = parents[parents[item]];
		item = parents[item];
	}
	return item;
}

} // namespace

NavMesh::NavMesh() : _corner_graph(std::make_shared<CornerGraph>()) {}

NavMesh NavMesh::build(std::span<const NavRegion> regions, const NavMeshOptions &options) {
	NavMesh mesh = join(regions, options);
	CornerPolygons polygons;
	const Corners corners = mesh.find_corners(options, polygons);
	mesh._corner_graph = std::make_shared<CornerGraph>(mesh, corners, polygons);
	return mesh;
}

NavMesh NavMesh::rebuild(const NavMesh &before, std::span<const PlanBox> changed, std::span<const NavRegion> regions, const NavMeshOptions &options) {
	NavMesh mesh = join(regions, options);
	CornerPolygons polygons;
	const Corners corners = mesh.find_corners(options, polygons);
	mesh._corner_graph = std::make_shared<CornerGraph>(mesh, corners, polygons, before, changed);
	return mesh;
}

NavMesh NavMesh::join(std::span<const NavRegion> regions, const NavMeshOptions &options) {
	NavMesh mesh;
	mesh._first_corner.push_back(0);
	HashIndex known; // points
	std::vector<uint32_t> corner_names;
	uint32_t first_name = 0;
	for (const NavRegion &region : regions) {
		const size_t corners_before = corner_names.size();
		for (size_t i = 0; i < region.polygons.size(); ++i) {
			mesh.add_polygon(region, i, known, corner_names);
		}
		for (size_t i = corners_before; i < corner_names.size(); ++i) {
			corner_names[i] += first_name;
		}
		first_name += uint32_t(region.vertices.size());
	}
	std::vector<NavEdge> edges;
	edges.reserve(mesh._corners.size());
	for (uint32_t polygon = 0; polygon < mesh.polygon_count(); ++polygon) {
		const uint32_t first = mesh._first_corner[polygon], end = mesh._first_corner[polygon + 1];
		for (uint32_t i = first; i < end; ++i) {
			const uint32_t next = i + 1 < end ? i + 1 : first;
			edges.push_back({ mesh.point(mesh._corners[i]), mesh.point(mesh._corners[next]), polygon, corner_names[i], corner_names[next] });
		}
	}
	mesh.set_links(find_links(edges, options), known);
	mesh.find_components();
	mesh.fill_grid();
	shrink(mesh._corners); // it stays for long
	shrink(mesh._first_corner);
	shrink(mesh._costs);
	return mesh;
}

uint32_t NavMesh::add_point(glm::vec3 point, HashIndex &known) {
	const uint64_t hash = hash_of(point);
	const uint32_t found = known.find(hash, [&](uint32_t index) { return _points[index] == point; });
	if (found != HashIndex::none) {
		return found;
	}
	_points.push_back(point);
	return known.add(hash);
}

void NavMesh::add_polygon(const NavRegion &region, size_t index, HashIndex &known, std::vector<uint32_t> &corner_names) {
	const std::vector<uint32_t> &polygon = region.polygons[index];
	if (!is_usable(region, polygon)) {
		return;
	}
	const double area = plan_area(polygon | std::views::transform([&](uint32_t vertex) { return region.vertices[vertex]; }));
	if (std::abs(area) < min_area) {
		return;
	}
	const auto first = ptrdiff_t(corner_names.size());
	corner_names.insert(corner_names.end(), polygon.begin(), polygon.end());
	if (area < 0.0) {
		std::reverse(corner_names.begin() + first, corner_names.end());
	}
	std::transform(corner_names.begin() + first, corner_names.end(), std::back_inserter(_corners),
			[&](uint32_t vertex) { return add_point(region.vertices[vertex], known); });
	_first_corner.push_back(uint32_t(_corners.size()));
	const float cost = index < region.costs.size() ? region.costs[index] : 1.0f;
	_costs.push_back(cost >= 1.0f && cost < 1e6f ? cost : 1.0f);
	_least_cost = _costs.size() == 1 ? _costs[0] : std::fmin(_least_cost, _costs.back());
}

void NavMesh::set_links(std::vector<NavGap> gaps, HashIndex &known) {
	std::stable_sort(gaps.begin(), gaps.end(), [](const NavGap &a, const NavGap &b) { return a.source < b.source; });
	_first_link.assign(polygon_count() + 1, 0);
	_links.reserve(gaps.size());
	for (const NavGap &gap : gaps) {
		++_first_link[gap.source + 1];
		_links.push_back({ gap.target, add_point(gap.left, known), add_point(gap.right, known) });
	}
	std::partial_sum(_first_link.begin(), _first_link.end(), _first_link.begin());
}

Corners NavMesh::find_corners(const NavMeshOptions &options, CornerPolygons &polygons) {
	std::vector<uint32_t> order;
	order.reserve(_points.size());
	const Corners corners(*this, options.margin, polygons, order);
	std::vector<uint32_t> new_of(_points.size());
	std::vector<glm::vec3> points;
	points.reserve(_points.size());
	for (const uint32_t point : order) {
		new_of[point] = uint32_t(points.size());
		points.push_back(_points[point]);
	}
	_points = std::move(points);
	for (uint32_t &corner : _corners) {
		corner = new_of[corner];
	}
	for (NavLink &link : _links) {
		link.left = new_of[link.left];
		link.right = new_of[link.right];
	}
	return corners;
}

uint32_t NavMesh::source(uint32_t link) const {
	return uint32_t(std::upper_bound(_first_link.begin(), _first_link.end(), link) - _first_link.begin()) - 1;
}

void NavMesh::find_components() {
	std::vector<uint32_t> parents(polygon_count());
	std::iota(parents.begin(), parents.end(), 0);
	for (uint32_t polygon = 0; polygon < polygon_count(); ++polygon) {
		for (uint32_t link = first_link(polygon); link < first_link(polygon + 1); ++link) {
			const uint32_t a = find_root(parents, polygon), b = find_root(parents, _links[link].target);
			parents[std::max(a, b)] = std::min(a, b);
		}
	}
	// The lowest polygon of a component is its root and comes first: number in that order.
	std::vector<uint32_t> components(polygon_count()), sizes;
	for (uint32_t polygon = 0; polygon < polygon_count(); ++polygon) {
		const uint32_t root = find_root(parents, polygon);
		if (root == polygon) {
			components[polygon] = uint32_t(_component_areas.size());
			_component_areas.push_back(0.0);
			sizes.push_back(0);
		} else {
			components[polygon] = components[root];
		}
		_component_areas[components[polygon]] += plan_area(corners(polygon));
		++sizes[components[polygon]];
	}
	_main_component = uint32_t(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
	for (uint32_t polygon = 0; polygon < polygon_count(); ++polygon) {
		if (components[polygon] != _main_component) {
			_islands.push_back({ polygon, components[polygon] });
		}
	}
	shrink(_islands);
}

uint32_t NavMesh::component(uint32_t polygon) const {
	const auto island = std::lower_bound(_islands.begin(), _islands.end(), polygon, [](Island here, uint32_t wanted) { return here.polygon < wanted; });
	return island != _islands.end() && island->polygon == polygon ? island->component : _main_component;
}

uint32_t NavMesh::column(float x) const {
	const float column = std::floor((x - _min.x) / _cell);
	return column >= 0.0f ? uint32_t(std::fmin(column, float(_columns - 1))) : 0;
}

uint32_t NavMesh::row(float z) const {
	const float row = std::floor((z - _min.z) / _cell);
	return row >= 0.0f ? uint32_t(std::fmin(row, float(_rows - 1))) : 0;
}

void NavMesh::fill_grid() {
	if (polygon_count() == 0) {
		return;
	}
	_min = _max = _points[0];
	for (const glm::vec3 &point : _points) {
		_min = { std::fmin(_min.x, point.x), std::fmin(_min.y, point.y), std::fmin(_min.z, point.z) };
		_max = { std::fmax(_max.x, point.x), std::fmax(_max.y, point.y), std::fmax(_max.z, point.z) };
	}
	// Four polygons a cell on average, at most 4096 cells a side.
	const float width = _max.x - _min.x, depth = _max.z - _min.z;
	_cell = std::fmax(std::sqrt(4.0f * width * depth / float(polygon_count())), std::fmax(width, depth) / 4096.0f);
	_columns = uint32_t(width / _cell) + 1;
	_rows = uint32_t(depth / _cell) + 1;
	const auto for_cells = [this](uint32_t polygon, auto action) {
		glm::vec3 low = corners(polygon)[0], high = low;
		for (const glm::vec3 corner : corners(polygon)) {
			low = { std::fmin(low.x, corner.x), 0.0f, std::fmin(low.z, corner.z) };
			high = { std::fmax(high.x, corner.x), 0.0f, std::fmax(high.z, corner.z) };
		}
		for (uint32_t r = row(low.z); r <= row(high.z); ++r) {
			for (uint32_t c = column(low.x); c <= column(high.x); ++c) {
				action(size_t(r) * _columns + c);
			}
		}
	};
	_first_in_cell.assign(size_t(_columns) * _rows + 1, 0);
	for (uint32_t polygon = 0; polygon < polygon_count(); ++polygon) {
		for_cells(polygon, [this](size_t cell) { ++_first_in_cell[cell + 1]; });
	}
	std::partial_sum(_first_in_cell.begin(), _first_in_cell.end(), _first_in_cell.begin());
	_in_cell.resize(_first_in_cell.back());
	std::vector<uint32_t> next(_first_in_cell.begin(), _first_in_cell.end() - 1);
	for (uint32_t polygon = 0; polygon < polygon_count(); ++polygon) {
		for_cells(polygon, [&](size_t cell) { _in_cell[next[cell]++] = polygon; });
	}
}

glm::vec3 NavMesh::nearest_in(uint32_t polygon, glm::vec3 point) const {
	const auto outline = corners(polygon);
	bool is_inside = true;
	glm::vec3 best{ 0.0f };
	float best_distance = INFINITY;
	for (size_t i = 0; i < outline.size(); ++i) {
		const glm::vec3 a = outline[i], b = outline[i + 1 < outline.size() ? i + 1 : 0];
		const float ex = b.x - a.x, ez = b.z - a.z, px = point.x - a.x, pz = point.z - a.z;
		if (ex * pz - ez * px <= 0.0f) { // left of the edge seen from above
			continue;
		}
		is_inside = false;
		const float t = std::fmin(1.0f, std::fmax(0.0f, (px * ex + pz * ez) / (ex * ex + ez * ez)));
		const glm::vec3 candidate = a + (b - a) * t;
		const float distance = std::hypot(candidate.x - point.x, candidate.z - point.z);
		if (distance < best_distance) {
			best_distance = distance;
			best = candidate;
		}
	}
	return is_inside ? glm::vec3(point.x, height_at(outline, point.x, point.z), point.z) : best;
}

NavPoint NavMesh::nearest(glm::vec3 point, float reach) const {
	NavPoint best;
	float best_squared = reach * reach;
	if (polygon_count() == 0 || !std::isfinite(point.x + point.y + point.z)) {
		return best;
	}
	// A growing square around the point: done when nothing outside of it can be nearer.
	for (float half = std::fmin(reach, _cell / 4.0f);; half = std::fmin(reach, 2.0f * half)) {
		for (uint32_t r = row(point.z - half); r <= row(point.z + half); ++r) {
			for (uint32_t c = column(point.x - half); c <= column(point.x + half); ++c) {
				const size_t cell = size_t(r) * _columns + c;
				for (uint32_t i = _first_in_cell[cell]; i < _first_in_cell[cell + 1]; ++i) {
					const glm::vec3 d = nearest_in(_in_cell[i], point) - point;
					const float squared = d.x * d.x + d.y * d.y + d.z * d.z;
					if (squared < best_squared || (squared == best_squared && _in_cell[i] < best.polygon)) {
						best_squared = squared;
						best = { _in_cell[i], point + d };
					}
				}
			}
		}
		if (half >= reach || best_squared <= half * half) {
			return best;
		}
	}
}

} // namespace pcg
