#include <doctest/doctest.h>

#include <array>
#include <vector>

#include "core/agenda/agenda.h"
#include "core/base/random.h"

using namespace pcg;

namespace {

constexpr int32_t minute_ms = 60'000;
constexpr int32_t hour_ms = 60 * minute_ms;
constexpr int day_minutes = 1440;
constexpr int week_minutes = 7 * day_minutes;

Task task_of(int32_t start_ms, int32_t end_ms, uint32_t target, DayMask days = all_days) {
	Task task;
	task.start_ms = start_ms;
	task.end_ms = end_ms;
	task.target = target;
	task.origin = target;
	task.days = days;
	return task;
}

// The same rules minute by minute: who owns each minute of the week, 0 = nobody.
class MinuteModel {
public:
	void insert(int start_minute, int length, DayMask days, uint32_t owner) {
		for (int day = 0; day < 7; ++day) {
			if (!((days >> day) & 1)) {
				continue;
			}
			for (int i = 0; i < length; ++i) {
				const int minute = ((day * day_minutes + start_minute + i) % week_minutes + week_minutes) % week_minutes;
				_owner[size_t(minute)] = owner;
			}
		}
	}
	uint32_t owner(int minute) const { return _owner[size_t(minute)]; }

private:
	std::array<uint32_t, week_minutes> _owner{};
};

// The same picture from the entries; counts how often a minute is claimed twice.
std::array<uint32_t, week_minutes> owners_of(const Agenda &agenda, int &claimed_twice) {
	std::array<uint32_t, week_minutes> owners{};
	for (const Task &task : agenda.tasks()) {
		for (int day = 0; day < 7; ++day) {
			if (!((task.days >> day) & 1)) {
				continue;
			}
			for (int32_t t = task.start_ms; t < task.end_ms; t += minute_ms) {
				uint32_t &owner = owners[size_t((day * day_minutes + t / minute_ms) % week_minutes)];
				claimed_twice += owner != 0;
				owner = task.target;
			}
		}
	}
	return owners;
}

bool is_sorted_and_in_range(const Agenda &agenda) {
	const Task *previous = nullptr;
	for (const Task &task : agenda.tasks()) {
		if (task.start_ms < 0 || task.start_ms >= 24 * hour_ms || task.end_ms <= task.start_ms ||
				task.end_ms > task.start_ms + 24 * hour_ms || task.days == 0 || task.days > all_days) {
			return false;
		}
		if (previous && previous->start_ms > task.start_ms) {
			return false;
		}
		previous = &task;
	}
	return true;
}

} // namespace

TEST_CASE("a newer entry in the middle splits the older one in two") {
	Agenda agenda;
	CHECK(agenda.insert(task_of(0, 24 * hour_ms, 1)));
	CHECK(agenda.insert(task_of(8 * hour_ms, 16 * hour_ms, 2)));
	REQUIRE(agenda.tasks().size() == 3);
	CHECK(agenda.tasks()[0].end_ms == 8 * hour_ms);
	CHECK(agenda.tasks()[1].target == 2);
	CHECK(agenda.tasks()[2].start_ms == 16 * hour_ms);
	CHECK(agenda.tasks()[2].end_ms == 24 * hour_ms);
	CHECK(!agenda.tasks()[0].is_start_cut);
	CHECK(!agenda.tasks()[1].is_start_cut);
	CHECK(agenda.tasks()[2].is_start_cut);
}

TEST_CASE("a cut start stays cut, on whichever day the rest begins") {
	Agenda agenda;
	agenda.insert(task_of(20 * hour_ms, 44 * hour_ms, 1, 0b0000001)); // Monday 20h to Tuesday 20h
	agenda.insert(task_of(22 * hour_ms, 26 * hour_ms, 2, 0b0000001)); // Monday 22h to Tuesday 2h
	agenda.insert(task_of(10 * hour_ms, 11 * hour_ms, 3, 0b0000010)); // Tuesday
	CHECK(!agenda.at(0, Duration::hours(21))->is_start_cut);
	CHECK(agenda.at(1, Duration::hours(9))->target == 1);
	CHECK(agenda.at(1, Duration::hours(9))->is_start_cut);
	CHECK(agenda.at(1, Duration::hours(12))->is_start_cut);
}

TEST_CASE("a newer entry trims the start or the end of an older one and keeps its building") {
	Agenda agenda;
	Task walk = task_of(8 * hour_ms, 10 * hour_ms, 7);
	walk.kind = TaskKind::GoToBuilding;
	agenda.insert(walk);
	agenda.insert(task_of(7 * hour_ms, 9 * hour_ms, 2));
	REQUIRE(agenda.tasks().size() == 2);
	CHECK(agenda.tasks()[1].start_ms == 9 * hour_ms);
	CHECK(agenda.tasks()[1].kind == TaskKind::GoToBuilding);
	CHECK(agenda.tasks()[1].target == 7);
}

TEST_CASE("an entry that is wholly covered is deleted") {
	Agenda agenda;
	agenda.insert(task_of(8 * hour_ms, 10 * hour_ms, 1));
	agenda.insert(task_of(7 * hour_ms, 11 * hour_ms, 2));
	REQUIRE(agenda.tasks().size() == 1);
	CHECK(agenda.tasks()[0].target == 2);
}

