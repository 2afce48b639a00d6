#pragma once

#include <godot_cpp/core/math.hpp>

namespace godot {

class String;
struct Vector4i;

struct Vector4 {
	enum Axis { AXIS_X, AXIS_Y, AXIS_Z, AXIS_W };
	static constexpr int AXIS_COUNT = 4;

	real_t x = 0, y = 0, z = 0, w = 0;

	constexpr Vector4() = default;
	constexpr Vector4(real_t p_x, real_t p_y, real_t p_z, real_t p_w) : x(p_x), y(p_y), z(p_z), w(p_w) {}

	const real_t &operator[](int p_axis) const { return (&x)[p_axis]; }
	real_t &operator[](int p_axis) { return (&x)[p_axis]; }

	constexpr Vector4 operator+(const Vector4 &p_v) const { return {x + p_v.x, y + p_v.y, z + p_v.z, w + p_v.w}; }
	constexpr Vector4 operator-(const Vector4 &p_v) const { return {x - p_v.x, y - p_v.y, z - p_v.z, w - p_v.w}; }
	constexpr Vector4 operator*(const Vector4 &p_v) const { return {x * p_v.x, y * p_v.y, z * p_v.z, w * p_v.w}; }
	constexpr Vector4 operator/(const Vector4 &p_v) const { return {x / p_v.x, y / p_v.y, z / p_v.z, w / p_v.w}; }
	constexpr Vector4 operator*(real_t p_s) const { return {x * p_s, y * p_s, z * p_s, w * p_s}; }
	constexpr Vector4 operator/(real_t p_s) const { return {x / p_s, y / p_s, z / p_s, w / p_s}; }
	constexpr Vector4 operator-() const { return {-x, -y, -z, -w}; }
	constexpr Vector4 &operator+=(const Vector4 &p_v) { return *this = *this + p_v; }
	constexpr Vector4 &operator-=(const Vector4 &p_v) { return *this = *this - p_v; }
	constexpr Vector4 &operator*=(const Vector4 &p_v) { return *this = *this * p_v; }
	constexpr Vector4 &operator/=(const Vector4 &p_v) { return *this = *this / p_v; }
	constexpr Vector4 &operator*=(real_t p_s) { return *this = *this * p_s; }
	constexpr Vector4 &operator/=(real_t p_s) { return *this = *this / p_s; }
	constexpr bool operator==(const Vector4 &p_v) const { return x == p_v.x && y == p_v.y && z == p_v.z && w == p_v.w; }
	constexpr bool operator!=(const Vector4 &p_v) const { return !(*this == p_v); }
	// In the order of the axes, so that vectors can be sorted and be keys.
	constexpr bool operator<(const Vector4 &p_v) const {
		return x != p_v.x ? x < p_v.x : (y != p_v.y ? y < p_v.y : (z != p_v.z ? z < p_v.z : w < p_v.w));
	}
	constexpr bool operator>(const Vector4 &p_v) const { return p_v < *this; }
	constexpr bool operator<=(const Vector4 &p_v) const { return !(p_v < *this); }
	constexpr bool operator>=(const Vector4 &p_v) const { return !(*this < p_v); }

	constexpr real_t dot(const Vector4 &p_v) const { return x * p_v.x + y * p_v.y + z * p_v.z + w * p_v.w; }
	constexpr real_t length_squared() const { return dot(*this); }
	real_t length() const { return Math::sqrt(length_squared()); }
	real_t distance_to(const Vector4 &p_to) const { return (p_to - *this).length(); }
	constexpr real_t distance_squared_to(const Vector4 &p_to) const { return (p_to - *this).length_squared(); }
	void normalize() {
		const real_t squared = length_squared();
		*this = squared == 0 ? Vector4() : *this / Math::sqrt(squared);
	}
	Vector4 normalized() const {
		Vector4 result = *this;
		result.normalize();
		return result;
	}
	bool is_normalized() const { return Math::is_equal_approx(length_squared(), 1, UNIT_EPSILON); }
	constexpr Vector4 lerp(const Vector4 &p_to, real_t p_weight) const { return *this + (p_to - *this) * p_weight; }
	Vector4 direction_to(const Vector4 &p_to) const { return (p_to - *this).normalized(); }
	Vector4 floor() const { return {Math::floor(x), Math::floor(y), Math::floor(z), Math::floor(w)}; }
	Vector4 ceil() const { return {Math::ceil(x), Math::ceil(y), Math::ceil(z), Math::ceil(w)}; }
	Vector4 round() const { return {Math::round(x), Math::round(y), Math::round(z), Math::round(w)}; }
	bool is_equal_approx(const Vector4 &p_v) const {
		return Math::is_equal_approx(x, p_v.x) && Math::is_equal_approx(y, p_v.y) && Math::is_equal_approx(z, p_v.z) &&
		       Math::is_equal_approx(w, p_v.w);
	}
	bool is_zero_approx() const {
		return Math::is_zero_approx(x) && Math::is_zero_approx(y) && Math::is_zero_approx(z) && Math::is_zero_approx(w);
	}
	bool is_finite() const {
		return Math::is_finite(x) && Math::is_finite(y) && Math::is_finite(z) && Math::is_finite(w);
	}
	constexpr Vector4 inverse() const { return {1 / x, 1 / y, 1 / z, 1 / w}; }
	Vector4 abs() const { return {Math::abs(x), Math::abs(y), Math::abs(z), Math::abs(w)}; }
	constexpr Vector4 sign() const { return {real_t(SIGN(x)), real_t(SIGN(y)), real_t(SIGN(z)), real_t(SIGN(w))}; }
	constexpr Vector4 min(const Vector4 &p_v) const {
		return {MIN(x, p_v.x), MIN(y, p_v.y), MIN(z, p_v.z), MIN(w, p_v.w)};
	}
	constexpr Vector4 max(const Vector4 &p_v) const {
		return {MAX(x, p_v.x), MAX(y, p_v.y), MAX(z, p_v.z), MAX(w, p_v.w)};
	}
	constexpr Vector4 clamp(const Vector4 &p_min, const Vector4 &p_max) const { return max(p_min).min(p_max); }
	Vector4 snapped(const Vector4 &p_step) const {
		return {real_t(Math::snapped(x, p_step.x)), real_t(Math::snapped(y, p_step.y)),
		        real_t(Math::snapped(z, p_step.z)), real_t(Math::snapped(w, p_step.w))};
	}

	operator String() const;
	operator Vector4i() const;
};

constexpr Vector4 operator*(real_t p_s, const Vector4 &p_v) {
	return p_v * p_s;
}

} // namespace godot
