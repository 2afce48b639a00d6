#include "godot/resources/pcg_household_table.h"

#include <algorithm>

#include <godot_cpp/core/class_db.hpp>

#include "core/io/household_csv.h"
#include "core/population/population_generator.h"
#include "godot/convert.h"

using namespace godot;

namespace pcg {

namespace {

constexpr int64_t max_previewed = 1'000'000; // persons: half a second

} // namespace

void PCGHouseholdTable::_bind_methods() {
	ClassDB::bind_static_method("PCGHouseholdTable", D_METHOD("from_file", "path"), &PCGHouseholdTable::from_file);
	ClassDB::bind_method(D_METHOD("get_households"), &PCGHouseholdTable::get_households);
	ClassDB::bind_method(D_METHOD("preview_households", "persons", "seed"), &PCGHouseholdTable::preview_households, DEFVAL(1));
}

Ref<PCGHouseholdTable> PCGHouseholdTable::from_file(const String &p_path) {
	Ref<PCGHouseholdTable> table;
	table.instantiate();
	table->set_file(p_path);
	return table;
}

void PCGHouseholdTable::read_text(const std::string &text, Diagnostics &diagnostics) {
	std::optional<HouseholdTable> table;
	if (!diagnostics.has_errors()) {
		table = parse_household_table(text, name_or("household table"), diagnostics);
	}
	_table = table ? std::move(*table) : HouseholdTable();
}

TypedArray<Dictionary> PCGHouseholdTable::get_households() const {
	TypedArray<Dictionary> result;
	double sum = 0.0;
	for (const HouseholdPattern &pattern : _table.patterns) {
		sum += pattern.weight;
	}
	for (const HouseholdPattern &pattern : _table.patterns) {
		Dictionary entry;
		entry["descriptor"] = to_godot(std::string_view(pattern.descriptor));
		entry["count"] = pattern.weight;
		entry["share"] = sum > 0.0 ? pattern.weight / sum : 0.0;
		result.push_back(entry);
	}
	return result;
}

PackedInt32Array PCGHouseholdTable::preview_households(int64_t p_persons, int64_t p_seed) const {
	PopulationOptions options;
	options.persons = uint32_t(std::clamp<int64_t>(p_persons, 0, max_previewed));
	options.seed = uint64_t(p_seed);
	PackedInt32Array result;
	for (const uint32_t count : pcg::preview_households(_table, options)) {
		result.push_back(int32_t(count));
	}
	return result;
}

} // namespace pcg
