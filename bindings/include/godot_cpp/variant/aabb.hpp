#pragma once

#include <godot_cpp/variant/plane.hpp>
#include <godot_cpp/variant/vector3.hpp>

namespace godot {

class String;

struct AABB {
	Vector3 position;
	Vector3 size;

	constexpr AABB() = default;
	constexpr AABB(const Vector3 &p_position, const Vector3 &p_size) : position(p_position), size(p_size) {}

	const Vector3 &get_position() const { return position; }
	void set_position(const Vector3 &p_position) { position = p_position; }
	const Vector3 &get_size() const { return size; }
	void set_size(const Vector3 &p_size) { size = p_size; }
	Vector3 get_end() const { return position + size; }
	void set_end(const Vector3 &p_end) { size = p_end - position; }
	Vector3 get_center() const { return position + size * real_t(0.5); }
	real_t get_volume() const { return size.x * size.y * size.z; }
	bool has_volume() const { return size.x > 0 && size.y > 0 && size.z > 0; }
	bool has_surface() const { return size.x > 0 || size.y > 0 || size.z > 0; }
	real_t get_longest_axis_size() const { return size[size.max_axis_index()]; }
	real_t get_shortest_axis_size() const { return size[size.min_axis_index()]; }
	// Bit 2, 1, 0 of the index choose the end in x, y, z.
	Vector3 get_endpoint(int p_index) const {
		return {position.x + (p_index & 4 ? size.x : 0), position.y + (p_index & 2 ? size.y : 0),
		        position.z + (p_index & 1 ? size.z : 0)};
	}

	bool has_point(const Vector3 &p_point) const {
		const Vector3 end = get_end();
		return p_point.x >= position.x && p_point.y >= position.y && p_point.z >= position.z && p_point.x <= end.x &&
		       p_point.y <= end.y && p_point.z <= end.z;
	}
	bool encloses(const AABB &p_box) const { return has_point(p_box.position) && has_point(p_box.get_end()); }
	bool intersects(const AABB &p_box) const {
		const Vector3 end = get_end();
		const Vector3 other = p_box.get_end();
		return position.x < other.x && p_box.position.x < end.x && position.y < other.y && p_box.position.y < end.y &&
		       position.z < other.z && p_box.position.z < end.z;
	}
	AABB intersection(const AABB &p_box) const {
		if (!intersects(p_box)) {
			return AABB();
		}
		const Vector3 start = position.max(p_box.position);
		return {start, get_end().min(p_box.get_end()) - start};
	}
	AABB merge(const AABB &p_box) const {
		AABB result = *this;
		result.merge_with(p_box);
		return result;
	}
	void merge_with(const AABB &p_box) {
		const Vector3 end = get_end().max(p_box.get_end());
		position = position.min(p_box.position);
		size = end - position;
	}
	void expand_to(const Vector3 &p_point) { merge_with(AABB(p_point, Vector3())); }
	AABB expand(const Vector3 &p_point) const { return merge(AABB(p_point, Vector3())); }
	void grow_by(real_t p_by) {
		position -= Vector3(p_by, p_by, p_by);
		size += Vector3(2 * p_by, 2 * p_by, 2 * p_by);
	}
	AABB grow(real_t p_by) const {
		AABB result = *this;
		result.grow_by(p_by);
		return result;
	}
	AABB abs() const { return {position + size.min(Vector3()), size.abs()}; }

	bool operator==(const AABB &p_box) const { return position == p_box.position && size == p_box.size; }
	bool operator!=(const AABB &p_box) const { return !(*this == p_box); }
	bool is_equal_approx(const AABB &p_box) const {
		return position.is_equal_approx(p_box.position) && size.is_equal_approx(p_box.size);
	}
	bool is_finite() const { return position.is_finite() && size.is_finite(); }

	operator String() const;
};

} // namespace godot
