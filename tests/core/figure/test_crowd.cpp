#include <doctest/doctest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "core/figure/crowd.h"

using namespace pcg;

namespace {

struct Street {
	Population population;
	SimTime now = SimTime::at(0, Duration::hours(8));
	Crowd crowd{ population, nullptr, [this] { return now; } };

	Street() {
		population.households.push_back({ .first_member = PersonId(0), .member_count = 2, .hair_color = 3 });
		population.persons.push_back({ .household = HouseholdId(0), .age = 40.0f, .gender = Gender::Woman, .clothes_color = 0 });
		population.persons.push_back({ .household = HouseholdId(0), .age = 7.0f, .gender = Gender::Man, .clothes_color = 1 });
	}

	// Seen from above, from so many metres; everybody near the middle is an agent.
	Eye eye = Eye::at({ 0, 30, 0 }, glm::perspective(glm::radians(90.0f), 1.0f, 0.1f, 1000.0f) * glm::lookAt(glm::vec3(0, 30, 0), glm::vec3(0), glm::vec3(0, 0, -1)));
	DetailLimits limits{ .agent_distance = 0.0f };
	void update(Duration since_eight) {
		now = SimTime::at(0, Duration::hours(8)) + since_eight;
		crowd.update(now, eye, limits);
	}
	const Body &body(uint32_t person) const { return crowd.body(crowd.slot_of(PersonId(person))); }
	void push(uint32_t person, glm::vec3 to) { crowd.move_agent(crowd.slot_of(PersonId(person)), to); }
};

} // namespace

TEST_CASE("a body is where its speed brings it along the path, and stands at the end") {
	Street street;
	const glm::vec3 path[] = { { 0, 0, 0 }, { 10, 0, 0 }, { 10, 0, 5 } };
	street.crowd.spawn_agent(PersonId(0), path[0]);
	street.crowd.walk_agent(PersonId(0), path, 2.0f);
	street.update(Duration::seconds(3)); // 6 m
	CHECK(street.crowd.position(PersonId(0)).x == doctest::Approx(6.0f));
	street.update(Duration::seconds(6)); // 12 m: two beyond the corner
	CHECK(street.crowd.position(PersonId(0)).x == doctest::Approx(10.0f));
	CHECK(street.crowd.position(PersonId(0)).z == doctest::Approx(2.0f));
	street.crowd.write_figures();
	const std::vector<float> &numbers = street.crowd.figures(looks_of(street.population, PersonId(0)).kind);
	REQUIRE(numbers.size() == crowd_stride);
	CHECK(numbers[16] == doctest::Approx(12.0f));
	CHECK(numbers[17] == 1.0f);
	// The figure's front is its -z axis (third column of the matrix): along +z on the last stretch.
	CHECK(numbers[2] == doctest::Approx(0.0f));
	CHECK(numbers[10] == doctest::Approx(-1.0f));
	street.update(Duration::seconds(60));
	CHECK(street.crowd.position(PersonId(0)).z == doctest::Approx(5.0f));
	street.crowd.write_figures();
	CHECK(numbers[17] == 0.0f);
}

TEST_CASE("going back in time walks the path from its start") {
	Street street;
	const glm::vec3 path[] = { { 0, 0, 0 }, { 10, 0, 0 }, { 20, 0, 0 } };
	street.crowd.spawn_agent(PersonId(1), path[0]);
	street.crowd.walk_agent(PersonId(1), path, 1.0f);
	street.update(Duration::seconds(15));
	street.update(Duration::seconds(4));
	CHECK(street.crowd.position(PersonId(1)).x == doctest::Approx(4.0f));
}

TEST_CASE("a freed body leaves the others in place") {
	Street street;
	street.crowd.spawn_agent(PersonId(0), { 1, 0, 0 });
	street.crowd.spawn_agent(PersonId(1), { 2, 0, 0 });
	street.crowd.free_agent(PersonId(0));
	street.crowd.free_agent(PersonId(0)); // once more changes nothing
	street.update({});
	CHECK(street.crowd.size() == 1);
	CHECK_FALSE(street.crowd.has(PersonId(0)));
	CHECK(street.crowd.position(PersonId(1)).x == 2.0f);
}

TEST_CASE("looks follow age, gender and household") {
	Street street;
	CHECK(looks_of(street.population, PersonId(0)).kind == 4); // woman, adult
	CHECK(looks_of(street.population, PersonId(1)).kind == 0); // boy
	CHECK(looks_of(street.population, PersonId(0)).hair == looks_of(street.population, PersonId(1)).hair);
}

