#include "cli/people.h"

#include "cli/progress.h"
#include "core/io/household_csv.h"
#include "core/population/population_generator.h"

namespace pcg::cli {

namespace {

// More than any city has; a person and its agenda take some 150 bytes.
constexpr int64_t most_persons = 100'000'000;

} // namespace

PeopleRequest read_people_request(Args &args) {
	PeopleRequest request;
	request.city = args.text("--city");
	request.households = args.text("--households");
	request.people = args.text("--population");
	request.persons = uint32_t(args.whole("--persons", 0, 1, most_persons));
	request.seed = uint64_t(args.whole("--seed", 1));
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

bool make_people(const PeopleRequest &request, const CityFile &city, PopulationFile &people, Diagnostics &diagnostics) {
	if (!request.people.empty()) {
		Result<PopulationFile> file = read_population(request.people, city.building_ids);
		if (!file) {
			diagnostics.add(file.diagnostic());
			return false;
		}
		people = std::move(*file);
		return true;
	}
	const Result<HouseholdTable> table = read_household_table(request.households);
	if (!table) {
		diagnostics.add(table.diagnostic());
		return false;
	}
	PopulationOptions options;
	options.seed = request.seed;
	options.persons = request.persons;
	options.work = long_work("persons");
	Diagnostics found;
	people.population = generate_population(*table, city.city, options, found);
	end_progress();
	for (Diagnostic diagnostic : found.list()) {
		diagnostic.file = diagnostic.file.empty() ? (diagnostic.id == "no-homes" ? request.city : request.households) : diagnostic.file;
		diagnostics.add(std::move(diagnostic));
	}
	return !diagnostics.has_errors() && !was_cancelled();
}

} // namespace pcg::cli
