#include "godot/resources/pcg_layout.h"

#include <algorithm>

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>

using namespace godot;

namespace pcg {

// Limits are the core's to check, with a message that names them; here numbers only have to fit their type.
static uint32_t to_count(int value) { return uint32_t(std::max(0, value)); }

#define PCG_BIND(m_type, m_name, m_hint) \
	ClassDB::bind_method(D_METHOD("set_" #m_name, "value"), &PCGLayout::set_##m_name); \
	ClassDB::bind_method(D_METHOD("get_" #m_name), &PCGLayout::get_##m_name); \
	ADD_PROPERTY(PropertyInfo(Variant::m_type, #m_name, PROPERTY_HINT_RANGE, m_hint), "set_" #m_name, "get_" #m_name)

void PCGLayout::_bind_methods() {
	BIND_ENUM_CONSTANT(KIND_GRID);
	BIND_ENUM_CONSTANT(KIND_RADIAL);
	BIND_ENUM_CONSTANT(KIND_GROWN);
	BIND_ENUM_CONSTANT(KIND_FOOTPRINTS);
	BIND_ENUM_CONSTANT(KIND_BLOCKS);
	ClassDB::bind_method(D_METHOD("set_kind", "kind"), &PCGLayout::set_kind);
	ClassDB::bind_method(D_METHOD("get_kind"), &PCGLayout::get_kind);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "kind", PROPERTY_HINT_ENUM, "Grid,Radial,Grown,Footprints,Blocks"), "set_kind", "get_kind");
	ClassDB::bind_method(D_METHOD("set_geojson", "path"), &PCGLayout::set_geojson);
	ClassDB::bind_method(D_METHOD("get_geojson"), &PCGLayout::get_geojson);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "geojson", PROPERTY_HINT_FILE, "*.geojson,*.json"), "set_geojson", "get_geojson");
	PCG_BIND(INT, rings, "1,100");
	PCG_BIND(INT, spokes, "5,64");
	PCG_BIND(INT, blocks_x, "1,100,1,or_greater");
	PCG_BIND(INT, blocks_z, "1,100,1,or_greater");
	PCG_BIND(INT, lots_along, "1,100");
	PCG_BIND(INT, lots_deep, "1,2");
	PCG_BIND(FLOAT, lot_front, "5,500,0.5,suffix:m");
	PCG_BIND(FLOAT, lot_aspect, "0.25,4,0.05");
	PCG_BIND(FLOAT, street_width, "2,100,0.5,suffix:m");
	PCG_BIND(FLOAT, main_street_width, "2,100,0.5,suffix:m");
	PCG_BIND(FLOAT, pavement_width, "0.5,50,0.5,suffix:m");
	PCG_BIND(FLOAT, jitter, "0,0.25,0.01");
	PCG_BIND(FLOAT, removed, "0,0.5,0.01");
	ClassDB::bind_method(D_METHOD("set_districts", "districts"), &PCGLayout::set_districts);
	ClassDB::bind_method(D_METHOD("get_districts"), &PCGLayout::get_districts);
	const String array_of_districts = vformat("%d/%d:PCGDistrict", int(Variant::OBJECT), int(PROPERTY_HINT_RESOURCE_TYPE));
	ADD_PROPERTY(PropertyInfo(Variant::ARRAY, "districts", PROPERTY_HINT_ARRAY_TYPE, array_of_districts), "set_districts", "get_districts");
	ClassDB::bind_method(D_METHOD("get_lot_count"), &PCGLayout::get_lot_count);
	ClassDB::bind_method(D_METHOD("fit_lots", "count"), &PCGLayout::fit_lots);
}

#undef PCG_BIND

#define PCG_SETTER(m_name, m_type, m_convert) \
	void PCGLayout::set_##m_name(m_type p_value) { \
		_parameters.m_name = m_convert(p_value); \
		emit_changed(); \
	}

PCG_SETTER(rings, int, to_count)
PCG_SETTER(spokes, int, to_count)
PCG_SETTER(blocks_x, int, to_count)
PCG_SETTER(blocks_z, int, to_count)
PCG_SETTER(lots_along, int, to_count)
PCG_SETTER(lots_deep, int, to_count)
PCG_SETTER(lot_front, double, float)
PCG_SETTER(lot_aspect, double, float)
PCG_SETTER(street_width, double, float)
PCG_SETTER(main_street_width, double, float)
PCG_SETTER(pavement_width, double, float)
PCG_SETTER(jitter, double, float)
PCG_SETTER(removed, double, float)

#undef PCG_SETTER

void PCGLayout::set_kind(Kind p_kind) {
	ERR_FAIL_COND_MSG(p_kind < KIND_GRID || p_kind > KIND_BLOCKS, "PCGLayout: kind is KIND_GRID, KIND_RADIAL, KIND_GROWN, KIND_FOOTPRINTS or KIND_BLOCKS.");
	_kind = p_kind;
	if (!is_drawn()) {
		_parameters.kind = LayoutKind(p_kind);
	}
	notify_property_list_changed();
	emit_changed();
}

void PCGLayout::set_geojson(const String &p_path) {
	_geojson = p_path;
	emit_changed();
}

// The inspector shows what the kind uses; all is stored.
void PCGLayout::_validate_property(PropertyInfo &p_property) const {
	const auto is = [&](const char *name) { return p_property.name == StringName(name); };
	const bool is_of_lots = is("lot_front") || is("lot_aspect") || is("jitter");
	const bool is_of_streets = is("rings") || is("spokes") || is("blocks_x") || is("blocks_z") || is("main_street_width") || is("lots_along") ||
			is("lots_deep") || is("removed");
	bool is_used = true;
	switch (_kind) {
		case KIND_GRID: is_used = !is("rings") && !is("spokes") && !is("main_street_width") && !is("geojson"); break;
		case KIND_RADIAL: is_used = !is("blocks_x") && !is("blocks_z") && !is("geojson"); break;
		case KIND_GROWN: is_used = !is("rings") && !is("spokes") && !is("geojson"); break;
		case KIND_FOOTPRINTS: is_used = !is_of_streets && !is_of_lots; break;
		case KIND_BLOCKS: is_used = !is_of_streets; break;
	}
	if (!is_used) {
		p_property.usage = PROPERTY_USAGE_STORAGE;
	}
}

void PCGLayout::set_districts(const TypedArray<PCGDistrict> &p_districts) {
	_districts = p_districts;
	emit_changed();
}

LayoutParameters PCGLayout::parameters() const {
	LayoutParameters parameters = _parameters;
	for (int64_t i = 0; i < _districts.size(); ++i) {
		const Ref<PCGDistrict> district = _districts[i];
		if (district.is_valid()) {
			parameters.districts.push_back(district->to_core());
		}
	}
	return parameters;
}

int PCGLayout::get_lot_count() const {
	if (is_drawn()) {
		return 0; // the city knows them
	}
	Diagnostics unheard;
	const std::optional<Layout> layout = make_layout(_parameters, unheard);
	return layout ? int(layout->lots.size()) : 0;
}

void PCGLayout::fit_lots(int p_count) {
	_parameters = layout_for_lots(to_count(p_count), _parameters);
	emit_changed();
}

} // namespace pcg
