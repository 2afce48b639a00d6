#pragma once

#include <cmath>
#include <compare>
#include <cstdint>
#include <string>

// Time of the simulated world in whole milliseconds, so that sums are exact and equal on every platform.
namespace pcg {

// A span of time, may be negative.
struct Duration {
	int64_t ms = 0;

	// Rounded to the nearest millisecond; NaN and infinities become 0, values beyond +-1e12 s are clamped.
	static Duration seconds(double value) {
		if (!std::isfinite(value)) {
			return {};
		}
		const double clamped = value > 1e12 ? 1e12 : (value < -1e12 ? -1e12 : value);
		return { int64_t(std::llround(clamped * 1000.0)) };
	}
	static constexpr Duration hours(int64_t value) { return { value * 3'600'000 }; }
	static constexpr Duration minutes(int64_t value) { return { value * 60'000 }; }
	constexpr double in_seconds() const { return double(ms) / 1000.0; }

	friend constexpr auto operator<=>(const Duration &, const Duration &) = default;
	friend constexpr Duration operator+(Duration a, Duration b) { return { a.ms + b.ms }; }
	friend constexpr Duration operator-(Duration a, Duration b) { return { a.ms - b.ms }; }
};

constexpr Duration one_day = Duration::hours(24);

// A moment: milliseconds since 0h of the first day, which is a Monday. May be negative (the evening before).
struct SimTime {
	int64_t ms = 0;

	static constexpr SimTime at(int64_t day, Duration time_of_day) { return { day * one_day.ms + time_of_day.ms }; }

	// Days since the first, rounded down: -1 is the day before it.
	constexpr int64_t day() const {
		const int64_t quotient = ms / one_day.ms;
		return ms % one_day.ms < 0 ? quotient - 1 : quotient;
	}
	// 0 Monday .. 6 Sunday.
	constexpr int weekday() const { return int(((day() % 7) + 7) % 7); }
	// In [0, 24 h).
	constexpr Duration time_of_day() const { return { ms - day() * one_day.ms }; }
	constexpr double in_seconds() const { return double(ms) / 1000.0; }

	friend constexpr auto operator<=>(const SimTime &, const SimTime &) = default;
	friend constexpr SimTime operator+(SimTime a, Duration b) { return { a.ms + b.ms }; }
	friend constexpr SimTime operator-(SimTime a, Duration b) { return { a.ms - b.ms }; }
	friend constexpr Duration operator-(SimTime a, SimTime b) { return { a.ms - b.ms }; }
};

// A set of week days, bit 0 = Monday .. bit 6 = Sunday.
using DayMask = uint8_t;
constexpr DayMask all_days = 0x7F;

// "07:58" or, with seconds, "07:58:02"; times past midnight go on counting ("25:10"), times before it carry a minus.
std::string clock_text(Duration time_of_day, bool with_seconds = false);

} // namespace pcg
