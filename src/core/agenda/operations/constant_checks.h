#pragma once

#include <optional>
#include <string_view>

#include "core/base/sim_time.h"
#include "core/lang/dialect.h"

// What is wrong with an entry whatever happens: said when rules are loaded where the values are known by then, else when they run.
namespace pcg::agenda {

constexpr double day_seconds = 86'400.0;
constexpr double week_seconds = 7.0 * day_seconds;
constexpr std::string_view too_long_id = "longer-than-a-day";

// Of start and end in seconds of the day. An entry of more than a day is cut, with all others nothing is inserted.
std::optional<CallProblem> times_problem(std::string_view operation, double start, double end);
std::optional<CallProblem> duration_problem(double duration, double priority);
std::optional<CallProblem> moment_problem(std::string_view operation, double time);
// `numbers`: which ones buildings have.
CallProblem no_building(std::string_view operation, double number, std::string_view numbers);
CallProblem no_days(DayMask outer);
// For what shows only while rules run.
void warn(Vm &vm, CallProblem problem);

// For OperationSpec::check.
std::optional<CallProblem> check_times(const KnownCall &call); // (t0, t1, ..)
std::optional<CallProblem> check_building_entry(const KnownCall &call); // (t0, t1, building)
std::optional<CallProblem> check_duration(const KnownCall &call); // (duration, rule [, priority])
std::optional<CallProblem> check_moment(const KnownCall &call); // (time, ..)

} // namespace pcg::agenda
