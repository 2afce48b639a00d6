#pragma once

#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/vector4.hpp>

namespace godot {

class String;

// A 4 × 4 matrix, stored by columns. Only what crosses the border to the engine; cameras make their own projections.
struct Projection {
	Vector4 columns[4] = {Vector4(1, 0, 0, 0), Vector4(0, 1, 0, 0), Vector4(0, 0, 1, 0), Vector4(0, 0, 0, 1)};

	constexpr Projection() = default;
	constexpr Projection(const Vector4 &p_x, const Vector4 &p_y, const Vector4 &p_z, const Vector4 &p_w)
	    : columns{p_x, p_y, p_z, p_w} {}

	const Vector4 &operator[](int p_index) const { return columns[p_index]; }
	Vector4 &operator[](int p_index) { return columns[p_index]; }

	Vector4 xform(const Vector4 &p_v) const {
		return columns[0] * p_v.x + columns[1] * p_v.y + columns[2] * p_v.z + columns[3] * p_v.w;
	}
	Projection operator*(const Projection &p_p) const {
		return {xform(p_p.columns[0]), xform(p_p.columns[1]), xform(p_p.columns[2]), xform(p_p.columns[3])};
	}
	bool operator==(const Projection &p_p) const {
		return columns[0] == p_p.columns[0] && columns[1] == p_p.columns[1] && columns[2] == p_p.columns[2] &&
		       columns[3] == p_p.columns[3];
	}
	bool operator!=(const Projection &p_p) const { return !(*this == p_p); }

	operator String() const;
};

} // namespace godot
