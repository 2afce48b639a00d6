#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace pcg {

// 0 Monday .. 6 Sunday.
constexpr std::array<std::string_view, 7> day_names{ "monday", "tuesday", "wednesday", "thursday", "friday", "saturday", "sunday" };

// "mon": how tables, command lines and scripts name a day of the week.
constexpr std::string_view short_day_name(size_t weekday) { return day_names[weekday].substr(0, 3); }

constexpr std::optional<int> weekday_named(std::string_view short_name) {
	for (size_t day = 0; day < day_names.size(); ++day) {
		if (short_day_name(day) == short_name) {
			return int(day);
		}
	}
	return std::nullopt;
}

} // namespace pcg
