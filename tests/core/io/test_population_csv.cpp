#include <doctest/doctest.h>

#include "core/io/population_csv.h"
#include "core/population/names.h"

using namespace pcg;

namespace {

FileIds buildings() {
	FileIds ids;
	ids.add(10);
	ids.add(20);
	return ids;
}

std::optional<PopulationFile> people_of(const std::string &rows, Diagnostics &diagnostics, const std::string &more_columns = "") {
	const FileIds ids = buildings();
	return parse_population("household,person,home,age,gender,speed" + more_columns + "\n" + rows, "people.csv", &ids, diagnostics);
}

PopulationFile people_of(const std::string &rows, const std::string &more_columns = "") {
	Diagnostics diagnostics;
	std::optional<PopulationFile> file = people_of(rows, diagnostics, more_columns);
	INFO(to_text(diagnostics));
	REQUIRE(file.has_value());
	CHECK(diagnostics.is_empty());
	return *file;
}

// "line:column id; ..": where there are none.
std::string problems_of(const std::string &rows, const std::string &more_columns = "") {
	Diagnostics diagnostics;
	CHECK_FALSE(people_of(rows, diagnostics, more_columns).has_value());
	CHECK(diagnostics.has_errors());
	std::string text;
	for (const Diagnostic &diagnostic : diagnostics.list()) {
		text += (text.empty() ? "" : "; ") + std::to_string(diagnostic.line) + ":" + std::to_string(diagnostic.column) + " " + std::string(diagnostic.id);
	}
	return text;
}

const std::string looks = ",first_name,family_name,hair,clothes";

} // namespace

TEST_CASE("people are read with their own numbers, members of a household together") {
	const PopulationFile file = people_of("7,70,20,34,w,1.4\n8,80,10,70,m,0.9\n7,71,20,5.5,m,1.1\n");
	const Population &population = file.population;
	REQUIRE(population.households.size() == 2);
	CHECK(population.households[0].home == BuildingId(1));
	CHECK(population.households[0].member_count == 2);
	CHECK(file.person_ids.number_of(1) == 71);
	CHECK(population.persons[1].age == 5.5f);
	CHECK(population.persons[1].gender == Gender::Man);
	CHECK(population.persons[2].walking_speed == 0.9f);
	CHECK(population.persons[2].household == HouseholdId(1));
}

TEST_CASE("households that begin after others went on keep their members") {
	const PopulationFile file = people_of("5,1,10,30,w,1\n5,2,10,31,w,1\n6,3,20,32,w,1\n5,4,10,33,w,1\n9,5,20,34,w,1\n");
	REQUIRE(file.population.households.size() == 3);
	CHECK(file.population.households[0].member_count == 3);
	CHECK(file.population.persons[2].age == 33.0f);
	CHECK(file.population.persons[4].age == 34.0f);
	CHECK(file.household_ids.number_of(2) == 9);
	CHECK(file.person_ids.number_of(2) == 4);
}

TEST_CASE("what is wrong with a row of people is told") {
	CHECK(problems_of("1,1,30,34,w,1.4\n") == "2:5 unknown-building");
	CHECK(problems_of("1,1,10,34,x,1.4\n") == "2:11 bad-gender");
	CHECK(problems_of("1,1,10,-3,w,1.4\n") == "2:8 not-a-number");
	CHECK(problems_of("1,1,10,30,w,0\n") == "2:13 not-a-number");
	CHECK(problems_of("1,1,10,30,w,inf\n") == "2:13 not-a-number");
	CHECK(problems_of("-1,1,10,30,w,1\n") == "2:1 not-a-number");
	CHECK(problems_of("1,1,10,30,w,1\n1,2,20,30,w,1\n") == "3:5 two-homes");
	CHECK(problems_of("1,1,10,30,w,1\n2,1,10,30,w,1\n") == "3:3 repeated-person");
	Diagnostics diagnostics;
	CHECK_FALSE(parse_population("household,person\n1,1\n", "people.csv", nullptr, diagnostics).has_value());
	REQUIRE(diagnostics.list().size() == 1);
	CHECK(diagnostics.list()[0].id == "missing-column");
}

