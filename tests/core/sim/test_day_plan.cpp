#include <doctest/doctest.h>

#include "core/sim/day_plan.h"
#include "tests/core/sim/town.h"

using namespace pcg;
using namespace pcg::test;

namespace {

constexpr DayMask monday = 1;
constexpr DayMask sunday = 1 << 6;

Task entry(int32_t start, int32_t end, DayMask days) {
	Task task;
	task.start_ms = start;
	task.end_ms = end;
	task.days = days;
	return task;
}

} // namespace

TEST_CASE("an entry holds from its start up to its end, on its days only") {
	const Task tasks[] = { entry(at(8), at(16), monday) };
	CHECK(planned_entry_at({ tasks, {} }, moment(0, 8)).task == 0);
	CHECK(planned_entry_at({ tasks, {} }, moment(0, 15, 59)).end == moment(0, 16));
	CHECK(planned_entry_at({ tasks, {} }, moment(0, 16)).is_hole());
	CHECK(planned_entry_at({ tasks, {} }, moment(1, 9)).is_hole());
	CHECK(planned_entry_at({ tasks, {} }, moment(7, 9)).start == moment(7, 8));
}

TEST_CASE("an entry that runs past midnight holds on the morning after, Sunday's on Monday") {
	const Task tasks[] = { entry(at(22), at(30), sunday) };
	const PlannedEntry found = planned_entry_at({ tasks, {} }, moment(7, 3));
	CHECK(!found.is_hole());
	CHECK(found.start == moment(6, 22));
	CHECK(found.end == moment(7, 6));
	CHECK(planned_entry_at({ tasks, {} }, moment(0, 3)).start == moment(-1, 22));
	CHECK(planned_entry_at({ tasks, {} }, moment(1, 3)).is_hole());
}

TEST_CASE("a hole reaches from the entry before to the entry after, over several days") {
	const Task tasks[] = { entry(at(8), at(9), monday), entry(at(20), at(21), monday) };
	const PlannedEntry day = planned_entry_at({ tasks, {} }, moment(0, 12));
	CHECK(day.is_hole());
	CHECK(day.start == moment(0, 9));
	CHECK(day.end == moment(0, 20));
	const PlannedEntry week = planned_entry_at({ tasks, {} }, moment(3, 12));
	CHECK(week.start == moment(0, 21));
	CHECK(week.end == moment(7, 8));
}

TEST_CASE("without any entry all is one hole") {
	const PlannedEntry found = planned_entry_at({}, moment(2, 12));
	CHECK(found.is_hole());
	CHECK(found.end > moment(2, 12));
}

TEST_CASE("a single day stands in place of the week, and what began the evening before goes on") {
	Task night;
	night.start_ms = at(22);
	night.end_ms = at(30);
	Task morning;
	morning.start_ms = at(8);
	morning.end_ms = at(16);
	const Task week[] = { morning, night };
	Task trip = morning;
	trip.start_ms = at(10);
	trip.days = 2; // Tuesday
	const SingleDay days[] = { { 8, { trip } } }; // the second Tuesday
	const AgendaView agenda{ week, days };
	CHECK(planned_entry_at(agenda, moment(1, 9)).start == moment(1, 8));
	CHECK(planned_entry_at(agenda, moment(8, 5)).start == moment(7, 22));
	CHECK(planned_entry_at(agenda, moment(8, 9)).is_hole());
	CHECK(planned_entry_at(agenda, moment(8, 9)).start == moment(8, 6));
	CHECK(planned_entry_at(agenda, moment(8, 9)).end == moment(8, 10));
	CHECK(planned_entry_at(agenda, moment(8, 10)).task == 0);
	CHECK(planned_entry_at(agenda, moment(9, 5)).start == moment(8, 16)); // nobody works that night
	CHECK(planned_entry_at(agenda, moment(9, 5)).end == moment(9, 8));
}
