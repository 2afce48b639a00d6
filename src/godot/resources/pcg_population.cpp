#include "godot/resources/pcg_population.h"

#include <godot_cpp/core/class_db.hpp>

#include "core/io/atomic_file.h"
#include "core/io/population_csv.h"
#include "godot/convert.h"
#include "godot/ports/engine_files.h"
#include "godot/report.h"

using namespace godot;

namespace pcg {

void PCGPopulation::_bind_methods() {
	ClassDB::bind_static_method("PCGPopulation", D_METHOD("from_file", "path"), &PCGPopulation::from_file);
	ClassDB::bind_method(D_METHOD("reload"), &PCGPopulation::reload);
	ClassDB::bind_method(D_METHOD("save_csv", "path"), &PCGPopulation::save_csv);
	ClassDB::bind_method(D_METHOD("set_file", "file"), &PCGPopulation::set_file);
	ClassDB::bind_method(D_METHOD("get_file"), &PCGPopulation::get_file);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "file", PROPERTY_HINT_FILE, "*.csv"), "set_file", "get_file");
	ClassDB::bind_method(D_METHOD("set_source", "source"), &PCGPopulation::set_source);
	ClassDB::bind_method(D_METHOD("get_source"), &PCGPopulation::get_source);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "source", PROPERTY_HINT_MULTILINE_TEXT), "set_source", "get_source");
}

// Text that comes from a file is neither edited nor stored here.
void PCGPopulation::_validate_property(PropertyInfo &p_property) const {
	if (!_file.is_empty() && p_property.name == StringName("source")) {
		p_property.usage = PROPERTY_USAGE_EDITOR | PROPERTY_USAGE_READ_ONLY;
	}
}

Ref<PCGPopulation> PCGPopulation::from_file(const String &p_path) {
	Ref<PCGPopulation> people;
	people.instantiate();
	people->set_file(p_path);
	return people;
}

void PCGPopulation::set_file(const String &p_file) {
	_file = p_file;
	reload();
	notify_property_list_changed();
}

void PCGPopulation::set_source(const String &p_source) {
	_file = String();
	_source = p_source;
	reload();
}

void PCGPopulation::reload() {
	_diagnostics = Diagnostics();
	if (!_file.is_empty()) {
		const Result<std::string> text = read_engine_file(_file);
		if (text) {
			_source = to_godot(std::string_view(*text));
		} else {
			_source = String();
			_diagnostics.add(text.diagnostic());
		}
	}
	emit_changed();
}

Error PCGPopulation::save_csv(const String &p_path) const {
	return save_to(p_path, [this](const std::string &path, Diagnostics &diagnostics) { write_file(path, from_godot(_source), diagnostics); });
}

Population PCGPopulation::read(const CityModel &city, Diagnostics &diagnostics) const {
	diagnostics.append(_diagnostics);
	if (_diagnostics.has_errors()) {
		return {};
	}
	FileIds buildings;
	for (size_t i = 0; i < city.buildings().size(); ++i) {
		buildings.add(int64_t(i));
	}
	Result<PopulationFile> people = parse_population(from_godot(_source), _file.is_empty() ? "population" : from_godot(_file), buildings);
	if (!people) {
		diagnostics.add(people.diagnostic());
		return {};
	}
	for (Household &household : people->population.households) {
		household.pattern = no_row;
	}
	return std::move(people->population);
}

} // namespace pcg
