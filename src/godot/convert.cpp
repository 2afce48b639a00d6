#include "godot/convert.h"

#include <algorithm>
#include <cmath>

#include <godot_cpp/core/error_macros.hpp>

using namespace godot;

namespace pcg {

String to_godot(std::string_view text) {
	return String::utf8(text.data(), int64_t(text.size()));
}

std::string from_godot(const String &text) {
	const CharString bytes = text.utf8();
	return std::string(bytes.get_data(), size_t(bytes.length()));
}

PackedByteArray to_bytes(std::span<const uint8_t> bytes) {
	PackedByteArray result;
	result.resize(int64_t(bytes.size()));
	std::copy(bytes.begin(), bytes.end(), result.ptrw());
	return result;
}

PackedByteArray to_bytes(std::string_view bytes) { return to_bytes(std::span(reinterpret_cast<const uint8_t *>(bytes.data()), bytes.size())); }

std::string_view view_of(const PackedByteArray &bytes) { return { reinterpret_cast<const char *>(bytes.ptr()), size_t(bytes.size()) }; }

PackedStringArray to_godot(const std::vector<std::string> &texts) {
	PackedStringArray result;
	for (const std::string &text : texts) {
		result.push_back(to_godot(std::string_view(text)));
	}
	return result;
}

std::vector<std::string> from_godot(const PackedStringArray &texts) {
	std::vector<std::string> result;
	for (int64_t i = 0; i < texts.size(); ++i) {
		result.push_back(from_godot(texts[i]));
	}
	return result;
}

PackedVector3Array to_godot(std::span<const glm::vec3> points) {
	PackedVector3Array result;
	result.resize(int64_t(points.size()));
	Vector3 *out = result.ptrw();
	for (size_t i = 0; i < points.size(); ++i) {
		out[i] = to_godot(points[i]);
	}
	return result;
}

std::vector<glm::vec3> from_godot(const PackedVector3Array &points) {
	std::vector<glm::vec3> result;
	result.reserve(size_t(points.size()));
	const Vector3 *in = points.ptr();
	for (int64_t i = 0; i < points.size(); ++i) {
		result.push_back(from_godot(in[i]));
	}
	return result;
}

Dictionary to_godot(const Diagnostic &diagnostic) {
	Dictionary result;
	result["severity"] = diagnostic.severity == Severity::Error ? "error" : "warning";
	result["id"] = to_godot(diagnostic.id);
	result["file"] = to_godot(std::string_view(diagnostic.file));
	result["line"] = diagnostic.line;
	result["column"] = diagnostic.column;
	result["message"] = to_godot(std::string_view(diagnostic.message));
	result["hint"] = to_godot(std::string_view(diagnostic.hint));
	result["source"] = to_godot(std::string_view(diagnostic.source));
	return result;
}

TypedArray<Dictionary> to_godot(const Diagnostics &diagnostics) {
	TypedArray<Dictionary> result;
	for (const Diagnostic &diagnostic : diagnostics.list()) {
		result.push_back(to_godot(diagnostic));
	}
	return result;
}

std::vector<AttributeOverride> from_godot(const Dictionary &attributes, Diagnostics &diagnostics) {
	std::vector<AttributeOverride> result;
	const Array names = attributes.keys();
	for (int64_t i = 0; i < names.size(); ++i) {
		const String name = names[i];
		const Variant value = attributes[names[i]];
		switch (value.get_type()) {
			case Variant::BOOL: result.push_back({ from_godot(name), bool(value) }); break;
			case Variant::INT:
			case Variant::FLOAT: result.push_back({ from_godot(name), double(value) }); break;
			case Variant::STRING:
			case Variant::STRING_NAME: {
				const String text = value;
				result.push_back({ from_godot(name), from_godot(text) });
				break;
			}
			default:
				diagnostics.warning("attribute-type", "attribute \"" + from_godot(name) + "\" must be a number, true or false, or text", "it is left out");
				break;
		}
	}
	return result;
}

Transform3D to_godot(glm::vec3 position, glm::vec3 facing) {
	const float length = std::sqrt(facing.x * facing.x + facing.z * facing.z);
	Vector3 front(0, 0, 1); // also for a direction straight up or down, which has no horizontal part
	if (length > 1e-6f) {
		front = Vector3(facing.x / length, 0, facing.z / length);
	}
	const Vector3 up(0, 1, 0);
	return Transform3D(Basis(up.cross(front), up, front), to_godot(position));
}

glm::mat4 from_godot(const Transform3D &transform) {
	const auto column = [&](int axis) { return glm::vec4(from_godot(transform.basis.get_column(axis)), 0.0f); };
	return { column(0), column(1), column(2), glm::vec4(from_godot(transform.origin), 1.0f) };
}

glm::vec3 facing_of(const Transform3D &transform) {
	return from_godot(transform.basis.get_column(2).normalized());
}

} // namespace pcg
