#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <variant>

#include <glm/geometric.hpp>

#include "core/city/street_shapes.h"

using namespace pcg;

namespace {

Layout layout_of(LayoutKind kind, uint64_t seed) {
	LayoutParameters parameters = layout_for_lots(60);
	parameters.kind = kind;
	parameters.rings = 2;
	parameters.seed = seed;
	parameters.jitter = kind == LayoutKind::Grid ? 0.1f : 0.0f;
	parameters.removed = kind == LayoutKind::Grid ? 0.2f : 0.0f;
	Diagnostics diagnostics;
	return *make_layout(parameters, diagnostics);
}

template <typename Point> double area_of(const std::vector<Point> &polygon) {
	double area = 0.0;
	for (size_t i = 0; i < polygon.size(); ++i) {
		const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
		area += (double(a.x) * b.z - double(b.x) * a.z) / -2.0;
	}
	return area;
}

const AttributeOverride *find(const cga::InitialShape &shape, std::string_view name) {
	const auto found = std::ranges::find_if(shape.attributes, [&](const AttributeOverride &attribute) { return attribute.name == name; });
	return found == shape.attributes.end() ? nullptr : &*found;
}

double number(const cga::InitialShape &shape, std::string_view name) { return std::get<double>(find(shape, name)->value); }

// Metres from the point to the segment, in plan.
double distance_to(glm::dvec3 a, glm::dvec3 b, glm::dvec3 point) {
	const glm::dvec3 way = b - a;
	const double t = std::clamp(glm::dot(point - a, way) / glm::dot(way, way), 0.0, 1.0);
	return glm::distance(point, a + way * t);
}

bool is_on_outline(const std::vector<glm::vec3> &outline, glm::dvec3 point) {
	for (size_t i = 0; i < outline.size(); ++i) {
		if (distance_to(outline[i], outline[(i + 1) % outline.size()], point) < 0.03) {
			return true;
		}
	}
	return false;
}

// Whether a crossing's side along the street meets the kerb there.
bool is_beside_crossing(const Layout &layout, glm::dvec3 point) {
	for (const Ground &ground : layout.ground) {
		if (ground.kind == GroundKind::Crossing && (distance_to(ground.polygon[0], ground.polygon[1], point) < 0.03 ||
														  distance_to(ground.polygon[2], ground.polygon[3], point) < 0.03)) {
			return true;
		}
	}
	return false;
}

} // namespace

TEST_CASE("street shapes cover the public ground, and sidewalks begin at the kerb, whatever the layout") {
	for (LayoutKind kind : { LayoutKind::Grid, LayoutKind::Radial, LayoutKind::Grown }) {
		for (uint64_t seed = 1; seed <= 12; ++seed) {
			const Layout layout = layout_of(kind, seed);
			const StreetShapes shapes(layout);
			for (uint32_t i = 0; i < layout.ground.size(); ++i) {
				const Ground &ground = layout.ground[i];
				double area = 0.0;
				for (const cga::InitialShape &shape : shapes.of(i)) {
					const std::vector<glm::dvec3> &outline = shape.faces[0].outline;
					const double part = area_of(outline);
					CHECK(part > 0.0); // counter-clockwise
					area += part;
					REQUIRE(shape.faces[0].uvs.size() == outline.size());
					if (shape.start_rule == "Sidewalk") {
						const glm::dvec3 middle = (outline[0] + outline[1]) / 2.0;
						CHECK(is_on_outline(layout.block(ground.block).outline, middle));
						CHECK(is_beside_crossing(layout, middle) == std::get<bool>(find(shape, "atCrossing")->value));
					}
				}
				CHECK(area == doctest::Approx(area_of(ground.polygon)).epsilon(2e-3));
			}
		}
	}
}

TEST_CASE("street shapes bring the attributes and coordinates of streets") {
	LayoutParameters parameters;
	parameters.blocks_x = 2;
	parameters.blocks_z = 1;
	Diagnostics diagnostics;
	const Layout layout = *make_layout(parameters, diagnostics);
	const StreetShapes shapes(layout);
	std::multiset<double> valencies;
	std::multiset<std::string> connections;
	for (uint32_t i = 0; i < layout.ground.size(); ++i) {
		const cga::InitialShape shape = shapes.of(i)[0];
		CHECK_FALSE(shape.name.empty());
		if (shape.start_rule == "Junction") {
			valencies.insert(number(shape, "valency"));
		} else if (shape.start_rule == "Street") {
			CHECK(number(shape, "streetWidth") == doctest::Approx(8.0));
			connections.insert(std::get<std::string>(find(shape, "connectionStart")->value));
			connections.insert(std::get<std::string>(find(shape, "connectionEnd")->value));
			const std::vector<glm::dvec2> &uvs = shape.faces[0].uvs;
			CHECK(glm::distance(uvs[0], glm::dvec2(0.0)) < 1e-9);
			CHECK(glm::distance(uvs[2], glm::dvec2(1.0)) < 1e-9);
		} else if (shape.start_rule == "Sidewalk") {
			CHECK(number(shape, "sidewalkWidth") == doctest::Approx(3.0));
		}
	}
	// Two blocks side by side: four corners, and two junctions where the street between them meets the others.
	CHECK(valencies == std::multiset<double>{ 2, 2, 2, 2, 3, 3 });
	// Six streets meet those two junctions: one at both ends, four at one.
	CHECK(connections.count("CROSSING") == 6);
	CHECK(connections.count("JUNCTION") == 8);
}

TEST_CASE("ground along no street is a square") {
	Layout layout;
	layout.blocks.resize(1);
	layout.ground.push_back({ GroundKind::Pavement, { { 0, 0, 0 }, { 9, 0, 0 }, { 9, 0, -9 } }, BlockId(0), no_street });
	const std::vector<cga::InitialShape> shapes = StreetShapes(layout).of(0);
	REQUIRE(shapes.size() == 1);
	CHECK(shapes[0].start_rule == "Square");
	CHECK(shapes[0].attributes.empty());
}
