#include <doctest/doctest.h>

#include "core/population/household_words.h"

using namespace pcg;

namespace {

// "2 16-64; minor 1+ 0-17": what a descriptor was read as, in short.
std::string read(std::string_view words, int adult_from = adult_age) {
	const Result<HouseholdPattern> pattern = read_household_words(words, adult_from);
	if (!pattern) {
		return "error: " + pattern.diagnostic().message;
	}
	std::string text;
	for (const MemberGroup &group : pattern->groups) {
		text += text.empty() ? "" : "; ";
		text += group.is_minor ? "minor " : "";
		text += group.sex == MemberGroup::Sex::Woman ? "woman " : group.sex == MemberGroup::Sex::Man ? "man " : "";
		text += std::to_string(int(group.count)) + (group.is_open ? "+" : "");
		text += " " + std::to_string(int(group.min_age)) + "-" + std::to_string(int(group.max_age));
	}
	return text;
}

} // namespace

TEST_CASE("the paper's descriptor is read") {
	CHECK(read("one adult woman with two minor children") == "woman 1 18-99; minor 2 0-17");
}

TEST_CASE("the wording of the Spanish census is read") {
	CHECK(read("One woman aged 16-64", 16) == "woman 1 16-64");
	CHECK(read("One man aged 65 or over", 16) == "man 1 65-99");
	CHECK(read("One adult woman with one or more minors", 16) == "woman 1 16-99; minor 1+ 0-15");
	CHECK(read("Two adults aged 16-64, no minors", 16) == "2 16-64");
	CHECK(read("Two adults, at least one aged 65 or over, no minors", 16) == "1 65-99; 1 16-99");
	CHECK(read("Two adults and three or more minors", 16) == "2 16-99; minor 3+ 0-15");
	CHECK(read("Two adults aged 35+, one aged 16-34, no minors", 16) == "2 35-99; 1 16-34");
	CHECK(read("Two adults aged 35+, two aged 16-34 and two or more minors", 16) == "2 35-99; 2 16-34; minor 2+ 0-15");
	CHECK(read("Other household of three adults, with or without minors", 16) == "3 16-99; minor 0+ 0-15");
	CHECK(read("Five or more adults, with or without minors", 16) == "5+ 16-99; minor 0+ 0-15");
}

TEST_CASE("the wording of the American Community Survey is read") {
	CHECK(read("Married-couple household, with own children under 18") == "woman 1 18-99; man 1 18-99; minor 1+ 0-17");
	CHECK(read("Cohabiting couple household without children") == "woman 1 18-99; man 1 18-99");
	CHECK(read("Male householder, no spouse/partner, living alone, 65 and over") == "man 1 65-99");
	CHECK(read("Female householder, no spouse/partner present, with own children under 18") == "woman 1 18-99; minor 1+ 0-17");
}

TEST_CASE("everyday wording is read") {
	CHECK(read("single mother with a son and two daughters") == "woman 1 18-99; minor man 1 0-17; minor woman 2 0-17");
	CHECK(read("Elderly couple") == "woman 1 65-99; man 1 65-99");
	CHECK(read("retired couple, no children") == "woman 1 65-99; man 1 65-99");
	CHECK(read("2 adults, 1 elder and 3 kids") == "2 18-99; 1 65-99; minor 3 0-17");
	CHECK(read("One person living alone") == "1 18-99");
	CHECK(read("couple aged 30 to 40 with children") == "woman 1 30-40; man 1 30-40; minor 1+ 0-17");
}

TEST_CASE("wording that is not understood is an error that names the word") {
	CHECK(read("one wombat").find("'wombat'") != std::string::npos);
	CHECK(read("").find("nobody") != std::string::npos);
	CHECK(read("two minors").find("at least one adult") != std::string::npos);
	CHECK(read("adults with one child").find("how many 'adults'") != std::string::npos);
	CHECK(read("two").find("stands before nothing") != std::string::npos);
	CHECK(read("one hundred").find("'hundred'") != std::string::npos);
	CHECK(read("900 adults").find("larger than 20") != std::string::npos);
	CHECK(read("one adult aged 64-16").find("smaller first") != std::string::npos);
	CHECK(read("aged 16-64").find("ages stand before") != std::string::npos);
	CHECK(read("two adults living alone").find("'alone'") != std::string::npos);
}
