#pragma once

#include <godot_cpp/classes/resource.hpp>

#include "core/city/layout.h"

namespace pcg {

// How streets, blocks and lots are laid out. What each lot becomes is the city's land use.
class PCGLayout : public godot::Resource {
	GDCLASS(PCGLayout, godot::Resource)

public:
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

	int get_lot_count() const;
	// Chooses blocks and lots for a roughly square city of about that many lots.
	void fit_lots(int p_count);

	const LayoutParameters &parameters() const { return _parameters; }

protected:
	static void _bind_methods();

private:
	LayoutParameters _parameters;
};

} // namespace pcg
