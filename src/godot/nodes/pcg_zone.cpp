#include "godot/nodes/pcg_zone.h"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>

#include "core/semantics/city_query.h"
#include "godot/convert.h"

using namespace godot;

namespace pcg {

void PCGZone::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_type", "type"), &PCGZone::set_type);
	ClassDB::bind_method(D_METHOD("get_type"), &PCGZone::get_type);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "type"), "set_type", "get_type");
	ClassDB::bind_method(D_METHOD("set_polygon", "polygon"), &PCGZone::set_polygon);
	ClassDB::bind_method(D_METHOD("get_polygon"), &PCGZone::get_polygon);
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_VECTOR3_ARRAY, "polygon"), "set_polygon", "get_polygon");
	ClassDB::bind_method(D_METHOD("set_height", "height"), &PCGZone::set_height);
	ClassDB::bind_method(D_METHOD("get_height"), &PCGZone::get_height);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "height", PROPERTY_HINT_RANGE, "0,100,0.01,or_greater,suffix:m"), "set_height",
			"get_height");
	ClassDB::bind_method(D_METHOD("set_zone_id", "id"), &PCGZone::set_zone_id);
	ClassDB::bind_method(D_METHOD("get_zone_id"), &PCGZone::get_zone_id);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "zone_id"), "set_zone_id", "get_zone_id");
	ClassDB::bind_method(D_METHOD("set_reachable", "reachable"), &PCGZone::set_reachable);
	ClassDB::bind_method(D_METHOD("is_reachable"), &PCGZone::is_reachable);
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "reachable"), "set_reachable", "is_reachable");
	ClassDB::bind_method(D_METHOD("contains", "point"), &PCGZone::contains);
}

void PCGZone::set_type(const String &p_type) {
	_type = p_type;
	_link.note_change(this);
	update_configuration_warnings();
}

void PCGZone::set_polygon(const PackedVector3Array &p_polygon) {
	_polygon = p_polygon;
	_link.note_change(this);
	update_configuration_warnings();
}

void PCGZone::set_height(double p_height) {
	ERR_FAIL_COND_MSG(!(p_height >= 0.0), "PCGZone: a height is 0 m or more.");
	_height = p_height;
	_link.note_change(this);
}

void PCGZone::set_reachable(bool p_reachable) {
	_is_reachable = p_reachable;
	update_configuration_warnings();
}

bool PCGZone::contains(const Vector3 &p_point) const {
	Zone zone;
	zone.polygon = from_godot(_polygon);
	const Vector3 local = is_inside_tree() ? get_global_transform().affine_inverse().xform(p_point)
										   : get_transform().affine_inverse().xform(p_point);
	return pcg::contains(zone, from_godot(local));
}

PackedStringArray PCGZone::_get_configuration_warnings() const {
	PackedStringArray warnings;
	CityLink::warn(this, warnings);
	if (_type.is_empty()) {
		warnings.push_back("This zone has no type. Give it one that rules ask for, such as \"park\".");
	}
	if (_polygon.size() < 3) {
		warnings.push_back("This zone has no ground: give its polygon at least three corners.");
	} else if (!_is_reachable) {
		warnings.push_back("Nobody can walk to this zone. Leave free ground in it, or beside it, and from there to the street.");
	}
	return warnings;
}

} // namespace pcg
