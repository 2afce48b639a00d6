#include "godot/resources/pcg_household_table.h"

#include <godot_cpp/core/class_db.hpp>

#include "core/io/household_csv.h"
#include "godot/convert.h"
#include "godot/ports/engine_files.h"

using namespace godot;

namespace pcg {

void PCGHouseholdTable::_bind_methods() {
	ClassDB::bind_static_method("PCGHouseholdTable", D_METHOD("from_file", "path"), &PCGHouseholdTable::from_file);
	ClassDB::bind_method(D_METHOD("reload"), &PCGHouseholdTable::reload);
	ClassDB::bind_method(D_METHOD("has_errors"), &PCGHouseholdTable::has_errors);
	ClassDB::bind_method(D_METHOD("get_diagnostics"), &PCGHouseholdTable::get_diagnostics);
	ClassDB::bind_method(D_METHOD("get_diagnostics_text"), &PCGHouseholdTable::get_diagnostics_text);
	ClassDB::bind_method(D_METHOD("get_households"), &PCGHouseholdTable::get_households);
	ClassDB::bind_method(D_METHOD("set_file", "file"), &PCGHouseholdTable::set_file);
	ClassDB::bind_method(D_METHOD("get_file"), &PCGHouseholdTable::get_file);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "file", PROPERTY_HINT_FILE, "*.csv"), "set_file", "get_file");
	ClassDB::bind_method(D_METHOD("set_source", "source"), &PCGHouseholdTable::set_source);
	ClassDB::bind_method(D_METHOD("get_source"), &PCGHouseholdTable::get_source);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "source", PROPERTY_HINT_MULTILINE_TEXT), "set_source", "get_source");
}

// Text that comes from a file is neither edited nor stored here.
void PCGHouseholdTable::_validate_property(PropertyInfo &p_property) const {
	if (!_file.is_empty() && p_property.name == StringName("source")) {
		p_property.usage = PROPERTY_USAGE_EDITOR | PROPERTY_USAGE_READ_ONLY;
	}
}

Ref<PCGHouseholdTable> PCGHouseholdTable::from_file(const String &p_path) {
	Ref<PCGHouseholdTable> table;
	table.instantiate();
	table->set_file(p_path);
	return table;
}

void PCGHouseholdTable::set_file(const String &p_file) {
	_file = p_file;
	reload();
	notify_property_list_changed();
}

void PCGHouseholdTable::set_source(const String &p_source) {
	_file = String();
	_source = p_source;
	reload();
}

void PCGHouseholdTable::reload() {
	_diagnostics = Diagnostics();
	_table = HouseholdTable();
	std::string text = from_godot(_source);
	if (!_file.is_empty()) {
		Result<std::string> bytes = read_engine_file(_file);
		if (!bytes) {
			_diagnostics.add(bytes.diagnostic());
			emit_changed();
			return;
		}
		text = std::move(*bytes);
		_source = to_godot(std::string_view(text));
	}
	Result<HouseholdTable> table = parse_household_table(text, _file.is_empty() ? "household table" : from_godot(_file));
	if (table) {
		_table = std::move(*table);
	} else {
		_diagnostics.add(table.diagnostic());
	}
	emit_changed();
}

TypedArray<Dictionary> PCGHouseholdTable::get_diagnostics() const { return to_godot(_diagnostics); }

String PCGHouseholdTable::get_diagnostics_text() const { return to_godot(std::string_view(to_text(_diagnostics))).strip_edges(); }

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

} // namespace pcg
