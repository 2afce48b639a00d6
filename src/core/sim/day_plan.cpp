#include "core/sim/day_plan.h"

#include <span>

namespace pcg {

namespace {

constexpr int64_t week_days = 7;

DayMask mask_of(int64_t day) { return DayMask(1u << SimTime::at(day, {}).weekday()); }

PlannedEntry on_day(std::span<const Task> tasks, size_t index, int64_t day) {
	const Task &task = tasks[index];
	return { SimTime::at(day, task.start()), SimTime::at(day, task.end()), task.target, uint16_t(index), task.kind, task.is_start_cut };
}

PlannedEntry hole_at(const AgendaView &agenda, SimTime time) {
	const Duration week{ week_days * one_day.ms };
	PlannedEntry result;
	result.start = time - week;
	result.end = time + week;
	for (int64_t day = time.day() - week_days - 1; day <= time.day() + week_days; ++day) {
		const DayMask mask = mask_of(day);
		for (const Task &task : agenda.on(day)) {
			if (!(task.days & mask)) {
				continue;
			}
			const SimTime start = SimTime::at(day, task.start());
			const SimTime end = SimTime::at(day, task.end());
			if (start > time && start < result.end) {
				result.end = start;
			} else if (end <= time && end > result.start) {
				result.start = end;
			}
		}
	}
	return result;
}

// The first day to look at is the one that may have begun what still goes on.
PlannedEntry planned_in_changed(const AgendaView &agenda, SimTime time) {
	for (int64_t day = time.day() - 1; day <= time.day(); ++day) {
		const std::span<const Task> tasks = agenda.on(day);
		const DayMask mask = mask_of(day);
		for (size_t i = 0; i < tasks.size(); ++i) {
			if ((tasks[i].days & mask) && SimTime::at(day, tasks[i].start()) <= time && time < SimTime::at(day, tasks[i].end())) {
				return on_day(tasks, i, day);
			}
		}
	}
	return hole_at(agenda, time);
}

} // namespace

PlannedEntry planned_entry_at(const AgendaView &agenda, SimTime time) {
	if (!agenda.single_days.empty()) [[unlikely]] {
		return planned_in_changed(agenda, time);
	}
	const std::span<const Task> tasks = agenda.week;
	const int64_t today = time.day();
	const int64_t since_midnight = time.ms - today * one_day.ms;
	const int weekday = time.weekday();
	const DayMask on_today = DayMask(1 << weekday), on_yesterday = DayMask(1 << ((weekday + 6) % 7));
	for (size_t i = 0; i < tasks.size(); ++i) {
		const Task &task = tasks[i];
		if (task.start_ms <= since_midnight && since_midnight < task.end_ms && (task.days & on_today)) {
			return on_day(tasks, i, today);
		}
		if (since_midnight + one_day.ms < task.end_ms && (task.days & on_yesterday)) {
			return on_day(tasks, i, today - 1);
		}
	}
	return hole_at(agenda, time);
}

} // namespace pcg
