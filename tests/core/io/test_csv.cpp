#include <doctest/doctest.h>

#include "core/base/random.h"
#include "core/io/atomic_file.h"
#include "core/io/csv.h"
#include "core/io/household_csv.h"
#include "core/io/population_csv.h"

using namespace pcg;

namespace {

// A few bytes changed, removed or doubled.
std::string damaged(std::string text, Random &random) {
	constexpr std::string_view bytes = "\",;\n\r\t+-.0129aoe# \xFF\x80";
	for (size_t i = 1 + random.index(6); i > 0 && !text.empty(); --i) {
		const size_t at = random.index(text.size());
		switch (random.index(4)) {
			case 0:
				text[at] = bytes[random.index(bytes.size())];
				break;
			case 1:
				text.erase(at, 1 + random.index(20));
				break;
			case 2:
				text.insert(at, 1, bytes[random.index(bytes.size())]);
				break;
			default:
				text.insert(at, text.substr(random.index(text.size()), random.index(60)));
		}
	}
	return text;
}

} // namespace

TEST_CASE("quotes hold separators, line breaks and quotes") {
	Diagnostics diagnostics;
	const std::optional<CsvTable> table = parse_csv("a,b\n\"x, \"\"y\"\"\nz\", 2 \n\n# remark\n3,4", "t.csv", diagnostics);
	REQUIRE(table.has_value());
	CHECK(diagnostics.is_empty());
	REQUIRE(table->rows.size() == 2);
	CHECK(table->rows[0].fields[0].text == "x, \"y\"\nz");
	CHECK(table->rows[0].fields[1].text == "2");
	CHECK(table->rows[1].line == 6);
	CHECK(table->find_column("b") == 1);
	CHECK(table->find_column("c") == -1);
	CHECK(csv_quoted("a \"b\", c") == "\"a \"\"b\"\", c\"");
	CHECK(csv_quoted("plain") == "plain");
}

TEST_CASE("damaged tables give a message or a table, never anything else") {
	const Result<std::string> households = read_file("rules/data/households_madrid_2001.csv");
	REQUIRE(households.is_ok());
	const std::string people = "household,person,home,age,gender,speed\n1,1,5,34,w,1.4\n2,2,6,70,m,0.93\n1,3,5,4,m,1\n3,4,5,20,w,1\n";
	FileIds buildings;
	buildings.add(5);
	buildings.add(6);
	Random random(77, 1);
	int read = 0;
	for (int i = 0; i < 4000; ++i) {
		Diagnostics diagnostics;
		const std::optional<HouseholdTable> table = parse_household_table(damaged(*households, random), "t.csv", diagnostics);
		read += table.has_value();
		CHECK(table.has_value() != diagnostics.has_errors());
		CHECK(diagnostics.list().size() <= max_table_problems);
		const std::optional<PopulationFile> file = parse_population(damaged(people, random), "p.csv", &buildings, diagnostics);
		CHECK((!file || file->population.persons.size() <= 200));
	}
	CHECK(read > 100);
}
