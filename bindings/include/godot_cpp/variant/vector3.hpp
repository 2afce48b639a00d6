#pragma once

#include <godot_cpp/core/math.hpp>

namespace godot {

class String;
struct Vector3i;

struct Vector3 {
	enum Axis { AXIS_X, AXIS_Y, AXIS_Z };
	static constexpr int AXIS_COUNT = 3;

	real_t x = 0, y = 0, z = 0;

	constexpr Vector3() = default;
	constexpr Vector3(real_t p_x, real_t p_y, real_t p_z) : x(p_x), y(p_y), z(p_z) {}

	const real_t &operator[](int p_axis) const { return (&x)[p_axis]; }
	real_t &operator[](int p_axis) { return (&x)[p_axis]; }

	constexpr Vector3 operator+(const Vector3 &p_v) const { return {x + p_v.x, y + p_v.y, z + p_v.z}; }
	constexpr Vector3 operator-(const Vector3 &p_v) const { return {x - p_v.x, y - p_v.y, z - p_v.z}; }
	constexpr Vector3 operator*(const Vector3 &p_v) const { return {x * p_v.x, y * p_v.y, z * p_v.z}; }
	constexpr Vector3 operator/(const Vector3 &p_v) const { return {x / p_v.x, y / p_v.y, z / p_v.z}; }
	constexpr Vector3 operator*(real_t p_s) const { return {x * p_s, y * p_s, z * p_s}; }
	constexpr Vector3 operator/(real_t p_s) const { return {x / p_s, y / p_s, z / p_s}; }
	constexpr Vector3 operator-() const { return {-x, -y, -z}; }
	constexpr Vector3 &operator+=(const Vector3 &p_v) { return *this = *this + p_v; }
	constexpr Vector3 &operator-=(const Vector3 &p_v) { return *this = *this - p_v; }
	constexpr Vector3 &operator*=(const Vector3 &p_v) { return *this = *this * p_v; }
	constexpr Vector3 &operator/=(const Vector3 &p_v) { return *this = *this / p_v; }
	constexpr Vector3 &operator*=(real_t p_s) { return *this = *this * p_s; }
	constexpr Vector3 &operator/=(real_t p_s) { return *this = *this / p_s; }
	constexpr bool operator==(const Vector3 &p_v) const { return x == p_v.x && y == p_v.y && z == p_v.z; }
	constexpr bool operator!=(const Vector3 &p_v) const { return !(*this == p_v); }
	// In the order of the axes, so that vectors can be sorted and be keys.
	constexpr bool operator<(const Vector3 &p_v) const {
		return x != p_v.x ? x < p_v.x : (y != p_v.y ? y < p_v.y : z < p_v.z);
	}
	constexpr bool operator>(const Vector3 &p_v) const { return p_v < *this; }
	constexpr bool operator<=(const Vector3 &p_v) const { return !(p_v < *this); }
	constexpr bool operator>=(const Vector3 &p_v) const { return !(*this < p_v); }

