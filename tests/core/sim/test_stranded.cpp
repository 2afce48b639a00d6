#include <doctest/doctest.h>

#include "core/sim/invariants.h"
#include "tests/core/sim/commuter.h"

using namespace pcg;
using namespace pcg::test;

namespace {

// A street along x, as wide as people reach from where navigation ends, which a gate at 300 m may close.
class Street : public StraightLinePaths {
public:
	explicit Street(const CityModel &city) : StraightLinePaths(city) {}
	bool is_open = true;

	void find_path(glm::vec3 from, glm::vec3 to, std::vector<glm::vec3> &points) const override {
		points.clear();
		if (is_on(from) && is_on(to) && (is_open || (from.x < 300.0f) == (to.x < 300.0f))) {
			points.assign({ from, to });
		}
	}
	bool nearest_walkable(glm::vec3 from, glm::vec3 &point) const override {
		point = { from.x, 0.0f, 0.0f };
		return true;
	}

private:
	static bool is_on(glm::vec3 point) { return std::abs(point.y) <= 2.0f && std::abs(point.z) <= 2.0f; }
};

} // namespace

TEST_CASE("whoever is given back where nobody can walk goes straight to where people can, and on") {
	for (const glm::vec3 off : { glm::vec3(0.0f, 4.0f, 0.0f), glm::vec3(0.0f, -3.0f, 0.0f), glm::vec3(40.0f, 0.0f, 90.0f) }) {
		Commuter t;
		const Street street(t.town.city);
		t.town.ground = &street;
		Simulation &simulation = t.start(moment(0, 9));
		InvariantChecker checker(simulation);
		simulation.jump_to(moment(0, 9));
		CHECK(simulation.take_over(t.ana));
		CHECK(simulation.place_taken(t.ana, glm::vec3(100.0f, 0.0f, 0.0f) + off));
		CHECK(simulation.release(t.ana));
		CHECK(simulation.state(t.ana) == PersonState::Walking);
		CHECK(!simulation.is_stranded(t.ana));
		for (int i = 0; i < 100; ++i) {
			simulation.step(Duration{ 7000 });
			checker.check();
		}
		CHECK(simulation.inside_count(t.work) == 1);
		simulation.flush_lived();
		checker.finish();
		CHECK(checker.broken_total() == 0);
	}
}

TEST_CASE("who finds no way tries again every few minutes, and at once when the city is edited") {
	for (const bool is_edited : { false, true }) {
		Commuter t;
		Street street(t.town.city);
		t.town.ground = &street;
		Simulation &simulation = t.start(moment(0, 7));
		InvariantChecker checker(simulation);
		simulation.jump_to(moment(0, 7));
		simulation.advance_to(moment(0, 7, 59));
		street.is_open = false;
		simulation.advance_to(moment(0, 9, 1));
		checker.check();
		CHECK(simulation.inside_count(t.home) == 1);
		CHECK(simulation.statistics().count(SimEventKind::Unreachable) == 1); // told once
		CHECK(simulation.take_over(t.ana));
		CHECK(simulation.release(t.ana));
		CHECK(simulation.is_stranded(t.ana)); // outdoors
		street.is_open = true;
		if (is_edited) {
			t.town.bench(0.0f, 50.0f);
		}
		simulation.advance_to(moment(0, 9, 1, 1));
		CHECK(simulation.is_stranded(t.ana) == !is_edited);
		simulation.advance_to(moment(0, 9, 6));
		checker.check();
		CHECK(simulation.state(t.ana) == PersonState::Walking);
		simulation.advance_to(moment(0, 9, 20));
		CHECK(simulation.inside_count(t.work) == 1);
		simulation.flush_lived();
		checker.finish();
		CHECK(checker.broken_total() == 0);
	}
}

TEST_CASE("a building that is gone and comes back calls its people again") {
	Commuter t;
	Simulation &simulation = t.start(moment(0, 9));
	InvariantChecker checker(simulation);
	simulation.jump_to(moment(0, 9));
	const Entrance door = t.town.city.entrance(t.town.city.entrance_of(t.work));
	const EntranceId id = t.town.city.entrance_of(t.work);
	t.town.city.remove_building(t.work);
	simulation.advance_to(moment(0, 9, 5)); // half way home
	checker.check();
	CHECK(simulation.view(t.ana).place == target_of(t.home));
	t.town.city.put_building(t.work, {});
	t.town.city.put_entrance(id, door);
	simulation.advance_to(moment(0, 9, 5));
	CHECK(simulation.view(t.ana).place == target_of(t.work));
	simulation.advance_to(moment(0, 9, 11));
	CHECK(simulation.inside_count(t.work) == 1);
	simulation.flush_lived();
	checker.finish();
	CHECK(checker.broken_total() == 0);
}

TEST_CASE("nobody is put into a home that is gone, by a jump or by the start") {
	for (const bool is_jump : { false, true }) {
		Commuter t;
		t.town.household(t.home);
		const PersonId ben = t.town.person(); // at home all day
		if (!is_jump) {
			t.town.city.remove_building(t.home);
		}
		Simulation &simulation = t.start(moment(0, 3));
		InvariantChecker checker(simulation);
		t.town.city.remove_building(t.home);
		simulation.jump_to(moment(0, 3));
		checker.check();
		CHECK(simulation.inside_count(t.home) == 0);
		CHECK(simulation.state(ben) == PersonState::Waiting);
		CHECK(simulation.position(ben).x == 0.0f); // before its door
		CHECK(simulation.view(t.ana).place == target_of(t.work)); // from where there was no way home the evening before
		CHECK(simulation.outside_count() == 1);
		simulation.advance_to(moment(0, 9));
		CHECK(simulation.inside_count(t.work) == 1);
		simulation.flush_lived();
		checker.finish();
		CHECK(checker.broken_total() == 0);
	}
}
