#pragma once

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>

#include "core/population/household_pattern.h"
#include "godot/resources/pcg_text_file.h"

namespace pcg {

// Kinds of households and how often each occurs, as a CSV table.
class PCGHouseholdTable : public PCGTextFile {
	GDCLASS(PCGHouseholdTable, PCGTextFile)

public:
	static godot::Ref<PCGHouseholdTable> from_file(const godot::String &p_path);
	godot::TypedArray<godot::Dictionary> get_households() const;
	godot::PackedInt32Array preview_households(int64_t p_persons, int64_t p_seed) const;

	const HouseholdTable &table() const { return _table; }

protected:
	static void _bind_methods();
	void read_text(const std::string &text, Diagnostics &diagnostics) override;

private:
	HouseholdTable _table;
};

} // namespace pcg
