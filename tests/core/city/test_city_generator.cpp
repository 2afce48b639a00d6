#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/city/city_bytes.h"
#include "core/city/city_generator.h"
#include "core/city/footprint_layout.h"
#include "core/city/lot_ground.h"
#include "core/city/plan_layout.h"
#include "core/city/walkable.h"
#include "core/navigation/nav_mesh_paths.h"
#include "core/navigation/reachability.h"
#include "tests/core/city/compiled.h"

using namespace pcg;

namespace {

// A box 3 m behind the street and 2 m from the sides, with the door in the middle of its front.
constexpr std::string_view house_rules = R"(
attr height = 5
@StartRule
Lot --> split(z) { 3: Back | ~1: Middle | 3: Lawn }
Back --> NIL
Lawn --> NIL
Middle --> split(x) { 2: NIL | ~1: House | 2: NIL }
House --> extrude(height) comp(f) { front: Facade | all: Wall. }
Facade --> [ t('0.5, 0, 0) entrance("house", 4) ] Wall.
)";

constexpr std::string_view park_rules = R"(
@StartRule
Lot --> zone("park") split(x) { ~1: NIL | 1: Strip }
Strip --> split(z) { ~1: NIL | 2: Bench }
@Object("bench")
Bench --> extrude(0.5)
)";

RulesByType town_rules() { return { { "house", { compile(house_rules), {}, {} } }, { "park", { compile(park_rules), {}, {} } } }; }

Layout town(uint32_t lots) {
	LayoutParameters parameters = layout_for_lots(lots);
	parameters.land_use = { { "house", 0.8 }, { "park", 0.2 } };
	Diagnostics diagnostics;
	return *make_layout(parameters, diagnostics);
}

City make(uint32_t lots, unsigned threads = 1) {
	CityOptions options;
	options.work.threads = threads;
	Diagnostics diagnostics;
	std::optional<City> city = generate_city(town(lots), town_rules(), options, diagnostics);
	REQUIRE(city.has_value());
	CHECK_MESSAGE(diagnostics.is_empty(), to_text(diagnostics));
	return std::move(*city);
}

} // namespace

TEST_CASE("every lot is built by the rules of its type, and what they mean is in the model") {
	const City city = make(40);
	for (size_t i = 0; i < city.lots.size(); ++i) {
		const LotBuild &lot = city.lots[i];
		const bool is_house = city.layout.lots[i].type == "house";
		CHECK(is_valid(lot.building) == is_house);
		CHECK(lot.entrances.size() == (is_house ? 1 : 0));
		CHECK(lot.zones.size() == (is_house ? 0 : 1));
		CHECK(lot.objects.size() == (is_house ? 0 : 1));
		CHECK_FALSE(lot.model.mesh.faces.empty() == is_house);
	}
	const TypeId house = city.model.types.find("house");
	CHECK(city.model.buildings_of_type(house).size() == 32);
	CHECK(city.model.zones_of_type(city.model.types.find("park")).size() == 8);
	CHECK(city.model.objects_of_type(city.model.types.find("bench")).size() == 8);
	CHECK(city.model.capacity(city.model.buildings_of_type(house)[0], house) == 4);
	CHECK(city.model.building(city.model.buildings_of_type(house)[0]).lot != LotId::Invalid);
}

TEST_CASE("doors lie before the house on the street's side, and people stand outside of its walls") {
	const City city = make(10);
	for (size_t i = 0; i < city.lots.size(); ++i) {
		for (EntranceId id : city.lots[i].entrances) {
			const Entrance &door = city.model.entrance(id);
			const std::vector<glm::vec3> &polygon = city.layout.lots[i].polygon;
			const glm::vec3 front = (polygon[0] + polygon[1]) / 2.0f;
			// 3 m from the front's middle, one cell of 0.25 m less at most.
			CHECK(glm::distance(door.position, front) <= 3.001f);
			CHECK(glm::distance(door.position, front) >= 2.7f);
			const glm::vec3 inwards = (polygon[3] - polygon[0]) / glm::distance(polygon[3], polygon[0]);
			CHECK(glm::dot(door.facing, inwards) == doctest::Approx(-1.0));
		}
	}
}

