#include "core/cga/occluders.h"

#include <doctest/doctest.h>

using namespace pcg;
using namespace pcg::cga;

TEST_CASE("places in a recorded tree are found again, and who is related to whom is known") {
	// 0 -> 1, 2; 1 -> 3, 5; 2 -> 4: children of different shapes are made in turns.
	ShapeTree tree;
	CHECK(tree.add(0) == 1);
	CHECK(tree.add(0) == 2);
	CHECK(tree.add(1) == 3);
	CHECK(tree.add(2) == 4);
	CHECK(tree.add(1) == 5);
	tree.finish();
	CHECK(tree.child({ 0, false }, 1).node == 2);
	CHECK(tree.child({ 1, false }, 1).node == 5);
	CHECK(tree.is_related({ 1, false }, 3)); // made of it
	CHECK(tree.is_related({ 5, false }, 1)); // made from it
	CHECK(tree.is_related({ 4, false }, 0));
	CHECK(tree.is_related({ 3, false }, 3));
	CHECK_FALSE(tree.is_related({ 3, false }, 5)); // sisters
	CHECK_FALSE(tree.is_related({ 1, false }, 4));

	const TreePlace beyond = tree.child({ 1, false }, 2); // the record has no such child
	CHECK(beyond.is_beyond);
	CHECK(beyond.node == 1);
	CHECK(tree.child(beyond, 0).is_beyond);
	CHECK(tree.is_related(beyond, 0)); // its ancestors are still known
	CHECK(tree.is_related(beyond, 1));
	CHECK_FALSE(tree.is_related(beyond, 3)); // a sister in the record
}
