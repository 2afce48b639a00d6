#include "godot/nodes/pcg_lot.h"

#include <godot_cpp/core/class_db.hpp>

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
}

void PCGLot::set_lot_id(int p_id) {
	_link.set_id(p_id);
	_link.note_change(this);
}

} // namespace pcg
