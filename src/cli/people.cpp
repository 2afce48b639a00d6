#include "cli/people.h"

#include "core/io/household_csv.h"
#include "core/population/population_generator.h"

namespace pcg::cli {

PeopleRequest read_people_request(Args &args) {
	PeopleRequest request;
	request.city = args.text("--city");
	request.households = args.text("--households");
	request.people = args.text("--population");
	request.persons = uint32_t(args.whole("--persons", 0, 0, 100'000'000));
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
	people.population = generate_population(*table, city.city, options, diagnostics);
	return !diagnostics.has_errors();
}

} // namespace pcg::cli