TEST_CASE("every bad cell is told at once, in the order of the file") {
	CHECK(problems_of("1,1,10,30,w,1,\"Ana\nRossi\",,,\n1,2,10,30,w,1,\"Ñ\",,,\n1,3,10,x,w,1,,,,\n1,4,10,30,m,1,\"L\"eo,,,\n1,5,10,-1,m,1,\"Leo\",,,\n", looks) ==
			"5:8 not-a-number; 6:1 bad-quotes; 7:8 not-a-number"); // a row with odd quotes hides nothing behind it
	CHECK(problems_of("2,1,10,30,w,1\n1,2,10,40,f,1.25\n1,3,10,abc,m,-1\n1,4\n1,5,77,-3,m,nan\n") ==
			"3:11 bad-gender; 4:8 not-a-number; 4:14 not-a-number; 5:1 bad-row; 6:5 unknown-building; 6:8 not-a-number; "
			"6:13 not-a-number");
	std::string many;
	for (int i = 0; i < 40; ++i) {
		many += "1," + std::to_string(i) + ",10,30,f,1\n";
	}
	Diagnostics diagnostics;
	CHECK_FALSE(people_of(many, diagnostics).has_value());
	CHECK(diagnostics.list().size() == 20);
	CHECK(diagnostics.error_count() == 40);
}

TEST_CASE("people written out come back the same, with their numbers") {
	const PopulationFile file = people_of("1,12,20,34,w,1.4\n4,2,10,70,m,0.93\n");
	const FileIds ids = buildings();
	Diagnostics diagnostics;
	const std::string text = population_to_csv(file.population, { .buildings = &ids, .households = &file.household_ids, .persons = &file.person_ids });
	const auto again = parse_population(text, "again.csv", &ids, diagnostics);
	REQUIRE(again.has_value());
	CHECK(again->population.persons[1].walking_speed == 0.93f);
	CHECK(again->population.persons[1].name == file.population.persons[1].name);
	CHECK(again->population.households[0].home == BuildingId(1));
	CHECK(again->household_ids.number_of(1) == 4);
	CHECK(again->person_ids.number_of(0) == 12);
}

TEST_CASE("names and colors edited by hand are kept, whatever the name") {
	const std::string rows = "1,1,20,34,w,1.4,Ada,Marsh,red,navy\n1,2,20,36,m,1.4,Hugo,,,\n2,3,10,70,m,0.93,,,,\n"
							 "3,4,10,40,w,1.2,Zsófia,\"Nagy, the elder\",,\n3,5,10,40,w,1.2,Ada,,,\n4,6,10,40,w,1.2,Zsófia,Nagy,,\n";
	const PopulationFile file = people_of(rows, looks);
	const Population &population = file.population;
	CHECK(full_name(population, PersonId(0)) == "Ada Marsh");
	CHECK(full_name(population, PersonId(1)) == "Hugo Marsh");
	CHECK(full_name(population, PersonId(3)) == "Zsófia Nagy, the elder");
	CHECK(full_name(population, PersonId(4)) == "Ada Nagy, the elder");
	CHECK(full_name(population, PersonId(5)) == "Zsófia Nagy");
	CHECK(population.names.size() == 3); // each once
	CHECK(hair_colors()[population.households[0].hair_color].name == "red");
	CHECK(clothes_colors()[population.persons[0].clothes_color].name == "navy");
	const FileIds ids = buildings();
	const std::string text = population_to_csv(population, { .buildings = &ids });
	Diagnostics diagnostics;
	const auto again = parse_population(text, "again.csv", &ids, diagnostics);
	REQUIRE(again.has_value());
	CHECK(population_to_csv(again->population, { .buildings = &ids }) == text);
}

TEST_CASE("one line of a saved table edited by hand is a warning at most, and nobody is lost") {
	const std::string saved = "1,1,20,34,w,1.4,Ada,Marsh,red,navy\n1,2,20,36,m,1.4,Leo,Marsh,red,blue\n1,3,20,6,m,1,Jan,Marsh,red,white\n";
	const auto edited = [&](std::string_view from, std::string_view to) {
		std::string rows = saved;
		rows.replace(rows.find(from), from.size(), to);
		Diagnostics diagnostics;
		const auto file = people_of(rows, diagnostics, looks);
		REQUIRE(file.has_value());
		CHECK(file->population.persons.size() == 3);
		std::string text = std::string(family_name(file->population, HouseholdId(0))) + " " +
				std::string(hair_colors()[file->population.households[0].hair_color].name);
		for (const Diagnostic &diagnostic : diagnostics.list()) {
			CHECK(diagnostic.severity == Severity::Warning);
			text += "; " + std::to_string(diagnostic.line) + ":" + std::to_string(diagnostic.column) + " " + std::string(diagnostic.id);
		}
		return text;
	};
	CHECK(edited("Leo,Marsh", "Leo,Baker") == "Marsh red; 3:21 two-looks");
	CHECK(edited("Ada,Marsh", "Ada,Baker") == "Baker red; 3:21 two-looks"); // once for the household
	CHECK(edited("Ada,Marsh", "Ada,") == "Marsh red");
	CHECK(edited("red,blue", "black,blue") == "Marsh red; 3:27 two-looks");
	CHECK(edited("red,navy", "green,navy") == "Marsh red; 2:27 unknown-look"); // as if it were empty: the others say it
	CHECK(edited("Ada,Marsh", "Ada,Ńagy").starts_with("Ńagy red; 3:21 two-looks"));
}

