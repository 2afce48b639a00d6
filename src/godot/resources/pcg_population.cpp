#include "godot/resources/pcg_population.h"

#include <godot_cpp/core/class_db.hpp>

#include "core/io/atomic_file.h"
#include "core/io/population_csv.h"
#include "godot/convert.h"
#include "godot/report.h"

using namespace godot;

namespace pcg {

void PCGPopulation::_bind_methods() {
	ClassDB::bind_static_method("PCGPopulation", D_METHOD("from_file", "path"), &PCGPopulation::from_file);
	ClassDB::bind_method(D_METHOD("save_csv", "path"), &PCGPopulation::save_csv);
}

Ref<PCGPopulation> PCGPopulation::from_file(const String &p_path) {
	Ref<PCGPopulation> people;
	people.instantiate();
	people->set_file(p_path);
	return people;
}

void PCGPopulation::read_text(const std::string &text, Diagnostics &diagnostics) {
	if (!diagnostics.has_errors()) {
		parse_population(text, name_or("population"), nullptr, diagnostics);
	}
}

Error PCGPopulation::save_csv(const String &p_path) const {
	return save_to(p_path, [this](const std::string &path, Diagnostics &diagnostics) { write_file(path, from_godot(get_source()), diagnostics); });
}

Population PCGPopulation::read(const CityModel &city, Diagnostics &diagnostics) const {
	if (has_errors()) {
		diagnostics.append(this->diagnostics());
		return {};
	}
	FileIds buildings;
	for (size_t i = 0; i < city.buildings().size(); ++i) {
		buildings.add(int64_t(i));
	}
	std::optional<PopulationFile> people = parse_population(from_godot(get_source()), name_or("population"), &buildings, diagnostics);
	if (!people) {
		return {};
	}
	for (Household &household : people->population.households) {
		household.pattern = no_row;
	}
	return std::move(people->population);
}

} // namespace pcg
