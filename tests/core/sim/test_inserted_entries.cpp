#include <doctest/doctest.h>

#include "core/sim/day_plan.h"
#include "core/sim/inserted_entries.h"
#include "tests/core/sim/town.h"

using namespace pcg;
using namespace pcg::test;

namespace {

InsertedEntry entry(uint32_t person, SimTime start, SimTime end, uint32_t target) {
	InsertedEntry result;
	result.person = PersonId(person);
	result.start = start;
	result.end = end;
	result.target = target;
	return result;
}

} // namespace

TEST_CASE("the newest inserted entry wins over older ones of the same person") {
	InsertedEntries entries;
	entries.insert(entry(3, moment(0, 8), moment(0, 12), 1));
	entries.insert(entry(2, moment(0, 8), moment(0, 12), 2));
	entries.insert(entry(3, moment(0, 9), moment(0, 10), 3));
	CHECK(entries.of(PersonId(2)).size() == 1);
	REQUIRE(entries.of(PersonId(3)).size() == 3);
	CHECK(entries.at(PersonId(3), moment(0, 8, 59))->target == 1);
	CHECK(entries.at(PersonId(3), moment(0, 9))->target == 3);
	CHECK(entries.at(PersonId(3), moment(0, 10))->target == 1);
	CHECK(entries.at(PersonId(3), moment(0, 10))->is_start_cut);
	CHECK(!entries.at(PersonId(3), moment(0, 8))->is_start_cut);
	CHECK(entries.at(PersonId(3), moment(0, 12)) == nullptr);
	entries.insert(entry(3, moment(0, 7), moment(0, 13), 4));
	CHECK(entries.of(PersonId(3)).size() == 1);
	entries.drop_before(moment(0, 12));
	CHECK(entries.of(PersonId(2)).empty());
	entries.drop(PersonId(3));
	CHECK(entries.is_empty());
}

TEST_CASE("what was inserted cuts the agenda on its day only") {
	Task day;
	day.start_ms = at(8);
	day.end_ms = at(16);
	const InsertedEntry inserted[] = { entry(0, moment(1, 10), moment(1, 11), 7) };
	CHECK(planned_entry_at({ &day, 1 }, inserted, moment(0, 10)).end == moment(0, 16));
	CHECK(planned_entry_at({ &day, 1 }, inserted, moment(1, 9)).end == moment(1, 10));
	CHECK(planned_entry_at({ &day, 1 }, inserted, moment(1, 10)).target == 7);
	CHECK(planned_entry_at({ &day, 1 }, inserted, moment(1, 10)).task == PlannedEntry::inserted);
	const PlannedEntry rest = planned_entry_at({ &day, 1 }, inserted, moment(1, 12));
	CHECK(rest.start == moment(1, 11));
	CHECK(rest.end == moment(1, 16));
	CHECK(rest.is_start_cut);
}

TEST_CASE("entries out of order are refused") {
	InsertedEntries entries;
	CHECK(entries.restore({ entry(1, moment(0, 8), moment(0, 9), 1), entry(1, moment(0, 9), moment(0, 10), 1), entry(2, moment(0, 1), moment(0, 2), 1) }));
	CHECK(entries.all().size() == 3);
	CHECK(!entries.restore({ entry(1, moment(0, 8), moment(0, 9), 1), entry(1, moment(0, 8, 30), moment(0, 10), 1) }));
	CHECK(!entries.restore({ entry(2, moment(0, 8), moment(0, 9), 1), entry(1, moment(0, 8), moment(0, 9), 1) }));
	CHECK(!entries.restore({ entry(1, moment(0, 8), moment(0, 8), 1) }));
	CHECK(entries.all().size() == 3);
}
