#include <doctest/doctest.h>

#include "core/agenda/agenda_edit.h"
#include "core/sim/invariants.h"
#include "tests/core/sim/random_town.h"

using namespace pcg;
using namespace pcg::test;

namespace {

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

} // namespace

TEST_CASE("an inserted entry holds on its day, and the agenda goes on behind it") {
	Commuter t;
	Simulation &simulation = t.start();
	CHECK(t.visit(at(12), at(13), 0));
	simulation.advance_to(moment(0, 20));
	CHECK(t.recorder.of(t.ana) ==
			Lines{ "08:00:00 0 left-building building 0", "08:00:00 0 set-out building 1", "08:10:00 0 entered-building building 1",
					"12:00:00 0 left-building building 1", "12:00:00 0 set-out building 2", "12:08:20 0 entered-building building 2",
					"13:00:00 0 left-building building 2", "13:00:00 0 set-out building 1", "13:08:20 0 entered-building building 1",
					"16:00:00 0 left-building building 1", "16:00:00 0 set-out building 0", "16:10:00 0 entered-building building 0" });
	t.recorder.lines.clear();
	simulation.advance_to(moment(1, 20));
	CHECK(t.recorder.of(t.ana).size() == 6);
}

TEST_CASE("an entry whose time has come begins at once; what cannot be is refused") {
	Commuter t;
	Simulation &simulation = t.start(moment(0, 8, 4)); // 240 m from home, 140 m behind the plaza
	CHECK(t.visit(at(8), at(9), 0));
	simulation.advance_to(moment(0, 8, 30));
	CHECK(t.recorder.has("08:06:20 0 entered-building building 2"));
	CHECK(!t.visit(at(10), at(10), 0));
	CHECK(!t.town.insert(PersonId(9), Town::entry(TaskKind::GoToBuilding, at(10), at(11), index_of(t.plaza)), 0));
	simulation.jump_to(moment(0, 8, 8)); // a jump knows of it too
	CHECK(simulation.view(t.ana).place == target_of(t.plaza));
}

TEST_CASE("an agenda that was changed for every week is lived from then on") {
	Commuter t;
	Simulation &simulation = t.start();
	simulation.advance_to(moment(0, 8, 4)); // on the way to work, 240 m from home
	CHECK(t.visit(at(12), at(13)));
	simulation.advance_to(moment(0, 8, 30));
	CHECK(t.recorder.has("08:10:00 0 entered-building building 1")); // the walk went on
	CHECK(t.visit(at(8), at(9)));
	simulation.advance_to(moment(0, 20));
	CHECK(t.recorder.has("08:38:20 0 entered-building building 2"));
	CHECK(t.recorder.has("09:08:20 0 entered-building building 1"));
	CHECK(t.recorder.has("12:08:20 0 entered-building building 2"));
	CHECK(t.recorder.has("13:08:20 0 entered-building building 1"));
	t.recorder.lines.clear();
	simulation.advance_to(moment(1, 8, 10));
	CHECK(t.recorder.has("08:01:40 0 entered-building building 2"));
}

TEST_CASE("somebody whom the game took over goes on with its day from where it is given back") {
	Commuter t;
	Simulation &simulation = t.start();
	InvariantChecker checker(simulation);
	simulation.jump_to(moment(0, 7));
	simulation.advance_to(moment(0, 8, 1));
	CHECK(simulation.take_over(t.ana));
	CHECK(!simulation.take_over(t.ana));
	CHECK(simulation.view(t.ana).presence == Presence::Taken);
	CHECK(simulation.position(t.ana).x == 60.0f);
	CHECK(simulation.place_taken(t.ana, { 400.0f, 0.0f, 300.0f }));
	simulation.advance_to(moment(0, 9));
	checker.check();
	CHECK(simulation.outside_count() == 1);
	CHECK(simulation.release(t.ana));
	CHECK(!simulation.release(t.ana));
	CHECK(!simulation.place_taken(t.ana, { 0.0f, 0.0f, 0.0f }));
	simulation.advance_to(moment(0, 12));
	simulation.flush_lived();
	checker.finish();
	CHECK(t.recorder.of(t.ana) ==
			Lines{ "08:00:00 0 left-building building 0", "08:00:00 0 set-out building 1", "08:01:00 0 taken-over",
					"09:00:00 0 released", "09:00:00 0 set-out building 1",
					"09:06:00 0 entered-building building 1" }); // 360.6 m
	CHECK(checker.broken_total() == 0);
}