TEST_CASE("people step aside little by little, and never faster than they could") {
	Street street;
	const glm::vec3 path[] = { { 0, 0, 0 }, { 10, 0, 0 }, { 10, 0, 10 } };
	street.crowd.spawn_agent(PersonId(1), path[0]);
	street.crowd.walk_agent(PersonId(1), path, 1.0f);
	glm::vec3 last = path[0];
	float widest = 0.0f;
	for (int step = 1; step <= 220; ++step) {
		street.update(Duration{ step * 100 });
		const Body &body = street.body(1);
		CHECK(glm::distance(body.position, last) < 0.3f); // in a tenth of a second, also round the corner
		widest = std::max(widest, glm::distance(body.position, body.on_path));
		last = body.position;
	}
	CHECK(widest > 0.05f);
	CHECK(widest <= 0.46f);
	CHECK(glm::distance(last, path[2]) < 0.001f);
}

TEST_CASE("who was pushed a little walks on and comes back to its path on the way") {
	Street street;
	const glm::vec3 path[] = { { 0, 0, 0 }, { 20, 0, 0 } };
	street.crowd.spawn_agent(PersonId(0), path[0]);
	street.crowd.walk_agent(PersonId(0), path, 1.0f);
	street.update(Duration::seconds(2));
	street.push(0, street.body(0).position + glm::vec3(0, 0, 1));
	glm::vec3 last = street.body(0).position;
	for (int step = 1; step <= 30; ++step) {
		street.update(Duration::seconds(2) + Duration{ step * 100 });
		CHECK(glm::distance(street.body(0).position, last) < 0.2f);
		last = street.body(0).position;
	}
	CHECK(street.body(0).gap() < 0.02f);
	CHECK(street.body(0).on_path.x == doctest::Approx(5.0f)); // where it should be, as if nothing had been
}

TEST_CASE("who was pushed far walks back in view, hurrying, and catches up") {
	Street street;
	const glm::vec3 path[] = { { 0, 0, 0 }, { 60, 0, 0 } };
	street.eye = Eye::at({ 0, 100, 0 }, glm::perspective(glm::radians(90.0f), 1.0f, 0.1f, 1000.0f) * glm::lookAt(glm::vec3(0, 100, 0), glm::vec3(0), glm::vec3(0, 0, -1)));
	street.crowd.spawn_agent(PersonId(0), path[0]);
	street.crowd.walk_agent(PersonId(0), path, 1.0f);
	street.update(Duration::seconds(2));
	street.push(0, { 2, 0, 8 });
	glm::vec3 last = street.body(0).position;
	int steps = 0;
	for (; steps < 400 && street.body(0).gap() > 0.02f; ++steps) {
		street.update(Duration::seconds(2) + Duration{ (steps + 1) * 100 });
		CHECK(glm::distance(street.body(0).position, last) < 0.3f);
		CHECK(street.body(0).shown_pose == AgentPose::Walk);
		last = street.body(0).position;
	}
	CHECK(steps > 50);
	CHECK(steps < 400);
}

TEST_CASE("far and unseen it is put back at once") {
	Street street;
	street.crowd.spawn_agent(PersonId(0), { 200, 0, 0 });
	street.update({});
	street.push(0, { 208, 0, 0 });
	street.update(Duration::seconds(0.1));
	CHECK(street.body(0).position == glm::vec3(200, 0, 0));
	CHECK(street.body(0).was_placed);
}

TEST_CASE("whoever stands goes back on foot and then stands") {
	Street street;
	street.crowd.spawn_agent(PersonId(0), { 0, 0, 0 });
	street.crowd.place_agent(PersonId(0), { 0, 0, 0 }, { 0, 0, 1 }, AgentPose::Sit);
	street.update({});
	street.push(0, { 4, 0, 0 });
	street.update(Duration::seconds(0.5));
	CHECK(street.body(0).shown_pose == AgentPose::Walk);
	CHECK(street.body(0).facing.x < 0.0f);
	for (int step = 1; step <= 80; ++step) {
		street.update(Duration::seconds(0.5) + Duration{ step * 100 });
	}
	CHECK(street.body(0).position == glm::vec3(0.0f));
	CHECK(street.body(0).shown_pose == AgentPose::Sit);
	CHECK(street.body(0).facing.z == doctest::Approx(1.0f));
}

