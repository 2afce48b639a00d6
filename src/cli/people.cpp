#include "cli/people.h"

#include "cli/progress.h"
#include "core/io/household_csv.h"
#include "core/population/crowded_homes.h"
#include "core/population/population_generator.h"

namespace pcg::cli {

namespace {

// More than any city has; a person and its agenda take some 150 bytes.
constexpr int64_t most_persons = 100'000'000;

// What is about homes is about the city.
void append_with_file(Diagnostics &diagnostics, const Diagnostics &found, const std::string &table, const std::string &city) {
	for (Diagnostic diagnostic : found.list()) {
		diagnostic.file = diagnostic.id == "no-homes" ? city : table;
		diagnostics.add(std::move(diagnostic));
	}
}

} // namespace

PeopleRequest read_people_request(Args &args) {
	PeopleRequest request;
	request.city = args.text("--city");
	request.households = args.text("--households");
	request.people = args.text("--population");
	request.persons = uint32_t(args.whole("--persons", 0, 1, most_persons));
	request.seed = uint64_t(args.whole("--seed", 1));
	request.attributes = read_attributes(args);
	if (request.city.empty()) {
		args.problem("--city CITY.json is missing");
	}
	if (request.households.empty() == request.people.empty()) {
		args.problem("give either --households TABLE.csv with --persons N, or --population PEOPLE.csv");
	}
	if (!request.households.empty() && !args.has("--persons")) {
		args.problem("--households needs --persons N");
	}
	return request;
}

void check_people_outputs(Args &args, const PeopleRequest &request, const std::string &rules, std::span<const NamedFile> outputs) {
	const NamedFile inputs[] = { { "the rule file", rules }, { "--city", request.city }, { "--households", request.households },
		{ "--population", request.people } };
	check_outputs(args, inputs, outputs);
}

FileNumbers numbers_of(const PeopleRequest &request, const CityFile &city, const PopulationFile &people) {
	FileNumbers numbers{ &city.building_ids, &city.zone_ids, &city.object_ids };
	if (request.has_file_numbers()) {
		numbers.households = &people.household_ids;
		numbers.persons = &people.person_ids;
	}
	return numbers;
}

bool make_people(const PeopleRequest &request, const CityFile &city, PopulationFile &people, Diagnostics &diagnostics) {
	if (!request.people.empty()) {
		std::optional<PopulationFile> file = read_population(request.people, &city.building_ids, diagnostics);
		if (!file) {
			return false;
		}
		people = std::move(*file);
		Diagnostics found;
		warn_of_crowded_homes(people.population, city.city, numbers_of(request, city, people), found);
		append_with_file(diagnostics, found, request.people, request.city);
		return true;
	}
	const std::optional<HouseholdTable> table = read_household_table(request.households, diagnostics);
	if (!table) {
		return false;
	}
	PopulationOptions options;
	options.seed = request.seed;
	options.persons = request.persons;
	options.work = long_work("persons");
	Diagnostics found;
	people.population = generate_population(*table, city.city, options, found);
	end_progress();
	append_with_file(diagnostics, found, request.households, request.city);
	return !diagnostics.has_errors() && !was_cancelled();
}

} // namespace pcg::cli
