#pragma once

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/string.hpp>

#include "core/base/diagnostic.h"
#include "core/population/population.h"
#include "core/semantics/city_model.h"

namespace pcg {

// Certain people, a line of a table each, from a CSV file or from text kept in the resource; for whoever edits people by hand.
class PCGPopulation : public godot::Resource {
	GDCLASS(PCGPopulation, godot::Resource)

public:
	static godot::Ref<PCGPopulation> from_file(const godot::String &p_path);
	void set_file(const godot::String &p_file);
	godot::String get_file() const { return _file; }
	void set_source(const godot::String &p_source);
	godot::String get_source() const { return _source; }
	void reload();
	godot::Error save_csv(const godot::String &p_path) const;

	// Household::pattern of people from here: of no row of a household table.
	static constexpr uint16_t no_row = 0xFFFF;
	// In that city, whose buildings are numbered by their ids; nobody after an error.
	Population read(const CityModel &city, Diagnostics &diagnostics) const;

protected:
	static void _bind_methods();
	void _validate_property(godot::PropertyInfo &p_property) const;

private:
	godot::String _file; // empty: `_source` is the table
	godot::String _source;
	Diagnostics _diagnostics; // of reading the file
};

} // namespace pcg
