#include "godot/nodes/pcg_object.h"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>

using namespace godot;

namespace pcg {

void PCGObject::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_type", "type"), &PCGObject::set_type);
	ClassDB::bind_method(D_METHOD("get_type"), &PCGObject::get_type);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "type"), "set_type", "get_type");
	ClassDB::bind_method(D_METHOD("set_places", "places"), &PCGObject::set_places);
	ClassDB::bind_method(D_METHOD("get_places"), &PCGObject::get_places);
	ADD_PROPERTY(PropertyInfo(Variant::ARRAY, "places", PROPERTY_HINT_ARRAY_TYPE, "Transform3D"), "set_places", "get_places");
	ClassDB::bind_method(D_METHOD("set_footprint", "metres"), &PCGObject::set_footprint);
	ClassDB::bind_method(D_METHOD("get_footprint"), &PCGObject::get_footprint);
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR2, "footprint", PROPERTY_HINT_NONE, "suffix:m"), "set_footprint", "get_footprint");
	ClassDB::bind_method(D_METHOD("set_object_id", "id"), &PCGObject::set_object_id);
	ClassDB::bind_method(D_METHOD("get_object_id"), &PCGObject::get_object_id);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "object_id"), "set_object_id", "get_object_id");
}

void PCGObject::set_type(const String &p_type) {
	_type = p_type;
	_link.note_change(this);
	update_configuration_warnings();
}

void PCGObject::set_places(const TypedArray<Transform3D> &p_places) {
	_places = p_places;
	_link.note_change(this);
}

void PCGObject::set_footprint(const Vector2 &p_metres) {
	ERR_FAIL_COND_MSG(!(p_metres.x >= 0.0f && p_metres.y >= 0.0f), "PCGObject: a footprint is 0 m or more along x and z.");
	_footprint = p_metres;
	_link.note_change(this);
}

std::vector<glm::vec3> PCGObject::footprint_corners() const {
	if (!(_footprint.x > 0.0f && _footprint.y > 0.0f)) {
		return {};
	}
	const float x = float(_footprint.x) / 2.0f, z = float(_footprint.y) / 2.0f;
	return { { -x, 0.0f, z }, { x, 0.0f, z }, { x, 0.0f, -z }, { -x, 0.0f, -z } };
}

PackedStringArray PCGObject::_get_configuration_warnings() const {
	PackedStringArray warnings;
	CityLink::warn(this, warnings);
	if (_type.is_empty()) {
		warnings.push_back("This object has no type. Give it one that rules ask for, such as \"bench\".");
	}
	return warnings;
}

} // namespace pcg
