#pragma once

#include <godot_cpp/variant/rect2.hpp>
#include <godot_cpp/variant/vector2.hpp>

namespace godot {

class String;

// The x axis, the y axis and the origin.
struct Transform2D {
	Vector2 columns[3] = {Vector2(1, 0), Vector2(0, 1), Vector2()};

	constexpr Transform2D() = default;
	constexpr Transform2D(const Vector2 &p_x, const Vector2 &p_y, const Vector2 &p_origin)
	    : columns{p_x, p_y, p_origin} {}
	constexpr Transform2D(real_t p_xx, real_t p_xy, real_t p_yx, real_t p_yy, real_t p_ox, real_t p_oy)
	    : columns{{p_xx, p_xy}, {p_yx, p_yy}, {p_ox, p_oy}} {}
	Transform2D(real_t p_rotation, const Vector2 &p_origin)
	    : columns{Vector2::from_angle(p_rotation), Vector2::from_angle(p_rotation + real_t(Math_PI / 2)), p_origin} {}

	const Vector2 &operator[](int p_index) const { return columns[p_index]; }
	Vector2 &operator[](int p_index) { return columns[p_index]; }
	const Vector2 &get_origin() const { return columns[2]; }
	void set_origin(const Vector2 &p_origin) { columns[2] = p_origin; }
	real_t get_rotation() const { return columns[0].angle(); }
	real_t determinant() const { return columns[0].cross(columns[1]); }
	Vector2 get_scale() const { return {columns[0].length(), (determinant() < 0 ? -1 : 1) * columns[1].length()}; }

	Vector2 basis_xform(const Vector2 &p_v) const { return columns[0] * p_v.x + columns[1] * p_v.y; }
	Vector2 xform(const Vector2 &p_v) const { return basis_xform(p_v) + columns[2]; }
	// For rotation and translation only.
	Vector2 xform_inv(const Vector2 &p_v) const {
		const Vector2 v = p_v - columns[2];
		return {columns[0].dot(v), columns[1].dot(v)};
	}
	Transform2D affine_inverse() const {
		const real_t scale = 1 / determinant();
		Transform2D result(Vector2(columns[1].y, -columns[0].y) * scale, Vector2(-columns[1].x, columns[0].x) * scale,
		                   Vector2());
		result.columns[2] = result.basis_xform(-columns[2]);
		return result;
	}
	Transform2D inverse() const {
		Transform2D result(Vector2(columns[0].x, columns[1].x), Vector2(columns[0].y, columns[1].y), Vector2());
		result.columns[2] = result.basis_xform(-columns[2]);
		return result;
	}
	Transform2D translated(const Vector2 &p_by) const { return {columns[0], columns[1], columns[2] + p_by}; }
	Transform2D translated_local(const Vector2 &p_by) const { return {columns[0], columns[1], xform(p_by)}; }
	Transform2D rotated(real_t p_angle) const { return Transform2D(p_angle, Vector2()) * *this; }
	Transform2D scaled(const Vector2 &p_scale) const {
		return {columns[0] * p_scale, columns[1] * p_scale, columns[2] * p_scale};
	}

	Vector2 operator*(const Vector2 &p_v) const { return xform(p_v); }
	Transform2D operator*(const Transform2D &p_t) const {
		return {basis_xform(p_t.columns[0]), basis_xform(p_t.columns[1]), xform(p_t.columns[2])};
	}
	void operator*=(const Transform2D &p_t) { *this = *this * p_t; }
	bool operator==(const Transform2D &p_t) const {
		return columns[0] == p_t.columns[0] && columns[1] == p_t.columns[1] && columns[2] == p_t.columns[2];
	}
	bool operator!=(const Transform2D &p_t) const { return !(*this == p_t); }
	bool is_equal_approx(const Transform2D &p_t) const {
		return columns[0].is_equal_approx(p_t.columns[0]) && columns[1].is_equal_approx(p_t.columns[1]) &&
		       columns[2].is_equal_approx(p_t.columns[2]);
	}
	bool is_finite() const { return columns[0].is_finite() && columns[1].is_finite() && columns[2].is_finite(); }

	operator String() const;
};

} // namespace godot
