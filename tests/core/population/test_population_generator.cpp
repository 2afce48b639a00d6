#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "core/io/household_csv.h"
#include "core/population/alias_table.h"
#include "core/population/crowded_homes.h"
#include "core/population/household_draw.h"
#include "core/population/names.h"
#include "core/population/population_generator.h"
#include "core/population/walking_speed.h"

using namespace pcg;

namespace {

CityModel city_of(size_t homes, uint32_t capacity) {
	CityModel city;
	const TypeId house = city.types.add("house");
	for (size_t i = 0; i < homes; ++i) {
		Entrance entrance;
		entrance.building = city.add_building();
		entrance.type = house;
		entrance.capacity = capacity;
		city.add_entrance(entrance);
	}
	return city;
}

HouseholdTable table_of(std::string_view text) {
	Diagnostics diagnostics;
	const std::optional<HouseholdTable> table = parse_household_table(text, "table.csv", diagnostics);
	REQUIRE(table.has_value());
	return *table;
}

// The value of the chi-squared distribution that is exceeded with probability 0.001 (Wilson and Hilferty's approximation).
double chi_squared_limit(double degrees) {
	const double a = 2.0 / (9.0 * degrees);
	return degrees * std::pow(1.0 - a + 3.0902 * std::sqrt(a), 3.0);
}

} // namespace