TEST_CASE("homes have any number that a building of the city has") {
	FileIds ids;
	ids.add(-1);
	ids.add(INT64_MIN);
	const std::string rows = "household,person,home,age,gender,speed\n1,1,-1,34,w,1\n2,2,-9223372036854775808,30,m,1\n";
	Diagnostics diagnostics;
	const auto file = parse_population(rows, "people.csv", &ids, diagnostics);
	REQUIRE(file.has_value());
	CHECK(file->population.households[0].home == BuildingId(0));
	CHECK(file->population.households[1].home == BuildingId(1));
	CHECK(problems_of("1,1,-1,34,w,1.4\n") == "2:5 unknown-building");
	CHECK(problems_of("1,1,9999999999999999999,34,w,1.4\n") == "2:5 not-a-number");
}

TEST_CASE("whoever moves in later keeps a name of his own") {
	Population population = people_of("1,1,20,34,w,1.4,Zsófia,Nagy,,\n", looks).population;
	append_population(population, people_of("1,1,20,34,w,1.4,Ada,Marsh,,\n2,2,20,34,w,1.4,Tünde,Tóth,,\n", looks).population);
	CHECK(full_name(population, PersonId(0)) == "Zsófia Nagy");
	CHECK(full_name(population, PersonId(1)) == "Ada Marsh");
	CHECK(full_name(population, PersonId(2)) == "Tünde Tóth");
}

TEST_CASE("a color that is none is drawn and told with the closest; the person lives") {
	Diagnostics diagnostics;
	const auto file = people_of("1,1,20,34,w,1.4,Ada,Marsh,red,nayv\n", diagnostics, looks);
	REQUIRE(file.has_value());
	CHECK(full_name(file->population, PersonId(0)) == "Ada Marsh");
	REQUIRE(diagnostics.warning_count() == 1);
	CHECK(diagnostics.list()[0].id == "unknown-look");
	CHECK(diagnostics.list()[0].column == 31);
	CHECK(diagnostics.list()[0].hint == "did you mean 'navy'?");
}

TEST_CASE("a household larger than any is cut, and the others live") {
	std::string rows = "5,0,10,40,w,1\n";
	for (int i = 0; i < 70'000; ++i) {
		rows += "77," + std::to_string(1000 + i) + ",20,30,m,1.2\n";
	}
	rows += "9,1,10,40,m,1\n";
	Diagnostics diagnostics;
	const auto file = people_of(rows, diagnostics);
	REQUIRE(file.has_value());
	REQUIRE(file->population.households.size() == 3);
	CHECK(file->population.households[1].member_count == 65'535);
	CHECK(file->population.persons.size() == 65'537);
	CHECK(file->household_ids.number_of(index_of(file->population.persons.back().household)) == 9);
	REQUIRE(diagnostics.warning_count() == 1);
	const Diagnostic &told = diagnostics.list()[0];
	CHECK(told.id == "household-too-large");
	CHECK(told.line == 65'538);
	CHECK(told.message == "household 77 has 70000 members, more than 65535: from here on 4465 are left out");
}

TEST_CASE("what is wrong in any city is told without one") {
	const std::string rows = "household,person,home,age,gender,speed\n1,1,9999,34,w,1.4\n";
	Diagnostics none;
	const auto file = parse_population(rows, "people.csv", nullptr, none);
	REQUIRE(file.has_value());
	CHECK(none.is_empty());
	CHECK(file->population.households[0].home == BuildingId::Invalid);
	Diagnostics diagnostics;
	CHECK_FALSE(parse_population(rows + "1,2,10,34,w,1.4\n2,3,x,34,w,1\n", "people.csv", nullptr, diagnostics).has_value());
	REQUIRE(diagnostics.list().size() == 2);
	CHECK(diagnostics.list()[0].id == "two-homes");
	CHECK(diagnostics.list()[1].id == "not-a-number");
}
