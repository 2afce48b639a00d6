#pragma once

#include <godot_cpp/core/math.hpp>

namespace godot {

class String;
struct Vector3;

struct Vector3i {
	enum Axis { AXIS_X, AXIS_Y, AXIS_Z };
	static constexpr int AXIS_COUNT = 3;

	int32_t x = 0, y = 0, z = 0;

	constexpr Vector3i() = default;
	constexpr Vector3i(int32_t p_x, int32_t p_y, int32_t p_z) : x(p_x), y(p_y), z(p_z) {}

	const int32_t &operator[](int p_axis) const { return (&x)[p_axis]; }
	int32_t &operator[](int p_axis) { return (&x)[p_axis]; }

	constexpr Vector3i operator+(const Vector3i &p_v) const { return {x + p_v.x, y + p_v.y, z + p_v.z}; }
	constexpr Vector3i operator-(const Vector3i &p_v) const { return {x - p_v.x, y - p_v.y, z - p_v.z}; }
	constexpr Vector3i operator*(const Vector3i &p_v) const { return {x * p_v.x, y * p_v.y, z * p_v.z}; }
	constexpr Vector3i operator/(const Vector3i &p_v) const { return {x / p_v.x, y / p_v.y, z / p_v.z}; }
	constexpr Vector3i operator%(const Vector3i &p_v) const { return {x % p_v.x, y % p_v.y, z % p_v.z}; }
	constexpr Vector3i operator*(int32_t p_s) const { return {x * p_s, y * p_s, z * p_s}; }
	constexpr Vector3i operator/(int32_t p_s) const { return {x / p_s, y / p_s, z / p_s}; }
	constexpr Vector3i operator%(int32_t p_s) const { return {x % p_s, y % p_s, z % p_s}; }
	constexpr Vector3i operator-() const { return {-x, -y, -z}; }
	constexpr Vector3i &operator+=(const Vector3i &p_v) { return *this = *this + p_v; }
	constexpr Vector3i &operator-=(const Vector3i &p_v) { return *this = *this - p_v; }
	constexpr Vector3i &operator*=(const Vector3i &p_v) { return *this = *this * p_v; }
	constexpr Vector3i &operator/=(const Vector3i &p_v) { return *this = *this / p_v; }
	constexpr Vector3i &operator%=(const Vector3i &p_v) { return *this = *this % p_v; }
	constexpr Vector3i &operator*=(int32_t p_s) { return *this = *this * p_s; }
	constexpr Vector3i &operator/=(int32_t p_s) { return *this = *this / p_s; }
	constexpr Vector3i &operator%=(int32_t p_s) { return *this = *this % p_s; }
	constexpr bool operator==(const Vector3i &p_v) const { return x == p_v.x && y == p_v.y && z == p_v.z; }
	constexpr bool operator!=(const Vector3i &p_v) const { return !(*this == p_v); }
	// In the order of the axes, so that vectors can be sorted and be keys.
	constexpr bool operator<(const Vector3i &p_v) const {
		return x != p_v.x ? x < p_v.x : (y != p_v.y ? y < p_v.y : z < p_v.z);
	}
	constexpr bool operator>(const Vector3i &p_v) const { return p_v < *this; }
	constexpr bool operator<=(const Vector3i &p_v) const { return !(p_v < *this); }
	constexpr bool operator>=(const Vector3i &p_v) const { return !(*this < p_v); }

	constexpr int64_t length_squared() const { return int64_t(x) * x + int64_t(y) * y + int64_t(z) * z; }
	double length() const { return Math::sqrt(double(length_squared())); }
	constexpr int64_t distance_squared_to(const Vector3i &p_to) const { return (p_to - *this).length_squared(); }
	double distance_to(const Vector3i &p_to) const { return (p_to - *this).length(); }
	Vector3i abs() const { return {Math::abs(x), Math::abs(y), Math::abs(z)}; }
	constexpr Vector3i sign() const { return {int32_t(SIGN(x)), int32_t(SIGN(y)), int32_t(SIGN(z))}; }
	constexpr Vector3i min(const Vector3i &p_v) const { return {MIN(x, p_v.x), MIN(y, p_v.y), MIN(z, p_v.z)}; }
	constexpr Vector3i max(const Vector3i &p_v) const { return {MAX(x, p_v.x), MAX(y, p_v.y), MAX(z, p_v.z)}; }
	constexpr Vector3i clamp(const Vector3i &p_min, const Vector3i &p_max) const { return max(p_min).min(p_max); }
	constexpr Axis min_axis_index() const { return x < y ? (x < z ? AXIS_X : AXIS_Z) : (y < z ? AXIS_Y : AXIS_Z); }
	constexpr Axis max_axis_index() const { return x < y ? (y < z ? AXIS_Z : AXIS_Y) : (x < z ? AXIS_Z : AXIS_X); }

	operator String() const;
	operator Vector3() const;
};

constexpr Vector3i operator*(int32_t p_s, const Vector3i &p_v) {
	return p_v * p_s;
}

} // namespace godot
