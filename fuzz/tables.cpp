#include "core/io/city_json.h"
#include "core/io/household_csv.h"
#include "core/io/population_csv.h"
#include "core/population/household_draw.h"
#include "fuzz/fuzz.h"

using namespace pcg;

// The first byte says which table the others are: of households, of people, or a city.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
	if (size == 0) {
		return 0;
	}
	const std::string text = fuzz::text_of(data + 1, size - 1);
	Diagnostics diagnostics;
	if (data[0] == 'h') {
		const std::optional<HouseholdTable> table = parse_household_table(text, "table.csv", diagnostics);
		Random random(size);
		for (size_t i = 0; table && i < table->patterns.size() && i < 100; ++i) {
			draw_members(table->patterns[i], random);
		}
	} else if (data[0] == 'p') {
		FileIds buildings;
		buildings.add(1);
		buildings.add(7);
		const std::optional<PopulationFile> people = parse_population(text, "people.csv", &buildings, diagnostics);
		if (people) {
			population_to_csv(people->population, { .buildings = &buildings });
		}
	} else {
		const std::optional<CityFile> city = parse_city_json(text, "city.json", diagnostics);
		if (city) {
			city_to_json(city->city);
		}
	}
	to_text(diagnostics);
	return 0;
}
