#include <doctest/doctest.h>

#include "core/sim/reservations.h"

using namespace pcg;

TEST_CASE("each place of an object goes to one person until it is released") {
	CityModel city;
	CityObject bench;
	bench.places.resize(2);
	const ObjectId id = city.add_object(bench);
	Reservations reservations;
	reservations.update(city);
	CHECK(reservations.take(city, id, PersonId(4)) == 0);
	CHECK(reservations.take(city, id, PersonId(5)) == 1);
	CHECK(!reservations.is_free(city, id));
	CHECK(reservations.take(city, id, PersonId(6)) == Reservations::none);
	reservations.release(id, 0);
	CHECK(reservations.holder(id, 0) == PersonId::Invalid);
	CHECK(reservations.holder(id, 1) == PersonId(5));
	CHECK(reservations.take(city, id, PersonId(6)) == 0);
}

TEST_CASE("objects added later are taken in, removed ones are not free, unknown ones neither") {
	CityModel city;
	Reservations reservations;
	reservations.update(city);
	const ObjectId id = city.add_object({});
	CHECK(!reservations.is_free(city, id));
	reservations.update(city);
	CHECK(reservations.is_free(city, id));
	city.remove_object(id);
	CHECK(!reservations.is_free(city, id));
	CHECK(!reservations.is_free(city, ObjectId::Invalid));
}

TEST_CASE("an object that gets or loses places: what is held stays held where its place is left") {
	CityModel city;
	CityObject bench;
	bench.places.resize(3);
	const ObjectId id = city.add_object(bench), other = city.add_object(bench);
	Reservations reservations;
	reservations.update(city);
	for (uint32_t person = 0; person < 3; ++person) {
		CHECK(reservations.take(city, id, PersonId(person)) == person);
	}
	CHECK(reservations.take(city, other, PersonId(7)) == 0);
	bench.places.resize(1);
	city.put_object(id, bench);
	CHECK(!reservations.is_free(city, id));
	reservations.update(city);
	CHECK(reservations.holder(id, 0) == PersonId(0));
	CHECK(reservations.holder(id, 1) == PersonId::Invalid);
	reservations.release(id, 2); // is no more
	CHECK(reservations.holder(other, 0) == PersonId(7));
	CHECK(reservations.take(city, id, PersonId(9)) == Reservations::none);
	bench.places.resize(4);
	city.put_object(id, bench);
	reservations.update(city);
	CHECK(reservations.holder(id, 0) == PersonId(0));
	CHECK(reservations.take(city, id, PersonId(9)) == 1);
	CHECK(reservations.holder(other, 0) == PersonId(7));
}
