// Checks that report through the engine and leave the function; same names and meaning as in the engine itself.
#pragma once

#include <godot_cpp/core/defs.hpp>

#include <cstdint>

namespace godot {

class String;

namespace internal {

enum class Report { Error, Warning };

// A message is a literal or a String; taking both here keeps every macro to one form.
class ReportText {
	friend void report(const char *, const char *, int, const char *, const ReportText &, Report);
	const char *literal = "";
	const String *string = nullptr;

public:
	ReportText(const char *p_text) : literal(p_text) {}
	ReportText(const String &p_text) : string(&p_text) {}
};

void report(const char *p_function, const char *p_file, int p_line, const char *p_error,
            const ReportText &p_message = "", Report p_kind = Report::Error);
void report_index(const char *p_function, const char *p_file, int p_line, int64_t p_index, int64_t p_size,
                  const char *p_index_text, const char *p_size_text, const ReportText &p_message = "");

} // namespace internal
} // namespace godot

#define FUNCTION_STR __FUNCTION__

#if defined(_MSC_VER)
#define GENERATE_TRAP() __debugbreak()
#else
#define GENERATE_TRAP() __builtin_trap()
#endif

#define GODOT_CPP_REPORT(...) ::godot::internal::report(FUNCTION_STR, __FILE__, __LINE__, __VA_ARGS__)
#define GODOT_CPP_REPORT_INDEX(m_index, m_size, m_msg)                                                                 \
	::godot::internal::report_index(FUNCTION_STR, __FILE__, __LINE__, int64_t(m_index), int64_t(m_size),               \
	                                _STR(m_index), _STR(m_size), m_msg)

// `else ((void)0)` lets a macro stand in an `if` without braces and demands the semicolon.
#define GODOT_CPP_CHECK(m_failed, m_report, m_leave)                                                                   \
	if (unlikely(m_failed)) {                                                                                          \
		m_report;                                                                                                      \
		m_leave;                                                                                                       \
	} else                                                                                                             \
		((void)0)

#define GODOT_CPP_CHECK_INDEX(m_index, m_size, m_msg, m_leave)                                                         \
	GODOT_CPP_CHECK((m_index) < 0 || (m_index) >= (m_size), GODOT_CPP_REPORT_INDEX(m_index, m_size, m_msg), m_leave)
#define GODOT_CPP_CHECK_UNSIGNED(m_index, m_size, m_msg, m_leave)                                                      \
	GODOT_CPP_CHECK((m_index) >= (m_size), GODOT_CPP_REPORT_INDEX(m_index, m_size, m_msg), m_leave)
#define GODOT_CPP_CHECK_NULL(m_param, m_msg, m_leave)                                                                  \
	GODOT_CPP_CHECK((m_param) == nullptr, GODOT_CPP_REPORT("Parameter \"" _STR(m_param) "\" is null.", m_msg), m_leave)
#define GODOT_CPP_CHECK_COND(m_cond, m_msg, m_then, m_leave)                                                           \
	GODOT_CPP_CHECK(m_cond, GODOT_CPP_REPORT("Condition \"" _STR(m_cond) "\" is true." m_then, m_msg), m_leave)

// clang-format off: it would put a space into `return)`
#define ERR_FAIL_INDEX(m_index, m_size) GODOT_CPP_CHECK_INDEX(m_index, m_size, "", return)
#define ERR_FAIL_INDEX_MSG(m_index, m_size, m_msg) GODOT_CPP_CHECK_INDEX(m_index, m_size, m_msg, return)
#define ERR_FAIL_INDEX_V(m_index, m_size, m_retval) GODOT_CPP_CHECK_INDEX(m_index, m_size, "", return m_retval)
#define ERR_FAIL_INDEX_V_MSG(m_index, m_size, m_retval, m_msg)                                                         \
	GODOT_CPP_CHECK_INDEX(m_index, m_size, m_msg, return m_retval)
#define CRASH_BAD_INDEX(m_index, m_size) GODOT_CPP_CHECK_INDEX(m_index, m_size, "FATAL", GENERATE_TRAP())
#define CRASH_BAD_INDEX_MSG(m_index, m_size, m_msg) GODOT_CPP_CHECK_INDEX(m_index, m_size, m_msg, GENERATE_TRAP())

#define ERR_FAIL_UNSIGNED_INDEX(m_index, m_size) GODOT_CPP_CHECK_UNSIGNED(m_index, m_size, "", return)
#define ERR_FAIL_UNSIGNED_INDEX_MSG(m_index, m_size, m_msg) GODOT_CPP_CHECK_UNSIGNED(m_index, m_size, m_msg, return)
#define ERR_FAIL_UNSIGNED_INDEX_V(m_index, m_size, m_retval)                                                           \
	GODOT_CPP_CHECK_UNSIGNED(m_index, m_size, "", return m_retval)
