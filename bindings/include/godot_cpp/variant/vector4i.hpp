#pragma once

#include <godot_cpp/core/math.hpp>

namespace godot {

class String;
struct Vector4;

struct Vector4i {
	enum Axis { AXIS_X, AXIS_Y, AXIS_Z, AXIS_W };
	static constexpr int AXIS_COUNT = 4;

	int32_t x = 0, y = 0, z = 0, w = 0;

	constexpr Vector4i() = default;
	constexpr Vector4i(int32_t p_x, int32_t p_y, int32_t p_z, int32_t p_w) : x(p_x), y(p_y), z(p_z), w(p_w) {}

	const int32_t &operator[](int p_axis) const { return (&x)[p_axis]; }
	int32_t &operator[](int p_axis) { return (&x)[p_axis]; }

	constexpr Vector4i operator+(const Vector4i &p_v) const { return {x + p_v.x, y + p_v.y, z + p_v.z, w + p_v.w}; }
	constexpr Vector4i operator-(const Vector4i &p_v) const { return {x - p_v.x, y - p_v.y, z - p_v.z, w - p_v.w}; }
	constexpr Vector4i operator*(const Vector4i &p_v) const { return {x * p_v.x, y * p_v.y, z * p_v.z, w * p_v.w}; }
	constexpr Vector4i operator/(const Vector4i &p_v) const { return {x / p_v.x, y / p_v.y, z / p_v.z, w / p_v.w}; }
	constexpr Vector4i operator%(const Vector4i &p_v) const { return {x % p_v.x, y % p_v.y, z % p_v.z, w % p_v.w}; }
	constexpr Vector4i operator*(int32_t p_s) const { return {x * p_s, y * p_s, z * p_s, w * p_s}; }
	constexpr Vector4i operator/(int32_t p_s) const { return {x / p_s, y / p_s, z / p_s, w / p_s}; }
	constexpr Vector4i operator%(int32_t p_s) const { return {x % p_s, y % p_s, z % p_s, w % p_s}; }
	constexpr Vector4i operator-() const { return {-x, -y, -z, -w}; }
	constexpr Vector4i &operator+=(const Vector4i &p_v) { return *this = *this + p_v; }
	constexpr Vector4i &operator-=(const Vector4i &p_v) { return *this = *this - p_v; }
	constexpr Vector4i &operator*=(const Vector4i &p_v) { return *this = *this * p_v; }
	constexpr Vector4i &operator/=(const Vector4i &p_v) { return *this = *this / p_v; }
	constexpr Vector4i &operator%=(const Vector4i &p_v) { return *this = *this % p_v; }
	constexpr Vector4i &operator*=(int32_t p_s) { return *this = *this * p_s; }
	constexpr Vector4i &operator/=(int32_t p_s) { return *this = *this / p_s; }
	constexpr Vector4i &operator%=(int32_t p_s) { return *this = *this % p_s; }
	constexpr bool operator==(const Vector4i &p_v) const {
		return x == p_v.x && y == p_v.y && z == p_v.z && w == p_v.w;
	}
	constexpr bool operator!=(const Vector4i &p_v) const { return !(*this == p_v); }
	// In the order of the axes, so that vectors can be sorted and be keys.
	constexpr bool operator<(const Vector4i &p_v) const {
		return x != p_v.x ? x < p_v.x : (y != p_v.y ? y < p_v.y : (z != p_v.z ? z < p_v.z : w < p_v.w));
	}
	constexpr bool operator>(const Vector4i &p_v) const { return p_v < *this; }
	constexpr bool operator<=(const Vector4i &p_v) const { return !(p_v < *this); }
	constexpr bool operator>=(const Vector4i &p_v) const { return !(*this < p_v); }

	constexpr int64_t length_squared() const {
		return int64_t(x) * x + int64_t(y) * y + int64_t(z) * z + int64_t(w) * w;
	}
	double length() const { return Math::sqrt(double(length_squared())); }
	constexpr int64_t distance_squared_to(const Vector4i &p_to) const { return (p_to - *this).length_squared(); }
	double distance_to(const Vector4i &p_to) const { return (p_to - *this).length(); }
	Vector4i abs() const { return {Math::abs(x), Math::abs(y), Math::abs(z), Math::abs(w)}; }
	constexpr Vector4i sign() const { return {int32_t(SIGN(x)), int32_t(SIGN(y)), int32_t(SIGN(z)), int32_t(SIGN(w))}; }
	constexpr Vector4i min(const Vector4i &p_v) const {
		return {MIN(x, p_v.x), MIN(y, p_v.y), MIN(z, p_v.z), MIN(w, p_v.w)};
	}
	constexpr Vector4i max(const Vector4i &p_v) const {
		return {MAX(x, p_v.x), MAX(y, p_v.y), MAX(z, p_v.z), MAX(w, p_v.w)};
	}
	constexpr Vector4i clamp(const Vector4i &p_min, const Vector4i &p_max) const { return max(p_min).min(p_max); }

	operator String() const;
	operator Vector4() const;
};

constexpr Vector4i operator*(int32_t p_s, const Vector4i &p_v) {
	return p_v * p_s;
}

} // namespace godot
