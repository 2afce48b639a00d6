// How fast a city is made and walked in. Prints one JSON object a figure.
#include <cmath>
#include <cstdio>
#include <ctime>
#include <optional>

#include "bench/figure.h"
#include "bench/house_rules.h"
#include "core/base/random.h"
#include "core/cga/dialect.h"
#include "core/city/city_generator.h"
#include "core/city/walkable.h"
#include "core/io/rule_loader.h"
#include "core/navigation/nav_mesh_paths.h"

using namespace pcg;

namespace {

// Of processor time: all of this runs on one thread, whatever else the machine does.
double seconds_of(const auto &work) {
	const std::clock_t start = std::clock();
	work();
	return double(std::clock() - start) / CLOCKS_PER_SEC;
}

constexpr double budget_seconds = 0.5; // for 300 lots
// Recast at cells of 0.5 m, and a path of Detour, 240 m long on average, both on 300 lots.
constexpr double recast_ms = 329.0, detour_us = 36.1, detour_metres = 240.0;

std::optional<City> make_city(uint32_t lots, Diagnostics &diagnostics) {
	MemorySourceProvider sources;
	sources.add("house.cga", std::string(house_rules));
	const RulesByType rules = { { "", { load_program("house.cga", cga::cga_dialect(), sources, diagnostics), {}, {} } } };
	CityOptions options;
	options.work.threads = 1;
	return generate_city(*make_layout(layout_for_lots(lots), diagnostics), rules, options, diagnostics);
}

void measure_queries(const City &city, const NavMesh &mesh) {
	constexpr int queries = 20000;
	PathFinder finder(mesh);
	Random random(1);
	std::vector<NavPoint> ends;
	for (int i = 0; i < 2 * queries; ++i) {
		ends.push_back(mesh.nearest(city.model.entrances()[random.index(city.model.entrances().size())].position, 2.0f));
	}
	double metres = 0.0;
	const double seconds = seconds_of([&] {
		for (int i = 0; i < queries; ++i) {
			metres += finder.find(ends[size_t(2 * i)], ends[size_t(2 * i + 1)]) ? finder.length() : 0.0;
		}
	});
	bench::print("path query, 300 lots", seconds / queries * 1e6, "us", detour_us);
	bench::print("length of those paths", metres / queries, "m", detour_metres);
}

void measure_distances(const City &city, const NavMesh &mesh) {
	const uint32_t count = uint32_t(city.model.buildings().size());
	const NavMeshPaths paths(city.model, mesh);
	double sum = 0.0;
	const auto ask_all = [&] {
		for (uint32_t a = 0; a < count; ++a) {
			for (uint32_t b = 0; b < a; ++b) {
				sum += paths.distance(BuildingId(a), BuildingId(b));
			}
		}
	};
	const double pairs = count * (count - 1) / 2.0;
	bench::print("learning all distances, 300 buildings", seconds_of(ask_all), "s", pairs * detour_us * 1e-6);
	bench::print("known distance", seconds_of(ask_all) / pairs * 1e9, "ns");
}

// A lot in the middle is cleared. Told is what an engine that bakes tile by tile would tell: that something in its tile, of 80 m, has changed.
void measure_edit(City city, const NavMesh &before, double whole_seconds) {
	const Lot &lot = city.layout.lots[city.layout.lots.size() / 2];
	city.patches.push_back({ lot.polygon, {} });
	PlanBox tile;
	tile.add(lot.polygon[0] + glm::vec3(40.0f, 0.0f, 40.0f));
	tile.add(lot.polygon[0] - glm::vec3(40.0f, 0.0f, 40.0f));
	NavMeshOptions options;
	options.margin = 0.05f; // as city_nav_mesh()
	const NavRegion region = city_nav_region(city);
	NavMesh after;
	const double seconds = seconds_of([&] { after = NavMesh::rebuild(before, { &tile, 1 }, { &region, 1 }, options); });
	bench::print("walking mesh of 300 lots after an edit", seconds * 1e3, "ms", whole_seconds * 1e3);
}

void measure_nearest(const City &city, const NavMesh &mesh) {
	const NavMeshPaths paths(city.model, mesh);
	const TypeId type = city.model.entrances()[0].type;
	BuildingId nearest = BuildingId::Invalid;
	const double seconds = seconds_of([&] { nearest = paths.nearest_building(type, BuildingId(1)); });
	bench::print("nearest of a type, for all of 10,000 buildings", is_valid(nearest) ? seconds : INFINITY, "s");
}

void measure_large(Diagnostics &diagnostics) {
	std::optional<City> city;
	bench::print("10,000 lots generated, one thread", seconds_of([&] { city = make_city(10'000, diagnostics); }), "s");
	NavMesh mesh;
	bench::print("mesh of 10,000 lots joined", seconds_of([&] { mesh = city_nav_mesh(*city); }), "s");
	const NavMeshPaths paths(city->model, mesh);
	const size_t count = city->model.buildings().size();
	Random random(2);
	constexpr int queries = 2000;
	const double seconds = seconds_of([&] {
		for (int i = 0; i < queries; ++i) {
			(void)paths.distance(BuildingId(random.index(count)), BuildingId(random.index(count)));
		}
	});
	bench::print("distance never asked before, 10,000 lots", seconds / queries * 1e6, "us");
	measure_nearest(*city, mesh);
}

} // namespace

int main() {
	Diagnostics diagnostics;
	std::optional<City> city;
	const double seconds = seconds_of([&] { city = make_city(300, diagnostics); });
	if (!city || diagnostics.has_errors()) {
		std::fputs(to_text(diagnostics).c_str(), stderr);
		return 1;
	}
	bench::print("300 box lots generated, one thread", seconds, "s", budget_seconds);
	NavMesh mesh;
	const double mesh_seconds = seconds_of([&] { mesh = city_nav_mesh(*city); });
	bench::print("walking mesh of 300 lots", mesh_seconds * 1e3, "ms", recast_ms);
	measure_edit(*city, mesh, mesh_seconds);
	measure_queries(*city, mesh);
	measure_distances(*city, mesh);
	measure_large(diagnostics);
	return 0;
}
