#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/navigation_mesh.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/variant/color.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>
#include <godot_cpp/variant/vector2.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include "core/base/diagnostic.h"
#include "core/cga/derivation.h"
#include "core/figure/figure.h"
#include "core/geometry/mesh.h"
#include "core/navigation/nav_mesh.h"

// The only place that knows both worlds. Core and engine agree on metres, y up, right-handed axes and -z as north, so vectors are copied
// as they are; text is UTF-8 in the core; what differs (winding of triangles) is said at the function.
namespace pcg {

inline godot::Vector2 to_godot(glm::vec2 value) { return godot::Vector2(value.x, value.y); }
inline godot::Vector3 to_godot(glm::vec3 value) { return godot::Vector3(value.x, value.y, value.z); }
inline godot::Color to_godot(glm::vec4 value) { return godot::Color(value.x, value.y, value.z, value.w); }
inline glm::vec2 from_godot(godot::Vector2 value) { return { float(value.x), float(value.y) }; }
inline glm::vec3 from_godot(godot::Vector3 value) { return { float(value.x), float(value.y), float(value.z) }; }
inline glm::vec4 from_godot(godot::Color value) { return { value.r, value.g, value.b, value.a }; }

// Bytes that are not UTF-8 become the replacement character.
godot::String to_godot(std::string_view text);
std::string from_godot(const godot::String &text);
godot::PackedByteArray to_bytes(std::span<const uint8_t> bytes);
godot::PackedByteArray to_bytes(std::string_view bytes);
// Holds until the array changes or goes.
std::string_view view_of(const godot::PackedByteArray &bytes);
godot::PackedStringArray to_godot(const std::vector<std::string> &texts);
std::vector<std::string> from_godot(const godot::PackedStringArray &texts);

godot::PackedVector3Array to_godot(std::span<const glm::vec3> points);
std::vector<glm::vec3> from_godot(const godot::PackedVector3Array &points);

// Keys: severity ("error", "warning"), id, file, line, column, message, hint, source. Line and column count from 1, 0 = unknown.
godot::Dictionary to_godot(const Diagnostic &diagnostic);
godot::TypedArray<godot::Dictionary> to_godot(const Diagnostics &diagnostics);

// Attribute overrides by name: numbers, true or false, text. Other values are left out, with a warning that names them.
std::vector<AttributeOverride> from_godot(const godot::Dictionary &attributes, Diagnostics &diagnostics);

glm::mat4 from_godot(const godot::Transform3D &transform);
// A frame that stands at `position` and whose local +z (the front of Godot's models) looks along the horizontal part of `facing`.
godot::Transform3D to_godot(glm::vec3 position, glm::vec3 facing);
// The direction that such a frame looks along; unit length.
glm::vec3 facing_of(const godot::Transform3D &transform);

// What the engine baked, for the core to find ways on.
NavRegion from_godot(const godot::Ref<godot::NavigationMesh> &mesh);
// With what figure.gdshader wants in UV and UV2.
godot::Ref<godot::ArrayMesh> to_godot(const Figure &figure);

} // namespace pcg
