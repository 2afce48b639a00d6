#include <doctest/doctest.h>

#include "core/sim/invariants.h"
#include "tests/core/sim/random_town.h"

using namespace pcg;
using namespace pcg::test;

namespace {

// Changes the city and the people in all ways that there are.
class Meddler {
public:
	Meddler(Town &town, Simulation &simulation, uint64_t seed) : _town(town), _simulation(simulation), _random(seed, 2) {}

	void live() { _simulation.step(Duration{ int64_t(_random.index(120'000)) }); }
	void meddle() {
		const size_t what = _random.index(60);
		what < 5 ? change_city(what) : what < 12 ? change_people(what) : what < 13 ? change_agendas() : void();
	}

private:
	PersonId anybody() { return PersonId(uint32_t(_random.index(_simulation.person_count()))); }
	ObjectId any_object() { return ObjectId(uint32_t(_random.index(_town.city.objects().size()))); }
	glm::vec3 somewhere() { return { float(_random.uniform(0, 700)), 0.0f, float(_random.uniform(0, 700)) }; }

	void change_city(size_t what) {
		CityModel &city = _town.city;
		if (_random.chance(0.2)) {
			change_seats();
			return;
		}
		switch (what) {
			case 0: city.move_object(any_object(), somewhere()); break;
			case 1: city.move_entrance(EntranceId(uint32_t(_random.index(city.entrances().size()))), somewhere(), { 1.0f, 0.0f, 0.0f }); break;
			case 2: _random.chance(0.03) ? city.remove_building(BuildingId(uint32_t(_random.index(15)))) : void(); break;
			case 3: _random.chance(0.1) ? city.remove_object(any_object()) : void(); break;
			default: _town.bench(float(_random.uniform(300, 360)), float(_random.uniform(300, 360))); break;
		}
	}
	void change_seats() {
		const ObjectId id = any_object();
		CityObject object = _town.city.object(id);
		object.places.resize(1 + _random.index(3), { object.position, { 0.0f, 0.0f, 1.0f } });
		for (size_t i = 0; i < object.places.size(); ++i) {
			object.places[i].position = object.position + glm::vec3(float(i), 0.0f, 0.0f);
		}
		_town.city.put_object(id, object);
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
	// By the same rules, now and then without what was inserted since.
	void change_agendas() {
		_simulation.change_agendas([&] {
			_random.chance(0.5) ? _town.write_agendas() : void();
			return _town.program;
		});
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
		INFO((checker.examples().empty() ? std::string() : checker.examples()[0]));
		CHECK(checker.broken_total() == 0);
	}
}
