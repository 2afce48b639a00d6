#pragma once

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include "core/base/diagnostic.h"
#include "core/population/household_pattern.h"

namespace pcg {

// Kinds of households and how often each occurs, from a CSV file or from text kept in the resource.
class PCGHouseholdTable : public godot::Resource {
	GDCLASS(PCGHouseholdTable, godot::Resource)

public:
	static godot::Ref<PCGHouseholdTable> from_file(const godot::String &p_path);
	void set_file(const godot::String &p_file);
	godot::String get_file() const { return _file; }
	void set_source(const godot::String &p_source);
	godot::String get_source() const { return _source; }
	void reload();

	bool has_errors() const { return _diagnostics.has_errors(); }
	godot::TypedArray<godot::Dictionary> get_diagnostics() const;
	godot::String get_diagnostics_text() const;
	godot::TypedArray<godot::Dictionary> get_households() const;

	const HouseholdTable &table() const { return _table; }
	const Diagnostics &diagnostics() const { return _diagnostics; }

protected:
	static void _bind_methods();
	void _validate_property(godot::PropertyInfo &p_property) const;

private:
	godot::String _file; // empty: `_source` is the table
	godot::String _source;
	HouseholdTable _table;
	Diagnostics _diagnostics;
};

} // namespace pcg
