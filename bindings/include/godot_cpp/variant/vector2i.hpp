#pragma once

#include <godot_cpp/core/math.hpp>

namespace godot {

class String;
struct Vector2;

struct Vector2i {
	enum Axis { AXIS_X, AXIS_Y };
	static constexpr int AXIS_COUNT = 2;

	int32_t x = 0, y = 0;

	constexpr Vector2i() = default;
	constexpr Vector2i(int32_t p_x, int32_t p_y) : x(p_x), y(p_y) {}

	const int32_t &operator[](int p_axis) const { return (&x)[p_axis]; }
	int32_t &operator[](int p_axis) { return (&x)[p_axis]; }

	constexpr Vector2i operator+(const Vector2i &p_v) const { return {x + p_v.x, y + p_v.y}; }
	constexpr Vector2i operator-(const Vector2i &p_v) const { return {x - p_v.x, y - p_v.y}; }
	constexpr Vector2i operator*(const Vector2i &p_v) const { return {x * p_v.x, y * p_v.y}; }
	constexpr Vector2i operator/(const Vector2i &p_v) const { return {x / p_v.x, y / p_v.y}; }
	constexpr Vector2i operator%(const Vector2i &p_v) const { return {x % p_v.x, y % p_v.y}; }
	constexpr Vector2i operator*(int32_t p_s) const { return {x * p_s, y * p_s}; }
	constexpr Vector2i operator/(int32_t p_s) const { return {x / p_s, y / p_s}; }
	constexpr Vector2i operator%(int32_t p_s) const { return {x % p_s, y % p_s}; }
	constexpr Vector2i operator-() const { return {-x, -y}; }
	constexpr Vector2i &operator+=(const Vector2i &p_v) { return *this = *this + p_v; }
	constexpr Vector2i &operator-=(const Vector2i &p_v) { return *this = *this - p_v; }
	constexpr Vector2i &operator*=(const Vector2i &p_v) { return *this = *this * p_v; }
	constexpr Vector2i &operator/=(const Vector2i &p_v) { return *this = *this / p_v; }
	constexpr Vector2i &operator%=(const Vector2i &p_v) { return *this = *this % p_v; }
	constexpr Vector2i &operator*=(int32_t p_s) { return *this = *this * p_s; }
	constexpr Vector2i &operator/=(int32_t p_s) { return *this = *this / p_s; }
	constexpr Vector2i &operator%=(int32_t p_s) { return *this = *this % p_s; }
	constexpr bool operator==(const Vector2i &p_v) const { return x == p_v.x && y == p_v.y; }
	constexpr bool operator!=(const Vector2i &p_v) const { return !(*this == p_v); }
	// In the order of the axes, so that vectors can be sorted and be keys.
	constexpr bool operator<(const Vector2i &p_v) const { return x != p_v.x ? x < p_v.x : y < p_v.y; }
	constexpr bool operator>(const Vector2i &p_v) const { return p_v < *this; }
	constexpr bool operator<=(const Vector2i &p_v) const { return !(p_v < *this); }
	constexpr bool operator>=(const Vector2i &p_v) const { return !(*this < p_v); }

	constexpr int64_t length_squared() const { return int64_t(x) * x + int64_t(y) * y; }
	double length() const { return Math::sqrt(double(length_squared())); }
	constexpr int64_t distance_squared_to(const Vector2i &p_to) const { return (p_to - *this).length_squared(); }
	double distance_to(const Vector2i &p_to) const { return (p_to - *this).length(); }
	Vector2i abs() const { return {Math::abs(x), Math::abs(y)}; }
	constexpr Vector2i sign() const { return {int32_t(SIGN(x)), int32_t(SIGN(y))}; }
	constexpr Vector2i min(const Vector2i &p_v) const { return {MIN(x, p_v.x), MIN(y, p_v.y)}; }
	constexpr Vector2i max(const Vector2i &p_v) const { return {MAX(x, p_v.x), MAX(y, p_v.y)}; }
	constexpr Vector2i clamp(const Vector2i &p_min, const Vector2i &p_max) const { return max(p_min).min(p_max); }
	constexpr Axis min_axis_index() const { return x < y ? AXIS_X : AXIS_Y; }
	constexpr Axis max_axis_index() const { return x < y ? AXIS_Y : AXIS_X; }

	operator String() const;
	operator Vector2() const;
};

constexpr Vector2i operator*(int32_t p_s, const Vector2i &p_v) {
	return p_v * p_s;
}

typedef Vector2i Size2i;
typedef Vector2i Point2i;

} // namespace godot
