#include <doctest/doctest.h>

#include "core/sim/age_heat.h"
#include "core/sim/heat_map_image.h"
#include "tests/core/sim/town.h"

using namespace pcg;
using namespace pcg::test;

namespace {

// One of 40 and one of 8 years walk the 100 m along x to work and back, at 1 m/s; the child sets out at that time of day.
void let_two_commute(Town &town, int32_t child_sets_out) {
	const BuildingId home = town.building("house", 1.0f, 1.0f);
	const BuildingId work = town.building("workplace", 101.0f, 1.0f);
	town.household(home);
	town.go(town.person(40.0f, 1.0f), at(8), at(16), work);
	town.go(town.person(8.0f, 1.0f), child_sets_out, at(16), work);
}

} // namespace

TEST_CASE("a heat map holds every second that somebody spent outdoors, where it was spent") {
	Town town;
	let_two_commute(town, at(8));
	Simulation &simulation = town.simulate();
	HeatGrid grid{ { 0.0f, 0.0f }, 2.0f, 60, 2 };
	HeatMap all(grid);
	simulation.add_observer(all);
	simulation.start(moment(0, 0));
	simulation.advance_to(moment(1, 0));
	CHECK(all.total() == doctest::Approx(400.0)); // two persons, two walks of 100 s
	CHECK(all.person_seconds()[25] == doctest::Approx(8.0)); // 2 m at 1 m/s, four times
	CHECK(all.person_seconds()[60] == 0.0);
}

TEST_CASE("heat of ages and hours adds up to all of it, on the same ground") {
	Town town;
	let_two_commute(town, at(7, 59, 40)); // 20 of the child's 100 s are of the hour before
	AgeHeat heat(town.city, town.population);
	Simulation &simulation = town.simulate();
	simulation.add_observer(heat);
	simulation.start(moment(0, 0));
	simulation.advance_to(moment(1, 0));
	const size_t children = 0, adults = 1, elders = 2;
	CHECK(heat.map({}, {}).total() == doctest::Approx(400.0));
	CHECK(heat.map(children, {}).total() == doctest::Approx(200.0));
	CHECK(heat.map(adults, {}).total() == doctest::Approx(200.0));
	CHECK(heat.map(elders, {}).total() == 0.0);
	CHECK(heat.map(children, 7).total() == doctest::Approx(20.0));
	CHECK(heat.map(children, 8).total() == doctest::Approx(80.0));
	CHECK(heat.map({}, 7).total() == doctest::Approx(20.0));
	CHECK(heat.map({}, 8).total() == doctest::Approx(180.0));
	CHECK(heat.map({}, 16).total() == doctest::Approx(200.0));
	CHECK(heat.map({}, 3).total() == 0.0);
	const HeatMap hour = heat.map(children, 7);
	const HeatGrid &coarse = hour.grid();
	CHECK(coarse.cell == 2.0f * heat.grid().cell);
	CHECK(coarse.cell * float(coarse.columns) == heat.grid().cell * float(heat.grid().columns));
	CHECK(coarse.cell * float(coarse.rows) == heat.grid().cell * float(heat.grid().rows));
	const auto at_metre = [&](float x) { // along his way, which begins at (1, 1)
		const size_t column = size_t((x - coarse.origin.x) / coarse.cell), row = size_t((1.0f - coarse.origin.y) / coarse.cell);
		return hour.person_seconds()[row * coarse.columns + column];
	};
	CHECK(at_metre(10.0f) == doctest::Approx(4.0)); // a cell of 4 m at 1 m/s
	CHECK(at_metre(50.0f) == 0.0); // where he was after eight
}

TEST_CASE("the grid covers the whole city and keeps to its limit") {
	Town town;
	town.building("house", -500.0f, 10.0f);
	town.building("house", 1500.0f, 300.0f);
	const HeatGrid grid = grid_over(town.city, 20.0f, 1.0f, 1000);
	CHECK(grid.origin.x == -520.0f);
	CHECK(grid.columns <= 1000);
	CHECK(grid.origin.x + float(grid.columns) * grid.cell >= 1520.0f);
	CHECK(grid_over(CityModel(), 20.0f, 1.0f, 100).cell_count() > 0);
}