	constexpr real_t dot(const Vector3 &p_v) const { return x * p_v.x + y * p_v.y + z * p_v.z; }
	constexpr real_t length_squared() const { return dot(*this); }
	real_t length() const { return Math::sqrt(length_squared()); }
	real_t distance_to(const Vector3 &p_to) const { return (p_to - *this).length(); }
	constexpr real_t distance_squared_to(const Vector3 &p_to) const { return (p_to - *this).length_squared(); }
	void normalize() {
		const real_t squared = length_squared();
		*this = squared == 0 ? Vector3() : *this / Math::sqrt(squared);
	}
	Vector3 normalized() const {
		Vector3 result = *this;
		result.normalize();
		return result;
	}
	bool is_normalized() const { return Math::is_equal_approx(length_squared(), 1, UNIT_EPSILON); }
	Vector3 limit_length(real_t p_length = 1.0) const {
		const real_t current = length();
		return current > 0 && p_length < current ? *this / current * p_length : *this;
	}
	constexpr Vector3 lerp(const Vector3 &p_to, real_t p_weight) const { return *this + (p_to - *this) * p_weight; }
	Vector3 direction_to(const Vector3 &p_to) const { return (p_to - *this).normalized(); }
	Vector3 move_toward(const Vector3 &p_to, real_t p_delta) const {
		const Vector3 way = p_to - *this;
		const real_t distance = way.length();
		return distance <= p_delta || distance < real_t(CMP_EPSILON) ? p_to : *this + way / distance * p_delta;
	}
	constexpr Vector3 slide(const Vector3 &p_normal) const { return *this - p_normal * dot(p_normal); }
	constexpr Vector3 reflect(const Vector3 &p_normal) const { return p_normal * (2 * dot(p_normal)) - *this; }
	constexpr Vector3 bounce(const Vector3 &p_normal) const { return -reflect(p_normal); }
	constexpr Vector3 project(const Vector3 &p_to) const { return p_to * (dot(p_to) / p_to.length_squared()); }
	Vector3 floor() const { return {Math::floor(x), Math::floor(y), Math::floor(z)}; }
	Vector3 ceil() const { return {Math::ceil(x), Math::ceil(y), Math::ceil(z)}; }
	Vector3 round() const { return {Math::round(x), Math::round(y), Math::round(z)}; }
	bool is_equal_approx(const Vector3 &p_v) const {
		return Math::is_equal_approx(x, p_v.x) && Math::is_equal_approx(y, p_v.y) && Math::is_equal_approx(z, p_v.z);
	}
	bool is_zero_approx() const {
		return Math::is_zero_approx(x) && Math::is_zero_approx(y) && Math::is_zero_approx(z);
	}
	bool is_finite() const { return Math::is_finite(x) && Math::is_finite(y) && Math::is_finite(z); }
	constexpr Vector3 inverse() const { return {1 / x, 1 / y, 1 / z}; }
	Vector3 abs() const { return {Math::abs(x), Math::abs(y), Math::abs(z)}; }
	constexpr Vector3 sign() const { return {real_t(SIGN(x)), real_t(SIGN(y)), real_t(SIGN(z))}; }
	constexpr Vector3 min(const Vector3 &p_v) const { return {MIN(x, p_v.x), MIN(y, p_v.y), MIN(z, p_v.z)}; }
	constexpr Vector3 max(const Vector3 &p_v) const { return {MAX(x, p_v.x), MAX(y, p_v.y), MAX(z, p_v.z)}; }
	constexpr Vector3 clamp(const Vector3 &p_min, const Vector3 &p_max) const { return max(p_min).min(p_max); }
	Vector3 snapped(const Vector3 &p_step) const {
		return {real_t(Math::snapped(x, p_step.x)), real_t(Math::snapped(y, p_step.y)),
		        real_t(Math::snapped(z, p_step.z))};
	}
	constexpr Vector3 cross(const Vector3 &p_v) const {
		return {y * p_v.z - z * p_v.y, z * p_v.x - x * p_v.z, x * p_v.y - y * p_v.x};
	}
	real_t angle_to(const Vector3 &p_v) const { return Math::atan2(cross(p_v).length(), dot(p_v)); }
	real_t signed_angle_to(const Vector3 &p_v, const Vector3 &p_axis) const {
		const real_t angle = angle_to(p_v);
		return cross(p_v).dot(p_axis) < 0 ? -angle : angle;
	}
	// About a normalized axis, by the formula of Rodrigues.
	Vector3 rotated(const Vector3 &p_axis, real_t p_angle) const {
		const real_t cosine = Math::cos(p_angle);
		return *this * cosine + p_axis.cross(*this) * Math::sin(p_angle) + p_axis * (p_axis.dot(*this) * (1 - cosine));
	}
	void rotate(const Vector3 &p_axis, real_t p_angle) { *this = rotated(p_axis, p_angle); }
	constexpr Axis min_axis_index() const { return x < y ? (x < z ? AXIS_X : AXIS_Z) : (y < z ? AXIS_Y : AXIS_Z); }
	constexpr Axis max_axis_index() const { return x < y ? (y < z ? AXIS_Z : AXIS_Y) : (x < z ? AXIS_Z : AXIS_X); }

	operator String() const;
	operator Vector3i() const;
};

constexpr Vector3 operator*(real_t p_s, const Vector3 &p_v) {
	return p_v * p_s;
}

} // namespace godot
