#pragma once

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace pcg {

// Sends a value through the core's types and back, for the tests of convert.h. In debug builds only.
class PCGConvertProbe : public godot::RefCounted {
	GDCLASS(PCGConvertProbe, godot::RefCounted)

public:
	// Vector2, Vector3, Color, String, PackedStringArray, PackedVector3Array, Transform3D (an upright frame) and Dictionary (attributes); null
	// for all others.
	static godot::Variant round_trip(const godot::Variant &p_value);
	// What the engine gets to see of a diagnostic with every field filled in.
	static godot::Dictionary sample_diagnostic();

protected:
	static void _bind_methods();
};

} // namespace pcg
