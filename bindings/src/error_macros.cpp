#include <godot_cpp/core/error_macros.hpp>

#include <godot_cpp/godot.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <string>

namespace godot::internal {

void report(const char *p_function, const char *p_file, int p_line, const char *p_error, const ReportText &p_message,
            Report p_kind) {
	const CharString converted = p_message.string ? p_message.string->utf8() : CharString();
	const char *message = p_message.string ? converted.get_data() : p_message.literal;
	const bool is_warning = p_kind == Report::Warning;
	if (*p_error && *message) {
		(is_warning ? engine.print_warning_with_message : engine.print_error_with_message)(p_error, message, p_function,
		                                                                                   p_file, p_line, false);
	} else {
		(is_warning ? engine.print_warning : engine.print_error)(*message ? message : p_error, p_function, p_file,
		                                                         p_line, false);
	}
}

void report_index(const char *p_function, const char *p_file, int p_line, int64_t p_index, int64_t p_size,
                  const char *p_index_text, const char *p_size_text, const ReportText &p_message) {
	const std::string error = std::string("Index ") + p_index_text + " = " + std::to_string(p_index) +
	                          " is out of bounds (" + p_size_text + " = " + std::to_string(p_size) + ").";
	report(p_function, p_file, p_line, error.c_str(), p_message);
}

void report_untyped_assignment() {
	report(__FUNCTION__, __FILE__, __LINE__, "Cannot assign a container of another element type.");
}

} // namespace godot::internal
