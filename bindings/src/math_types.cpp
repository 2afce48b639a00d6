// What the math types need of the engine (text), and the parts too long for a header.
#include <godot_cpp/variant/variant.hpp>

namespace godot {

#define GODOT_CPP_TO_TEXT(m_type)                                                                                      \
	m_type::operator String() const {                                                                                  \
		return Variant(*this).stringify();                                                                             \
	}
GODOT_CPP_TO_TEXT(Vector2)
GODOT_CPP_TO_TEXT(Vector2i)
GODOT_CPP_TO_TEXT(Vector3)
GODOT_CPP_TO_TEXT(Vector3i)
GODOT_CPP_TO_TEXT(Vector4)
GODOT_CPP_TO_TEXT(Vector4i)
GODOT_CPP_TO_TEXT(Rect2)
GODOT_CPP_TO_TEXT(Rect2i)
GODOT_CPP_TO_TEXT(Plane)
GODOT_CPP_TO_TEXT(Quaternion)
GODOT_CPP_TO_TEXT(AABB)
GODOT_CPP_TO_TEXT(Basis)
GODOT_CPP_TO_TEXT(Transform2D)
GODOT_CPP_TO_TEXT(Transform3D)
GODOT_CPP_TO_TEXT(Projection)
GODOT_CPP_TO_TEXT(Color)
#undef GODOT_CPP_TO_TEXT

// Fractions are cut off, as in the engine.
Vector2::operator Vector2i() const {
	return {int32_t(x), int32_t(y)};
}
Vector2i::operator Vector2() const {
	return {real_t(x), real_t(y)};
}
Vector3::operator Vector3i() const {
	return {int32_t(x), int32_t(y), int32_t(z)};
}
Vector3i::operator Vector3() const {
	return {real_t(x), real_t(y), real_t(z)};
}
Vector4::operator Vector4i() const {
	return {int32_t(x), int32_t(y), int32_t(z), int32_t(w)};
}
Vector4i::operator Vector4() const {
	return {real_t(x), real_t(y), real_t(z), real_t(w)};
}
Rect2::operator Rect2i() const {
	return {Vector2i(position), Vector2i(size)};
}
Rect2i::operator Rect2() const {
	return {Vector2(position), Vector2(size)};
}

Quaternion Basis::get_quaternion() const {
	const Basis &m = *this;
	const real_t trace = m[0][0] + m[1][1] + m[2][2];
	if (trace > 0) {
		const real_t s = Math::sqrt(trace + 1) * 2;
		return {(m[2][1] - m[1][2]) / s, (m[0][2] - m[2][0]) / s, (m[1][0] - m[0][1]) / s, s / 4};
	}
	// The largest diagonal element keeps the root away from zero.
	const int i = m[0][0] < m[1][1] ? (m[1][1] < m[2][2] ? 2 : 1) : (m[0][0] < m[2][2] ? 2 : 0);
	const int j = (i + 1) % 3;
	const int k = (i + 2) % 3;
	const real_t s = Math::sqrt(m[i][i] - m[j][j] - m[k][k] + 1) * 2;
	Quaternion result;
	result[i] = s / 4;
	result[j] = (m[j][i] + m[i][j]) / s;
	result[k] = (m[k][i] + m[i][k]) / s;
	result.w = (m[k][j] - m[j][k]) / s;
	return result;
}

Quaternion Basis::get_rotation_quaternion() const {
	Basis turned = orthonormalized();
	return (turned.determinant() < 0 ? turned * -1 : turned).get_quaternion();
}

namespace {

// The engine does the rare ones, so that all six orders agree with it.
Variant call_basis(const Basis &p_basis, const char *p_method, EulerOrder p_order) {
	return Variant(p_basis).call(p_method, int64_t(p_order));
}

} // namespace

Vector3 Basis::get_euler(EulerOrder p_order) const {
	return call_basis(*this, "get_euler", p_order);
}

void Basis::set_euler(const Vector3 &p_euler, EulerOrder p_order) {
	static const int axes[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
	Basis turns[3];
	for (int axis = 0; axis < 3; axis++) {
		Vector3 direction;
		direction[axis] = 1;
		turns[axis] = Basis(direction, p_euler[axis]);
	}
	const int *order = axes[p_order];
	*this = turns[order[0]] * turns[order[1]] * turns[order[2]];
}

Color::Color(const String &p_code) : Color(Variant(p_code).operator Color()) {}

Color::Color(const char *p_code) : Color(String(p_code)) {}

Color Color::html(const String &p_rgba) {
	return Color(p_rgba);
}

Color Color::named(const String &p_name) {
	return Color(p_name);
}

Color Color::from_hsv(float p_h, float p_s, float p_v, float p_alpha) {
	auto channel = [&](float p_n) {
		const float k = std::fmod(p_n + p_h * 6.0f, 6.0f);
		return p_v - p_v * p_s * MAX(0.0f, MIN(MIN(k, 4.0f - k), 1.0f));
	};
	return {channel(5), channel(3), channel(1), p_alpha};
}

uint32_t Color::to_rgba32() const {
	auto byte = [](float p_channel) { return uint32_t(CLAMP(Math::round(p_channel * 255.0f), 0.0f, 255.0f)); };
	return byte(r) << 24 | byte(g) << 16 | byte(b) << 8 | byte(a);
}

String Color::to_html(bool p_alpha) const {
	return Variant(*this).call("to_html", p_alpha);
}

} // namespace godot