TEST_CASE("entries that touch leave one another alone") {
	Agenda agenda;
	agenda.insert(task_of(8 * hour_ms, 10 * hour_ms, 1));
	agenda.insert(task_of(10 * hour_ms, 11 * hour_ms, 2));
	agenda.insert(task_of(7 * hour_ms, 8 * hour_ms, 3));
	REQUIRE(agenda.tasks().size() == 3);
	CHECK(agenda.tasks()[1].end_ms == 10 * hour_ms);
}

TEST_CASE("an entry past midnight is stored whole and cuts the morning of the next day") {
	Agenda agenda;
	agenda.insert(task_of(0, 24 * hour_ms, 1));
	agenda.insert(task_of(22 * hour_ms, 30 * hour_ms, 2, 0b0010000)); // Friday night until Saturday 6h
	CHECK(agenda.at(4, Duration::hours(23))->target == 2);
	CHECK(agenda.at(5, Duration::hours(5))->target == 2);
	CHECK(agenda.at(5, Duration::hours(6))->target == 1);
	CHECK(agenda.at(4, Duration::hours(5))->target == 1);
	CHECK(agenda.at(6, Duration::hours(5))->target == 1);
}

TEST_CASE("Sunday night runs into Monday morning: the week is a circle") {
	Agenda agenda;
	agenda.insert(task_of(22 * hour_ms, 26 * hour_ms, 2, 0b1000000));
	CHECK(agenda.at(0, Duration::hours(1))->target == 2);
	CHECK(agenda.at(0, Duration::hours(2)) == nullptr);
}

TEST_CASE("a start before midnight belongs to the day before") {
	Agenda agenda;
	agenda.insert(task_of(-1 * hour_ms, 1 * hour_ms, 3, 0b0000001));
	REQUIRE(agenda.tasks().size() == 1);
	CHECK(agenda.tasks()[0].start_ms == 23 * hour_ms);
	CHECK(agenda.tasks()[0].end_ms == 25 * hour_ms);
	CHECK(agenda.tasks()[0].days == 0b1000000);
}

TEST_CASE("pieces that are equal but for their days become one entry again") {
	Agenda agenda;
	agenda.insert(task_of(0, 24 * hour_ms, 1));
	for (int day = 0; day < 7; ++day) {
		agenda.insert(task_of(8 * hour_ms, 9 * hour_ms, 2, DayMask(1u << day)));
	}
	REQUIRE(agenda.tasks().size() == 3);
	CHECK(agenda.tasks()[0].days == all_days);
	CHECK(agenda.tasks()[1].days == all_days);
}

TEST_CASE("an entry without length, without days or longer than a day changes nothing") {
	Agenda agenda;
	agenda.insert(task_of(0, hour_ms, 1));
	CHECK_FALSE(agenda.insert(task_of(hour_ms, hour_ms, 2)));
	CHECK_FALSE(agenda.insert(task_of(2 * hour_ms, hour_ms, 2)));
	CHECK_FALSE(agenda.insert(task_of(0, hour_ms, 2, 0)));
	CHECK_FALSE(agenda.insert(task_of(0, 24 * hour_ms + 1, 2)));
	CHECK_FALSE(agenda.insert(task_of(INT32_MIN, INT32_MAX, 2)));
	REQUIRE(agenda.tasks().size() == 1);
	CHECK(agenda.tasks()[0].target == 1);
}

namespace {

// `is_plain`: entries of all days within one day, which are inserted by a shorter way until the first other one comes.
void insert_at_random(Random &random, int rounds, double is_plain) {
	for (int round = 0; round < rounds; ++round) {
		Agenda agenda;
		MinuteModel model;
		const uint32_t insertions = 2 + uint32_t(random.index(14));
		for (uint32_t owner = 1; owner <= insertions; ++owner) {
			const bool plain = random.chance(is_plain);
			const int start = plain ? int(random.index(day_minutes)) : int(random.index(5 * day_minutes)) - 2 * day_minutes;
			const int longest = plain ? day_minutes - start : day_minutes;
			const int length = random.chance(0.1) ? longest : 1 + int(random.index(size_t(longest)));
			const DayMask days = plain || random.chance(0.3) ? all_days : DayMask(1 + random.index(127));
			REQUIRE(agenda.insert(task_of(start * minute_ms, (start + length) * minute_ms, owner, days)));
			model.insert(start, length, days, owner);
		}
		REQUIRE(is_sorted_and_in_range(agenda));
		int claimed_twice = 0;
		const auto owners = owners_of(agenda, claimed_twice);
		CHECK(claimed_twice == 0);
		int differences = 0;
		for (int minute = 0; minute < week_minutes; ++minute) {
			differences += owners[size_t(minute)] != model.owner(minute);
			const Task *task = agenda.at(minute / day_minutes, Duration::minutes(minute % day_minutes));
			differences += (task ? task->target : 0) != model.owner(minute);
		}
		CHECK(differences == 0);
		int newest_pieces = 0;
		for (const Task &task : agenda.tasks()) {
			newest_pieces += task.target == insertions;
		}
		CHECK(newest_pieces == 1);
	}
}

} // namespace

TEST_CASE("random insertions: sorted, disjoint, the newest whole, nothing lost that was not overlapped") {
	Random random(20231, 5);
	insert_at_random(random, 150, 0.0);
	insert_at_random(random, 60, 0.9);
	insert_at_random(random, 60, 1.0);
}
