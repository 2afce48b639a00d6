#include "core/cga/arena.h"

#include <doctest/doctest.h>

#include <cstdint>

using namespace pcg::cga;

TEST_CASE("what is released is handed out again, also across chunks") {
	Arena arena;
	double *first = arena.make(1.5);
	const Arena::Mark mark = arena.mark();
	std::byte *second = arena.allocate<std::byte>(1000);
	arena.allocate<std::byte>(1'000'000); // in a chunk of its own
	const size_t capacity = arena.capacity();
	arena.release(mark);
	CHECK(arena.allocate<std::byte>(1000) == second);
	arena.allocate<std::byte>(1'000'000);
	CHECK(arena.capacity() == capacity);
	CHECK(*first == 1.5);
}

TEST_CASE("memory is aligned for every type, and a mark of an empty arena is its beginning") {
	Arena arena;
	const Arena::Mark empty = arena.mark();
	char *character = arena.make('a');
	const double *number = arena.make(2.0);
	CHECK(reinterpret_cast<uintptr_t>(number) % alignof(double) == 0);
	arena.release(empty);
	CHECK(arena.make('b') == character);
}

TEST_CASE("a scope gives back what was taken within it") {
	Arena arena;
	arena.make(1);
	int *inner = nullptr;
	{
		const ArenaScope scope(arena);
		inner = arena.make(2);
	}
	CHECK(arena.make(3) == inner);
}
