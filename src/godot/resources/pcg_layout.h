#pragma once

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include "core/city/layout.h"
#include "godot/resources/pcg_district.h"

namespace pcg {

// How streets, blocks and lots are laid out. What each lot becomes is the city's land use.
class PCGLayout : public godot::Resource {
	GDCLASS(PCGLayout, godot::Resource)

public:
	enum Kind {
		KIND_GRID = int(LayoutKind::Grid),
		KIND_RADIAL = int(LayoutKind::Radial),
		KIND_GROWN = int(LayoutKind::Grown),
		KIND_FOOTPRINTS, // lots that were drawn or measured; there are no parameters for streets
		KIND_BLOCKS, // blocks that were drawn or measured, to be divided into lots
	};

	void set_kind(Kind p_kind);
	Kind get_kind() const { return _kind; }
	void set_geojson(const godot::String &p_path);
	godot::String get_geojson() const { return _geojson; }
	void set_rings(int p_count);
	int get_rings() const { return int(_parameters.rings); }
	void set_spokes(int p_count);
	int get_spokes() const { return int(_parameters.spokes); }
	void set_main_street_width(double p_metres);
	double get_main_street_width() const { return _parameters.main_street_width; }
	void set_jitter(double p_part);
	double get_jitter() const { return _parameters.jitter; }
	void set_removed(double p_part);
	double get_removed() const { return _parameters.removed; }
	void set_blocks_x(int p_count);
	int get_blocks_x() const { return int(_parameters.blocks_x); }
	void set_blocks_z(int p_count);
	int get_blocks_z() const { return int(_parameters.blocks_z); }
	void set_lots_along(int p_count);
	int get_lots_along() const { return int(_parameters.lots_along); }
	void set_lots_deep(int p_count);
	int get_lots_deep() const { return int(_parameters.lots_deep); }
	void set_lot_front(double p_metres);
	double get_lot_front() const { return _parameters.lot_front; }
	void set_lot_aspect(double p_ratio);
	double get_lot_aspect() const { return _parameters.lot_aspect; }
	void set_street_width(double p_metres);
	double get_street_width() const { return _parameters.street_width; }
	void set_pavement_width(double p_metres);
	double get_pavement_width() const { return _parameters.pavement_width; }

	bool is_drawn() const { return _kind == KIND_FOOTPRINTS || _kind == KIND_BLOCKS; } // or measured
	// Made by the layout itself; 0 where its parameters make no city.
	int get_lot_count() const;
	// Chooses blocks and lots for a roughly square city of about that many lots.
	void fit_lots(int p_count);

	void set_districts(const godot::TypedArray<PCGDistrict> &p_districts);
	godot::TypedArray<PCGDistrict> get_districts() const { return _districts; }

	LayoutParameters parameters() const; // with districts; land use and seed are the city's

protected:
	static void _bind_methods();
	void _validate_property(godot::PropertyInfo &p_property) const;

private:
	LayoutParameters _parameters;
	Kind _kind = KIND_GRID; // of the parameters, as long as there are streets of their own
	godot::String _geojson; // a path; empty: none
	godot::TypedArray<PCGDistrict> _districts;
};

} // namespace pcg

VARIANT_ENUM_CAST(pcg::PCGLayout::Kind);
