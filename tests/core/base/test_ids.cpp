#include <doctest/doctest.h>

#include <limits>

#include "core/base/ids.h"

using namespace pcg;

TEST_CASE("numbers of the rule language become ids only when they name one") {
	CHECK(to_id<PersonId>(2.0, 3) == PersonId(2));
	CHECK(to_id<PersonId>(3.0, 3) == PersonId::Invalid);
	CHECK(to_id<PersonId>(-1.0, 3) == PersonId::Invalid);
	CHECK(to_id<PersonId>(0.5, 3) == PersonId::Invalid);
	CHECK(to_id<PersonId>(std::numeric_limits<double>::quiet_NaN(), 3) == PersonId::Invalid);
	CHECK(to_number(PersonId::Invalid) == -1.0);
}
