#pragma once

#include <godot_cpp/core/math_defs.hpp>

#include <cmath>

namespace godot::Math {

#define GODOT_CPP_MATH_1(m_name)                                                                                       \
	inline double m_name(double p_x) {                                                                                 \
		return std::m_name(p_x);                                                                                       \
	}                                                                                                                  \
	inline float m_name(float p_x) {                                                                                   \
		return std::m_name(p_x);                                                                                       \
	}
GODOT_CPP_MATH_1(sin)
GODOT_CPP_MATH_1(cos)
GODOT_CPP_MATH_1(tan)
GODOT_CPP_MATH_1(asin)
GODOT_CPP_MATH_1(acos)
GODOT_CPP_MATH_1(atan)
GODOT_CPP_MATH_1(sinh)
GODOT_CPP_MATH_1(cosh)
GODOT_CPP_MATH_1(tanh)
GODOT_CPP_MATH_1(sqrt)
GODOT_CPP_MATH_1(exp)
GODOT_CPP_MATH_1(log)
GODOT_CPP_MATH_1(floor)
GODOT_CPP_MATH_1(ceil)
GODOT_CPP_MATH_1(round)
#undef GODOT_CPP_MATH_1

inline double atan2(double p_y, double p_x) {
	return std::atan2(p_y, p_x);
}
inline float atan2(float p_y, float p_x) {
	return std::atan2(p_y, p_x);
}
inline double pow(double p_x, double p_y) {
	return std::pow(p_x, p_y);
}
inline float pow(float p_x, float p_y) {
	return std::pow(p_x, p_y);
}
inline double fmod(double p_x, double p_y) {
	return std::fmod(p_x, p_y);
}
inline float fmod(float p_x, float p_y) {
	return std::fmod(p_x, p_y);
}

inline double abs(double p_x) {
	return std::abs(p_x);
}
inline float abs(float p_x) {
	return std::abs(p_x);
}
inline int abs(int p_x) {
	return p_x < 0 ? -p_x : p_x;
}
inline int64_t abs(int64_t p_x) {
	return p_x < 0 ? -p_x : p_x;
}
inline bool is_nan(double p_x) {
	return std::isnan(p_x);
}
inline bool is_nan(float p_x) {
	return std::isnan(p_x);
}
inline bool is_inf(double p_x) {
	return std::isinf(p_x);
}
inline bool is_inf(float p_x) {
	return std::isinf(p_x);
}
inline bool is_finite(double p_x) {
	return std::isfinite(p_x);
}
inline bool is_finite(float p_x) {
	return std::isfinite(p_x);
}

inline double deg_to_rad(double p_x) {
	return p_x * Math_PI / 180.0;
}
inline float deg_to_rad(float p_x) {
	return p_x * float(Math_PI / 180.0);
}
inline double rad_to_deg(double p_x) {
	return p_x * 180.0 / Math_PI;
}
inline float rad_to_deg(float p_x) {
	return p_x * float(180.0 / Math_PI);
}

inline double lerp(double p_from, double p_to, double p_weight) {
	return p_from + (p_to - p_from) * p_weight;
}
inline float lerp(float p_from, float p_to, float p_weight) {
	return p_from + (p_to - p_from) * p_weight;
}
inline double inverse_lerp(double p_from, double p_to, double p_value) {
	return (p_value - p_from) / (p_to - p_from);
}
inline float inverse_lerp(float p_from, float p_to, float p_value) {
	return (p_value - p_from) / (p_to - p_from);
}

// Equal up to a tolerance relative to the size of the numbers, and never finer than CMP_EPSILON.
inline bool is_equal_approx(double p_a, double p_b) {
	return p_a == p_b || std::abs(p_a - p_b) < MAX(CMP_EPSILON * std::abs(p_a), CMP_EPSILON);
}
inline bool is_equal_approx(float p_a, float p_b) {
	return p_a == p_b || std::abs(p_a - p_b) < MAX(float(CMP_EPSILON) * std::abs(p_a), float(CMP_EPSILON));
}
inline bool is_equal_approx(double p_a, double p_b, double p_tolerance) {
	return p_a == p_b || std::abs(p_a - p_b) < p_tolerance;
}
inline bool is_zero_approx(double p_x) {
	return std::abs(p_x) < CMP_EPSILON;
}
inline bool is_zero_approx(float p_x) {
	return std::abs(p_x) < float(CMP_EPSILON);
}

// The remainder with the sign of the divisor.
inline double fposmod(double p_x, double p_y) {
	double value = std::fmod(p_x, p_y);
	return (value < 0 && p_y > 0) || (value > 0 && p_y < 0) ? value + p_y : value;
}
inline float fposmod(float p_x, float p_y) {
	return float(fposmod(double(p_x), double(p_y)));
}
inline int64_t posmod(int64_t p_x, int64_t p_y) {
	int64_t value = p_x % p_y;
	return (value < 0 && p_y > 0) || (value > 0 && p_y < 0) ? value + p_y : value;
}

inline double snapped(double p_value, double p_step) {
	return p_step == 0 ? p_value : std::floor(p_value / p_step + 0.5) * p_step;
}
inline double move_toward(double p_from, double p_to, double p_delta) {
	return std::abs(p_to - p_from) <= p_delta ? p_to : p_from + (p_to < p_from ? -p_delta : p_delta);
}
inline float move_toward(float p_from, float p_to, float p_delta) {
	return std::abs(p_to - p_from) <= p_delta ? p_to : p_from + (p_to < p_from ? -p_delta : p_delta);
}

} // namespace godot::Math
