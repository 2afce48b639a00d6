#pragma once

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/string.hpp>

namespace pcg {

// A typed door in the scene: stands before its threshold, local +z looks out of the building.
class PCGEntrance : public godot::Node3D {
	GDCLASS(PCGEntrance, godot::Node3D)

public:
	void set_type(const godot::String &p_type);
	godot::String get_type() const { return _type; }
	void set_capacity(int p_capacity);
	int get_capacity() const { return _capacity; }
	void set_building_id(int p_id) { _building_id = p_id; }
	int get_building_id() const { return _building_id; }
	void set_entrance_id(int p_id) { _entrance_id = p_id; }
	int get_entrance_id() const { return _entrance_id; }
	void set_reachable(bool p_reachable);
	bool is_reachable() const { return _is_reachable; }

	godot::PackedStringArray _get_configuration_warnings() const override;

protected:
	static void _bind_methods();

private:
	godot::String _type;
	int _capacity = 0;
	int _building_id = -1;
	int _entrance_id = -1;
	bool _is_reachable = true;
};

} // namespace pcg
