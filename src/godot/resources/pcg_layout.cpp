#include "godot/resources/pcg_layout.h"

#include <algorithm>

#include <godot_cpp/core/class_db.hpp>

using namespace godot;

namespace pcg {

// Limits are the core's to check, with a message that names them; here numbers only have to fit their type.
static uint32_t to_count(int value) { return uint32_t(std::max(0, value)); }

#define PCG_BIND(m_type, m_name, m_hint) \
	ClassDB::bind_method(D_METHOD("set_" #m_name, "value"), &PCGLayout::set_##m_name); \
	ClassDB::bind_method(D_METHOD("get_" #m_name), &PCGLayout::get_##m_name); \
	ADD_PROPERTY(PropertyInfo(Variant::m_type, #m_name, PROPERTY_HINT_RANGE, m_hint), "set_" #m_name, "get_" #m_name)

void PCGLayout::_bind_methods() {
	PCG_BIND(INT, blocks_x, "1,100,1,or_greater");
	PCG_BIND(INT, blocks_z, "1,100,1,or_greater");
	PCG_BIND(INT, lots_along, "1,100");
	PCG_BIND(INT, lots_deep, "1,2");
	PCG_BIND(FLOAT, lot_front, "5,500,0.5,suffix:m");
	PCG_BIND(FLOAT, lot_aspect, "0.25,4,0.05");
	PCG_BIND(FLOAT, street_width, "2,100,0.5,suffix:m");
	PCG_BIND(FLOAT, pavement_width, "0.5,50,0.5,suffix:m");
	ClassDB::bind_method(D_METHOD("get_lot_count"), &PCGLayout::get_lot_count);
	ClassDB::bind_method(D_METHOD("fit_lots", "count"), &PCGLayout::fit_lots);
}

#undef PCG_BIND

#define PCG_SETTER(m_name, m_type, m_convert) \
	void PCGLayout::set_##m_name(m_type p_value) { \
		_parameters.m_name = m_convert(p_value); \
		emit_changed(); \
	}

PCG_SETTER(blocks_x, int, to_count)
PCG_SETTER(blocks_z, int, to_count)
PCG_SETTER(lots_along, int, to_count)
PCG_SETTER(lots_deep, int, to_count)
PCG_SETTER(lot_front, double, float)
PCG_SETTER(lot_aspect, double, float)
PCG_SETTER(street_width, double, float)
PCG_SETTER(pavement_width, double, float)

#undef PCG_SETTER

int PCGLayout::get_lot_count() const {
	return int(_parameters.blocks_x * _parameters.blocks_z * _parameters.lots_along * _parameters.lots_deep);
}

void PCGLayout::fit_lots(int p_count) {
	_parameters = layout_for_lots(to_count(p_count), _parameters);
	emit_changed();
}

} // namespace pcg
