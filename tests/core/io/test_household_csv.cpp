#include <doctest/doctest.h>

#include "core/io/household_csv.h"

using namespace pcg;

namespace {

// The only one.
Diagnostic problem_of(std::string_view text) {
	Diagnostics diagnostics;
	CHECK_FALSE(parse_household_table(text, "table.csv", diagnostics).has_value());
	REQUIRE(diagnostics.list().size() == 1);
	CHECK(diagnostics.has_errors());
	return diagnostics.list()[0];
}

HouseholdTable table_of(std::string_view text) {
	Diagnostics diagnostics;
	const std::optional<HouseholdTable> table = parse_household_table(text, "table.csv", diagnostics);
	INFO(to_text(diagnostics));
	REQUIRE(table.has_value());
	CHECK(diagnostics.is_empty());
	return *table;
}

} // namespace

TEST_CASE("descriptors and columns tell the same household") {
	const HouseholdTable table = table_of(
			"# a remark\ndescriptor,count,adults,minors,women\n"
			"One adult woman with two minor children,10,,,\n\"Lone mothers, two\",20,1,2,1\n");
	REQUIRE(table.patterns.size() == 2);
	CHECK(table.patterns[1].weight == 20.0);
	CHECK(table.patterns[1].descriptor == "Lone mothers, two");
	for (const HouseholdPattern &pattern : table.patterns) {
		REQUIRE(pattern.groups.size() == 2);
		CHECK(pattern.groups[0].sex == MemberGroup::Sex::Woman);
		CHECK(pattern.groups[0].count == 1);
		CHECK(pattern.groups[1].is_minor);
		CHECK(pattern.groups[1].count == 2);
	}
}

TEST_CASE("semicolons, a byte order mark and Windows line ends are understood") {
	CHECK(table_of("\xEF\xBB\xBF" "descriptor;count\r\nOne man;3\r\n").patterns[0].weight == 3.0);
}

TEST_CASE("a bad row is one message with line and column and what to do") {
	const Diagnostic negative = problem_of("descriptor,count\nOne man,5\nOne woman,-2\n");
	CHECK(negative.id == "negative-count");
	CHECK(negative.line == 3);
	CHECK(negative.column == 11);
	CHECK(!negative.hint.empty());
	CHECK(negative.source == "One woman,-2");

	CHECK(problem_of("descriptor,count\nOne man,many\n").id == "not-a-number");
	CHECK(problem_of("descriptor,count\nOne man,\n").id == "not-a-number");
	CHECK(problem_of("descriptor,count\nOne man,1e999\n").id == "not-a-number");
	CHECK(problem_of("descriptor,count\nOne man,nan\n").id == "not-a-number");
	CHECK(problem_of("descriptor,count\nOne man\n").id == "bad-row");
	CHECK(problem_of("descriptor,count\n\"One man,5\n").id == "bad-quotes");
	CHECK(problem_of("descriptor,count\nOne man,0\n").id == "no-households");
	CHECK(problem_of("descriptor,count,adults,minors\nx,5,0,2\n").id == "bad-household");
	CHECK(problem_of("descriptor,count,adults,min_age\nx,5,2,900\n").hint == "write an age in whole years, 0 to 120");
	CHECK(problem_of("descriptor,count,adults\nx,5,-99999999999\n").id == "not-a-number");
	CHECK(problem_of("descriptor,count,adults\nx,5,2.5\n").id == "not-a-number");
	CHECK(problem_of("descriptor,count,adults,women,men\nx,5,1,1,1\n").id == "bad-household");
}

TEST_CASE("a household of more than 20 is left out with a warning, and a table of nothing else is refused") {
	const std::string rows = "descriptor,count,adults,minors\nok,5,1,1\nmany,1,15,6\nhuge,1,99999999999999999999,0\na household of 1000 adults,1,,\nfine,5,20,0\n";
	Diagnostics diagnostics;
	const auto table = parse_household_table(rows, "table.csv", diagnostics);
	REQUIRE(table.has_value());
	REQUIRE(table->patterns.size() == 2);
	CHECK(table->patterns[1].descriptor == "fine");
	std::string told;
	for (const Diagnostic &diagnostic : diagnostics.list()) {
		CHECK(diagnostic.severity == Severity::Warning);
		told += std::to_string(diagnostic.line) + " " + std::string(diagnostic.id) + "; ";
	}
	CHECK(told == "3 household-too-large; 4 household-too-large; 5 household-too-large; ");
	CHECK(diagnostics.list()[0].message == "\"many\": a household larger than 20 members is left out");
	Diagnostics nothing_left;
	CHECK_FALSE(parse_household_table("descriptor,count,adults\nhuge,1,70000\n", "table.csv", nothing_left).has_value());
	REQUIRE(nothing_left.list().size() == 2);
	CHECK(nothing_left.list()[1].message == "no row is left: all households are too large");
}

