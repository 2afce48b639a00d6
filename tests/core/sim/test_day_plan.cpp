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
	CHECK(planned_entry_at(tasks, moment(0, 8)).task == 0);
	CHECK(planned_entry_at(tasks, moment(0, 15, 59)).end == moment(0, 16));
	CHECK(planned_entry_at(tasks, moment(0, 16)).is_hole());
	CHECK(planned_entry_at(tasks, moment(1, 9)).is_hole());
	CHECK(planned_entry_at(tasks, moment(7, 9)).start == moment(7, 8));
}

TEST_CASE("an entry that runs past midnight holds on the morning after, Sunday's on Monday") {
	const Task tasks[] = { entry(at(22), at(30), sunday) };
	const PlannedEntry found = planned_entry_at(tasks, moment(7, 3));
	CHECK(!found.is_hole());
	CHECK(found.start == moment(6, 22));
	CHECK(found.end == moment(7, 6));
	CHECK(planned_entry_at(tasks, moment(0, 3)).start == moment(-1, 22));
	CHECK(planned_entry_at(tasks, moment(1, 3)).is_hole());
}

TEST_CASE("a hole reaches from the entry before to the entry after, over several days") {
	const Task tasks[] = { entry(at(8), at(9), monday), entry(at(20), at(21), monday) };
	const PlannedEntry day = planned_entry_at(tasks, moment(0, 12));
	CHECK(day.is_hole());
	CHECK(day.start == moment(0, 9));
	CHECK(day.end == moment(0, 20));
	const PlannedEntry week = planned_entry_at(tasks, moment(3, 12));
	CHECK(week.start == moment(0, 21));
	CHECK(week.end == moment(7, 8));
}

TEST_CASE("without any entry all is one hole") {
	const PlannedEntry found = planned_entry_at({}, moment(2, 12));
	CHECK(found.is_hole());
	CHECK(found.end > moment(2, 12));
}
