#pragma once

#include <optional>

#include "tests/core/sim/town.h"

// Small lives for tests of what changes while a simulation runs.
namespace pcg::test {

// Ana lives at 0 m and works 600 m away; she walks 1 m/s.
struct Commuter {
	Town town;
	BuildingId home = town.building("house", 0.0f);
	BuildingId work = town.building("workplace", 600.0f);
	BuildingId plaza = town.building("shop", 100.0f);
	PersonId ana;
	Recorder recorder;

	Commuter() {
		town.household(home);
		ana = town.person();
		town.go(ana, at(8), at(16), work);
		town.go(ana, at(16), at(17), home);
	}
	Simulation &start(SimTime time = moment(0, 0)) {
		Simulation &simulation = town.simulate();
		simulation.add_observer(recorder);
		simulation.start(time);
		return simulation;
	}
	bool visit(int32_t from, int32_t to, std::optional<int64_t> day = std::nullopt) {
		return town.insert(ana, Town::entry(TaskKind::GoToBuilding, from, to, index_of(plaza)), day);
	}
};

// Otto sits in the park from 8:01:40 on, at the first of two benches.
struct Sitter {
	Town town;
	BuildingId home = town.building("house", 0.0f);
	ZoneId park = town.zone("park", 100.0f, -20.0f, 40.0f);
	ObjectId near = town.bench(110.0f, 0.0f);
	PersonId otto;
	Recorder recorder;

	Simulation &start(SimTime time) {
		town.rules("Sit Sit --> goToZone(\"park\") set(bench, findObject(\"bench\", 50)) case isValid(bench): goToObject(bench)"
				   " interact(bench, \"sit\") waitUntilNextTask() else: wait(1)");
		town.household(home);
		otto = town.person();
		town.delayed(otto, at(8), at(12), "Sit");
		Simulation &simulation = town.simulate();
		simulation.add_observer(recorder);
		simulation.start(time);
		return simulation;
	}
};

} // namespace pcg::test
