#include <doctest/doctest.h>

#include "core/base/random.h"
#include "core/sim/event_queue.h"

using namespace pcg;

TEST_CASE("moments come out by time, then by person, however they went in") {
	EventQueue queue;
	Random random(7);
	for (int i = 0; i < 2000; ++i) {
		queue.push({ SimTime{ int64_t(random.index(50)) }, PersonId(uint32_t(random.index(40))) });
	}
	EventQueue::Due last = queue.pop();
	for (int i = 1; i < 2000; ++i) {
		const EventQueue::Due due = queue.pop();
		REQUIRE(!(due < last));
		last = due;
	}
	CHECK(queue.is_empty());
}
