#include "core/agenda/operations/constant_checks.h"

#include <cmath>
#include <string>
#include <utility>

#include "core/agenda/task.h"
#include "core/lang/vm.h"

namespace pcg::agenda {

std::optional<CallProblem> moment_problem(std::string_view operation, double time) {
	const std::string name = "'" + std::string(operation) + "'";
	if (!std::isfinite(time)) {
		return CallProblem{ "time-not-finite", name + " has a time that is not finite, so nothing is inserted",
			"numbers beyond 1e308, roots of negative numbers and the distance to a building that cannot be reached are not finite: test with a comparison first" };
	}
	if (std::abs(time) > week_seconds) {
		return CallProblem{ "time-out-of-range", name + " has a time more than a week away, so nothing is inserted", "times are seconds from 0h of the day" };
	}
	return std::nullopt;
}

std::optional<CallProblem> times_problem(std::string_view operation, double start, double end) {
	const std::string name = "'" + std::string(operation) + "'";
	std::optional<CallProblem> problem = moment_problem(operation, std::isfinite(end) ? start : end);
	if (problem) {
		return problem;
	}
	if (start >= end) {
		return CallProblem{ "no-length", name + " would end before it starts, so nothing is inserted", "the first time has to be before the second" };
	}
	if (end - start > day_seconds) {
		return CallProblem{ too_long_id, name + " lasts longer than 24 h and is cut there", "write one entry for each day" };
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

CallProblem no_building(std::string_view operation, double number, std::string_view numbers) {
	const std::string name = "'" + std::string(operation) + "'";
	if (number == -1.0) {
		return { "no-building", name + " is given no building, so nothing is inserted", "a building that is not found is -1: test it with isValid(..) first" };
	}
	return { "no-building", name + " is given " + value_text(Value::of(number)) + ", which is no building of the city, so nothing is inserted",
		std::string(numbers) + ": find one by its type, as in findBuilding(\"school\")" };
}

CallProblem no_days(DayMask outer) {
	return { "no-days", "these days are none of those around, so nothing is inserted there", "the days around are " + days_text(outer) };
}

void warn(Vm &vm, CallProblem problem) { vm.warn(problem.id, std::move(problem.message), std::move(problem.hint)); }

std::optional<CallProblem> check_times(const KnownCall &call) {
	const auto times = call.arguments;
	return times[0].is_number() && times[1].is_number() ? times_problem(call.operation, times[0].number, times[1].number) : std::nullopt;
}

std::optional<CallProblem> check_building_entry(const KnownCall &call) {
	if (call.arguments[2].is_number() && !(call.arguments[2].number >= 0.0)) {
		return no_building(call.operation, call.arguments[2].number, "to rules what is below 0 is none");
	}
	return check_times(call);
}

std::optional<CallProblem> check_duration(const KnownCall &call) {
	if (!call.arguments[0].is_number()) {
		return std::nullopt;
	}
	const bool has_priority = call.arguments.size() >= 3 && call.arguments[2].is_number();
	return duration_problem(call.arguments[0].number, has_priority ? call.arguments[2].number : 0.0);
}

std::optional<CallProblem> check_moment(const KnownCall &call) {
	return call.arguments[0].is_number() ? moment_problem(call.operation, call.arguments[0].number) : std::nullopt;
}

} // namespace pcg::agenda