TEST_CASE("the alias table draws in proportion and never what does not occur") {
	const AliasTable table({ 1.0, 0.0, 3.0, -2.0, NAN, 6.0 });
	Random random(1, 2);
	std::map<size_t, int> drawn;
	for (int i = 0; i < 100'000; ++i) {
		++drawn[table.draw(random)];
	}
	CHECK(drawn.size() == 3);
	// Four standard deviations of a binomial count.
	CHECK(std::abs(drawn[0] - 10'000) < 380);
	CHECK(std::abs(drawn[2] - 30'000) < 580);
	CHECK(std::abs(drawn[5] - 60'000) < 620);
	CHECK(AliasTable({ 0.0 }).is_empty());
	CHECK(AliasTable({}).is_empty());
}

TEST_CASE("over 100,000 households the drawn shares match the table") {
	for (const char *file : { "rules/data/households_us_acs2023.csv", "rules/data/households_madrid_2001.csv" }) {
		Diagnostics diagnostics;
		const std::optional<HouseholdTable> table = read_household_table(file, diagnostics);
		REQUIRE(table.has_value());
		PopulationOptions options;
		options.seed = 5;
		options.households = 100'000;
		const Population population = generate_population(*table, city_of(1000, 2000), options, diagnostics);
		CHECK(diagnostics.is_empty());
		REQUIRE(population.households.size() == 100'000);
		std::vector<double> drawn(table->patterns.size());
		for (const Household &household : population.households) {
			drawn[household.pattern] += 1.0;
		}
		double total = 0.0;
		for (const HouseholdPattern &pattern : table->patterns) {
			total += pattern.weight;
		}
		// Rows expected fewer than five times are put together, as the test asks for.
		double chi = 0.0, rare_drawn = 0.0, rare_expected = 0.0;
		int cells = 0;
		for (size_t i = 0; i < drawn.size(); ++i) {
			const double expected = 100'000.0 * table->patterns[i].weight / total;
			if (expected < 5.0) {
				rare_drawn += drawn[i];
				rare_expected += expected;
				continue;
			}
			chi += (drawn[i] - expected) * (drawn[i] - expected) / expected;
			++cells;
		}
		if (rare_expected > 0.0) {
			chi += (rare_drawn - rare_expected) * (rare_drawn - rare_expected) / rare_expected;
			++cells;
		}
		CHECK(chi < chi_squared_limit(cells - 1));
	}
}

TEST_CASE("members are as the pattern says, adults first, somebody always 18 or over") {
	const HouseholdTable table = table_of("descriptor,count,adult_from\nOne adult woman with two minors,1,16\nTwo adults aged 16-34,1,16\n");
	for (uint64_t i = 0; i < 2000; ++i) {
		Random random(3, i);
		const std::vector<DrawnMember> family = draw_members(table.patterns[0], random);
		REQUIRE(family.size() == 3);
		CHECK(family[0].gender == Gender::Woman);
		CHECK(family[1].age <= 15);
		CHECK(family[2].age <= 15);
		CHECK(family[0].age >= family[1].age + 18);
		CHECK(family[0].age <= std::min(family[1].age, family[2].age) + 45);
		const std::vector<DrawnMember> pair = draw_members(table.patterns[1], random);
		REQUIRE(pair.size() == 2);
		CHECK(pair[0].age >= 18);
		CHECK(pair[1].age >= 16);
		CHECK(pair[1].age <= 34);
	}
}

TEST_CASE("the number of persons asked for is met, and the same seed gives the same people") {
	Diagnostics diagnostics;
	const std::optional<HouseholdTable> table = read_household_table("rules/data/households_us_acs2023.csv", diagnostics);
	REQUIRE(table.has_value());
	PopulationOptions options;
	options.persons = 600;
	const CityModel city = city_of(300, 6);
	const Population population = generate_population(*table, city, options, diagnostics);
	CHECK(population.persons.size() == 600);
	const Population again = generate_population(*table, city, options, diagnostics);
	REQUIRE(again.persons.size() == 600);
	for (size_t i = 0; i < 600; ++i) {
		CHECK(again.persons[i].age == population.persons[i].age);
		CHECK(again.persons[i].name == population.persons[i].name);
		CHECK(again.home_of(PersonId(uint32_t(i))) == population.home_of(PersonId(uint32_t(i))));
		CHECK(population.persons[i].walking_speed >= slowest_walking_speed);
	}
	options.seed = 2;
	const Population other = generate_population(*table, city, options, diagnostics);
	int same = 0;
	for (size_t i = 0; i < 600; ++i) {
		same += other.persons[i].age == population.persons[i].age;
	}
	CHECK(same < 100);
}

TEST_CASE("a preview tells the rows of those who are drawn afterwards") {
	Diagnostics diagnostics;
	const std::optional<HouseholdTable> table = read_household_table("rules/data/households_us_acs2023.csv", diagnostics);
	REQUIRE(table.has_value());
	PopulationOptions options;
	options.persons = 600;
	std::vector<uint32_t> drawn(table->patterns.size());
	for (const Household &household : generate_population(*table, city_of(300, 2000), options, diagnostics).households) {
		++drawn[household.pattern];
	}
	CHECK(preview_households(*table, options) == drawn);
	options.persons = 0;
	CHECK(preview_households(*table, options) == std::vector<uint32_t>(table->patterns.size()));
	options.persons = 10;
	CHECK(preview_households({}, options).empty());
}

TEST_CASE("households have hair of all colors but gray") {
	std::vector<int> drawn(hair_colors().size());
	Random random(1, 2);
	for (int i = 0; i < 1000; ++i) {
		++drawn[draw_hair_color(random)];
	}
	for (size_t color = 0; color < drawn.size(); ++color) {
		CHECK((drawn[color] > 0) == (hair_colors()[color].name != "gray"));
	}
}

TEST_CASE("members of a household stand together and know it") {
	Diagnostics diagnostics;
	PopulationOptions options;
	options.households = 50;
	const Population population =
			generate_population(table_of("descriptor,count\nCouple with one child,1\n"), city_of(100, 6), options, diagnostics);
	REQUIRE(population.persons.size() == 150);
	for (uint32_t i = 0; i < 150; ++i) {
		CHECK(population.persons[i].household == HouseholdId(i / 3));
		CHECK(!full_name(population, PersonId(i)).empty());
	}
	CHECK(population.households[7].first_member == PersonId(21));
}

TEST_CASE("no home takes more persons than its capacity, and those left out are counted with both figures") {
	Diagnostics diagnostics;
	PopulationOptions options;
	options.persons = 100;
	const Population population = generate_population(table_of("descriptor,count\nTwo adults,1\n"), city_of(10, 5), options, diagnostics);
	CHECK(population.persons.size() == 40); // two couples in each home of five
	std::map<uint32_t, int> living;
	for (const Household &household : population.households) {
		living[index_of(household.home)] += household.member_count;
	}
	for (const auto &[home, persons] : living) {
		CHECK(persons == 4);
	}
	REQUIRE(diagnostics.warning_count() == 1);
	CHECK(diagnostics.list()[0].id == "too-few-homes");
	CHECK(diagnostics.list()[0].message ==
			"100 persons, but the homes of the city take 50: 60 were left out; 10 places stay free, but no home has enough of them for a whole household");
}

TEST_CASE("where the homes have places for all, but not for whole households, that is what the warning says") {
	Diagnostics diagnostics;
	PopulationOptions options;
	options.persons = 8;
	const Population population = generate_population(table_of("descriptor,count\nTwo adults,1\n"), city_of(3, 3), options, diagnostics);
	CHECK(population.persons.size() == 6);
	REQUIRE(diagnostics.list().size() == 1);
	CHECK(diagnostics.list()[0].message ==
			"8 persons, of whom 2 were left out: 3 places stay free, but no home has enough of them for a whole household");
}

TEST_CASE("homes of single persons can be filled to the last place") {
	Diagnostics diagnostics;
	PopulationOptions options;
	options.persons = 50;
	CHECK(generate_population(table_of("descriptor,count\nOne man,1\n"), city_of(10, 5), options, diagnostics).persons.size() == 50);
	CHECK(diagnostics.is_empty());
	options.persons = 51;
	CHECK(generate_population(table_of("descriptor,count\nOne man,1\n"), city_of(10, 5), options, diagnostics).persons.size() == 50);
	CHECK(diagnostics.warning_count() == 1);
}

TEST_CASE("a building that says no capacity takes the default") {
	Diagnostics diagnostics;
	PopulationOptions options;
	options.persons = 100;
	options.default_capacity = 3;
	CHECK(generate_population(table_of("descriptor,count\nOne man,1\n"), city_of(10, 0), options, diagnostics).persons.size() == 30);
}

TEST_CASE("households larger than any home are drawn again, with one warning") {
	Diagnostics diagnostics;
	PopulationOptions options;
	options.persons = 40;
	const Population population =
			generate_population(table_of("descriptor,count\nOne man,1\nSix adults,1\n"), city_of(20, 4), options, diagnostics);
	CHECK(population.persons.size() == 40);
	REQUIRE(diagnostics.warning_count() == 1);
	CHECK(diagnostics.list()[0].id == "homes-too-small");
	CHECK(diagnostics.list()[0].message.ends_with(" households were larger than the largest home, which takes 4 persons, and drawn again"));
	Diagnostics of_one;
	options.persons = 0;
	options.households = 1;
	for (options.seed = 1; of_one.is_empty(); ++options.seed) { // until the first draw is of six
		generate_population(table_of("descriptor,count\nOne man,1\nSix adults,1\n"), city_of(20, 1), options, of_one);
	}
	CHECK(of_one.list()[0].message == "1 household was larger than the largest home, which takes 1 person, and drawn again");
}

TEST_CASE("a city without homes is a warning with both figures, and nobody to house is nobody") {
	Diagnostics diagnostics;
	PopulationOptions options;
	const HouseholdTable table = table_of("descriptor,count\nOne man,1\n");
	CHECK(generate_population(table, city_of(3, 4), options, diagnostics).persons.empty());
	CHECK(diagnostics.is_empty());
	options.persons = 10;
	CHECK(generate_population(table, CityModel(), options, diagnostics).persons.empty());
	CHECK(diagnostics.error_count() == 0);
	REQUIRE(diagnostics.warning_count() == 1);
	CHECK(diagnostics.list()[0].id == "no-homes");
	CHECK(diagnostics.list()[0].message ==
			"10 persons, but the homes of the city take 0, for no building has an entrance of type 'house': all 10 were left out");
	options.persons = 0;
	options.households = 7;
	Diagnostics of_households;
	CHECK(generate_population(table_of("descriptor,count\nCouple with one child,1\n"), CityModel(), options, of_households).persons.empty());
	REQUIRE(of_households.list().size() == 1);
	CHECK(of_households.list()[0].message.starts_with("21 persons, but the homes of the city take 0"));
}

TEST_CASE("people who were put into a full home by hand live there, with a warning that tells both figures") {
	Population population;
	for (const uint16_t members : { 4, 9, 5 }) {
		Household household;
		household.home = BuildingId(uint32_t(population.households.size()));
		household.member_count = members;
		population.households.push_back(household);
	}
	const CityModel city = city_of(3, 5);
	FileIds buildings;
	for (const int64_t number : { 10, 20, 30 }) {
		buildings.add(number);
	}
	Diagnostics diagnostics;
	warn_of_crowded_homes(population, city, { .buildings = &buildings }, diagnostics);
	REQUIRE(diagnostics.list().size() == 1);
	CHECK(diagnostics.warning_count() == 1);
	CHECK(diagnostics.list()[0].id == "crowded-home");
	CHECK(diagnostics.list()[0].message == "9 persons live in building 20, which takes 5");
	population.households.push_back(population.households[2]); // ten in all
	Diagnostics two;
	warn_of_crowded_homes(population, city, { .buildings = &buildings }, two);
	REQUIRE(two.list().size() == 1);
	CHECK(two.list()[0].message == "10 persons live in building 30, which takes 5; 1 more home is too small");
	Diagnostics none;
	warn_of_crowded_homes(population, city_of(3, 10), {}, none);
	population.home_type = "flat"; // nobody says how many live behind another door
	warn_of_crowded_homes(population, city, {}, none);
	CHECK(none.is_empty());
}

TEST_CASE("walking speeds are those of the sources") {
	CHECK(mean_walking_speed(Gender::Man, 45) == doctest::Approx(1.434));
	CHECK(mean_walking_speed(Gender::Woman, 95) == doctest::Approx(0.943));
	CHECK(mean_walking_speed(Gender::Woman, 4) == doctest::Approx(1.0));
	CHECK(mean_walking_speed(Gender::Man, 1) == doctest::Approx(1.1));
}
