#include <doctest/doctest.h>

#include "tests/core/lang/test_dialects.h"

using namespace pcg;
using namespace pcg::test;

namespace {

// The value of an expression as text; names may be defined behind it.
std::string value_of(const std::string &expression, const std::string &definitions = {}) {
	return run_shape("Start --> log(\"\" + (" + expression + "))\n" + definitions);
}

} // namespace

// The values are those of the CGA reference, func_array and func_colon.
TEST_CASE("arrays are made of values, ranges and arrays, side by side and one above the other") {
	CHECK(value_of("[\"B\", \"C\", \"D\"]") == "(3)[B,C,D]");
	CHECK(value_of("[\"A\", a, \"E\"]", "a = [\"B\", \"C\"]") == "(4)[A,B,C,E]");
	CHECK(value_of("[-1 ; -2]") == "(2x1)\n   -1\n   -2");
	CHECK(value_of("[0:2 ; 3, 3, 3]") == "(2x3)\n   0   1   2\n   3   3   3");
	CHECK(value_of("[a, b ; b, a]", "a = [-1 ; -2] b = [0:2 ; 3, 3, 3]") ==
			"(4x4)\n   -1   0   1    2\n   -2   3   3    3\n    0   1   2   -1\n    3   3   3   -2");
}

TEST_CASE("a range ends at its limit, and goes down with a negative step") {
	CHECK(value_of("[2:4]") == "(3)[2,3,4]");
	CHECK(value_of("[0.5:3]") == "(3)[0.5,1.5,2.5]");
	CHECK(value_of("[4:2]") == "(0)[]");
	CHECK(value_of("[1:0.5:3]") == "(5)[1,1.5,2,2.5,3]");
	CHECK(value_of("[4:-1:2]") == "(3)[4,3,2]");
	CHECK(value_of("[1:-0.5:2]") == "(0)[]");
	CHECK(value_of("[1:-0.5:1]") == "(1)[1]");
	CHECK(value_of("[1:0:1]") == "(0)[]");
	CHECK(value_of("[0:0.15:0.5]") == "(4)[0,0.15,0.3,0.45]");
}

TEST_CASE("arrays are indexed by numbers, arrays and truth values") {
	const std::string a = "a = [1,2,3,4] m = [1,2,3; 4,5,6; 7,8,9]";
	CHECK(value_of("a[3]", a) == "4");
	CHECK(value_of("m[1, 1]", a) == "5");
	CHECK(value_of("a[[0,2]]", a) == "(2)[1,3]");
	CHECK(value_of("a[3:-1:1]", a) == "(3)[4,3,2]");
	CHECK(value_of("a[[0,1; 2,3]]", a) == "(2x2)\n   1   2\n   3   4");
	CHECK(value_of("m[1, [0,2]]", a) == "(2)[4,6]");
	CHECK(value_of("m[[0,0,1], 2]", a) == "(3x1)\n   3\n   3\n   6");
	CHECK(value_of("m[0:2, [0,2]]", a) == "(3x2)\n   1   3\n   4   6\n   7   9");
	CHECK(value_of("a[[true,false,true]]", a) == "(2)[1,3]");
	CHECK(value_of("a[a .> 1 .&& a .<= 3]", a) == "(2)[2,3]");
	CHECK(value_of("m[[false,true,true], 0]", a) == "(2x1)\n   4\n   7");
	CHECK(value_of("m[3]", a) == "4"); // a flat array has one index for all
}

TEST_CASE("what lies outside of an array is 0, false or nothing") {
	const std::string a = "a = [1,2,3,4] m = [1,2,3; 4,5,6; 7,8,9]";
	CHECK(value_of("a[-1]", a) == "0");
	CHECK(value_of("a[[false,false,true,true,true]]", a) == "(3)[3,4,0]");
	CHECK(value_of("m[[2,3], -1:1]", a) == "(2x3)\n   0   7   8\n   0   0   0");
	CHECK(value_of("[true][5]", a) == "false");
	CHECK(value_of("\"<\" + [\"x\"][5] + \">\"", a) == "<>");
	CHECK(run_day("Start --> log([1, 2][2])") == "failed index-range 1:21"); // strict
}

TEST_CASE("operators with a dot go element by element") {
	CHECK(value_of("[1,2] .+ 1") == "(2)[2,3]");
	CHECK(value_of("1 .+ [1;2]") == "(2x1)\n   2\n   3");
	CHECK(value_of("[1,2] .+ [2,1]") == "(2)[3,3]");
	CHECK(value_of("3 .- [1,2]") == "(2)[2,1]");
	CHECK(value_of(".-[1,-2]") == "(2)[-1,2]");
	CHECK(value_of("-4 .* [0.25,-0.75,-1]") == "(3)[-1,3,4]");
	CHECK(value_of("12 ./ [2,3,4]") == "(3)[6,4,3]");
	CHECK(value_of("[8,-5,0] .% 3") == "(3)[2,-2,0]");
	CHECK(value_of("1 .== [1,2]") == "(2)[true,false]");
	CHECK(value_of("[\"a\",\"b\"] .!= \"b\"") == "(2)[true,false]");
	CHECK(value_of("[1,2;2,1] .< [2,1;1,2]") == "(2x2)\n    true   false\n   false    true");
	CHECK(value_of("[\"a\",\"b\"] .+ 1") == "(2)[a1,b1]");
	CHECK(value_of("[true,false] .+ \"a\"") == "(2)[truea,falsea]");
	CHECK(value_of(".![true,false]") == "(2)[false,true]");
	CHECK(value_of("[true,false] .|| true") == "(2)[true,true]");
	CHECK(value_of("[true,false] .&& [false,true]") == "(2)[false,false]");
	CHECK(value_of("1.==1") == "true"); // 1 .== 1
}

TEST_CASE("whole arrays are compared row by row") {
	CHECK(value_of("[1,2] == [1,2]") == "true");
	CHECK(value_of("[\"a\",\"b\"] == [\"a\";\"b\"]") == "false");
	CHECK(value_of("[1,2] < [1,3]") == "true");
	CHECK(value_of("[\"a\",\"b\"] < [\"a\";\"b\"]") == "false");
	CHECK(value_of("[\"a\";\"b\"] <= [\"a\"]") == "false");
	CHECK(value_of("[1,2,3] >= [1,2]") == "true");
}

TEST_CASE("arrays that do not fit are told, and the run goes on") {
	CHECK(run_shape("Start --> log([1,2] .+ [1,2,3]) log(1)") == "(0)[] 1");
	CHECK(run_shape("Start --> log([[1;2], 3]) log(1)") == "(0)[] 1");
	CHECK(run_shape("Start --> log([1, \"a\"]) log(1)") == "(0)[] 1");
	CHECK(run_shape("Start --> log([0 : 1000000]) log(1)") == "(0)[] 1"); // more than 100000 elements
}

TEST_CASE("arrays with functions that call themselves") {
	CHECK(value_of("fibonacci(10)", "fibonacci(n) = fibonacci([0,1], n, 2)\n"
									"fibonacci(a, n, size) = case size == n : a else : fibonacci([a, a[size-2] + a[size-1]], n, size + 1)") ==
			"(10)[0,1,1,2,3,5,8,13,21,34]");
}
