#pragma once

#include <godot_cpp/variant/vector3.hpp>

namespace godot {

class String;
class Variant;

// Points p with normal · p = d; the normal points to the side that is "over".
struct Plane {
	Vector3 normal;
	real_t d = 0;

	constexpr Plane() = default;
	constexpr Plane(real_t p_a, real_t p_b, real_t p_c, real_t p_d) : normal(p_a, p_b, p_c), d(p_d) {}
	constexpr Plane(const Vector3 &p_normal, real_t p_d = 0) : normal(p_normal), d(p_d) {}
	constexpr Plane(const Vector3 &p_normal, const Vector3 &p_point) : normal(p_normal), d(p_normal.dot(p_point)) {}
	// Clockwise points, as the engine winds its triangles.
	Plane(const Vector3 &p_a, const Vector3 &p_b, const Vector3 &p_c)
	    : normal((p_a - p_c).cross(p_a - p_b).normalized()), d(normal.dot(p_a)) {}

	Vector3 get_center() const { return normal * d; }
	Vector3 project(const Vector3 &p_point) const { return p_point - normal * distance_to(p_point); }
	real_t distance_to(const Vector3 &p_point) const { return normal.dot(p_point) - d; }
	bool is_point_over(const Vector3 &p_point) const { return normal.dot(p_point) > d; }
	bool has_point(const Vector3 &p_point, real_t p_tolerance = CMP_EPSILON) const {
		return Math::abs(distance_to(p_point)) <= p_tolerance;
	}
	void normalize() {
		const real_t length = normal.length();
		*this = length == 0 ? Plane() : Plane(normal / length, d / length);
	}
	Plane normalized() const {
		Plane result = *this;
		result.normalize();
		return result;
	}

	Plane operator-() const { return {-normal, -d}; }
	bool operator==(const Plane &p_plane) const { return normal == p_plane.normal && d == p_plane.d; }
	bool operator!=(const Plane &p_plane) const { return !(*this == p_plane); }
	bool is_equal_approx(const Plane &p_plane) const {
		return normal.is_equal_approx(p_plane.normal) && Math::is_equal_approx(d, p_plane.d);
	}
	bool is_finite() const { return normal.is_finite() && Math::is_finite(d); }

	operator String() const;
};

} // namespace godot