TEST_CASE("nobody can walk through houses, and every door can be reached") {
	const City city = make(40);
	for (size_t i = 0; i < city.lots.size(); ++i) {
		if (city.layout.lots[i].type == "house") {
			const std::vector<glm::vec3> &polygon = city.layout.lots[i].polygon;
			const glm::vec3 middle = (polygon[0] + polygon[2]) / 2.0f;
			const bool is_free = std::any_of(city.lots[i].free_ground.begin(), city.lots[i].free_ground.end(), [&](const auto &piece) {
				return middle.x > piece[0].x && middle.x < piece[2].x && middle.z < piece[0].z && middle.z > piece[2].z;
			});
			CHECK_FALSE(is_free);
		}
	}
	Diagnostics diagnostics;
	const NavMesh mesh = city_nav_mesh(city);
	report_unreachable(city, reach_of_entrances(city.model, mesh), diagnostics);
	CHECK_MESSAGE(diagnostics.is_empty(), to_text(diagnostics));
	const NavMeshPaths paths(city.model, mesh);
	const std::vector<BuildingId> &houses = city.model.buildings_of_type(city.model.types.find("house"));
	for (BuildingId house : houses) {
		CHECK(std::isfinite(paths.distance(houses[0], house)));
	}
}

TEST_CASE("the city is the same for any number of threads") {
	const City one = make(40, 1), four = make(40, 4);
	REQUIRE(one.model.entrances().size() == four.model.entrances().size());
	for (size_t i = 0; i < one.model.entrances().size(); ++i) {
		CHECK(one.model.entrances()[i].position == four.model.entrances()[i].position);
		CHECK(one.model.entrances()[i].type == four.model.entrances()[i].type);
	}
	for (size_t i = 0; i < one.lots.size(); ++i) {
		CHECK(one.lots[i].model.mesh.positions == four.lots[i].model.mesh.positions);
		CHECK(one.lots[i].free_ground == four.lots[i].free_ground);
	}
}

TEST_CASE("building one lot anew touches no other and keeps the building's id and what was added by hand") {
	City city = make(10);
	RulesByType rules = town_rules();
	rules["house"].attributes = { { "height", 9.0 } };
	const auto lot = LotId(std::find_if(city.layout.lots.begin(), city.layout.lots.end(), [](const Lot &l) { return l.type == "house"; }) -
						   city.layout.lots.begin());
	const BuildingId building = city.lots[index_of(lot)].building;
	Entrance back_door = city.model.entrance(city.lots[index_of(lot)].entrances[0]);
	back_door.position += glm::vec3(1, 0, 0);
	const EntranceId by_hand = city.model.add_entrance(back_door);
	const City before = city;
	CHECK(city.model.origin == fingerprint_of(city.layout));
	Diagnostics diagnostics;
	REQUIRE(regenerate_lot(city, lot, rules, {}, diagnostics));
	for (size_t i = 0; i < city.lots.size(); ++i) {
		const bool is_same = city.lots[i].model.mesh.positions == before.lots[i].model.mesh.positions;
		CHECK(is_same == (LotId(i) != lot));
		CHECK(city.lots[i].objects == before.lots[i].objects);
	}
	CHECK(city.lots[index_of(lot)].building == building);
	CHECK(city.model.origin == before.model.origin);
	CHECK_FALSE(city.model.entrance(by_hand).is_removed);
	CHECK(city.model.building(building).entrances.size() == 2);
	CHECK(city.model.entrance(before.lots[index_of(lot)].entrances[0]).is_removed);
}

TEST_CASE("a lot that has lost its doors loses its building") {
	City city = make(10);
	RulesByType rules = town_rules();
	rules["house"].program = rules["park"].program;
	const auto lot = LotId(std::find_if(city.layout.lots.begin(), city.layout.lots.end(), [](const Lot &l) { return l.type == "house"; }) -
						   city.layout.lots.begin());
	const BuildingId building = city.lots[index_of(lot)].building;
	Diagnostics diagnostics;
	REQUIRE(regenerate_lot(city, lot, rules, {}, diagnostics));
	CHECK(city.model.building(building).is_removed);
	CHECK(city.lots[index_of(lot)].building == BuildingId::Invalid);
	// The house's rules now make a park, but not a house: nobody can live there.
	REQUIRE(diagnostics.warning_count() == 1);
	CHECK(diagnostics.list()[0].id == "no-entrance");
	CHECK(diagnostics.list()[0].message.find("lot " + std::to_string(index_of(lot)) + " (house)") == 0);
}

