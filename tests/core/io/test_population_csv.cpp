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

std::string_view problem_of(std::string_view rows) {
	const auto file = parse_population("household,person,home,age,gender,speed\n" + std::string(rows), "people.csv", buildings());
	REQUIRE(!file.is_ok());
	return file.diagnostic().id;
}

} // namespace

TEST_CASE("people are read with their own numbers, members of a household together") {
	const auto file = parse_population("household,person,home,age,gender,speed\n7,70,20,34,w,1.4\n8,80,10,70,m,0.9\n7,71,20,5.5,m,1.1\n",
			"people.csv", buildings());
	REQUIRE(file.is_ok());
	const Population &population = file->population;
	REQUIRE(population.households.size() == 2);
	CHECK(population.households[0].home == BuildingId(1));
	CHECK(population.households[0].member_count == 2);
	CHECK(file->person_ids.number_of(1) == 71);
	CHECK(population.persons[1].age == 5.5f);
	CHECK(population.persons[1].gender == Gender::Man);
	CHECK(population.persons[2].walking_speed == 0.9f);
	CHECK(population.persons[2].household == HouseholdId(1));
}

TEST_CASE("households that begin after others went on keep their members") {
	const auto file = parse_population("household,person,home,age,gender,speed\n5,1,10,30,w,1\n5,2,10,31,w,1\n6,3,20,32,w,1\n5,4,10,33,w,1\n9,5,20,34,w,1\n",
			"people.csv", buildings());
	REQUIRE(file.is_ok());
	REQUIRE(file->population.households.size() == 3);
	CHECK(file->population.households[0].member_count == 3);
	CHECK(file->population.persons[2].age == 33.0f);
	CHECK(file->population.persons[4].age == 34.0f);
	CHECK(file->household_ids.number_of(2) == 9);
	CHECK(file->person_ids.number_of(2) == 4);
}

TEST_CASE("what is wrong with a row of people is told") {
	CHECK(problem_of("1,1,30,34,w,1.4\n") == "unknown-building");
	CHECK(problem_of("1,1,10,34,x,1.4\n") == "bad-gender");
	CHECK(problem_of("1,1,10,-3,w,1.4\n") == "not-a-number");
	CHECK(problem_of("1,1,10,30,w,0\n") == "not-a-number");
	CHECK(problem_of("1,1,10,30,w,inf\n") == "not-a-number");
	CHECK(problem_of("-1,1,10,30,w,1\n") == "not-a-number");
	CHECK(problem_of("1,1,10,30,w,1\n1,2,20,30,w,1\n") == "two-homes");
	CHECK(problem_of("1,1,10,30,w,1\n2,1,10,30,w,1\n") == "repeated-person");
	CHECK(parse_population("household,person\n1,1\n", "people.csv", buildings()).diagnostic().id == "missing-column");
}

TEST_CASE("people written out come back the same") {
	const auto file = parse_population("household,person,home,age,gender,speed\n1,1,20,34,w,1.4\n2,2,10,70,m,0.93\n", "people.csv", buildings());
	REQUIRE(file.is_ok());
	const FileIds ids = buildings();
	const auto again = parse_population(population_to_csv(file->population, &ids), "again.csv", ids);
	REQUIRE(again.is_ok());
	CHECK(again->population.persons[1].walking_speed == 0.93f);
	CHECK(again->population.persons[1].name == file->population.persons[1].name);
	CHECK(again->population.households[0].home == BuildingId(1));
}

TEST_CASE("names and colors edited by hand are kept; a name that is none is told with the closest") {
	const std::string header = "household,person,home,age,gender,speed,first_name,family_name,hair,clothes\n";
	const FileIds ids = buildings();
	const auto file = parse_population(header + "1,1,20,34,w,1.4,Ada,Marsh,red,navy\n1,2,20,36,m,1.4,Hugo,,,\n2,3,10,70,m,0.93,,,,\n", "people.csv", ids);
	REQUIRE(file.is_ok());
	CHECK(full_name(file->population, PersonId(0)) == "Ada Marsh");
	CHECK(full_name(file->population, PersonId(1)) == "Hugo Marsh");
	CHECK(hair_colors()[file->population.households[0].hair_color].name == "red");
	CHECK(clothes_colors()[file->population.persons[0].clothes_color].name == "navy");
	const std::string text = population_to_csv(file->population, &ids);
	const auto again = parse_population(text, "again.csv", ids);
	REQUIRE(again.is_ok());
	CHECK(population_to_csv(again->population, &ids) == text);
	const auto wrong = parse_population(header + "1,1,20,34,w,1.4,Ad,Marsh,red,navy\n", "people.csv", ids);
	REQUIRE(!wrong.is_ok());
	CHECK(wrong.diagnostic().id == "unknown-look");
	CHECK(wrong.diagnostic().column == 17);
	CHECK(wrong.diagnostic().hint == "did you mean 'Ada'?");
	const auto two = parse_population(header + "1,1,20,34,w,1.4,Ada,Marsh,red,navy\n1,2,20,36,m,1.4,,Baker,,\n", "people.csv", ids);
	REQUIRE(!two.is_ok());
	CHECK(two.diagnostic().id == "two-looks");
}
