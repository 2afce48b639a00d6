#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <type_traits>
#include <utility>

#if defined(_MSC_VER)
#define GDE_EXPORT __declspec(dllexport)
#define _ALWAYS_INLINE_ __forceinline
#elif defined(_WIN32)
#define GDE_EXPORT __attribute__((visibility("default"))) __declspec(dllexport)
#define _ALWAYS_INLINE_ __attribute__((always_inline)) inline
#else
#define GDE_EXPORT __attribute__((visibility("default")))
#define _ALWAYS_INLINE_ __attribute__((always_inline)) inline
#endif
#define _FORCE_INLINE_ _ALWAYS_INLINE_

#define _STR(m_x) #m_x
#define _MKSTR(m_x) _STR(m_x)

#ifdef __GNUC__
#define likely(m_x) __builtin_expect(!!(m_x), 1)
#define unlikely(m_x) __builtin_expect(!!(m_x), 0)
#else
#define likely(m_x) m_x
#define unlikely(m_x) m_x
#endif

namespace godot {

#ifdef REAL_T_IS_DOUBLE
typedef double real_t;
#else
typedef float real_t;
#endif

template <typename T> constexpr T SIGN(const T p_value) {
	return p_value == 0 ? T(0) : p_value < 0 ? T(-1) : T(+1);
}

template <typename T, typename T2> constexpr auto MIN(const T p_a, const T2 p_b) {
	return p_a < p_b ? p_a : p_b;
}

template <typename T, typename T2> constexpr auto MAX(const T p_a, const T2 p_b) {
	return p_a > p_b ? p_a : p_b;
}

template <typename T, typename T2, typename T3> constexpr auto CLAMP(const T p_value, const T2 p_min, const T3 p_max) {
	return p_value < p_min ? p_min : p_value > p_max ? p_max : p_value;
}

} // namespace godot

using real_t = godot::real_t;
