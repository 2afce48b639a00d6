#include "core/agenda/agenda_generator.h"

#include "core/navigation/straight_line_paths.h"
#include "core/sim/dialect.h"
#include "core/sim/simulation.h"
#include "fuzz/fuzz.h"

using namespace pcg;

namespace {

// Two homes and three other buildings on a street, a park with a bench; a family, a couple and an elder.
struct Street {
	CityModel city;
	Population population;

	Street() {
		float x = 0.0f;
		for (const char *type : { "house", "house", "school", "workplace", "shop" }) {
			Entrance entrance;
			entrance.building = city.add_building();
			entrance.type = city.types.add(type);
			entrance.position = { x += 100.0f, 0.0f, 0.0f };
			city.add_entrance(entrance);
		}
		Zone park;
		park.type = city.types.add("park");
		park.polygon = { { 0.0f, 0.0f, 50.0f }, { 0.0f, 0.0f, 90.0f }, { 40.0f, 0.0f, 90.0f } };
		city.add_zone(std::move(park));
		CityObject bench;
		bench.type = city.types.add("bench");
		bench.position = { 10.0f, 0.0f, 70.0f };
		bench.places = { { bench.position, { 0.0f, 0.0f, 1.0f } } };
		city.add_object(std::move(bench));
		add_household({ 40.0f, 38.0f, 6.0f, 10.0f });
		add_household({ 30.0f, 31.0f });
		add_household({ 70.0f });
	}

	void add_household(std::initializer_list<float> ages) {
		Household household;
		household.home = BuildingId(uint32_t(population.households.size() % 2));
		household.first_member = PersonId(uint32_t(population.persons.size()));
		household.member_count = uint16_t(ages.size());
		for (float age : ages) {
			Person person;
			person.household = HouseholdId(uint32_t(population.households.size()));
			person.age = age;
			population.persons.push_back(person);
		}
		population.households.push_back(household);
	}
};

} // namespace

// The rules write three households' agendas, which are lived for a day.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
	static const Street street;
	Diagnostics diagnostics;
	const auto program = fuzz::load(fuzz::text_of(data, size), pcg_dialect(), diagnostics);
	if (program == nullptr) {
		return 0;
	}
	const StraightLinePaths paths(street.city);
	AgendaOptions options;
	options.seed = size;
	options.limits.max_steps = 5'000;
	options.limits.max_silent_steps = 5'000;
	options.limits.max_depth = 100;
	options.limits.max_native_depth = 40;
	options.work.threads = 1;
	const AgendaSet agendas = generate_agendas(*program, street.city, paths, street.population, options, diagnostics);
	AgentHost host;
	SimulationSettings settings;
	settings.seed = options.seed;
	Simulation simulation(street.city, paths, street.population, agendas, program, settings, host);
	simulation.start(SimTime::at(0, Duration::hours(5)));
	simulation.advance_to(SimTime::at(0, Duration::hours(20)));
	simulation.jump_to(SimTime::at(1, Duration::hours(8)));
	to_text(diagnostics);
	return 0;
}
