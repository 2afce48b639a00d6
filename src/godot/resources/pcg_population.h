#pragma once

#include <godot_cpp/classes/ref.hpp>

#include "core/population/population.h"
#include "core/semantics/city_model.h"
#include "godot/resources/pcg_text_file.h"

namespace pcg {

// Certain people, a line of a CSV table each; for whoever edits people by hand.
class PCGPopulation : public PCGTextFile {
	GDCLASS(PCGPopulation, PCGTextFile)

public:
	static godot::Ref<PCGPopulation> from_file(const godot::String &p_path);
	godot::Error save_csv(const godot::String &p_path) const;

	// Household::pattern of people from here: of no row of a household table.
	static constexpr uint16_t no_row = 0xFFFF;
	// In that city, whose buildings are numbered by their ids; nobody after an error.
	Population read(const CityModel &city, Diagnostics &diagnostics) const;

protected:
	static void _bind_methods();
	// What is wrong in any city.
	void read_text(const std::string &text, Diagnostics &diagnostics) override;
};

} // namespace pcg
