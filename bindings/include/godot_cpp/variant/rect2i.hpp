#pragma once

#include <godot_cpp/variant/vector2i.hpp>

namespace godot {

class String;
struct Rect2;

struct Rect2i {
	Vector2i position;
	Vector2i size;

	constexpr Rect2i() = default;
	constexpr Rect2i(const Vector2i &p_position, const Vector2i &p_size) : position(p_position), size(p_size) {}
	constexpr Rect2i(int32_t p_x, int32_t p_y, int32_t p_width, int32_t p_height)
	    : position(p_x, p_y), size(p_width, p_height) {}

	const Vector2i &get_position() const { return position; }
	void set_position(const Vector2i &p_position) { position = p_position; }
	const Vector2i &get_size() const { return size; }
	void set_size(const Vector2i &p_size) { size = p_size; }
	Vector2i get_end() const { return position + size; }
	void set_end(const Vector2i &p_end) { size = p_end - position; }
	Vector2i get_center() const { return position + size / 2; }
	int32_t get_area() const { return size.x * size.y; }
	bool has_area() const { return size.x > 0 && size.y > 0; }

	// The edges at the end do not belong to it.
	bool has_point(const Vector2i &p_point) const {
		const Vector2i end = get_end();
		return p_point.x >= position.x && p_point.y >= position.y && p_point.x < end.x && p_point.y < end.y;
	}
	bool encloses(const Rect2i &p_rect) const {
		const Vector2i end = get_end();
		const Vector2i other = p_rect.get_end();
		return p_rect.position.x >= position.x && p_rect.position.y >= position.y && other.x <= end.x &&
		       other.y <= end.y;
	}
	bool intersects(const Rect2i &p_rect) const {
		const Vector2i end = get_end();
		const Vector2i other = p_rect.get_end();
		return position.x < other.x && p_rect.position.x < end.x && position.y < other.y && p_rect.position.y < end.y;
	}
	Rect2i intersection(const Rect2i &p_rect) const {
		if (!intersects(p_rect)) {
			return Rect2i();
		}
		const Vector2i start = position.max(p_rect.position);
		return {start, get_end().min(p_rect.get_end()) - start};
	}
	Rect2i merge(const Rect2i &p_rect) const {
		const Vector2i start = position.min(p_rect.position);
		return {start, get_end().max(p_rect.get_end()) - start};
	}
	void expand_to(const Vector2i &p_point) {
		const Vector2i end = get_end().max(p_point);
		position = position.min(p_point);
		size = end - position;
	}
	Rect2i expand(const Vector2i &p_point) const {
		Rect2i result = *this;
		result.expand_to(p_point);
		return result;
	}
	Rect2i grow(int32_t p_by) const { return {position - Vector2i(p_by, p_by), size + Vector2i(2 * p_by, 2 * p_by)}; }
	Rect2i abs() const { return {position + size.min(Vector2i()), size.abs()}; }

	bool operator==(const Rect2i &p_rect) const { return position == p_rect.position && size == p_rect.size; }
	bool operator!=(const Rect2i &p_rect) const { return !(*this == p_rect); }

	operator String() const;
	operator Rect2() const;
};

} // namespace godot
