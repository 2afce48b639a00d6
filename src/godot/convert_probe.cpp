#include "godot/convert_probe.h"

#include <godot_cpp/core/class_db.hpp>

#include "godot/convert.h"
#include "godot/report.h"

using namespace godot;

namespace pcg {

void PCGConvertProbe::_bind_methods() {
	ClassDB::bind_static_method("PCGConvertProbe", D_METHOD("round_trip", "value"), &PCGConvertProbe::round_trip);
	ClassDB::bind_static_method("PCGConvertProbe", D_METHOD("sample_diagnostic"), &PCGConvertProbe::sample_diagnostic);
}

static Dictionary attributes_and_back(const Dictionary &attributes) {
	Dictionary result;
	Diagnostics diagnostics;
	for (const auto &[name, value] : from_godot(attributes, diagnostics)) {
		const String key = to_godot(std::string_view(name));
		if (const double *number = std::get_if<double>(&value)) {
			result[key] = *number;
		} else if (const bool *boolean = std::get_if<bool>(&value)) {
			result[key] = *boolean;
		} else {
			result[key] = to_godot(std::string_view(std::get<std::string>(value)));
		}
	}
	report(diagnostics);
	return result;
}

// Copy-initialised: T(value) would leave the choice between T's constructors open.
template <typename T> static T as(const Variant &value) {
	const T result = value;
	return result;
}

Variant PCGConvertProbe::round_trip(const Variant &p_value) {
	switch (p_value.get_type()) {
		case Variant::VECTOR2: return to_godot(from_godot(as<Vector2>(p_value)));
		case Variant::VECTOR3: return to_godot(from_godot(as<Vector3>(p_value)));
		case Variant::COLOR: return to_godot(from_godot(as<Color>(p_value)));
		case Variant::STRING: return to_godot(std::string_view(from_godot(as<String>(p_value))));
		case Variant::PACKED_STRING_ARRAY: return to_godot(from_godot(as<PackedStringArray>(p_value)));
		case Variant::PACKED_VECTOR3_ARRAY: {
			const std::vector<glm::vec3> points = from_godot(as<PackedVector3Array>(p_value));
			return to_godot(std::span<const glm::vec3>(points));
		}
		case Variant::TRANSFORM3D: {
			const Transform3D frame = p_value;
			return to_godot(from_godot(frame.origin), facing_of(frame));
		}
		case Variant::DICTIONARY: return attributes_and_back(p_value);
		default: return Variant();
	}
}

Dictionary PCGConvertProbe::sample_diagnostic() {
	return to_godot(Diagnostic{ Severity::Warning, "sample", "ä.cga", 3, 7, "a message", "a hint", "Lot --> X" });
}

} // namespace pcg