TEST_CASE("unknown wording names the row and what is understood") {
	const Diagnostic unknown = problem_of("descriptor,count\nOne man,5\nThree wombats,2\n");
	CHECK(unknown.id == "unknown-household-words");
	CHECK(unknown.line == 3);
	CHECK(unknown.message.find("Three wombats") != std::string::npos);
	CHECK(unknown.hint.find("adults") != std::string::npos);
}

TEST_CASE("a part of a row above is refused, or it would be counted twice") {
	CHECK(problem_of("household_type,count\nMarried-couple household,10\n..with own children under 18,4\n").id == "sub-row");
	CHECK(problem_of("household_type,count\nTotal households,10\nMarried-couple household,10\n").id == "total-row");
}

TEST_CASE("tables that are no tables are told apart") {
	CHECK(problem_of("").id == "empty-file");
	CHECK(problem_of("# only a remark\n").id == "empty-file");
	CHECK(problem_of("descriptor,count\n").id == "no-rows");
	CHECK(problem_of("name,count\nx,1\n").id == "missing-column");
	CHECK(problem_of(std::string_view("a\0b", 3)).id == "not-text");
	Diagnostics diagnostics;
	CHECK_FALSE(read_household_table("there/is/no/such.csv", diagnostics).has_value());
	CHECK(diagnostics.error_count() == 1);
}

TEST_CASE("the shipped tables are read and count every household once") {
	Diagnostics diagnostics;
	const std::optional<HouseholdTable> us = read_household_table("rules/data/households_us_acs2023.csv", diagnostics);
	REQUIRE(us.has_value());
	double total = 0.0;
	for (const HouseholdPattern &pattern : us->patterns) {
		total += pattern.weight;
	}
	CHECK(total == 131'332'360.0); // DP02, total households

	const std::optional<HouseholdTable> madrid = read_household_table("rules/data/households_madrid_2001.csv", diagnostics);
	REQUIRE(madrid.has_value());
	total = 0.0;
	for (const HouseholdPattern &pattern : madrid->patterns) {
		total += pattern.weight;
		if (pattern.descriptor == "One adult woman with two minors") {
			CHECK(pattern.weight == 9060.0);
		}
	}
	CHECK(total == 1'873'792.0); // NH1, Madrid
}

TEST_CASE("households are counted whole, and no column is there twice") {
	for (const char *count : { "1.5", "1e22", "nan", "0x10" }) {
		const Diagnostic wrong = problem_of("descriptor,count\nOne man," + std::string(count) + "\n");
		CHECK(wrong.id == "not-a-number");
		CHECK(wrong.line == 2);
		CHECK(wrong.column == 9);
	}
	const Diagnostic twice = problem_of("descriptor,count,adults,Count\nOne man,1,1,1\n");
	CHECK(twice.id == "duplicate-column");
	CHECK(twice.line == 1);
	CHECK(twice.column == 25);
}

TEST_CASE("all bad rows of a table are told, 20 of them in full, in the order of the file") {
	Diagnostics diagnostics;
	CHECK_FALSE(parse_household_table("descriptor,count\nThree purple unicorns,3\nOne man,5\nOne woman\nA couple with two childrens,4\nOne man,-1\n", "table.csv",
			diagnostics)
					.has_value());
	std::string told;
	for (const Diagnostic &diagnostic : diagnostics.list()) {
		told += std::to_string(diagnostic.line) + " " + std::string(diagnostic.id) + "; ";
	}
	CHECK(told == "2 unknown-household-words; 4 bad-row; 5 unknown-household-words; 6 negative-count; ");

	std::string many = "descriptor,count\n";
	for (int i = 0; i < 30; ++i) {
		many += "Three wombats,1\n";
	}
	Diagnostics cut;
	CHECK_FALSE(parse_household_table(many, "table.csv", cut).has_value());
	CHECK(cut.list().size() == 20);
	CHECK(cut.error_count() == 30);
	CHECK(to_text(cut).find("... and 10 more") != std::string::npos);
}

TEST_CASE("a table of descriptors and counts needs no line of names") {
	const HouseholdTable table = table_of("\"one adult woman with two minor children\", 12345\nOne man,5\n");
	REQUIRE(table.patterns.size() == 2);
	CHECK(table.patterns[0].weight == 12345.0);
	CHECK(table.patterns[0].groups[1].count == 2);
	CHECK(table.patterns[1].descriptor == "One man");
	CHECK(table_of("\"one adult woman with two minor children\", 12345").patterns.size() == 1);
	const Diagnostic wrong = problem_of("One man,5\nOne woman,-2\n");
	CHECK(wrong.id == "negative-count");
	CHECK(wrong.line == 2);
	CHECK(problem_of("One man,5,7\nOne woman,2,7\n").id == "missing-column");
}
