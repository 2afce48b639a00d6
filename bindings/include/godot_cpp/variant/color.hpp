#pragma once

#include <godot_cpp/core/math.hpp>

namespace godot {

class String;

// Red, green, blue and alpha; 0 to 1 for what a screen can show.
struct Color {
	float r = 0, g = 0, b = 0, a = 1;

	constexpr Color() = default;
	constexpr Color(float p_r, float p_g, float p_b, float p_a = 1.0f) : r(p_r), g(p_g), b(p_b), a(p_a) {}
	constexpr Color(const Color &p_color, float p_a) : r(p_color.r), g(p_color.g), b(p_color.b), a(p_a) {}
	// A name ("red") or a code ("#ff0000").
	Color(const String &p_code);
	Color(const char *p_code);

	static Color html(const String &p_rgba);
	static Color named(const String &p_name);
	static Color from_hsv(float p_h, float p_s, float p_v, float p_alpha = 1.0f);
	static Color hex(uint32_t p_hex) {
		return {float((p_hex >> 24) & 255) / 255.0f, float((p_hex >> 16) & 255) / 255.0f,
		        float((p_hex >> 8) & 255) / 255.0f, float(p_hex & 255) / 255.0f};
	}

	const float &operator[](int p_index) const { return (&r)[p_index]; }
	float &operator[](int p_index) { return (&r)[p_index]; }

	constexpr Color operator+(const Color &p_c) const { return {r + p_c.r, g + p_c.g, b + p_c.b, a + p_c.a}; }
	constexpr Color operator-(const Color &p_c) const { return {r - p_c.r, g - p_c.g, b - p_c.b, a - p_c.a}; }
	constexpr Color operator*(const Color &p_c) const { return {r * p_c.r, g * p_c.g, b * p_c.b, a * p_c.a}; }
	constexpr Color operator*(float p_s) const { return {r * p_s, g * p_s, b * p_s, a * p_s}; }
	constexpr Color operator/(float p_s) const { return {r / p_s, g / p_s, b / p_s, a / p_s}; }
	constexpr bool operator==(const Color &p_c) const { return r == p_c.r && g == p_c.g && b == p_c.b && a == p_c.a; }
	constexpr bool operator!=(const Color &p_c) const { return !(*this == p_c); }
	bool operator<(const Color &p_c) const {
		return r != p_c.r ? r < p_c.r : g != p_c.g ? g < p_c.g : b != p_c.b ? b < p_c.b : a < p_c.a;
	}
	bool is_equal_approx(const Color &p_c) const {
		return Math::is_equal_approx(r, p_c.r) && Math::is_equal_approx(g, p_c.g) && Math::is_equal_approx(b, p_c.b) &&
		       Math::is_equal_approx(a, p_c.a);
	}

	constexpr Color lerp(const Color &p_to, float p_weight) const { return *this + (p_to - *this) * p_weight; }
	Color clamp() const {
		return {CLAMP(r, 0.0f, 1.0f), CLAMP(g, 0.0f, 1.0f), CLAMP(b, 0.0f, 1.0f), CLAMP(a, 0.0f, 1.0f)};
	}
	Color lightened(float p_amount) const {
		return {r + (1 - r) * p_amount, g + (1 - g) * p_amount, b + (1 - b) * p_amount, a};
	}
	Color darkened(float p_amount) const { return {r * (1 - p_amount), g * (1 - p_amount), b * (1 - p_amount), a}; }
	Color inverted() const { return {1 - r, 1 - g, 1 - b, a}; }
	float get_luminance() const { return 0.2126f * r + 0.7152f * g + 0.0722f * b; }
	uint32_t to_rgba32() const;
	String to_html(bool p_alpha = true) const;

	operator String() const;
};

} // namespace godot
