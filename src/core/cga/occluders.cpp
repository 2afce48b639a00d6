#include "core/cga/occluders.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include "core/cga/measure.h"
#include "core/cga/primitives.h"

namespace pcg::cga {

namespace {

bool is_flat(const Shape &shape) {
	const glm::dvec3 extent = (shape.geometry->high - shape.geometry->low) * shape.geometry_scale;
	return extent.x == 0.0 || extent.y == 0.0 || extent.z == 0.0;
}

// The faces in world coordinates, turned around where a negative scale turned the geometry inside out.
Solid solid_of(const Geometry &geometry, const Shape &shape, const Frame &frame) {
	Solid solid;
	solid.is_closed = geometry.is_closed && !is_flat(shape);
	const bool is_mirrored = shape.geometry_scale.x * shape.geometry_scale.y * shape.geometry_scale.z < 0.0;
	std::vector<glm::dvec3> points;
	std::vector<uint32_t> loop_ends;
	for (uint32_t i = 0; i < geometry.face_count; ++i) {
		const GeometryFace &face = geometry.faces[i];
		points.clear();
		loop_ends.clear();
		for (uint32_t l = 0; l < face.loop_count; ++l) {
			for (const glm::dvec3 &point : geometry.loop(face.first_loop + l)) {
				points.push_back(frame.to_parent(shape.to_scope(point)));
			}
			loop_ends.push_back(uint32_t(points.size()));
			if (is_mirrored) {
				std::reverse(points.begin() + (l > 0 ? loop_ends[l - 1] : 0), points.end());
			}
		}
		if (loop_ends[0] >= 3) {
			solid.add_polygon(points, loop_ends);
		}
	}
	return solid;
}

Solid box_solid(const Shape &shape, const Frame &frame) {
	Arena arena;
	const Geometry *cube = make_primitive(PrimitiveKind::PlainCube, 0, 0, arena);
	Shape box = shape;
	const glm::dvec3 extent = shape.geometry->high - shape.geometry->low;
	box.geometry_offset = shape.to_scope(shape.geometry->low);
	box.geometry_scale = shape.geometry_scale * extent;
	box.geometry = cube;
	return solid_of(*cube, box, frame);
}

} // namespace

Solid world_solid(const Shape &shape, glm::dvec3 origin) {
	Frame frame = shape.frame();
	frame.origin += origin;
	const Geometry &geometry = *shape.geometry;
	return geometry.face_count > Occluders::max_faces ? box_solid(shape, frame) : solid_of(geometry, shape, frame);
}

Bounds3 world_bounds(const Shape &shape, glm::dvec3 origin) {
	Frame frame = shape.frame();
	frame.origin += origin;
	if (shape.geometry == nullptr) {
		return { frame.origin, frame.origin };
	}
	const auto to_world = [&](glm::dvec3 point) { return frame.to_parent(shape.to_scope(point)); };
	Bounds3 bounds = { to_world(shape.geometry->points[0]), to_world(shape.geometry->points[0]) };
	for (uint32_t i = 1; i < shape.geometry->point_count; ++i) {
		const glm::dvec3 point = to_world(shape.geometry->points[i]);
		bounds = { glm::min(bounds.low, point), glm::max(bounds.high, point) };
	}
	return bounds;
}

void Occluders::add(const Shape &shape, glm::dvec3 origin, uint64_t label) {
	Occluder occluder;
	const Bounds3 bounds = world_bounds(shape, origin);
	occluder.low = bounds.low;
	occluder.high = bounds.high;
	occluder.frame = shape.frame();
	occluder.frame.origin += origin;
	occluder.size = shape.size;
	occluder.label = label;
	occluder.node = shape.tree.node;
	if (shape.geometry != nullptr) {
		occluder.area = label != 0 ? surface_area(shape) : 0.0;
		if (shape.geometry->is_closed && !is_flat(shape)) {
			occluder.solid = world_solid(shape, origin);
		}
	}
	_list.push_back(std::move(occluder));
}

void Occluders::finish() {
	tree.finish();
	std::vector<Bounds3> boxes;
	for (uint32_t i = 0; i < _list.size(); ++i) {
		if (_list[i].solid.is_closed) {
			_solids.push_back(i);
			boxes.push_back({ _list[i].low, _list[i].high });
			_list[i].body = ConvexBody(_list[i].solid);
		}
	}
	_tree.build(boxes);
}

void Occluders::set_bounds(glm::dvec3 low, glm::dvec3 high) {
	_low = low;
	_high = high;
}

// --- The tree

uint32_t ShapeTree::add(uint32_t parent) {
	_parents.push_back(parent);
	return uint32_t(_parents.size()) - 1;
}

// Children are added in the order of their numbers, so sorting by parents, which keeps that order, puts child k at place k.
void ShapeTree::finish() {
	const uint32_t count = uint32_t(_parents.size());
	_first_child.assign(count + 1, 0);
	for (uint32_t i = 1; i < count; ++i) {
		++_first_child[_parents[i] + 1];
	}
	for (uint32_t i = 0; i < count; ++i) {
		_first_child[i + 1] += _first_child[i];
	}
	std::vector<uint32_t> next(_first_child.begin(), _first_child.end() - 1);
	_children.resize(count - 1);
	for (uint32_t i = 1; i < count; ++i) {
		_children[next[_parents[i]]++] = i;
	}
	// Parents come before their children: sizes are summed backwards, numbers handed out forwards.
	std::vector<uint32_t> sizes(count, 1);
	for (uint32_t i = count - 1; i > 0; --i) {
		sizes[_parents[i]] += sizes[i];
	}
	_enter.assign(count, 0);
	_leave.assign(count, count);
	next.assign(count, 1);
	for (uint32_t i = 1; i < count; ++i) {
		uint32_t &at = next[_parents[i]];
		_enter[i] = at;
		_leave[i] = at + sizes[i];
		at += sizes[i];
		next[i] = _enter[i] + 1;
	}
}

TreePlace ShapeTree::child(TreePlace parent, uint32_t child_index) const {
	const uint32_t first = _first_child[parent.node];
	if (parent.is_beyond || child_index >= _first_child[parent.node + 1] - first) {
		return { parent.node, true };
	}
	return { _children[first + child_index], false };
}

bool ShapeTree::is_related(TreePlace asking, uint32_t node) const {
	return contains(node, asking.node) || (!asking.is_beyond && contains(asking.node, node));
}

} // namespace pcg::cga
