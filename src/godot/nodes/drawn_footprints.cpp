#include "godot/nodes/drawn_footprints.h"

#include <algorithm>

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

void add_outline(const Path3D *path, Loop2 &outline) {
	const Ref<Curve3D> curve = path->get_curve();
	const PackedVector3Array points = curve.is_valid() ? curve->tessellate() : PackedVector3Array();
	for (int64_t i = 0; i < points.size(); ++i) {
		const Vector3 point = path->get_transform().xform(points[i]);
		outline.push_back({ double(point.x), -double(point.z) });
	}
}

void add_outline(const Polygon2D *polygon, Loop2 &outline) {
	const PackedVector2Array points = polygon->get_polygon();
	const Transform2D frame = polygon->get_transform();
	for (int64_t i = 0; i < points.size(); ++i) {
		const Vector2 point = frame.xform(points[i]);
		outline.push_back({ double(point.x), -double(point.y) });
	}
}

} // namespace

std::vector<Footprint> drawn_footprints(const Node3D *city) {
	std::vector<Footprint> result;
	for (int i = 0; i < city->get_child_count(); ++i) {
		const Node *child = city->get_child(i);
		Footprint footprint;
		if (const Path3D *path = Object::cast_to<Path3D>(child)) {
			add_outline(path, footprint.outline);
		} else if (const Polygon2D *polygon = Object::cast_to<Polygon2D>(child)) {
			add_outline(polygon, footprint.outline);
		} else {
			continue;
		}
		Loop2 &outline = footprint.outline;
		if (outline.size() > 1 && glm::distance(outline.front(), outline.back()) < joined) {
			outline.pop_back();
		}
		if (signed_area(outline) < 0.0) {
			std::reverse(outline.begin(), outline.end());
		}
		footprint.name = from_godot(String(child->get_name()));
		footprint.type = from_godot(String(child->get_meta("lot_type", "")));
		footprint.height = float(double(child->get_meta("height", 0.0)));
		result.push_back(std::move(footprint));
	}
	return result;
}

} // namespace pcg