TEST_CASE("the picture is white streets, grey lots, pale ways, and darker where more time was spent") {
	HeatMap map({ { 0.0f, 0.0f }, 1.0f, 40, 10 });
	LivedSpan span;
	span.state = PersonState::Waiting;
	span.end = SimTime{ 1000 };
	span.position = { 30.5f, 0.0f, 5.5f };
	map.on_lived(span);
	span.end = SimTime{ 100'000 };
	span.position = { 20.5f, 0.0f, 5.5f };
	map.on_lived(span);
	const GroundPolygon house{ { 2.0f, 0.0f, 2.0f }, { 8.0f, 0.0f, 2.0f }, { 8.0f, 0.0f, 8.0f }, { 2.0f, 0.0f, 8.0f } };
	const GroundPolygon way{ { 6.0f, 0.0f, 2.0f }, { 8.0f, 0.0f, 2.0f }, { 8.0f, 0.0f, 8.0f }, { 6.0f, 0.0f, 8.0f } };
	const RgbImage image = draw_heat_map(map, { { house }, { way } }, { .pixels_per_cell = 1 });
	const auto red = [&](int x, int y) { return int(image.pixels[size_t(y * 40 + x) * 3]); };
	CHECK(image.width == 40);
	CHECK(red(0, 0) == 255);
	CHECK(red(5, 5) == 205);
	CHECK(red(7, 5) == 246);
	CHECK(red(20, 5) < 20); // the darkest
	CHECK(red(30, 5) > red(20, 5));
}

TEST_CASE("the heat changes evenly between the middles of cells, so that no squares are seen") {
	HeatMap map({ { 0.0f, 0.0f }, 1.0f, 40, 10 });
	LivedSpan span;
	span.state = PersonState::Waiting;
	span.end = SimTime{ 100'000 };
	span.position = { 20.5f, 0.0f, 5.5f };
	map.on_lived(span);
	const RgbImage image = draw_heat_map(map, {}, { .pixels_per_cell = 8 });
	const auto sum = [&](int x) { return
		int(image.pixels[size_t(44 * 320 + x) * 3]) + int(image.pixels[size_t(44 * 320 + x) * 3 + 1]); };
	for (int x = 165; x < 172; ++x) { // out of the darkest cell into its neighbour
		CHECK(sum(x) < sum(x + 1));
	}
}

TEST_CASE("a bench where somebody sits all day is a spot that leaves the ways in sight") {
	HeatMap map({ { 0.0f, 0.0f }, 1.0f, 40, 20 });
	LivedSpan span;
	span.state = PersonState::Waiting;
	span.end = SimTime{ 10'000 };
	for (int column = 0; column < 40; ++column) { // a way of 10 s a cell
		span.position = { float(column) + 0.5f, 0.0f, 5.5f };
		map.on_lived(span);
	}
	span.end = SimTime{ 14'400'000 };
	span.position = { 20.5f, 0.0f, 12.5f };
	map.on_lived(span);
	const RgbImage image = draw_heat_map(map, {}, { .pixels_per_cell = 1 });
	const auto red = [&](int x, int y) { return int(image.pixels[size_t(y * 40 + x) * 3]); };
	CHECK(red(10, 5) < 20); // the way is dark
	CHECK(red(20, 12) > red(10, 5)); // a cell alone is not darker than a way
	CHECK(red(20, 12) < 255); // but seen
}

TEST_CASE("the overlay is clear where nobody was and thick where people stay") {
	HeatMap map({ { 0.0f, 0.0f }, 1.0f, 40, 10 });
	LivedSpan span;
	span.state = PersonState::Waiting;
	span.end = SimTime{ 1000 };
	span.position = { 30.5f, 0.0f, 5.5f };
	map.on_lived(span);
	span.end = SimTime{ 100'000 };
	span.position = { 20.5f, 0.0f, 5.5f };
	map.on_lived(span);
	const RgbaImage image = draw_heat_overlay(map, { .pixels_per_cell = 1 });
	const auto opacity = [&](int x, int y) { return int(image.pixels[size_t(y * 40 + x) * 4 + 3]); };
	CHECK(image.width == 40);
	CHECK(image.height == 10);
	CHECK(image.pixels.size() == 40 * 10 * 4);
	CHECK(opacity(3, 3) == 0);
	CHECK(opacity(20, 5) == 255);
	CHECK(opacity(30, 5) > 0);
	CHECK(opacity(30, 5) < 255);
}
