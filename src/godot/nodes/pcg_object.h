#pragma once

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/typed_array.hpp>

namespace pcg {

// Something in the city that people use: a bench, a fountain. Places are local frames in which one person each stands or sits, with local
// +z the way that the person looks.
class PCGObject : public godot::Node3D {
	GDCLASS(PCGObject, godot::Node3D)

public:
	void set_type(const godot::String &p_type);
	godot::String get_type() const { return _type; }
	void set_places(const godot::TypedArray<godot::Transform3D> &p_places) { _places = p_places; }
	godot::TypedArray<godot::Transform3D> get_places() const { return _places; }
	void set_object_id(int p_id) { _object_id = p_id; }
	int get_object_id() const { return _object_id; }

	godot::PackedStringArray _get_configuration_warnings() const override;

protected:
	static void _bind_methods();

private:
	godot::String _type;
	godot::TypedArray<godot::Transform3D> _places;
	int _object_id = -1;
};

} // namespace pcg
