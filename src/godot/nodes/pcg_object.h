#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/typed_array.hpp>
#include <godot_cpp/variant/vector2.hpp>

#include "godot/nodes/city_link.h"

namespace pcg {

// Something in the city that people use: a bench, a fountain. Places are local frames in which one person each stands or sits, with local
// +z the way that the person looks.
class PCGObject : public godot::Node3D {
	GDCLASS(PCGObject, godot::Node3D)

public:
	void set_type(const godot::String &p_type);
	godot::String get_type() const { return _type; }
	void set_places(const godot::TypedArray<godot::Transform3D> &p_places);
	godot::TypedArray<godot::Transform3D> get_places() const { return _places; }
	void set_object_id(int p_id) { _link.set_id(p_id); }
	int get_object_id() const { return _link.id(); }

	// Metres along the node's x and z, around it, on which nobody can walk; 0 = nothing stands in the way.
	void set_footprint(const godot::Vector2 &p_metres);
	godot::Vector2 get_footprint() const { return _footprint; }
	std::vector<glm::vec3> footprint_corners() const; // local, counter-clockwise from above; none without a footprint

	godot::PackedStringArray _get_configuration_warnings() const override;

	CityLink &link() { return _link; }

protected:
	static void _bind_methods();
	void _notification(int p_what) { _link.notify(this, p_what); }

private:
	CityLink _link{ CityLink::Kind::Object };
	godot::String _type;
	godot::TypedArray<godot::Transform3D> _places;
	godot::Vector2 _footprint;
};

} // namespace pcg
