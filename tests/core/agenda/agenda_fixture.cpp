#include "agenda_fixture.h"

#include <array>

namespace pcg {

std::string AgendaFixture::day_of(PersonId id, int day) const {
	constexpr std::array<std::string_view, 5> kinds{ "stay", "go", "accompany", "rule", "slot" };
	std::string text;
	for (const Task &task : agendas.agenda_of(id).on(day)) {
		if (!((task.days >> day % 7) & 1)) {
			continue;
		}
		text += text.empty() ? "" : "; ";
		text += clock_text(task.start(), task.start_ms % 60'000 != 0) + "-" + clock_text(task.end(), task.end_ms % 60'000 != 0) + " ";
		text += kinds[size_t(task.kind)];
		if (task.kind == TaskKind::StayInside || task.kind == TaskKind::GoToBuilding) {
			text += " " + std::to_string(task.target);
		} else if (task.kind == TaskKind::Accompany) {
			text += " to " + std::to_string(index_of(agendas.groups[task.target].goal));
		} else if (task.kind == TaskKind::DelayedRule) {
			text += " " + program->rules[task.target].name;
		}
	}
	return text;
}

std::string AgendaFixture::walks_of(PersonId id, int day) const {
	std::string text;
	for (Task task : agendas.tasks_of(id)) {
		if (task.kind != TaskKind::Accompany || !((task.days >> day) & 1)) {
			continue;
		}
		task.days = DayMask(1u << day);
		const Group &group = agendas.groups[task.target];
		text += (text.empty() ? "" : "; ") + clock_text(task.start(), false) + " " + std::to_string(index_of(group.leader)) + " leads";
		for (PersonId joiner : joiners_on(agendas, task.target, set_out_days(group, task))) {
			text += " " + std::to_string(index_of(joiner));
		}
	}
	return text;
}

std::string AgendaFixture::problems() const {
	std::string text;
	for (const Diagnostic &diagnostic : diagnostics.list()) {
		text += text.empty() ? "" : " ";
		text += diagnostic.id;
	}
	return text;
}

} // namespace pcg
