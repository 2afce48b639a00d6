#include "core/base/sim_time.h"

#include <cstdio>
#include <cstdlib>

namespace pcg {

std::string clock_text(Duration time_of_day, bool with_seconds) {
	const long long total = std::llabs(time_of_day.ms) / 1000;
	const char *sign = time_of_day.ms < 0 ? "-" : "";
	char text[48];
	if (with_seconds) {
		std::snprintf(text, sizeof(text), "%s%02lld:%02lld:%02lld", sign, total / 3600, total / 60 % 60, total % 60);
	} else {
		std::snprintf(text, sizeof(text), "%s%02lld:%02lld", sign, total / 3600, total / 60 % 60);
	}
	return text;
}

} // namespace pcg
