#pragma once

#include <string_view>

#include "core/base/random.h"
#include "core/semantics/city_model.h"

namespace pcg::soak {

constexpr float street = 40.0f; // metres between doors
constexpr uint32_t columns = 30;

inline void add_door(CityModel &city, BuildingId building, std::string_view type, uint32_t capacity, glm::vec3 position) {
	Entrance entrance;
	entrance.building = building;
	entrance.type = city.types.add(type);
	entrance.capacity = capacity;
	entrance.position = position;
	city.add_entrance(entrance);
}

// A square park with six benches of two places.
inline void add_park(CityModel &city, glm::vec3 corner) {
	Zone park;
	park.type = city.types.add("park");
	const float size = street * 0.8f;
	park.polygon = { corner, corner + glm::vec3(0, 0, size), corner + glm::vec3(size, 0, size), corner + glm::vec3(size, 0, 0) };
	city.add_zone(park);
	for (int i = 0; i < 6; ++i) {
		CityObject bench;
		bench.type = city.types.add("bench");
		bench.position = corner + glm::vec3(4.0f + 5.0f * float(i), 0.0f, i % 2 ? 8.0f : 20.0f);
		bench.places = { { bench.position, { 0, 0, 1 } }, { bench.position + glm::vec3(0.6f, 0, 0), { 0, 0, 1 } } };
		city.add_object(bench);
	}
}

// Lots on a grid, mixed as in the demo: houses, flats above shops, workplaces, schools, shops and parks.
inline void build_city(CityModel &city, uint64_t seed, uint32_t lots) {
	Random random(seed, 3);
	for (uint32_t i = 0; i < lots; ++i) {
		const glm::vec3 door{ float(i % columns) * street, 0.0f, float(i / columns) * street };
		const size_t what = i < 3 ? 95 + i * 2 : random.index(100); // at least one of the rare ones
		if (what >= 98) {
			add_park(city, door);
			continue;
		}
		const BuildingId building = city.add_building();
		if (what < 60) {
			add_door(city, building, "house", 6, door);
		} else if (what < 68) {
			add_door(city, building, "shop", 4, door);
			add_door(city, building, "house", 30, door + glm::vec3(9.0f, 0.0f, 0.0f));
		} else {
			add_door(city, building, what < 88 ? "workplace" : what < 94 ? "shop" : "school", 60, door);
		}
	}
}

} // namespace pcg::soak
