#include "probe_values.h"

#include <godot_cpp/core/class_db.hpp>

using namespace godot;

TypedArray<int> ProbeValues::make_numbers() const {
	TypedArray<int> numbers;
	numbers.push_back(3);
	numbers.push_back(4);
	return numbers;
}

// Long because it is a table: one line a type.
void ProbeValues::_bind_methods() {
#define BIND_ECHO(m_name, m_type)                                                                                      \
	ClassDB::bind_static_method("ProbeValues", D_METHOD("echo_" m_name, "value"), &ProbeValues::echo<m_type>)
#define BIND_NUMBER(m_name, m_type)                                                                                    \
	ClassDB::bind_static_method("ProbeValues", D_METHOD("echo_" m_name, "value"), &ProbeValues::echo_number<m_type>)
	BIND_NUMBER("bool", bool);
	BIND_NUMBER("int8", int8_t);
	BIND_NUMBER("int16", int16_t);
	BIND_NUMBER("int32", int32_t);
	BIND_NUMBER("int64", int64_t);
	BIND_NUMBER("uint8", uint8_t);
	BIND_NUMBER("uint16", uint16_t);
	BIND_NUMBER("uint32", uint32_t);
	BIND_NUMBER("uint64", uint64_t);
	BIND_NUMBER("float", float);
	BIND_NUMBER("double", double);
	BIND_ECHO("string", String);
	BIND_ECHO("string_name", StringName);
	BIND_ECHO("node_path", NodePath);
	BIND_ECHO("vector2", Vector2);
	BIND_ECHO("vector2i", Vector2i);
	BIND_ECHO("rect2", Rect2);
	BIND_ECHO("rect2i", Rect2i);
	BIND_ECHO("vector3", Vector3);
	BIND_ECHO("vector3i", Vector3i);
	BIND_ECHO("transform2d", Transform2D);
	BIND_ECHO("vector4", Vector4);
	BIND_ECHO("vector4i", Vector4i);
	BIND_ECHO("plane", Plane);
	BIND_ECHO("quaternion", Quaternion);
	BIND_ECHO("aabb", AABB);
	BIND_ECHO("basis", Basis);
	BIND_ECHO("transform3d", Transform3D);
	BIND_ECHO("projection", Projection);
	BIND_ECHO("color", Color);
	BIND_ECHO("rid", RID);
	BIND_ECHO("callable", Callable);
	BIND_ECHO("signal", Signal);
	BIND_ECHO("dictionary", Dictionary);
	BIND_ECHO("array", Array);
	BIND_ECHO("bytes", PackedByteArray);
	BIND_ECHO("int32s", PackedInt32Array);
	BIND_ECHO("int64s", PackedInt64Array);
	BIND_ECHO("float32s", PackedFloat32Array);
	BIND_ECHO("float64s", PackedFloat64Array);
	BIND_ECHO("strings", PackedStringArray);
	BIND_ECHO("vector2s", PackedVector2Array);
	BIND_ECHO("vector3s", PackedVector3Array);
	BIND_ECHO("colors", PackedColorArray);
	BIND_ECHO("vector4s", PackedVector4Array);
#undef BIND_ECHO
#undef BIND_NUMBER
	ClassDB::bind_method(D_METHOD("echo_variant", "value"), &ProbeValues::echo_variant);
	ClassDB::bind_method(D_METHOD("echo_node", "node"), &ProbeValues::echo_node);
	ClassDB::bind_method(D_METHOD("echo_object", "object"), &ProbeValues::echo_object);
	ClassDB::bind_method(D_METHOD("echo_resource", "resource"), &ProbeValues::echo_resource);
	ClassDB::bind_method(D_METHOD("echo_nodes", "nodes"), &ProbeValues::echo_nodes);
	ClassDB::bind_method(D_METHOD("echo_points", "points"), &ProbeValues::echo_points);
	ClassDB::bind_method(D_METHOD("echo_counts", "counts"), &ProbeValues::echo_counts);
	ClassDB::bind_method(D_METHOD("make_numbers"), &ProbeValues::make_numbers);
	ClassDB::bind_method(D_METHOD("name_of", "node"), &ProbeValues::name_of);
}
