#pragma once

#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/variant/quaternion.hpp>
#include <godot_cpp/variant/vector3.hpp>

namespace godot {

class String;

// A 3 × 3 matrix, stored by rows; its columns are the axes.
struct Basis {
	Vector3 rows[3] = {Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)};

	constexpr Basis() = default;
	constexpr Basis(const Vector3 &p_x, const Vector3 &p_y, const Vector3 &p_z)
	    : rows{{p_x.x, p_y.x, p_z.x}, {p_x.y, p_y.y, p_z.y}, {p_x.z, p_y.z, p_z.z}} {}
	constexpr Basis(real_t p_xx, real_t p_xy, real_t p_xz, real_t p_yx, real_t p_yy, real_t p_yz, real_t p_zx,
	                real_t p_zy, real_t p_zz)
	    : rows{{p_xx, p_xy, p_xz}, {p_yx, p_yy, p_yz}, {p_zx, p_zy, p_zz}} {}
	Basis(const Quaternion &p_quaternion) { set_quaternion(p_quaternion); }
	Basis(const Vector3 &p_axis, real_t p_angle) { set_axis_angle(p_axis, p_angle); }

	static Basis from_euler(const Vector3 &p_euler, EulerOrder p_order = EULER_ORDER_YXZ) {
		Basis result;
		result.set_euler(p_euler, p_order);
		return result;
	}
	static Basis from_scale(const Vector3 &p_scale) {
		return {Vector3(p_scale.x, 0, 0), Vector3(0, p_scale.y, 0), Vector3(0, 0, p_scale.z)};
	}
	// -Z looks along the target, unless p_use_model_front lets +Z do so.
	static Basis looking_at(const Vector3 &p_target, const Vector3 &p_up = Vector3(0, 1, 0),
	                        bool p_use_model_front = false) {
		const Vector3 z = (p_use_model_front ? p_target : -p_target).normalized();
		const Vector3 x = p_up.cross(z).normalized();
		return {x, z.cross(x), z};
	}

	const Vector3 &operator[](int p_row) const { return rows[p_row]; }
	Vector3 &operator[](int p_row) { return rows[p_row]; }
	Vector3 get_column(int p_index) const { return {rows[0][p_index], rows[1][p_index], rows[2][p_index]}; }
	void set_column(int p_index, const Vector3 &p_value) {
		rows[0][p_index] = p_value.x;
		rows[1][p_index] = p_value.y;
		rows[2][p_index] = p_value.z;
	}
	void set_columns(const Vector3 &p_x, const Vector3 &p_y, const Vector3 &p_z) { *this = Basis(p_x, p_y, p_z); }

	real_t determinant() const { return rows[0].dot(rows[1].cross(rows[2])); }
	Basis transposed() const { return {rows[0], rows[1], rows[2]}; }
	void transpose() { *this = transposed(); }
	// Of a matrix that has one: the determinant is not 0.
	Basis inverse() const {
		const real_t scale = 1 / determinant();
		return {rows[1].cross(rows[2]) * scale, rows[2].cross(rows[0]) * scale, rows[0].cross(rows[1]) * scale};
	}
	void invert() { *this = inverse(); }
	// The axes made perpendicular and of length 1, keeping the direction of x and the plane of x and y.
	Basis orthonormalized() const {
		const Vector3 x = get_column(0).normalized();
		Vector3 y = get_column(1);
		y = (y - x * x.dot(y)).normalized();
		Vector3 z = get_column(2);
		z = (z - x * x.dot(z) - y * y.dot(z)).normalized();
		return {x, y, z};
	}
	void orthonormalize() { *this = orthonormalized(); }
	Vector3 get_scale() const {
		const Vector3 lengths(get_column(0).length(), get_column(1).length(), get_column(2).length());
		return determinant() < 0 ? -lengths : lengths;
	}
	Basis scaled(const Vector3 &p_scale) const { return from_scale(p_scale) * *this; }
	Basis scaled_local(const Vector3 &p_scale) const { return *this * from_scale(p_scale); }
	void scale(const Vector3 &p_scale) { *this = scaled(p_scale); }
	Basis rotated(const Vector3 &p_axis, real_t p_angle) const { return Basis(p_axis, p_angle) * *this; }
	void rotate(const Vector3 &p_axis, real_t p_angle) { *this = rotated(p_axis, p_angle); }

	void set_axis_angle(const Vector3 &p_axis, real_t p_angle) {
		const Vector3 axis = p_axis.normalized();
		*this = {Vector3(1, 0, 0).rotated(axis, p_angle), Vector3(0, 1, 0).rotated(axis, p_angle),
		         Vector3(0, 0, 1).rotated(axis, p_angle)};
	}
	void set_quaternion(const Quaternion &p_q) {
		*this = {p_q.xform(Vector3(1, 0, 0)), p_q.xform(Vector3(0, 1, 0)), p_q.xform(Vector3(0, 0, 1))};
	}
	Quaternion get_quaternion() const;
	Quaternion get_rotation_quaternion() const;
	// In radians about x, y and z.
	void set_euler(const Vector3 &p_euler, EulerOrder p_order = EULER_ORDER_YXZ);
	Vector3 get_euler(EulerOrder p_order = EULER_ORDER_YXZ) const;

	Vector3 xform(const Vector3 &p_v) const { return {rows[0].dot(p_v), rows[1].dot(p_v), rows[2].dot(p_v)}; }
	Vector3 xform_inv(const Vector3 &p_v) const { return rows[0] * p_v.x + rows[1] * p_v.y + rows[2] * p_v.z; }
	Basis operator*(const Basis &p_b) const {
		return {xform(p_b.get_column(0)), xform(p_b.get_column(1)), xform(p_b.get_column(2))};
	}
	void operator*=(const Basis &p_b) { *this = *this * p_b; }
	Basis operator*(real_t p_s) const { return {get_column(0) * p_s, get_column(1) * p_s, get_column(2) * p_s}; }
	bool operator==(const Basis &p_b) const {
		return rows[0] == p_b.rows[0] && rows[1] == p_b.rows[1] && rows[2] == p_b.rows[2];
	}
	bool operator!=(const Basis &p_b) const { return !(*this == p_b); }
	bool is_equal_approx(const Basis &p_b) const {
		return rows[0].is_equal_approx(p_b.rows[0]) && rows[1].is_equal_approx(p_b.rows[1]) &&
		       rows[2].is_equal_approx(p_b.rows[2]);
	}
	bool is_finite() const { return rows[0].is_finite() && rows[1].is_finite() && rows[2].is_finite(); }

	operator String() const;
	operator Quaternion() const { return get_quaternion(); }
};

} // namespace godot