TEST_CASE("types without rules are one error each, and their lots stay empty") {
	RulesByType rules = town_rules();
	rules.erase("park");
	Diagnostics diagnostics;
	const std::optional<City> city = generate_city(town(20), rules, {}, diagnostics);
	REQUIRE(city.has_value());
	REQUIRE(diagnostics.error_count() == 1);
	CHECK(diagnostics.list()[0].message.find("`park`, so 4 lots") != std::string::npos);
	CHECK(diagnostics.warning_count() == 0);
	for (size_t i = 0; i < city->lots.size(); ++i) {
		CHECK(city->lots[i].free_ground.empty() == false);
	}
	rules[""] = rules["house"];
	Diagnostics others;
	CHECK(generate_city(town(20), rules, {}, others).has_value());
	CHECK(others.error_count() == 0);
}

TEST_CASE("a warning that all lots give is told once, with the first lot's name and their number") {
	LayoutParameters parameters = layout_for_lots(12);
	parameters.land_use = { { "house", 1.0 } };
	Diagnostics diagnostics;
	const RulesByType rules = { { "house", { compile("@StartRule Lot --> extrude(3)"), {}, {} } } };
	REQUIRE(generate_city(*make_layout(parameters, diagnostics), rules, {}, diagnostics).has_value());
	REQUIRE(diagnostics.warning_count() == 1);
	CHECK(diagnostics.list()[0].message.find("lot 0 (house): ") == 0);
	CHECK(diagnostics.list()[0].message.find("(and on 11 other lots)") != std::string::npos);
}

TEST_CASE("generating can be cancelled") {
	std::atomic<bool> cancel{ false };
	CityOptions options;
	options.work.threads = 2;
	options.work.cancel = &cancel;
	options.work.progress = [&](size_t done, size_t) { cancel = done > 3; };
	Diagnostics diagnostics;
	CHECK_FALSE(generate_city(town(100), town_rules(), options, diagnostics).has_value());
}

TEST_CASE("rules build around a courtyard, which nobody enters without a gate; a lot within is an entrance that cannot be reached") {
	Footprint ring, inner;
	ring.outline = { { 0, 0 }, { 60, 0 }, { 60, 60 }, { 0, 60 } };
	ring.holes = { { { 15, 15 }, { 45, 15 }, { 45, 45 }, { 15, 45 } } };
	inner.outline = { { 25, 25 }, { 35, 25 }, { 35, 35 }, { 25, 35 } };
	LayoutParameters parameters;
	parameters.land_use = { { "house", 1.0 } };
	constexpr std::string_view door = "House --> extrude(6) comp(f) { front: [ t('0.5, 0, 0) entrance(\"house\", 4) ] Wall. | all: Wall. }";
	constexpr std::string_view gate = "House --> split(x) { ~1: Part | 4: NIL | ~1: Part }\nPart --> extrude(6) comp(f) { front: [ t('0.5, 0, 0) entrance(\"house\", 4) ] Wall. | all: Wall. }";
	for (const bool has_gate : { false, true }) {
		Diagnostics diagnostics;
		std::optional<Layout> layout = layout_of_footprints({ ring, inner }, parameters, diagnostics);
		REQUIRE(layout);
		const std::string text = "@StartRule\nLot --> House\n" + std::string(has_gate ? gate : door);
		const std::optional<City> city = generate_city(std::move(*layout), { { "house", { compile(text), {}, {} } } }, {}, diagnostics);
		REQUIRE(city);
		CHECK_MESSAGE(diagnostics.is_empty(), to_text(diagnostics));
		double free = 0.0, roof = 0.0;
		for (const std::vector<glm::vec3> &piece : lot_ground(*city, LotId(0))) {
			free += signed_area(to_plan(piece)) / 2.0;
		}
		for (const MeshFace &face : city->lots[0].model.mesh.faces) {
			for (uint32_t i = 0; face.normal.y > 0.9f && i < face.loop_count; ++i) {
				roof += signed_area(to_plan(city->lots[0].model.mesh.loop(face.first_loop + i))) / 2.0;
			}
		}
		// The courtyard less the lot within, and the gate, 4 m wide through both wings; walls on the border of two cells take one of them.
		CHECK(free <= (has_gate ? 800.0 + 4.0 * 30.0 : 0.0));
		CHECK(free >= (has_gate ? 0.97 * (800.0 + 4.0 * 30.0) : 0.0));
		CHECK(roof == doctest::Approx(has_gate ? 2700.0 - 4.0 * 30.0 : 2700.0));
		const std::vector<Reach> reach = reach_of_entrances(city->model, city_nav_mesh(*city), 1.0f);
		const size_t cut_off = size_t(std::ranges::count_if(reach, [](Reach r) { return r != Reach::Reachable; }));
		CHECK(cut_off == (has_gate ? 0 : 2)); // the other looks into the courtyard from the wing behind
	}
}
