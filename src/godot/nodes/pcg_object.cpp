#include "godot/nodes/pcg_object.h"

#include <godot_cpp/core/class_db.hpp>

using namespace godot;

namespace pcg {

void PCGObject::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_type", "type"), &PCGObject::set_type);
	ClassDB::bind_method(D_METHOD("get_type"), &PCGObject::get_type);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "type"), "set_type", "get_type");
	ClassDB::bind_method(D_METHOD("set_places", "places"), &PCGObject::set_places);
	ClassDB::bind_method(D_METHOD("get_places"), &PCGObject::get_places);
	ADD_PROPERTY(PropertyInfo(Variant::ARRAY, "places", PROPERTY_HINT_ARRAY_TYPE, "Transform3D"), "set_places", "get_places");
	ClassDB::bind_method(D_METHOD("set_object_id", "id"), &PCGObject::set_object_id);
	ClassDB::bind_method(D_METHOD("get_object_id"), &PCGObject::get_object_id);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "object_id"), "set_object_id", "get_object_id");
}

void PCGObject::set_type(const String &p_type) {
	_type = p_type;
	update_configuration_warnings();
}

PackedStringArray PCGObject::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (_type.is_empty()) {
		warnings.push_back("This object has no type. Give it one that rules ask for, such as \"bench\".");
	}
	return warnings;
}

} // namespace pcg
