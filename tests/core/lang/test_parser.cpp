#include <doctest/doctest.h>

#include "tests/core/lang/test_dialects.h"

using namespace pcg;
using namespace pcg::test;

TEST_CASE("statements need no line ends") {
	CHECK(run_day("a = 1 b = 2 attr c = 3 const d = 4 f(x) = x + 1 Start --> log(a, b, c, d, f(5)) B B --> log(9)") == "1,2,3,4,6 9");
}

TEST_CASE("chains nest, and an outer chain goes on after the else of an inner one") {
	const std::string rules = "Start --> Try(1) Try(2) Try(3) Try(4)\n"
							  "Try(n) --> case n < 3: case n == 1: log(\"one\") else: log(\"two\") case n == 3: log(\"three\") else: log(\"four\")";
	CHECK(run_day(rules) == "one two three four");
	CHECK(check_day("A --> case true: log(1) else: log(2) case true: log(3)") == "unreachable 1:25; syntax 1:38");
	CHECK(run_day("Start --> [ case true: log(1) else: log(2) ] log(3)") == "[ 1 ] 3");
}

TEST_CASE("random branches end where the next share begins") {
	CHECK(run_day("Start --> 0%: log(1) log(2) (50 + 50)% : log(3) log(4) else: log(5)") == "3 4");
	CHECK(run_day("x = 0%: 1 100%: 2 else: 3\nStart --> log(x) log(0) 100%: log(7) else: log(8)") == "2 0 7");
	CHECK(check_day("A --> 60%: log(1) 60%: log(2) else: log(3)") == "shares-above-100 1:7");
}

TEST_CASE("a percent sign is a modulus unless a colon follows") { CHECK(run_day("Start --> log(7 % 4) case 7 % 4 == 3: log(1) else: log(2)") == "3 1"); }

TEST_CASE("an index binds only where it touches") {
	CHECK(run_shape("a = [1, 2, 3]\nStart --> log(a[1]) log(a) [ log(2) ]") == "2 (3)[1,2,3] [ 2 ]");
	CHECK(run_shape("m = [1, 2; 3, 4]\nStart --> log(m[1, 0], m)") == "3,(2x2)\n   1   2\n   3   4");
}

TEST_CASE("a trailing dot makes a leaf, and a comment may follow it at once") {
	CHECK(run_shape("Start --> split(x) { 1: Wall.// note\n | ~1: Wall./* note */ }") == "{ 1: leaf:Wall. ~1: leaf:Wall. }");
}

TEST_CASE("old splits have entries without sizes and blocks of other operations in them") {
	CHECK(run_shape("Start --> split(y) { split(x) { 1: A. }* }") == "{ ~1: { 1: leaf:A. }* }");
	CHECK(run_shape("Start --> split(y) { { ~1: A. | 2: B. }* | { 1: C. } }") == "{ { ~1: leaf:A. 2: leaf:B. }* { 1: leaf:C. } }");
}

TEST_CASE("words that are keywords elsewhere can be names") {
	CHECK(run_shape("attr start = 3 style = 4\nStart --> log(start, style) version\nversion --> log(1)") == "3,4 version 1");
}

TEST_CASE("local values of rules and functions") {
	CHECK(run_shape("f(a) with ( b := a * 2 c := b + 1 ) = c * 10\nStart with ( x := f(1) ) --> log(x) A(x)\nA(n) with ( m := n + 1 ) --> log(m, n)") ==
			"30 A 31,30");
	CHECK(run_day("f(a) with ( b := a * 2 ) = b + a\nStart --> log(f(1), f(2))") == "3,6");
}

TEST_CASE("a mistake is told once and the rest is still read") {
	CHECK(check_day("A --> log(1 +) log(2)\nB --> log(]\nC = \nD --> E") == "syntax 1:14; syntax 2:11; syntax 4:1; unknown-name 4:7");
	CHECK(check_day("A --> members { age < : log(1) | true log(2) }\nB --> log(1") == "syntax 1:23; missing-head 1:34; syntax 2:12");
	CHECK(check_day("A( --> log(1)\nB --> A") == "syntax 1:2");
	CHECK(check_day("A --> ... log(1) ...\nB --> log(1)") == "ellipsis 1:7; ellipsis 1:18");
	CHECK(check_day("== \nA --> log(1)\n)\nB --> log(2)") == "syntax 1:1; syntax 3:1");
}

TEST_CASE("what is missing at the end is shown behind the last token") {
	CHECK(check_day("A --> log(1\n\n\n") == "syntax 1:12");
	CHECK(check_day("A --> [ log(1)\n\n") == "syntax 1:15");
	CHECK(check_day("A -->\n case age > 1") == "syntax 2:14");
}
