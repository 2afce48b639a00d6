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

#ifdef REAL_T_IS_DOUBLE
typedef double real_t;
#else
typedef float real_t;
#endif

#ifndef ABS
#define ABS(m_v) (((m_v) < 0) ? (-(m_v)) : (m_v))
#endif
#ifndef SIGN
#define SIGN(m_v) (((m_v) == 0) ? (0.0f) : (((m_v) < 0) ? (-1.0f) : (+1.0f)))
#endif
#ifndef MIN
#define MIN(m_a, m_b) (((m_a) < (m_b)) ? (m_a) : (m_b))
#endif
#ifndef MAX
#define MAX(m_a, m_b) (((m_a) > (m_b)) ? (m_a) : (m_b))
#endif
#ifndef CLAMP
#define CLAMP(m_a, m_min, m_max) (((m_a) < (m_min)) ? (m_min) : (((m_a) > (m_max)) ? m_max : m_a))
#endif
