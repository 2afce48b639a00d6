#include <doctest/doctest.h>

#include <cstdio>

#include "core/io/atomic_file.h"
#include "core/io/state_file.h"
#include "tests/core/sim/random_town.h"

using namespace pcg;
using namespace pcg::test;

TEST_CASE("a saved game brings its people along and goes on") {
	const std::string path = "build/tests/saved.pcgstate";
	Town town;
	fill_at_random(town, 4);
	add_rules_at_random(town, 4);
	Simulation &original = town.simulate();
	original.start(moment(0, 0));
	original.advance_to(moment(0, 10));
	Diagnostics diagnostics;
	REQUIRE(save_state(path, original, diagnostics));
	const std::optional<StateFile> file = load_state(path, diagnostics);
	std::remove(path.c_str());
	REQUIRE(file);
	Simulation loaded(town.city, town.paths, file->people.population, file->people.agendas, town.program, {}, town.host);
	REQUIRE(loaded.restore(file->simulation, diagnostics));
	Recorder after_original, after_loaded;
	original.add_observer(after_original);
	loaded.add_observer(after_loaded);
	original.advance_to(moment(1, 0));
	loaded.advance_to(moment(1, 0));
	CHECK(after_original.lines == after_loaded.lines);
	CHECK(diagnostics.is_empty());
}

TEST_CASE("what is no saved game, damaged or of another version gives one error that says so") {
	Town town;
	fill_at_random(town, 4);
	Simulation &simulation = town.simulate();
	simulation.start(moment(0, 0));
	const std::string good = state_file_bytes(simulation);
	const auto message_of = [](std::string_view bytes) {
		Diagnostics diagnostics;
		CHECK(!read_state_file(bytes, "game.sav", diagnostics));
		REQUIRE(diagnostics.error_count() == 1);
		CHECK(diagnostics.list()[0].file == "game.sav");
		return diagnostics.list()[0].message;
	};
	CHECK(message_of("") == "this is no saved simulation");
	CHECK(message_of("PNG and so on, long enough for a header") == "this is no saved simulation");
	std::string other = good;
	other[8] = 4;
	CHECK(message_of(other) == "it was saved by a newer version (format 4, this one reads format 3)");
	other[8] = 1;
	CHECK(message_of(other) == "it was saved by an older version (format 1, this one reads format 3)");
	CHECK(message_of(good.substr(0, 9)) == "the saved simulation is damaged");
	CHECK(message_of(good.substr(0, good.size() - 1)) == "the saved simulation is damaged");
	CHECK(message_of(good + "x") == "the saved simulation is damaged");
	for (size_t i = 12; i < good.size(); i += 97) {
		std::string bytes = good;
		bytes[i] = char(bytes[i] ^ 0x10);
		CHECK(message_of(bytes) == "the saved simulation is damaged");
	}
	Diagnostics diagnostics;
	CHECK(!load_state("build/tests/no such file", diagnostics));
	CHECK(diagnostics.error_count() == 1);
}
