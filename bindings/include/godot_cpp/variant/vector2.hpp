#pragma once

#include <godot_cpp/core/math.hpp>

namespace godot {

class String;
struct Vector2i;

struct Vector2 {
	enum Axis { AXIS_X, AXIS_Y };
	static constexpr int AXIS_COUNT = 2;

	real_t x = 0, y = 0;

	constexpr Vector2() = default;
	constexpr Vector2(real_t p_x, real_t p_y) : x(p_x), y(p_y) {}

	const real_t &operator[](int p_axis) const { return (&x)[p_axis]; }
	real_t &operator[](int p_axis) { return (&x)[p_axis]; }

	constexpr Vector2 operator+(const Vector2 &p_v) const { return {x + p_v.x, y + p_v.y}; }
	constexpr Vector2 operator-(const Vector2 &p_v) const { return {x - p_v.x, y - p_v.y}; }
	constexpr Vector2 operator*(const Vector2 &p_v) const { return {x * p_v.x, y * p_v.y}; }
	constexpr Vector2 operator/(const Vector2 &p_v) const { return {x / p_v.x, y / p_v.y}; }
	constexpr Vector2 operator*(real_t p_s) const { return {x * p_s, y * p_s}; }
	constexpr Vector2 operator/(real_t p_s) const { return {x / p_s, y / p_s}; }
	constexpr Vector2 operator-() const { return {-x, -y}; }
	constexpr Vector2 &operator+=(const Vector2 &p_v) { return *this = *this + p_v; }
	constexpr Vector2 &operator-=(const Vector2 &p_v) { return *this = *this - p_v; }
	constexpr Vector2 &operator*=(const Vector2 &p_v) { return *this = *this * p_v; }
	constexpr Vector2 &operator/=(const Vector2 &p_v) { return *this = *this / p_v; }
	constexpr Vector2 &operator*=(real_t p_s) { return *this = *this * p_s; }
	constexpr Vector2 &operator/=(real_t p_s) { return *this = *this / p_s; }
	constexpr bool operator==(const Vector2 &p_v) const { return x == p_v.x && y == p_v.y; }
	constexpr bool operator!=(const Vector2 &p_v) const { return !(*this == p_v); }
	// In the order of the axes, so that vectors can be sorted and be keys.
	constexpr bool operator<(const Vector2 &p_v) const { return x != p_v.x ? x < p_v.x : y < p_v.y; }
	constexpr bool operator>(const Vector2 &p_v) const { return p_v < *this; }
	constexpr bool operator<=(const Vector2 &p_v) const { return !(p_v < *this); }
	constexpr bool operator>=(const Vector2 &p_v) const { return !(*this < p_v); }

	constexpr real_t dot(const Vector2 &p_v) const { return x * p_v.x + y * p_v.y; }
	constexpr real_t length_squared() const { return dot(*this); }
	real_t length() const { return Math::sqrt(length_squared()); }
	real_t distance_to(const Vector2 &p_to) const { return (p_to - *this).length(); }
	constexpr real_t distance_squared_to(const Vector2 &p_to) const { return (p_to - *this).length_squared(); }
	void normalize() {
		const real_t squared = length_squared();
		*this = squared == 0 ? Vector2() : *this / Math::sqrt(squared);
	}
	Vector2 normalized() const {
		Vector2 result = *this;
		result.normalize();
		return result;
	}
	bool is_normalized() const { return Math::is_equal_approx(length_squared(), 1, UNIT_EPSILON); }
	Vector2 limit_length(real_t p_length = 1.0) const {
		const real_t current = length();
		return current > 0 && p_length < current ? *this / current * p_length : *this;
	}
	constexpr Vector2 lerp(const Vector2 &p_to, real_t p_weight) const { return *this + (p_to - *this) * p_weight; }
	Vector2 direction_to(const Vector2 &p_to) const { return (p_to - *this).normalized(); }
	Vector2 move_toward(const Vector2 &p_to, real_t p_delta) const {
		const Vector2 way = p_to - *this;
		const real_t distance = way.length();
		return distance <= p_delta || distance < real_t(CMP_EPSILON) ? p_to : *this + way / distance * p_delta;
	}
	constexpr Vector2 slide(const Vector2 &p_normal) const { return *this - p_normal * dot(p_normal); }
	constexpr Vector2 reflect(const Vector2 &p_normal) const { return p_normal * (2 * dot(p_normal)) - *this; }
	constexpr Vector2 bounce(const Vector2 &p_normal) const { return -reflect(p_normal); }
	constexpr Vector2 project(const Vector2 &p_to) const { return p_to * (dot(p_to) / p_to.length_squared()); }
	Vector2 floor() const { return {Math::floor(x), Math::floor(y)}; }
	Vector2 ceil() const { return {Math::ceil(x), Math::ceil(y)}; }
	Vector2 round() const { return {Math::round(x), Math::round(y)}; }
	bool is_equal_approx(const Vector2 &p_v) const {
		return Math::is_equal_approx(x, p_v.x) && Math::is_equal_approx(y, p_v.y);
	}
	bool is_zero_approx() const { return Math::is_zero_approx(x) && Math::is_zero_approx(y); }
	bool is_finite() const { return Math::is_finite(x) && Math::is_finite(y); }
	Vector2 abs() const { return {Math::abs(x), Math::abs(y)}; }
	constexpr Vector2 sign() const { return {real_t(SIGN(x)), real_t(SIGN(y))}; }
	constexpr Vector2 min(const Vector2 &p_v) const { return {MIN(x, p_v.x), MIN(y, p_v.y)}; }
	constexpr Vector2 max(const Vector2 &p_v) const { return {MAX(x, p_v.x), MAX(y, p_v.y)}; }
	constexpr Vector2 clamp(const Vector2 &p_min, const Vector2 &p_max) const { return max(p_min).min(p_max); }
	Vector2 snapped(const Vector2 &p_step) const {
		return {real_t(Math::snapped(x, p_step.x)), real_t(Math::snapped(y, p_step.y))};
	}
	constexpr real_t cross(const Vector2 &p_v) const { return x * p_v.y - y * p_v.x; }
	constexpr real_t aspect() const { return x / y; }
	constexpr Vector2 orthogonal() const { return {y, -x}; }
	real_t angle() const { return Math::atan2(y, x); }
	real_t angle_to(const Vector2 &p_v) const { return Math::atan2(cross(p_v), dot(p_v)); }
	real_t angle_to_point(const Vector2 &p_v) const { return (p_v - *this).angle(); }
	Vector2 rotated(real_t p_angle) const {
		const real_t sine = Math::sin(p_angle);
		const real_t cosine = Math::cos(p_angle);
		return {x * cosine - y * sine, x * sine + y * cosine};
	}
	static Vector2 from_angle(real_t p_angle) { return {Math::cos(p_angle), Math::sin(p_angle)}; }
	constexpr Axis min_axis_index() const { return x < y ? AXIS_X : AXIS_Y; }
	constexpr Axis max_axis_index() const { return x < y ? AXIS_Y : AXIS_X; }

	operator String() const;
	operator Vector2i() const;
};

constexpr Vector2 operator*(real_t p_s, const Vector2 &p_v) {
	return p_v * p_s;
}

typedef Vector2 Size2;
typedef Vector2 Point2;

} // namespace godot
