#include <doctest/doctest.h>

#include <string>

#include "core/base/regex.h"

using namespace pcg;

TEST_CASE("wildcards stand for any characters, and the whole text must fit") {
	CHECK(matches_wildcard("*.png", "a/b.png"));
	CHECK(matches_wildcard("a?c", "abc"));
	CHECK(matches_wildcard("*", ""));
	CHECK(matches_wildcard("a*b*c", "a1b2b3c"));
	CHECK_FALSE(matches_wildcard("?.png", "ab.png"));
	CHECK_FALSE(matches_wildcard("*.png", "a.png2"));
	CHECK_FALSE(matches_wildcard("a*b", "ac"));
	CHECK_FALSE(matches_wildcard(std::string(60, '*') + "x", std::string(10'000, 'a')));
}

TEST_CASE("regular expressions as file searches use them") {
	const auto fits = [](std::string_view pattern, std::string_view text) {
		const auto regex = Regex::compile(pattern);
		REQUIRE(regex.has_value());
		return regex->matches_all(text);
	};
	CHECK(fits("textures/[12].png", "textures/2.png"));
	CHECK_FALSE(fits("textures/[12].png", "textures/3.png"));
	CHECK(fits("[^a-c]+", "xyz"));
	CHECK_FALSE(fits("[^a-c]+", "xbz"));
	CHECK(fits("a|bc|d", "bc"));
	CHECK(fits("(ab)*c?", "ababc"));
	CHECK(fits("(?:x|y){2,3}", "xyx"));
	CHECK_FALSE(fits("(?:x|y){2,3}", "x"));
	CHECK_FALSE(fits("x{2}", "xxx"));
	CHECK(fits("x{2,}", "xxxx"));
	CHECK(fits("\\d+\\.\\w*", "12.ab_3"));
	CHECK(fits("^a.$", "ab"));
	CHECK(fits("", ""));
	CHECK(fits("(a*)*b", std::string(5000, 'a') + "b")); // no engine that tries all ways would end
	CHECK_FALSE(fits("(a*)*b", std::string(5000, 'a')));
}

TEST_CASE("the longest match from a place is found") {
	const auto regex = Regex::compile("[0-9]+");
	REQUIRE(regex.has_value());
	CHECK(regex->match_at("ab123c", 2) == 3);
	CHECK(regex->match_at("ab123c", 0) == std::string_view::npos);
}

TEST_CASE("patterns that are wrong or too large are refused") {
	for (const std::string &pattern : { std::string("("), std::string("a)"), std::string("[a"), std::string("*"), std::string("a{2"), std::string("a{3,1}"), std::string("\\"),
				 std::string(200, '(') + std::string(200, ')'), std::string("(a{999}){999}"), std::string("((((a{99}){99}){99}){99}){99}") }) {
		CHECK_FALSE(Regex::compile(pattern).has_value());
	}
}
