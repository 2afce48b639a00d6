#include "godot/nodes/drawn_footprints.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include <godot_cpp/classes/curve3d.hpp>
#include <godot_cpp/classes/path3d.hpp>
#include <godot_cpp/classes/polygon2d.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>

#include "core/geometry/polygon.h"
#include "godot/convert.h"

using namespace godot;

namespace pcg {

namespace {

constexpr double joined = 0.05; // metres; a last point this near to the first one closes the outline

Loop2 outline_of(const Path3D *path, const Path3D *parent) {
	const Ref<Curve3D> curve = path->get_curve();
	const PackedVector3Array points = curve.is_valid() ? curve->tessellate() : PackedVector3Array();
	const Transform3D frame = (parent ? parent->get_transform() : Transform3D()) * path->get_transform();
	Loop2 outline;
	for (int64_t i = 0; i < points.size(); ++i) {
		const Vector3 point = frame.xform(points[i]);
		outline.push_back({ double(point.x), -double(point.z) });
	}
	return outline;
}

Loop2 outline_of(const Polygon2D *polygon, const Polygon2D *parent) {
	const PackedVector2Array points = polygon->get_polygon();
	const Transform2D frame = (parent ? parent->get_transform() : Transform2D()) * polygon->get_transform();
	Loop2 outline;
	for (int64_t i = 0; i < points.size(); ++i) {
		const Vector2 point = frame.xform(points[i]);
		outline.push_back({ double(point.x), -double(point.y) });
	}
	return outline;
}

// In the city's plan, counter-clockwise; nothing for other nodes. As in the engine, only a parent of the same kind moves a node.
std::optional<Loop2> drawn_outline(const Node *node, const Node *parent) {
	Loop2 outline;
	if (const Path3D *path = Object::cast_to<Path3D>(node)) {
		outline = outline_of(path, Object::cast_to<Path3D>(parent));
	} else if (const Polygon2D *polygon = Object::cast_to<Polygon2D>(node)) {
		outline = outline_of(polygon, Object::cast_to<Polygon2D>(parent));
	} else {
		return std::nullopt;
	}
	if (outline.size() > 1 && glm::distance(outline.front(), outline.back()) < joined) {
		outline.pop_back();
	}
	if (signed_area(outline) < 0.0) {
		std::reverse(outline.begin(), outline.end());
	}
	return outline;
}

// What is no number at all becomes none, which is told like one that is too large.
float drawn_height(const Node *node) {
	const Variant height = node->get_meta("height", 0.0);
	const bool is_number = height.get_type() == Variant::FLOAT || height.get_type() == Variant::INT;
	return is_number ? float(double(height)) : height.get_type() == Variant::STRING && String(height).is_valid_float() ? float(String(height).to_float()) : NAN;
}

} // namespace

std::vector<Footprint> drawn_footprints(const Node3D *city) {
	std::vector<Footprint> result;
	for (int i = 0; i < city->get_child_count(); ++i) {
		const Node *child = city->get_child(i);
		std::optional<Loop2> outline = drawn_outline(child, nullptr);
		if (!outline) {
			continue;
		}
		Footprint &footprint = result.emplace_back();
		footprint.outline = std::move(*outline);
		for (int j = 0; j < child->get_child_count(); ++j) {
			if (std::optional<Loop2> hole = drawn_outline(child->get_child(j), child)) {
				footprint.holes.push_back(std::move(*hole));
			}
		}
		footprint.name = from_godot(String(child->get_name()));
		footprint.type = from_godot(String(child->get_meta("lot_type", "")));
		footprint.height = drawn_height(child);
	}
	return result;
}

} // namespace pcg