TEST_CASE("who was inside steps out when it is taken over; a jump leaves it with the game") {
	Commuter t;
	Simulation &simulation = t.start(moment(0, 10));
	CHECK(simulation.take_over(t.ana));
	CHECK(simulation.inside_count(t.work) == 0);
	CHECK(simulation.position(t.ana).x == 600.0f);
	simulation.jump_to(moment(2, 3));
	CHECK(simulation.view(t.ana).presence == Presence::Taken);
	CHECK(simulation.position(t.ana).x == 600.0f);
	CHECK(simulation.outside_count() == 1);
	CHECK(simulation.release(t.ana));
	simulation.advance_to(moment(2, 4));
	CHECK(simulation.inside_count(t.home) == 1);
	CHECK(simulation.outside_count() == 0);
}

TEST_CASE("a group whose leader is taken over walks on alone; one whose member is taken walks on with the rest") {
	for (const bool is_leader : { true, false }) {
		Town town;
		const BuildingId home = town.building("house", 0.0f);
		const BuildingId school = town.building("school", 300.0f);
		town.household(home);
		const PersonId ana = town.person(36.0f, 1.0f);
		const PersonId leo = town.person(8.0f, 1.0f);
		const PersonId mia = town.person(6.0f, 1.0f);
		town.accompany(ana, { leo, mia }, at(8), at(9), school);
		Simulation &simulation = town.simulate();
		Recorder recorder;
		simulation.add_observer(recorder);
		InvariantChecker checker(simulation);
		simulation.start(moment(0, 7));
		simulation.advance_to(moment(0, 8, 2));
		CHECK(simulation.take_over(is_leader ? ana : leo));
		simulation.advance_to(moment(0, 8, 30));
		CHECK(recorder.has("08:05:00 2 entered-building building 1"));
		CHECK(recorder.has("08:05:00 1 entered-building building 1") == is_leader);
		CHECK(recorder.has("08:05:00 0 entered-building building 1") == !is_leader);
		CHECK(recorder.has("08:02:00 2 patience-ran-out building 1") == is_leader);
		CHECK(simulation.release(is_leader ? ana : leo)); // the walk is over without it: on with its day, or after them
		simulation.advance_to(moment(0, 8, 40));
		CHECK(recorder.has("08:33:00 1 entered-building building 1") == !is_leader);
		CHECK(recorder.has("08:32:00 0 entered-building building 0") == is_leader);
		simulation.advance_to(moment(0, 12));
		CHECK(simulation.inside_count(home) == 3);
		simulation.flush_lived();
		checker.finish();
		CHECK(checker.broken_total() == 0);
	}
}

TEST_CASE("who is removed leaves its group, its seat and its building, and is seen no more") {
	Commuter t;
	Simulation &simulation = t.start(moment(0, 8, 5));
	CHECK(simulation.outside_count() == 1);
	CHECK(simulation.remove_person(t.ana));
	CHECK(!simulation.remove_person(t.ana));
	CHECK(!simulation.take_over(t.ana));
	CHECK(t.visit(at(12), at(13), 0)); // with nobody to live it
	CHECK(simulation.outside_count() == 0);
	simulation.advance_to(moment(1, 10));
	CHECK(t.recorder.lines.back() == "08:05:00 0 removed");
	simulation.jump_to(moment(1, 8, 5));
	CHECK(simulation.outside_count() == 0);
	CHECK(simulation.view(t.ana).presence == Presence::Removed);
}