TEST_CASE("a scene that moves itself is told where to, and carried when it is stuck") {
	Street street;
	const glm::vec3 path[] = { { 0, 0, 0 }, { 100, 0, 0 } };
	street.limits = { .agent_distance = 100.0f };
	street.crowd.spawn_agent(PersonId(0), path[0]);
	street.crowd.walk_agent(PersonId(0), path, 1.0f);
	street.update({});
	CHECK(street.crowd.level(0) == DetailLevel::Agent);
	REQUIRE(street.crowd.new_agents().size() == 1);
	street.crowd.set_scene(0, true, false);
	street.update(Duration::seconds(1));
	CHECK(street.body(0).position == glm::vec3(0.0f)); // it does not move
	CHECK(street.body(0).velocity.x == doctest::Approx(1.0f).epsilon(0.1));
	street.push(0, { 1, 0, 0 }); // it does what it was told
	street.update(Duration::seconds(2));
	CHECK(street.body(0).gap() == doctest::Approx(1.0f).epsilon(0.1));
	for (int step = 1; step <= 50; ++step) { // a wall: it stays
		street.update(Duration::seconds(2) + Duration{ step * 100 });
		CHECK(street.body(0).position == glm::vec3(1, 0, 0));
	}
	CHECK(street.body(0).velocity.x > 1.5f);
	for (int step = 51; step <= 600 && street.body(0).gap() > 0.02f; ++step) {
		street.update(Duration::seconds(2) + Duration{ step * 100 });
	}
	CHECK(street.body(0).gap() < 0.02f);
}

TEST_CASE("whose body lags behind is followed by it indoors, and steps out of it again") {
	Street street;
	street.crowd.spawn_agent(PersonId(0), { 0, 0, 0 });
	street.update({});
	street.push(0, { 3, 0, 0 });
	street.crowd.free_agent(PersonId(0));
	CHECK(street.crowd.size() == 0);
	CHECK_FALSE(street.crowd.has(PersonId(0)));
	street.update(Duration::seconds(0.5));
	REQUIRE(street.crowd.bodies().size() == 1);
	CHECK(street.crowd.bodies()[0].position.x < 2.6f);
	CHECK(street.crowd.pick({ 2.1f, 5, 0 }, { 0, -1, 0 }, 100.0f) == PersonId::Invalid);
	street.crowd.spawn_agent(PersonId(0), { 0, 0, 0 });
	CHECK(street.crowd.bodies().size() == 1);
	CHECK(street.body(0).position.x > 1.5f);
	street.crowd.free_agent(PersonId(0));
	for (int step = 1; step <= 60; ++step) {
		street.update(Duration::seconds(0.5) + Duration{ step * 100 });
	}
	CHECK(street.crowd.bodies().empty());
}

TEST_CASE("who follows its person indoors gets no scene any more, and who steps out again needs a new one") {
	Street street;
	street.limits = { .agent_distance = 100.0f };
	street.crowd.spawn_agent(PersonId(0), { 0, 0, 0 });
	street.update({});
	street.crowd.set_scene(0, false, false);
	street.push(0, { 3, 0, 0 });
	street.crowd.free_agent(PersonId(0));
	street.update(Duration::seconds(0.1));
	CHECK(street.crowd.level(0) == DetailLevel::Figure);
	CHECK(street.crowd.new_agents().empty());
	street.crowd.spawn_agent(PersonId(0), { 0, 0, 0 });
	street.update(Duration::seconds(0.2));
	REQUIRE(street.crowd.new_agents().size() == 1);
	CHECK_FALSE(street.body(0).has_scene);
}

TEST_CASE("a jump in time puts everybody where they belong") {
	Street street;
	street.crowd.spawn_agent(PersonId(0), { 0, 0, 0 });
	street.crowd.spawn_agent(PersonId(1), { 5, 0, 0 });
	street.update({});
	street.push(0, { 3, 0, 0 });
	street.push(1, { 9, 0, 0 });
	street.crowd.free_agent(PersonId(1));
	street.update(Duration::hours(-2));
	CHECK(street.crowd.bodies().size() == 1);
	CHECK(street.body(0).position == glm::vec3(0.0f));
}

TEST_CASE("a ray picks whom it meets first") {
	Street street;
	street.crowd.spawn_agent(PersonId(0), { 0, 0, 0 });
	street.crowd.spawn_agent(PersonId(1), { 0, 0, -3 });
	street.update({});
	CHECK(street.crowd.pick({ 0, 1, 10 }, { 0, 0, -1 }, 100.0f) == PersonId(0));
	CHECK(street.crowd.pick({ 0, 1, -10 }, { 0, 0, 1 }, 100.0f) == PersonId(1));
	CHECK(street.crowd.pick({ 0, 1, 10 }, { 0, 0, 1 }, 100.0f) == PersonId::Invalid);
	CHECK(street.crowd.pick({ 0, 1, 10 }, { 0, 0, -1 }, 5.0f) == PersonId::Invalid);
	CHECK(street.crowd.pick({ 2, 1, 10 }, { 0, 0, -1 }, 100.0f) == PersonId::Invalid);
}
