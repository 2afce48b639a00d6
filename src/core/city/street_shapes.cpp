#include "core/city/street_shapes.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/random.h"
#include "core/city/cell_grid.h"

namespace pcg {

namespace {

using Polygon = std::vector<glm::vec3>;

constexpr float same_place = 0.02f; // metres
constexpr float cell_size = 16.0f; // metres
constexpr float least_edge = 0.05f; // metres; a kerb or a crossing
constexpr float least_part = 0.5f; // metres of pavement between a crossing and the next or the corner; less goes with the crossing

int32_t cell_of(float metres) { return int32_t(std::floor(metres / cell_size)); }

// Metres from a point to the line through `a` and `b`, and along it.
struct Place {
	float along, beside;
};
Place place_on(glm::vec3 a, glm::vec3 b, glm::vec3 point) {
	const glm::vec3 way = glm::normalize(b - a), to = point - a;
	return { glm::dot(to, way), std::abs(to.x * way.z - to.z * way.x) };
}

bool is_on(glm::vec3 a, glm::vec3 b, glm::vec3 point) {
	const Place place = place_on(a, b, point);
	return place.beside < same_place && place.along > -same_place && place.along < glm::distance(a, b) + same_place;
}

// The longest edge that lies on the block's border, where the carriageway begins; the number of edges if there is none.
size_t kerb_of(const Polygon &polygon, const Polygon &outline) {
	size_t kerb = polygon.size();
	float longest = least_edge;
	for (size_t i = 0; i < polygon.size(); ++i) {
		const glm::vec3 from = polygon[i], to = polygon[(i + 1) % polygon.size()];
		const float length = glm::distance(from, to);
		for (size_t j = 0; j < outline.size() && length > longest; ++j) {
			const glm::vec3 a = outline[j], b = outline[(j + 1) % outline.size()];
			if (is_on(a, b, from) && is_on(a, b, to)) {
				kerb = i;
				longest = length;
			}
		}
	}
	return kerb;
}

// In a system of its first edge: x along it, y across to the left, both from 0 to 1.
std::vector<glm::dvec2> uvs_of(const std::vector<glm::dvec3> &outline) {
	const glm::dvec3 u = glm::normalize(outline[1] - outline[0]), v{ u.z, 0.0, -u.x };
	glm::dvec2 low(INFINITY), high(-INFINITY);
	std::vector<glm::dvec2> places;
	for (const glm::dvec3 &corner : outline) {
		places.push_back({ glm::dot(corner - outline[0], u), glm::dot(corner - outline[0], v) });
		low = { std::min(low.x, places.back().x), std::min(low.y, places.back().y) };
		high = { std::max(high.x, places.back().x), std::max(high.y, places.back().y) };
	}
	for (glm::dvec2 &place : places) {
		place = (place - low) / (high - low);
	}
	return places;
}

cga::InitialShape shape_of(const Polygon &polygon, const char *start_rule, std::vector<AttributeOverride> attributes) {
	cga::InitialShape shape = cga::InitialShape::of({ polygon.begin(), polygon.end() });
	shape.faces[0].uvs = uvs_of(shape.faces[0].outline);
	shape.start_rule = start_rule;
	shape.attributes = std::move(attributes);
	return shape;
}

// The part of a convex polygon between two places along its first edge, which stays the first edge. Empty where there is none.
Polygon part_of(const Polygon &polygon, float from, float to) {
	const glm::vec3 u = glm::normalize(polygon[1] - polygon[0]), v{ u.z, 0.0f, -u.x };
	std::vector<glm::vec2> plan, cut_once, part;
	for (const glm::vec3 &corner : polygon) {
		plan.push_back({ glm::dot(corner - polygon[0], u), glm::dot(corner - polygon[0], v) });
	}
	cut(plan, 0, from, true, cut_once);
	cut(cut_once, 0, to, false, part);
	Polygon result;
	for (const glm::vec2 &corner : part) {
		result.push_back(polygon[0] + u * corner.x + v * corner.y);
	}
	if (result.size() < 3) {
		return {};
	}
	const size_t kerb = kerb_of(result, { polygon[0], polygon[1] });
	std::rotate(result.begin(), result.begin() + ptrdiff_t(kerb % result.size()), result.end());
	return result;
}

} // namespace

const char *start_rule_of(const Ground &ground) {
	switch (ground.kind) {
		case GroundKind::Street: return "Street";
		case GroundKind::Crossing: return "Crossing";
		case GroundKind::Junction: return "Junction";
		case GroundKind::Pavement: return ground.street == no_street ? "Square" : "Sidewalk";
	}
	return "";
}

StreetShapes::StreetShapes(const Layout &layout) : _layout(layout), _valencies(layout.junctions.size()) {
	for (const Street &street : layout.streets) {
		++_valencies[street.from];
		++_valencies[street.to];
	}
	for (const Ground &ground : layout.ground) {
		if (ground.kind == GroundKind::Crossing && ground.polygon.size() == 4) {
			add_crossing(ground);
		}
	}
}

void StreetShapes::add_crossing(const Ground &ground) {
	const Polygon &corners = ground.polygon;
	for (const size_t i : { size_t(0), size_t(2) }) {
		const glm::vec3 middle = (corners[i] + corners[i + 1]) / 2.0f;
		_sides.emplace(Cell(cell_of(middle.x), cell_of(middle.z)), Side{ corners[i], corners[i + 1] });
		_ends[ground.street].push_back((corners[i + 1] + corners[(i + 2) % 4]) / 2.0f);
	}
}

cga::InitialShape StreetShapes::carriageway(const Ground &ground) const {
	const Polygon &corners = ground.polygon;
	const auto ends = _ends.find(ground.street);
	const auto connection = [&](glm::vec3 middle) {
		const bool is_crossing = ends != _ends.end() && std::ranges::any_of(ends->second, [&](glm::vec3 end) { return glm::distance(end, middle) < same_place; });
		return std::string(is_crossing ? "CROSSING" : "JUNCTION");
	};
	const bool is_crossing = ground.kind == GroundKind::Crossing;
	std::vector<AttributeOverride> attributes{ { "streetWidth", double(_layout.streets[ground.street].width) },
		{ "length", double(glm::distance(corners[0], corners[1])) } };
	if (!is_crossing && corners.size() == 4) {
		attributes.push_back({ "connectionStart", connection((corners[0] + corners[3]) / 2.0f) });
		attributes.push_back({ "connectionEnd", connection((corners[1] + corners[2]) / 2.0f) });
	}
	return shape_of(corners, start_rule_of(ground), std::move(attributes));
}

cga::InitialShape StreetShapes::junction(const Ground &ground) const {
	glm::vec3 middle(0.0f);
	for (const glm::vec3 &corner : ground.polygon) {
		middle += corner / float(ground.polygon.size());
	}
	const auto nearest = std::ranges::min_element(_layout.junctions, {}, [&](glm::vec3 junction) { return glm::distance(junction, middle); });
	const double valency = nearest == _layout.junctions.end() ? 0.0 : double(_valencies[size_t(nearest - _layout.junctions.begin())]);
	return shape_of(ground.polygon, start_rule_of(ground), { { "valency", valency } });
}

std::vector<std::pair<float, float>> StreetShapes::crossings_at(glm::vec3 from, glm::vec3 to) const {
	const float length = glm::distance(from, to);
	std::vector<std::pair<float, float>> found;
	for (int32_t x = cell_of(std::min(from.x, to.x)) - 1; x <= cell_of(std::max(from.x, to.x)) + 1; ++x) {
		for (int32_t z = cell_of(std::min(from.z, to.z)) - 1; z <= cell_of(std::max(from.z, to.z)) + 1; ++z) {
			const auto [begin, end] = _sides.equal_range({ x, z });
			for (auto side = begin; side != end; ++side) {
				const Place a = place_on(from, to, side->second.from), b = place_on(from, to, side->second.to);
				const float low = std::clamp(std::min(a.along, b.along), 0.0f, length), high = std::clamp(std::max(a.along, b.along), 0.0f, length);
				if (a.beside < same_place && b.beside < same_place && high - low > least_edge) {
					found.emplace_back(low, high);
				}
			}
		}
	}
	std::ranges::sort(found);
	return found;
}

std::vector<cga::InitialShape> StreetShapes::pavement(const Ground &ground) const {
	const size_t kerb = ground.street == no_street ? ground.polygon.size() : kerb_of(ground.polygon, _layout.block(ground.block).outline);
	if (kerb == ground.polygon.size()) {
		return { shape_of(ground.polygon, "Square", {}) };
	}
	Polygon strip = ground.polygon;
	std::rotate(strip.begin(), strip.begin() + ptrdiff_t(kerb), strip.end());
	const float length = glm::distance(strip[0], strip[1]);
	float width = 0.0f;
	for (const glm::vec3 &corner : strip) {
		width = std::max(width, place_on(strip[0], strip[1], corner).beside);
	}
	std::vector<cga::InitialShape> shapes;
	const auto add = [&](float from, float to, bool is_at_crossing) {
		// The ends go on as far as the strip does beside its kerb.
		const float low = from <= 0.0f ? -INFINITY : from, high = to >= length ? INFINITY : to;
		if (const Polygon part = to > from ? part_of(strip, low, high) : Polygon(); !part.empty()) {
			shapes.push_back(shape_of(part, "Sidewalk",
					{ { "streetWidth", double(_layout.streets[ground.street].width) }, { "sidewalkWidth", double(width) },
							{ "length", double(to - from) }, { "atCrossing", is_at_crossing } }));
		}
	};
	float done = 0.0f;
	for (const auto &[from, to] : crossings_at(strip[0], strip[1])) {
		const float begin = from - done <= least_part ? done : from, end = length - to <= least_part ? length : to;
		add(done, begin, false);
		add(begin, end, true);
		done = std::max(done, end);
	}
	add(done, length, false);
	return shapes;
}

std::vector<cga::InitialShape> StreetShapes::of(uint32_t index) const {
	const Ground &ground = _layout.ground[index];
	std::vector<cga::InitialShape> shapes;
	switch (ground.kind) {
		case GroundKind::Street:
		case GroundKind::Crossing: shapes = { carriageway(ground) }; break;
		case GroundKind::Junction: shapes = { junction(ground) }; break;
		case GroundKind::Pavement: shapes = pavement(ground); break;
	}
	const uint64_t seed = derive_seed(derive_seed(_layout.seed, hash_text("streets")), index);
	for (size_t i = 0; i < shapes.size(); ++i) {
		shapes[i].seed = derive_seed(seed, i);
		shapes[i].name = name_of(index);
	}
	return shapes;
}

std::string StreetShapes::name_of(uint32_t index) const {
	const Ground &ground = _layout.ground[index];
	switch (ground.kind) {
		case GroundKind::Street: return "street " + std::to_string(ground.street);
		case GroundKind::Crossing: return "crossing of street " + std::to_string(ground.street);
		case GroundKind::Junction: return "junction";
		case GroundKind::Pavement: return "pavement of block " + std::to_string(index_of(ground.block));
	}
	return {};
}

} // namespace pcg
