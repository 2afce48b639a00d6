#pragma once

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/string.hpp>

#include "godot/nodes/city_link.h"

namespace pcg {

// A typed door in the scene: stands before its threshold, local +z looks out of the building.
class PCGEntrance : public godot::Node3D {
	GDCLASS(PCGEntrance, godot::Node3D)

public:
	void set_type(const godot::String &p_type);
	godot::String get_type() const { return _type; }
	void set_capacity(int p_capacity);
	int get_capacity() const { return _capacity; }
	void set_building_id(int p_id);
	int get_building_id() const { return _building_id; }
	void set_entrance_id(int p_id) { _link.set_id(p_id); }
	int get_entrance_id() const { return _link.id(); }
	void set_reachable(bool p_reachable);
	bool is_reachable() const { return _is_reachable; }

	godot::PackedStringArray _get_configuration_warnings() const override;

	// The same as set_building_id(), by the city itself.
	void lead_into(int p_building) { _building_id = p_building; }
	CityLink &link() { return _link; }

protected:
	static void _bind_methods();
	void _notification(int p_what) { _link.notify(this, p_what); }

private:
	CityLink _link{ CityLink::Kind::Entrance };
	godot::String _type;
	int _capacity = 0;
	int _building_id = -1;
	bool _is_reachable = true;
};

} // namespace pcg
