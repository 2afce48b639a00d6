#include <doctest/doctest.h>

#include <limits>

#include "core/base/sim_time.h"

using namespace pcg;

TEST_CASE("the moment before the first day is Sunday evening") {
	const SimTime time = SimTime{} - Duration::minutes(1);
	CHECK(time.day() == -1);
	CHECK(time.weekday() == 6);
	CHECK(clock_text(time.time_of_day()) == "23:59");
}

TEST_CASE("seconds round to the nearest millisecond and refuse what is no number") {
	CHECK(Duration::seconds(1.0005).ms == 1001);
	CHECK(Duration::seconds(-0.0004).ms == 0);
	CHECK(Duration::seconds(std::numeric_limits<double>::quiet_NaN()).ms == 0);
	CHECK(Duration::seconds(std::numeric_limits<double>::infinity()).ms == 0);
	CHECK(Duration::seconds(1e300).ms == 1'000'000'000'000'000);
}

TEST_CASE("clock texts count past midnight and show what lies before it") {
	CHECK(clock_text(Duration::hours(25)) == "25:00");
	CHECK(clock_text(Duration::seconds(-90), true) == "-00:01:30");
}
