#pragma once

#include <godot_cpp/variant/vector3.hpp>

namespace godot {

class String;

// A rotation; those that rotate are of length 1.
struct Quaternion {
	real_t x = 0, y = 0, z = 0, w = 1;

	constexpr Quaternion() = default;
	constexpr Quaternion(real_t p_x, real_t p_y, real_t p_z, real_t p_w) : x(p_x), y(p_y), z(p_z), w(p_w) {}
	Quaternion(const Vector3 &p_axis, real_t p_angle) {
		const real_t length = p_axis.length();
		if (length > 0) {
			const Vector3 v = p_axis * (Math::sin(p_angle / 2) / length);
			*this = {v.x, v.y, v.z, Math::cos(p_angle / 2)};
		}
	}
	// The shortest rotation from one direction to another; both normalized and not opposite.
	Quaternion(const Vector3 &p_from, const Vector3 &p_to) {
		const Vector3 c = p_from.cross(p_to);
		*this = Quaternion(c.x, c.y, c.z, 1 + p_from.dot(p_to)).normalized();
	}

	const real_t &operator[](int p_index) const { return (&x)[p_index]; }
	real_t &operator[](int p_index) { return (&x)[p_index]; }

	real_t dot(const Quaternion &p_q) const { return x * p_q.x + y * p_q.y + z * p_q.z + w * p_q.w; }
	real_t length_squared() const { return dot(*this); }
	real_t length() const { return Math::sqrt(length_squared()); }
	void normalize() { *this = *this / length(); }
	Quaternion normalized() const { return *this / length(); }
	bool is_normalized() const { return Math::is_equal_approx(length_squared(), 1, UNIT_EPSILON); }
	Quaternion inverse() const { return {-x, -y, -z, w}; }
	Vector3 get_axis() const {
		const real_t scale = Math::sqrt(1 - w * w);
		return scale == 0 ? Vector3(x, y, z) : Vector3(x, y, z) / scale;
	}
	real_t get_angle() const { return 2 * Math::acos(CLAMP(w, real_t(-1), real_t(1))); }
	real_t angle_to(const Quaternion &p_to) const {
		const real_t d = dot(p_to);
		return Math::acos(CLAMP(d * d * 2 - 1, real_t(-1), real_t(1)));
	}

	Vector3 xform(const Vector3 &p_v) const {
		const Vector3 axis(x, y, z);
		const Vector3 across = axis.cross(p_v);
		return p_v + (across * w + axis.cross(across)) * 2;
	}
	Vector3 xform_inv(const Vector3 &p_v) const { return inverse().xform(p_v); }
	Quaternion slerp(const Quaternion &p_to, real_t p_weight) const {
		real_t cosine = dot(p_to);
		const Quaternion to = cosine < 0 ? -p_to : p_to;
		cosine = Math::abs(cosine);
		if (1 - cosine <= real_t(CMP_EPSILON)) {
			return *this * (1 - p_weight) + to * p_weight;
		}
		const real_t angle = Math::acos(cosine);
		return (*this * Math::sin((1 - p_weight) * angle) + to * Math::sin(p_weight * angle)) / Math::sin(angle);
	}

	Quaternion operator*(const Quaternion &p_q) const {
		return {w * p_q.x + x * p_q.w + y * p_q.z - z * p_q.y, w * p_q.y + y * p_q.w + z * p_q.x - x * p_q.z,
		        w * p_q.z + z * p_q.w + x * p_q.y - y * p_q.x, w * p_q.w - x * p_q.x - y * p_q.y - z * p_q.z};
	}
	void operator*=(const Quaternion &p_q) { *this = *this * p_q; }
	Vector3 operator*(const Vector3 &p_v) const { return xform(p_v); }
	Quaternion operator+(const Quaternion &p_q) const { return {x + p_q.x, y + p_q.y, z + p_q.z, w + p_q.w}; }
	Quaternion operator-(const Quaternion &p_q) const { return {x - p_q.x, y - p_q.y, z - p_q.z, w - p_q.w}; }
	Quaternion operator-() const { return {-x, -y, -z, -w}; }
	Quaternion operator*(real_t p_s) const { return {x * p_s, y * p_s, z * p_s, w * p_s}; }
	Quaternion operator/(real_t p_s) const { return {x / p_s, y / p_s, z / p_s, w / p_s}; }
	bool operator==(const Quaternion &p_q) const { return x == p_q.x && y == p_q.y && z == p_q.z && w == p_q.w; }
	bool operator!=(const Quaternion &p_q) const { return !(*this == p_q); }
	bool is_equal_approx(const Quaternion &p_q) const {
		return Math::is_equal_approx(x, p_q.x) && Math::is_equal_approx(y, p_q.y) && Math::is_equal_approx(z, p_q.z) &&
		       Math::is_equal_approx(w, p_q.w);
	}
	bool is_finite() const {
		return Math::is_finite(x) && Math::is_finite(y) && Math::is_finite(z) && Math::is_finite(w);
	}

	operator String() const;
};

} // namespace godot
