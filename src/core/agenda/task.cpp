#include "core/agenda/task.h"

#include "core/base/day_names.h"

namespace pcg {

DayMask rotate_days(DayMask days, int64_t shift) {
	const int by = int(((shift % 7) + 7) % 7);
	return DayMask(((days << by) | (days >> (7 - by))) & all_days);
}

Task normalized(Task task) {
	constexpr int32_t day_ms = int32_t(one_day.ms);
	if (task.start_ms >= 0 && task.start_ms < day_ms) {
		return task;
	}
	const int32_t shift = task.start_ms / day_ms - (task.start_ms % day_ms < 0 ? 1 : 0);
	task.start_ms -= shift * day_ms;
	task.end_ms -= shift * day_ms;
	task.days = rotate_days(task.days, shift);
	if (task.name != 0 || task.requirement != 0) {
		task.days_later = uint16_t(((task.days_later + shift) % 7 + 7) % 7);
	}
	return task;
}

std::string days_text(DayMask days) {
	if (days == all_days) {
		return "every day";
	}
	std::string text;
	for (size_t day = 0; day < day_names.size(); ++day) {
		if ((days >> day) & 1) {
			text += (text.empty() ? "" : ", ") + std::string(short_day_name(day));
		}
	}
	return text;
}

std::string_view task_kind_name(TaskKind kind) {
	switch (kind) {
		case TaskKind::StayInside:
			return "stayInside";
		case TaskKind::GoToBuilding:
			return "goToBuilding";
		case TaskKind::Accompany:
			return "accompany";
		case TaskKind::DelayedRule:
			return "delayedRule";
		case TaskKind::FloatingSlot:
			return "floatingSlot";
	}
	return "";
}

} // namespace pcg
