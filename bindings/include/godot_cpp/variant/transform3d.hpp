#pragma once

#include <godot_cpp/variant/aabb.hpp>
#include <godot_cpp/variant/basis.hpp>
#include <godot_cpp/variant/plane.hpp>

namespace godot {

class String;

struct Transform3D {
	Basis basis;
	Vector3 origin;

	constexpr Transform3D() = default;
	constexpr Transform3D(const Basis &p_basis, const Vector3 &p_origin = Vector3())
	    : basis(p_basis), origin(p_origin) {}
	constexpr Transform3D(const Vector3 &p_x, const Vector3 &p_y, const Vector3 &p_z, const Vector3 &p_origin)
	    : basis(p_x, p_y, p_z), origin(p_origin) {}

	const Basis &get_basis() const { return basis; }
	void set_basis(const Basis &p_basis) { basis = p_basis; }
	const Vector3 &get_origin() const { return origin; }
	void set_origin(const Vector3 &p_origin) { origin = p_origin; }

	// For rotation and translation only; affine_inverse() undoes scaling too.
	Transform3D inverse() const {
		const Basis turned = basis.transposed();
		return {turned, turned.xform(-origin)};
	}
	Transform3D affine_inverse() const {
		const Basis undone = basis.inverse();
		return {undone, undone.xform(-origin)};
	}
	void invert() { *this = inverse(); }
	void affine_invert() { *this = affine_inverse(); }
	Transform3D orthonormalized() const { return {basis.orthonormalized(), origin}; }
	void orthonormalize() { basis.orthonormalize(); }
	Transform3D looking_at(const Vector3 &p_target, const Vector3 &p_up = Vector3(0, 1, 0),
	                       bool p_use_model_front = false) const {
		return {Basis::looking_at(p_target - origin, p_up, p_use_model_front), origin};
	}
	Transform3D rotated(const Vector3 &p_axis, real_t p_angle) const {
		const Basis turn(p_axis, p_angle);
		return {turn * basis, turn.xform(origin)};
	}
	Transform3D rotated_local(const Vector3 &p_axis, real_t p_angle) const {
		return {basis * Basis(p_axis, p_angle), origin};
	}
	Transform3D scaled(const Vector3 &p_scale) const { return {basis.scaled(p_scale), origin * p_scale}; }
	Transform3D scaled_local(const Vector3 &p_scale) const { return {basis.scaled_local(p_scale), origin}; }
	Transform3D translated(const Vector3 &p_by) const { return {basis, origin + p_by}; }
	Transform3D translated_local(const Vector3 &p_by) const { return {basis, origin + basis.xform(p_by)}; }

	Vector3 xform(const Vector3 &p_v) const { return basis.xform(p_v) + origin; }
	Vector3 xform_inv(const Vector3 &p_v) const { return basis.xform_inv(p_v - origin); }
	AABB xform(const AABB &p_box) const {
		AABB result(xform(p_box.position), Vector3());
		for (int i = 1; i < 8; i++) {
			result.expand_to(xform(p_box.get_endpoint(i)));
		}
		return result;
	}
	Vector3 operator*(const Vector3 &p_v) const { return xform(p_v); }
	AABB operator*(const AABB &p_box) const { return xform(p_box); }
	Transform3D operator*(const Transform3D &p_t) const { return {basis * p_t.basis, xform(p_t.origin)}; }
	void operator*=(const Transform3D &p_t) { *this = *this * p_t; }
	bool operator==(const Transform3D &p_t) const { return basis == p_t.basis && origin == p_t.origin; }
	bool operator!=(const Transform3D &p_t) const { return !(*this == p_t); }
	bool is_equal_approx(const Transform3D &p_t) const {
		return basis.is_equal_approx(p_t.basis) && origin.is_equal_approx(p_t.origin);
	}
	bool is_finite() const { return basis.is_finite() && origin.is_finite(); }

	operator String() const;
};

} // namespace godot