#define ERR_FAIL_UNSIGNED_INDEX_V_MSG(m_index, m_size, m_retval, m_msg)                                                \
	GODOT_CPP_CHECK_UNSIGNED(m_index, m_size, m_msg, return m_retval)
#define CRASH_BAD_UNSIGNED_INDEX(m_index, m_size) GODOT_CPP_CHECK_UNSIGNED(m_index, m_size, "FATAL", GENERATE_TRAP())
#define CRASH_BAD_UNSIGNED_INDEX_MSG(m_index, m_size, m_msg)                                                           \
	GODOT_CPP_CHECK_UNSIGNED(m_index, m_size, m_msg, GENERATE_TRAP())

#define ERR_FAIL_NULL(m_param) GODOT_CPP_CHECK_NULL(m_param, "", return)
#define ERR_FAIL_NULL_MSG(m_param, m_msg) GODOT_CPP_CHECK_NULL(m_param, m_msg, return)
#define ERR_FAIL_NULL_V(m_param, m_retval) GODOT_CPP_CHECK_NULL(m_param, "", return m_retval)
#define ERR_FAIL_NULL_V_MSG(m_param, m_retval, m_msg) GODOT_CPP_CHECK_NULL(m_param, m_msg, return m_retval)

#define ERR_FAIL_COND(m_cond) GODOT_CPP_CHECK_COND(m_cond, "", "", return)
#define ERR_FAIL_COND_MSG(m_cond, m_msg) GODOT_CPP_CHECK_COND(m_cond, m_msg, "", return)
#define ERR_FAIL_COND_V(m_cond, m_retval)                                                                              \
	GODOT_CPP_CHECK_COND(m_cond, "", " Returning: " _STR(m_retval), return m_retval)
#define ERR_FAIL_COND_V_MSG(m_cond, m_retval, m_msg)                                                                   \
	GODOT_CPP_CHECK_COND(m_cond, m_msg, " Returning: " _STR(m_retval), return m_retval)
#define ERR_CONTINUE(m_cond) GODOT_CPP_CHECK_COND(m_cond, "", " Continuing.", continue)
#define ERR_CONTINUE_MSG(m_cond, m_msg) GODOT_CPP_CHECK_COND(m_cond, m_msg, " Continuing.", continue)
#define ERR_BREAK(m_cond) GODOT_CPP_CHECK_COND(m_cond, "", " Breaking.", break)
#define ERR_BREAK_MSG(m_cond, m_msg) GODOT_CPP_CHECK_COND(m_cond, m_msg, " Breaking.", break)
#define CRASH_COND(m_cond) GODOT_CPP_CHECK_COND(m_cond, "FATAL", "", GENERATE_TRAP())
#define CRASH_COND_MSG(m_cond, m_msg) GODOT_CPP_CHECK_COND(m_cond, m_msg, "", GENERATE_TRAP())

#define ERR_FAIL() GODOT_CPP_CHECK(true, GODOT_CPP_REPORT("Method/function failed."), return)
#define ERR_FAIL_MSG(m_msg) GODOT_CPP_CHECK(true, GODOT_CPP_REPORT("Method/function failed.", m_msg), return)
#define ERR_FAIL_V(m_retval)                                                                                           \
	GODOT_CPP_CHECK(true, GODOT_CPP_REPORT("Method/function failed. Returning: " _STR(m_retval)), return m_retval)
#define ERR_FAIL_V_MSG(m_retval, m_msg)                                                                                \
	GODOT_CPP_CHECK(true, GODOT_CPP_REPORT("Method/function failed. Returning: " _STR(m_retval), m_msg),               \
	                return m_retval)
#define CRASH_NOW() GODOT_CPP_CHECK(true, GODOT_CPP_REPORT("FATAL: Method/function failed."), GENERATE_TRAP())
#define CRASH_NOW_MSG(m_msg)                                                                                           \
	GODOT_CPP_CHECK(true, GODOT_CPP_REPORT("FATAL: Method/function failed.", m_msg), GENERATE_TRAP())
// clang-format on

#define GODOT_CPP_ONCE(m_action)                                                                                       \
	if (true) {                                                                                                        \
		static bool reported = false;                                                                                  \
		if (unlikely(!reported)) {                                                                                     \
			reported = true;                                                                                           \
			m_action;                                                                                                  \
		}                                                                                                              \
	} else                                                                                                             \
		((void)0)

#define ERR_PRINT(m_msg) GODOT_CPP_REPORT("", m_msg)
#define ERR_PRINT_ONCE(m_msg) GODOT_CPP_ONCE(ERR_PRINT(m_msg))
#define WARN_PRINT(m_msg) GODOT_CPP_REPORT("", m_msg, ::godot::internal::Report::Warning)
#define WARN_PRINT_ONCE(m_msg) GODOT_CPP_ONCE(WARN_PRINT(m_msg))

#ifdef DEV_ENABLED
#define DEV_ASSERT(m_cond) CRASH_COND(!(m_cond))
#else
#define DEV_ASSERT(m_cond)
#endif
