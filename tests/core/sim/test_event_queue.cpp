#include <doctest/doctest.h>

#include <set>

#include "core/base/random.h"
#include "core/sim/event_queue.h"

using namespace pcg;

namespace {

constexpr int64_t hour = 3'600'000;

// What comes out of both up to that time must be the same.
void drain(EventQueue &queue, std::multiset<Due> &expected, SimTime until) {
	for (Due due; queue.pop_until(until, due); expected.erase(expected.begin())) {
		REQUIRE(!expected.empty());
		REQUIRE(due.time == expected.begin()->time);
		REQUIRE(due.person == expected.begin()->person);
		REQUIRE(due.time <= until);
	}
	REQUIRE((expected.empty() || expected.begin()->time > until));
}

} // namespace

TEST_CASE("moments come out of the heap by time, then by person, however they went in") {
	DueHeap heap;
	Random random(7);
	for (int i = 0; i < 2000; ++i) {
		heap.push({ SimTime{ int64_t(random.index(50)) }, PersonId(uint32_t(random.index(40))) });
	}
	Due last = heap.pop();
	for (int i = 1; i < 2000; ++i) {
		const Due due = heap.pop();
		REQUIRE(!(due < last));
		last = due;
	}
	CHECK(heap.is_empty());
}

TEST_CASE("moments come out of the calendar by time, then by person: near, far, all at once, and before their time") {
	for (uint64_t seed = 1; seed <= 20; ++seed) {
		EventQueue queue;
		std::multiset<Due> expected;
		Random random(seed);
		int64_t now = (int64_t(random.index(200)) - 100) * hour; // days before the first one, too
		queue.clear(SimTime{ now });
		for (int step = 0; step < 400; ++step) {
			const int64_t reach = step % 7 == 0 ? 1000 * hour : step % 3 == 0 ? 30 * hour : 5000;
			for (size_t i = random.index(40); i > 0; --i) {
				const int64_t away = step % 5 == 0 ? 2 * hour : int64_t(random.index(size_t(reach)));
				const Due due{ SimTime{ now + away - 10 }, PersonId(uint32_t(random.index(30))) };
				queue.push(due);
				expected.insert(due);
			}
			now += step % 50 == 0 ? 40 * hour : int64_t(random.index(size_t(hour)));
			drain(queue, expected, SimTime{ now });
		}
		drain(queue, expected, SimTime{ now + 2000 * hour });
		CHECK(expected.empty());
	}
}

TEST_CASE("a calendar that was cleared knows nothing of before, at any time") {
	EventQueue queue;
	queue.clear(SimTime{ 0 });
	for (int64_t i = 0; i < 100; ++i) {
		queue.push({ SimTime{ i * hour }, PersonId(0) });
	}
	Due due;
	CHECK(queue.pop_until(SimTime{ 50 * hour }, due));
	queue.clear(SimTime{ -70 * hour });
	CHECK_FALSE(queue.pop_until(SimTime{ 1000 * hour }, due));
	queue.clear(SimTime{ -70 * hour });
	queue.push({ SimTime{ -69 * hour }, PersonId(5) });
	CHECK_FALSE(queue.pop_until(SimTime{ -69 * hour - 1 }, due));
	REQUIRE(queue.pop_until(SimTime{ -69 * hour }, due));
	CHECK(due.person == PersonId(5));
}
