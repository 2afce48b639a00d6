#include <doctest/doctest.h>

#include <algorithm>

#include "core/city/city_generator.h"
#include "core/city/walkable.h"
#include "tests/core/city/compiled.h"

using namespace pcg;

namespace {

constexpr std::string_view street_rules = R"(
attr streetWidth = 0
attr atCrossing = true
Street --> report("width", streetWidth) t(0, -0.1, 0) color("#202020") Asphalt.
Crossing --> color("#e0e0e0") Zebra.
Junction --> t(0, -0.1, 0) color("#202020") Asphalt.
Sidewalk --> case atCrossing : Paving. else : [ split(x) { ~1 : NIL | 1 : Bench | ~1 : NIL } ] split(z) { ~1 : Paving. | 0.2 : Kerb }
Kerb --> t(0, -0.1, 0) extrude(0.1) Kerb.
@Object("bench")
Bench --> extrude(0.5) zone("seat")
)";

// Lots are empty parks.
City make(std::string_view rules, Diagnostics &diagnostics, unsigned threads = 1) {
	LayoutParameters parameters = layout_for_lots(40);
	parameters.land_use = { { "park", 1.0 } };
	CityOptions options;
	options.work.threads = threads;
	options.streets.program = rules.empty() ? nullptr : compile(rules);
	const RulesByType lots{ { "park", { compile("@StartRule\nLot --> zone(\"park\") NIL\n"), {}, {} } } };
	std::optional<City> city = generate_city(*make_layout(parameters, diagnostics), lots, options, diagnostics);
	REQUIRE(city.has_value());
	return std::move(*city);
}

std::vector<const GroundBuild *> parts_of(const City &city) {
	std::vector<const GroundBuild *> parts;
	for (const auto *builds : { &city.ground.streets, &city.ground.blocks }) {
		for (const GroundBuild &build : *builds) {
			parts.push_back(&build);
		}
	}
	return parts;
}

double area_of(const City &city) {
	double sum = 0.0;
	for (const GroundBuild *part : parts_of(city)) {
		sum += area(part->model.mesh);
	}
	return sum;
}

} // namespace

TEST_CASE("streets are built by rules, merged by tile and block, and what they mean is in the model") {
	Diagnostics diagnostics;
	const City city = make(street_rules, diagnostics);
	CHECK_MESSAGE(diagnostics.is_empty(), to_text(diagnostics));
	CHECK(city.ground.streets.size() == city.layout.tiles.size());
	CHECK(city.ground.blocks.size() == city.layout.blocks.size());
	const TypeId bench = city.model.types.find("bench");
	size_t benches = 0;
	for (const GroundBuild *part : parts_of(city)) {
		CHECK(part->model.materials.size() <= 3);
		CHECK(part->objects.size() == part->model.objects.size());
		for (const ObjectId id : part->objects) {
			CHECK(city.model.object(id).type == bench);
			CHECK_FALSE(is_valid(city.model.object(id).lot));
		}
		benches += part->objects.size();
	}
	// One on each side of each block: beside crossings there is none.
	CHECK(benches == 4 * city.layout.blocks.size());
	CHECK(city.model.objects_of_type(bench).size() == benches);
	CHECK(city.model.zones_of_type(city.model.types.find("seat")).size() == benches);
}

TEST_CASE("street rules change nothing about where people can walk") {
	Diagnostics diagnostics;
	const NavRegion plain = city_nav_region(make({}, diagnostics)), made = city_nav_region(make(street_rules, diagnostics));
	CHECK(plain.vertices == made.vertices);
	CHECK(plain.polygons == made.polygons);
	CHECK(plain.costs == made.costs);
}

TEST_CASE("streets are the same for any number of threads") {
	Diagnostics diagnostics;
	const City one = make(street_rules, diagnostics, 1), other = make(street_rules, diagnostics, 4);
	for (size_t i = 0; i < parts_of(one).size(); ++i) {
		CHECK(parts_of(one)[i]->model.mesh.positions == parts_of(other)[i]->model.mesh.positions);
		CHECK(parts_of(one)[i]->model.materials == parts_of(other)[i]->model.materials);
		CHECK(parts_of(one)[i]->objects == parts_of(other)[i]->objects);
	}
}

TEST_CASE("what street rules do not build is plain, and said") {
	Diagnostics none, fewer, failing;
	const double plain = area_of(make({}, none));
	CHECK(none.is_empty());
	CHECK(area_of(make("Street --> Asphalt.\nSidewalk --> Paving.\nCrossing --> White.\n", fewer)) == doctest::Approx(plain).epsilon(0.03)); // no bars
	REQUIRE(fewer.list().size() == 1);
	CHECK(fewer.list()[0].message.find("no rule `Junction`") != std::string::npos);
	CHECK_FALSE(fewer.has_errors());
	const City city = make("Street --> Street\nSidewalk --> Paving.\nCrossing --> White.\nJunction --> Asphalt.\n", failing);
	CHECK(area_of(city) == doctest::Approx(plain).epsilon(0.03));
	REQUIRE(failing.has_errors());
	CHECK(failing.list()[0].message.find("street ") == 0);
	CHECK(failing.list()[0].message.find("other pieces") != std::string::npos);
}

TEST_CASE("doors of street rules lead nowhere, which is said") {
	Diagnostics diagnostics;
	make("Street --> entrance(\"metro\") X.\nSidewalk --> X.\nCrossing --> X.\nJunction --> X.\n", diagnostics);
	REQUIRE(diagnostics.list().size() == 1);
	CHECK(diagnostics.list()[0].id == "street-entrance");
}
