#include <doctest/doctest.h>

#include "core/io/obj.h"

using namespace pcg;

TEST_CASE("faces of an OBJ file become polygons, whatever else stands in it") {
	Diagnostics diagnostics;
	const auto obj = parse_obj("# a footprint\r\nmtllib a.mtl\r\no lot\r\nv 0 0 0\r\nv 10.5 0 0\nv 10.5 0 -2e1\n  v 0 0 -20 # last\nvn 0 1 0\nvt 0 0\n"
							   "usemtl grass\nf 1//1 2/1/1 3/1 4\nf -4 -3 -2\n",
			"lot.obj", diagnostics);
	REQUIRE(obj.has_value());
	CHECK(diagnostics.is_empty());
	REQUIRE(obj->faces.size() == 2);
	CHECK(obj->faces[0] == std::vector<glm::dvec3>{ { 0, 0, 0 }, { 10.5, 0, 0 }, { 10.5, 0, -20 }, { 0, 0, -20 } });
	CHECK(obj->faces[1] == std::vector<glm::dvec3>{ { 0, 0, 0 }, { 10.5, 0, 0 }, { 10.5, 0, -20 } });
}

TEST_CASE("a face has texture coordinates if all of its corners do") {
	Diagnostics diagnostics;
	const auto obj = parse_obj("v 0 0 0\nv 60 0 0\nv 60 0 -12\nv 0 0 -12\nvt 0 0\nvt 10 0\nvt 10 4\nvt 0 4\nf 1/1 2/2 3/3 4/4\nf 1/1 2 3/3\n", "street.obj",
			diagnostics);
	REQUIRE(obj.has_value());
	REQUIRE(obj->uvs.size() == 2);
	CHECK(obj->uvs[0] == std::vector<glm::dvec2>{ { 0, 0 }, { 10, 0 }, { 10, 4 }, { 0, 4 } });
	CHECK(obj->uvs[1].empty());
}

TEST_CASE("what is wrong in an OBJ file is told with its line") {
	const auto refused = [](std::string_view text, uint32_t line, std::string_view message) {
		Diagnostics diagnostics;
		CHECK_FALSE(parse_obj(text, "lot.obj", diagnostics).has_value());
		REQUIRE(diagnostics.error_count() >= 1);
		CHECK(diagnostics.list()[0].line == line);
		CHECK(diagnostics.list()[0].message.find(message) != std::string::npos);
	};
	refused("v 0 0 0\nv 1 x 0\n", 2, "three numbers");
	refused("v 0 0 0\nv 1 0\n", 2, "three numbers");
	refused("v nan 0 0\n", 1, "three numbers");
	refused("v 0 0 1e300\n", 1, "three numbers");
	refused("v 0 0 0\nv 1 0 0\nv 1 0 1\nf 1 2 4\n", 4, "one of the 3 vertices");
	refused("v 0 0 0\nf 0 0 0\n", 2, "one of the 1 vertices");
	refused("v 0 0 0\nf -2 1 1\n", 2, "`-2` is not");
	refused("v 0 0 0\nf 1 99999999999999999999 1\n", 2, "is not one of");
	refused("v 0 0 0\nv 1 0 0\nf 1 2\n", 3, "three corners");
	refused("", 0, "no face");
	refused("v 0 0 0\n", 0, "no face");
	refused(std::string_view("\0\xFF\x01v f\n\n", 7), 0, "no face");
}

TEST_CASE("a file of other things gives few errors, not one for each line") {
	std::string text;
	for (int i = 0; i < 100000; ++i) {
		text += "f a b c\n";
	}
	Diagnostics diagnostics;
	CHECK_FALSE(parse_obj(text, "lot.obj", diagnostics).has_value());
	CHECK(diagnostics.error_count() == 20);
}

TEST_CASE("a missing OBJ file is an error that names it") {
	Diagnostics diagnostics;
	CHECK_FALSE(load_obj("no/such.obj", diagnostics).has_value());
	CHECK(diagnostics.list()[0].file == "no/such.obj");
}
