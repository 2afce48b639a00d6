#pragma once

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/string.hpp>

#include "godot/nodes/city_link.h"

namespace pcg {

// A typed prism of interest in the scene. The outline is local to the node, which stands at the zone's centre of area.
class PCGZone : public godot::Node3D {
	GDCLASS(PCGZone, godot::Node3D)

public:
	void set_type(const godot::String &p_type);
	godot::String get_type() const { return _type; }
	void set_polygon(const godot::PackedVector3Array &p_polygon);
	godot::PackedVector3Array get_polygon() const { return _polygon; }
	void set_height(double p_height);
	double get_height() const { return _height; }
	void set_zone_id(int p_id) { _link.set_id(p_id); }
	int get_zone_id() const { return _link.id(); }
	void set_reachable(bool p_reachable);
	bool is_reachable() const { return _is_reachable; }
	// Whether a point of the world lies above the ground outline; heights are ignored.
	bool contains(const godot::Vector3 &p_point) const;

	godot::PackedStringArray _get_configuration_warnings() const override;

	CityLink &link() { return _link; }

protected:
	static void _bind_methods();
	void _notification(int p_what) { _link.notify(this, p_what); }

private:
	CityLink _link{ CityLink::Kind::Zone };
	godot::String _type;
	godot::PackedVector3Array _polygon;
	double _height = 3.0;
	bool _is_reachable = true;
};

} // namespace pcg
