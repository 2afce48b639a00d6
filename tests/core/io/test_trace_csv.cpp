#include <doctest/doctest.h>

#include <cstdio>

#include "core/io/png.h"
#include "core/io/trace_csv.h"
#include "tests/core/sim/town.h"

using namespace pcg;
using namespace pcg::test;

namespace {

// One person who goes to a shop 60 m away for an hour.
struct ShopTown {
	Town town;
	PersonId ana;

	ShopTown() {
		const BuildingId home = town.building("house", 0.0f);
		const BuildingId shop = town.building("shop", 60.0f);
		town.household(home);
		ana = town.person(36.0f);
		town.go(ana, at(10), at(11), shop);
	}
};

std::string text_of(const std::string &path) {
	const Result<std::string> text = read_file(path);
	std::remove(path.c_str());
	return text ? *text : std::string();
}

} // namespace

TEST_CASE("a trace has a row for every event, with the seconds since the start") {
	const std::string path = "build/tests/trace.csv";
	ShopTown t;
	Simulation &simulation = t.town.simulate();
	Diagnostics diagnostics;
	{
		AtomicFile file(path);
		TraceWriter writer(file, simulation, moment(0, 9));
		simulation.add_observer(writer);
		simulation.start(moment(0, 9));
		simulation.advance_to(moment(0, 10, 30));
		CHECK(file.commit(diagnostics));
	}
	CHECK(text_of(path) == "seconds,person,event,place,x,z\n"
						   "0.000,0,inside,building:0,0.00,0.00\n"
						   "3600.000,0,task-started,building:1,0.00,0.00\n"
						   "3600.000,0,left-building,building:0,0.00,0.00\n"
						   "3600.000,0,set-out,building:1,0.00,0.00\n"
						   "3660.000,0,entered-building,building:1,60.00,0.00\n");
}

TEST_CASE("a trace tells of a jump, and where it put everybody") {
	const std::string path = "build/tests/jumped.csv";
	ShopTown t;
	Simulation &simulation = t.town.simulate();
	Diagnostics diagnostics;
	{
		AtomicFile file(path);
		TraceWriter writer(file, simulation, moment(0, 0));
		simulation.start(moment(0, 9));
		simulation.add_observer(writer);
		simulation.jump_to(moment(0, 10, 0, 20));
		CHECK(file.commit(diagnostics));
	}
	CHECK(text_of(path) == "seconds,person,event,place,x,z\n"
						   "36020.000,,jumped,32400.000,,\n"
						   "36020.000,0,walking,building:1,20.00,0.00\n");
}

TEST_CASE("lived rows carry the numbers of the user's files") {
	const std::string path = "build/tests/lived.csv";
	ShopTown t;
	Simulation &simulation = t.town.simulate();
	LivedLog log;
	simulation.add_observer(log);
	simulation.start(moment(0, 9));
	simulation.advance_to(moment(0, 10, 1));
	simulation.flush_lived();
	FileIds buildings;
	buildings.add(100);
	buildings.add(200);
	Diagnostics diagnostics;
	CHECK(write_lived_csv(path, t.town.city, t.town.population, log, { .buildings = &buildings }, diagnostics));
	const std::string text = text_of(path);
	CHECK(text.find(",36,0,09:00:00,10:00:00,3600,inside,building:100,house,0,0.00,0.00,0.0,,home,,\n") != std::string::npos);
	CHECK(text.find(",36,0,10:00:00,10:01:00,60,walking,building:200,shop,1,60.00,0.00,60.0,,goToBuilding,10:00:00,11:00:00\n") !=
			std::string::npos);
}

namespace {

LivedEntry lived(PersonState state, int64_t start_ms, int64_t end_ms, float metres = 0.0f) {
	LivedEntry entry;
	entry.person = PersonId(0);
	entry.state = state;
	entry.start = { start_ms };
	entry.end = { end_ms };
	entry.metres = metres;
	return entry;
}

// The columns day, start, end, seconds, state and metres of each row.
std::vector<std::string> spans_of(const std::string &text) {
	std::vector<std::string> result;
	for (size_t begin = text.find('\n') + 1; begin < text.size(); begin = text.find('\n', begin) + 1) {
		std::vector<std::string> cells(1);
		for (char c : text.substr(begin, text.find('\n', begin) - begin)) {
			if (c == ',') {
				cells.emplace_back();
			} else {
				cells.back() += c;
			}
		}
		result.push_back(cells[3] + " " + cells[4] + " " + cells[5] + " " + cells[6] + " " + cells[7] + " " + cells[13]);
	}
	return result;
}

} // namespace

TEST_CASE("rows of lives are whole seconds without a gap; the last of a day ends at 24:00:00") {
	const std::string path = "build/tests/rows.csv";
	ShopTown t;
	t.town.simulate();
	LivedLog log;
	const int64_t night = 23 * 3'600'000;
	for (const LivedEntry &entry : { lived(PersonState::Inside, 0, 1'030), lived(PersonState::Waiting, 1'030, 1'070),
				 lived(PersonState::Walking, 1'070, 1'499, 0.5f), lived(PersonState::Walking, 1'499, 3'500, 2.0f),
				 lived(PersonState::Walking, 3'500, 3'900, 0.25f), lived(PersonState::Inside, 3'900, night),
				 lived(PersonState::Inside, night, one_day.ms), lived(PersonState::Inside, one_day.ms, one_day.ms + 5000),
				 lived(PersonState::Waiting, one_day.ms + 5000, 2 * one_day.ms + 60'000) }) {
		LivedSpan span;
		span.person = entry.person;
		span.state = entry.state;
		span.start = entry.start;
		span.end = entry.end;
		span.last_metre = double(entry.metres);
		log.on_lived(span);
	}
	Diagnostics diagnostics;
	CHECK(write_lived_csv(path, t.town.city, t.town.population, log, {}, diagnostics));
	CHECK(spans_of(text_of(path)) == Lines{ "0 00:00:00 00:00:01 1 inside 0.0", "0 00:00:01 00:00:04 3 walking 2.8",
											 "0 00:00:04 23:00:00 82796 inside 0.0", "0 23:00:00 24:00:00 3600 inside 0.0",
											 "1 00:00:00 00:00:05 5 inside 0.0", "1 00:00:05 24:01:00 86455 waiting 0.0" });
}

TEST_CASE("pictures are PNG files; what cannot be written is one error") {
	const std::string path = "build/tests/picture.png";
	Diagnostics diagnostics;
	CHECK(write_png(path, { 2, 1, { 255, 0, 0, 0, 0, 255 } }, diagnostics));
	CHECK(text_of(path).substr(1, 3) == "PNG");
	CHECK(!write_png("/dev/null/picture.png", { 1, 1, { 0, 0, 0 } }, diagnostics));
	CHECK(!write_png(path, {}, diagnostics));
	CHECK(diagnostics.error_count() == 2);
}
