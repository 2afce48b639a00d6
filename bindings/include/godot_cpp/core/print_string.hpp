#pragma once

#include <godot_cpp/variant/utility_functions.hpp>

namespace godot {

template <typename... Args> void print_line(const Variant &p_variant, const Args &...p_args) {
	UtilityFunctions::print(p_variant, p_args...);
}
template <typename... Args> void print_line_rich(const Variant &p_variant, const Args &...p_args) {
	UtilityFunctions::print_rich(p_variant, p_args...);
}
template <typename... Args> void print_error(const Variant &p_variant, const Args &...p_args) {
	UtilityFunctions::printerr(p_variant, p_args...);
}
template <typename... Args> void print_verbose(const Variant &p_variant, const Args &...p_args) {
	UtilityFunctions::print_verbose(p_variant, p_args...);
}
bool is_print_verbose_enabled();

} // namespace godot