TEST_CASE("households that are added live from then on where their agendas want them") {
	Commuter t;
	Simulation &simulation = t.start();
	simulation.advance_to(moment(0, 8, 5));
	Population &people = t.town.population;
	people.households.push_back({ t.plaza, PersonId(1), 2 });
	Person newcomer;
	newcomer.household = HouseholdId(1);
	newcomer.walking_speed = 1.0f;
	people.persons.insert(people.persons.end(), 2, newcomer);
	CHECK(!simulation.take_in_people()); // without agendas
	CHECK(simulation.person_count() == 1);
	AgendaSet &agendas = t.town.agendas;
	Task walk;
	walk.kind = TaskKind::GoToBuilding;
	walk.start_ms = at(8);
	walk.end_ms = at(9);
	walk.target = index_of(t.work);
	agendas.tasks.push_back(walk);
	agendas.first_task.insert(agendas.first_task.end(), 2, uint32_t(agendas.tasks.size()));
	agendas.first_floating_task.insert(agendas.first_floating_task.end(), 2, 0);
	CHECK(simulation.take_in_people());
	CHECK(simulation.person_count() == 3);
	CHECK(simulation.outside_count() == 2);
	CHECK(simulation.position(PersonId(1)).x == 400.0f); // since 8:00 from the plaza at 100 m
	CHECK(simulation.inside_count(t.plaza) == 1);
	simulation.advance_to(moment(0, 10));
	CHECK(t.recorder.has("08:05:00 2 added building 2"));
	CHECK(t.recorder.has("08:08:20 1 entered-building building 1"));
	CHECK(t.recorder.has("09:08:20 1 entered-building building 2"));
}

namespace {

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

} // namespace

TEST_CASE("a bench that is dragged away is followed; one that is removed is left for another") {
	Sitter t;
	Simulation &simulation = t.start(moment(0, 9));
	InvariantChecker checker(simulation);
	simulation.jump_to(moment(0, 9));
	CHECK(simulation.view(t.otto).pose == AgentPose::Sit);
	t.town.city.move_object(t.near, { 125.0f, 0.0f, 0.0f });
	simulation.advance_to(moment(0, 9, 1));
	checker.check();
	CHECK(t.recorder.of(t.otto) ==
			Lines{ "09:00:00 0 goal-changed object 0", "09:00:00 0 left-object object 0", "09:00:00 0 set-out zone 0",
					"09:00:00 0 arrived zone 0", "09:00:00 0 set-out object 0", "09:00:15 0 arrived object 0",
					"09:00:15 0 used-object object 0" });
	const ObjectId other = t.town.bench(105.0f, 0.0f);
	t.town.city.remove_object(t.near);
	simulation.advance_to(moment(0, 9, 2));
	CHECK(simulation.view(t.otto).place == target_of(other));
	CHECK(t.recorder.has("09:01:20 0 used-object object 1")); // 20 m back
	t.town.city.remove_object(other);
	simulation.advance_to(moment(0, 9, 10));
	CHECK(simulation.state(t.otto) == PersonState::Inside);
	simulation.flush_lived();
	checker.finish();
	CHECK(checker.broken_total() == 0);
}

TEST_CASE("a bench that is moved while somebody walks to it is met where it is; so is a park") {
	Sitter t;
	Simulation &simulation = t.start(moment(0, 7));
	simulation.advance_to(moment(0, 8, 0, 50)); // 50 m from home
	t.town.city.move_zone(t.park, { { 60.0f, 0.0f, -5.0f }, { 60.0f, 0.0f, 5.0f }, { 80.0f, 0.0f, 5.0f }, { 80.0f, 0.0f, -5.0f } }, 3.0f);
	simulation.advance_to(moment(0, 8, 1, 5)); // in the park at 60 m since 8:01:00, at 65 m
	CHECK(t.recorder.has("08:01:00 0 arrived zone 0"));
	t.town.city.move_object(t.near, { 85.0f, 0.0f, 0.0f });
	simulation.advance_to(moment(0, 8, 2));
	CHECK(t.recorder.has("08:01:25 0 used-object object 0"));
}

TEST_CASE("a door that moves is walked to anew; a building that is gone sends people home") {
	Commuter t;
	Simulation &simulation = t.start();
	InvariantChecker checker(simulation);
	simulation.jump_to(moment(0, 7));
	simulation.advance_to(moment(0, 8, 5));
	t.town.city.move_entrance(t.town.city.entrance_of(t.work), { 300.0f, 0.0f, 400.0f }, { 0.0f, 0.0f, 1.0f });
	simulation.advance_to(moment(0, 9));
	CHECK(t.recorder.has("08:11:40 0 entered-building building 1")); // 400 m from where she was
	t.town.city.remove_building(t.work);
	simulation.advance_to(moment(0, 12));
	CHECK(t.recorder.has("09:08:20 0 entered-building building 0")); // 500 m
	CHECK(simulation.inside_count(t.work) == 0);
	simulation.advance_to(moment(1, 20)); // nobody can go there any more
	simulation.flush_lived();
	checker.finish();
	CHECK(checker.broken_total() == 0);
	CHECK(simulation.inside_count(t.home) == 1);
}

