#include "core/agenda/operations/constant_checks.h"

#include <cmath>
#include <string>

namespace pcg::agenda {

namespace {

constexpr double day_seconds = 86'400.0;
constexpr double week_seconds = 7.0 * day_seconds;

} // namespace

std::optional<CallProblem> times_problem(std::string_view operation, double start, double end) {
	const std::string name = "'" + std::string(operation) + "'";
	if (!std::isfinite(start) || !std::isfinite(end)) {
		return CallProblem{ "time-not-finite", name + " has a time that is not finite, so nothing is inserted",
			"the distance to a building that cannot be reached is infinite: test it with isValid(..) or a comparison first" };
	}
	if (std::abs(start) > week_seconds) {
		return CallProblem{ "time-out-of-range", name + " starts more than a week away, so nothing is inserted", "times are seconds from 0h of the day" };
	}
	if (start >= end) {
		return CallProblem{ "no-length", name + " would end before it starts, so nothing is inserted", "the first time has to be before the second" };
	}
	if (end - start > day_seconds) {
		return CallProblem{ "longer-than-a-day", name + " lasts longer than 24 h and is cut there", "write one entry for each day" };
	}
	return std::nullopt;
}

std::optional<CallProblem> duration_problem(double duration, double priority) {
	if (duration > 0.0 && duration <= day_seconds && std::isfinite(priority)) {
		return std::nullopt;
	}
	return CallProblem{ "bad-duration", "'floatingTask' needs a duration above 0 and up to 24 h and a finite priority, so nothing is added",
		"the duration is the first argument, in seconds: floatingTask(20m, Rule)" };
}

CallProblem no_building(std::string_view operation, double number) {
	const std::string name = "'" + std::string(operation) + "'";
	if (number == -1.0) {
		return { "no-building", name + " is given no building, so nothing is inserted", "a building that is not found is -1: test it with isValid(..) first" };
	}
	return { "no-building", name + " is given " + value_text(Value::of(number)) + ", which is no building of the city, so nothing is inserted",
		"buildings have the ids of the city's file: write one of them, or find one by its type, as in findBuilding(\"school\")" };
}

std::optional<CallProblem> check_times(std::string_view operation, std::span<const Value> constants) {
	const bool are_known = constants.size() >= 2 && constants[0].is_number() && constants[1].is_number();
	return are_known ? times_problem(operation, constants[0].number, constants[1].number) : std::nullopt;
}

std::optional<CallProblem> check_building_entry(std::string_view operation, std::span<const Value> constants) {
	if (constants.size() >= 3 && constants[2].is_number() && !(constants[2].number >= 0.0)) {
		return no_building(operation, constants[2].number);
	}
	return check_times(operation, constants);
}

std::optional<CallProblem> check_duration(std::string_view, std::span<const Value> constants) {
	if (constants.empty() || !constants[0].is_number()) {
		return std::nullopt;
	}
	const bool has_priority = constants.size() >= 3 && constants[2].is_number();
	return duration_problem(constants[0].number, has_priority ? constants[2].number : 0.0);
}

} // namespace pcg::agenda
