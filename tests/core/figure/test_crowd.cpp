#include <doctest/doctest.h>

#include "core/figure/crowd.h"

using namespace pcg;

namespace {

struct Street {
	Population population;
	SimTime now = SimTime::at(0, Duration::hours(8));
	Crowd crowd{ population, [this] { return now; } };

	Street() {
		population.households.push_back({ .first_member = PersonId(0), .member_count = 2, .hair_color = 3 });
		population.persons.push_back({ .household = HouseholdId(0), .age = 40.0f, .gender = Gender::Woman, .clothes_color = 0 });
		population.persons.push_back({ .household = HouseholdId(0), .age = 7.0f, .gender = Gender::Man, .clothes_color = 1 });
	}
};

} // namespace

TEST_CASE("a body is where its speed brings it along the path, and stands at the end") {
	Street street;
	const glm::vec3 path[] = { { 0, 0, 0 }, { 10, 0, 0 }, { 10, 0, 5 } };
	street.crowd.spawn_agent(PersonId(0), path[0]);
	street.crowd.walk_agent(PersonId(0), path, 2.0f);
	street.crowd.update(street.now + Duration::seconds(3)); // 6 m
	CHECK(street.crowd.position(PersonId(0)).x == doctest::Approx(6.0f));
	street.crowd.update(street.now + Duration::seconds(6)); // 12 m: two beyond the corner
	CHECK(street.crowd.position(PersonId(0)).x == doctest::Approx(10.0f));
	CHECK(street.crowd.position(PersonId(0)).z == doctest::Approx(2.0f));
	const std::vector<float> &numbers = street.crowd.instances(looks_of(street.population, PersonId(0)).kind);
	REQUIRE(numbers.size() == crowd_stride);
	CHECK(numbers[16] == doctest::Approx(12.0f));
	CHECK(numbers[17] == 1.0f);
	// The figure's front is its -z axis (third column of the matrix): along +z on the last stretch.
	CHECK(numbers[2] == doctest::Approx(0.0f));
	CHECK(numbers[10] == doctest::Approx(-1.0f));
	street.crowd.update(street.now + Duration::seconds(60));
	CHECK(street.crowd.position(PersonId(0)).z == doctest::Approx(5.0f));
	CHECK(numbers[17] == 0.0f);
}

TEST_CASE("going back in time walks the path from its start") {
	Street street;
	const glm::vec3 path[] = { { 0, 0, 0 }, { 10, 0, 0 }, { 20, 0, 0 } };
	street.crowd.spawn_agent(PersonId(1), path[0]);
	street.crowd.walk_agent(PersonId(1), path, 1.0f);
	street.crowd.update(street.now + Duration::seconds(15));
	street.crowd.update(street.now + Duration::seconds(4));
	CHECK(street.crowd.position(PersonId(1)).x == doctest::Approx(4.0f));
}

TEST_CASE("a freed body leaves the others in place") {
	Street street;
	street.crowd.spawn_agent(PersonId(0), { 1, 0, 0 });
	street.crowd.spawn_agent(PersonId(1), { 2, 0, 0 });
	street.crowd.free_agent(PersonId(0));
	street.crowd.free_agent(PersonId(0)); // once more changes nothing
	street.crowd.update(street.now);
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