namespace {

// Changes the city and the people in all ways that there are.
class Meddler {
public:
	Meddler(Town &town, Simulation &simulation, uint64_t seed) : _town(town), _simulation(simulation), _random(seed, 2) {}

	void live() { _simulation.step(Duration{ int64_t(_random.index(120'000)) }); }
	void meddle() {
		const size_t what = _random.index(60);
		what < 5 ? change_city(what) : what < 12 ? change_people(what) : void();
	}

private:
	PersonId anybody() { return PersonId(uint32_t(_random.index(_simulation.person_count()))); }
	ObjectId any_object() { return ObjectId(uint32_t(_random.index(_town.city.objects().size()))); }
	glm::vec3 somewhere() { return { float(_random.uniform(0, 700)), 0.0f, float(_random.uniform(0, 700)) }; }

	void change_city(size_t what) {
		CityModel &city = _town.city;
		switch (what) {
			case 0: city.move_object(any_object(), somewhere()); break;
			case 1: city.move_entrance(EntranceId(uint32_t(_random.index(city.entrances().size()))), somewhere(), { 1.0f, 0.0f, 0.0f }); break;
			case 2: _random.chance(0.03) ? city.remove_building(BuildingId(uint32_t(_random.index(15)))) : void(); break;
			case 3: _random.chance(0.1) ? city.remove_object(any_object()) : void(); break;
			default: _town.bench(float(_random.uniform(300, 360)), float(_random.uniform(300, 360))); break;
		}
	}
	void change_people(size_t what) {
		const PersonId id = anybody();
		switch (what) {
			case 5: _simulation.take_over(id); break;
			case 6: _random.chance(0.05) ? _simulation.remove_person(id) : false; break;
			case 7: insert(id); break;
			case 8: _random.chance(0.05) ? _simulation.jump_to(_simulation.now() + Duration::minutes(int64_t(_random.index(400)) - 100)) : void(); break;
			default:
				_simulation.place_taken(id, somewhere());
				_simulation.release(id);
				break;
		}
	}
	void insert(PersonId id) {
		const SimTime start = _simulation.now() + Duration{ int64_t(_random.index(7'200'000)) - 600'000 };
		const int32_t from = int32_t(start.time_of_day().ms);
		const int32_t to = from + 1 + int32_t(_random.index(7'200'000));
		const TaskKind kind = _random.chance(0.5) ? TaskKind::StayInside : TaskKind::DelayedRule;
		const uint32_t target = kind == TaskKind::StayInside ? uint32_t(_random.index(15)) : index_of(_town.rule("Park"));
		const bool is_of_every_week = _random.chance(0.2);
		_town.insert(id, Town::entry(kind, from, to, target, DayMask(1u << start.weekday())), is_of_every_week ? std::nullopt : std::optional(start.day()));
	}

	Town &_town;
	Simulation &_simulation;
	Random _random;
};

} // namespace

TEST_CASE("all promises hold while the city and the people change at random") {
	for (uint64_t seed = 1; seed <= 8; ++seed) {
		Town town;
		fill_at_random(town, seed);
		add_rules_at_random(town, seed);
		Simulation &simulation = town.simulate();
		InvariantChecker checker(simulation);
		simulation.start(moment(0, 0));
		Meddler meddler(town, simulation, seed);
		while (simulation.now() < moment(2, 0)) {
			meddler.live();
			checker.check();
			meddler.meddle();
		}
		simulation.flush_lived();
		checker.finish();
		const uint64_t alone = checker.broken(Promise::NoChildAlone);
		CHECK(alone <= simulation.statistics().count(SimEventKind::PatienceRanOut));
		for (const std::string &example : checker.examples()) {
			INFO(example);
			CHECK(checker.broken_total() - alone == 0);
		}
	}
}
