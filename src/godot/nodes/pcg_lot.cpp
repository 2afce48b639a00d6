#include "godot/nodes/pcg_lot.h"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/object.hpp>

using namespace godot;

namespace pcg {

void PCGLot::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_lot_id", "id"), &PCGLot::set_lot_id);
	ClassDB::bind_method(D_METHOD("get_lot_id"), &PCGLot::get_lot_id);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "lot_id"), "set_lot_id", "get_lot_id");
	ClassDB::bind_method(D_METHOD("set_block_id", "id"), &PCGLot::set_block_id);
	ClassDB::bind_method(D_METHOD("get_block_id"), &PCGLot::get_block_id);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "block_id"), "set_block_id", "get_block_id");
	ClassDB::bind_method(D_METHOD("set_type", "type"), &PCGLot::set_type);
	ClassDB::bind_method(D_METHOD("get_type"), &PCGLot::get_type);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "type"), "set_type", "get_type");
	ClassDB::bind_method(D_METHOD("set_polygon", "polygon"), &PCGLot::set_polygon);
	ClassDB::bind_method(D_METHOD("get_polygon"), &PCGLot::get_polygon);
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_VECTOR3_ARRAY, "polygon"), "set_polygon", "get_polygon");
	ClassDB::bind_method(D_METHOD("set_holes", "holes"), &PCGLot::set_holes);
	ClassDB::bind_method(D_METHOD("get_holes"), &PCGLot::get_holes);
	ADD_PROPERTY(PropertyInfo(Variant::ARRAY, "holes", PROPERTY_HINT_ARRAY_TYPE, "PackedVector3Array"), "set_holes", "get_holes");
	ClassDB::bind_method(D_METHOD("get_overlapping_lots"), &PCGLot::get_overlapping_lots);
}

void PCGLot::set_overlaps(std::vector<Overlap> overlaps) {
	if (_overlaps != overlaps) {
		_overlaps = std::move(overlaps);
		update_configuration_warnings();
	}
}

TypedArray<PCGLot> PCGLot::get_overlapping_lots() const {
	TypedArray<PCGLot> lots;
	for (const Overlap &overlap : _overlaps) {
		if (PCGLot *lot = Object::cast_to<PCGLot>(ObjectDB::get_instance(overlap.object))) {
			lots.push_back(lot);
		}
	}
	return lots;
}

String PCGLot::title() const { return String(get_name()) + (_type.is_empty() ? String() : " (" + _type + ")"); }

PackedStringArray PCGLot::_get_configuration_warnings() const {
	PackedStringArray warnings;
	CityLink::warn(this, warnings);
	for (const Overlap &overlap : _overlaps) {
		if (const PCGLot *lot = Object::cast_to<PCGLot>(ObjectDB::get_instance(overlap.object))) {
			warnings.push_back(title() + " and " + lot->title() + " overlap by " + String::num(overlap.area, 1) + " square metres. Move one of them.");
		}
	}
	return warnings;
}

void PCGLot::set_lot_id(int p_id) {
	_link.set_id(p_id);
	_link.note_change(this);
}

} // namespace pcg
