#include "core/io/agenda_csv.h"

#include <cstdio>
#include <utility>

#include "core/base/day_names.h"
#include "core/io/csv.h"

namespace pcg {

namespace {

constexpr size_t buffer_size = 1 << 20;

// Seconds with as many digits behind the point as they need: 28800, 28712.5.
std::string seconds_text(int32_t ms) {
	char text[32];
	std::snprintf(text, sizeof(text), "%.3f", double(ms) / 1000.0);
	std::string seconds = text;
	while (seconds.back() == '0') {
		seconds.pop_back();
	}
	if (seconds.back() == '.') {
		seconds.pop_back();
	}
	return seconds;
}

// One part.
class Rows {
public:
	Rows(const AgendaSet &agendas, PersonId first, const Population &population, const Program &program, const FileNumbers &numbers,
			const std::function<void(std::string_view)> &sink) :
			_agendas(agendas), _first(index_of(first)), _population(population), _program(program), _numbers(numbers), _sink(sink) {}

	void write(std::optional<int> weekday) {
		for (size_t i = 0; i < _agendas.person_count() && _first + i < _population.persons.size(); ++i) {
			for (int day = 0; day < 7; ++day) {
				if (!weekday || *weekday == day) {
					write_day(PersonId(uint32_t(i)), day);
				}
			}
			if (_text.size() > buffer_size) {
				flush();
			}
		}
		flush();
	}

private:
	void flush() {
		_sink(_text);
		_text.clear();
	}

	// `place` among those of the part.
	void write_day(PersonId place, int day) {
		const PersonId id = PersonId(index_of(place) + _first);
		for (const Task &task : _agendas.tasks_of(place)) {
			if ((task.days >> day) & 1) {
				begin_row(id, day);
				_text += seconds_text(task.start_ms) + "," + seconds_text(task.end_ms) + ",";
				_text += std::string(task_kind_name(task.kind)) + "," + target_text(task) + "," + csv_quoted(detail_text(task, day)) + "\n";
			}
		}
		for (const FloatingTask &task : _agendas.floating_tasks_of(place)) {
			if ((task.days >> day) & 1) {
				begin_row(id, day);
				char priority[32];
				std::snprintf(priority, sizeof(priority), "%g", double(task.priority));
				_text += "," + seconds_text(task.duration_ms) + ",floatingTask,," +
						csv_quoted(rule_name(index_of(task.rule)) + " priority " + priority) + "\n";
			}
		}
	}

	void begin_row(PersonId id, int day) {
		const Person &person = _population.person(id);
		char age[32];
		std::snprintf(age, sizeof(age), "%g", double(person.age));
		_text += number_text(_numbers.households, person.household) + "," + number_text(_numbers.persons, id) + "," + age;
		_text += person.gender == Gender::Woman ? ",w," : ",m,";
		_text += std::string(short_day_name(size_t(day))) + ",";
	}

	std::string target_text(const Task &task) const {
		switch (task.kind) {
			case TaskKind::StayInside:
			case TaskKind::GoToBuilding:
				return number_text(_numbers.buildings, BuildingId(task.target));
			case TaskKind::Accompany:
				return number_text(_numbers.buildings, _agendas.groups[task.target].goal);
			case TaskKind::DelayedRule:
			case TaskKind::FloatingSlot:
				break;
		}
		return {};
	}

	std::string detail_text(Task task, int day) const {
		if (task.kind == TaskKind::DelayedRule) {
			return rule_name(task.target);
		}
		if (task.kind != TaskKind::Accompany) {
			return {};
		}
		const Group &group = _agendas.groups[task.target];
		std::string text = "leader " + number_text(_numbers.persons, group.leader) + " joiners";
		task.days = DayMask(1u << day);
		for (PersonId joiner : joiners_on(_agendas, task.target, set_out_days(group, task), PersonId(_first))) {
			text += " " + number_text(_numbers.persons, joiner);
		}
		return text;
	}

	std::string rule_name(uint32_t rule) const { return rule < _program.rules.size() ? _program.rules[rule].name : std::string(); }

	const AgendaSet &_agendas;
	uint32_t _first;
	const Population &_population;
	const Program &_program;
	const FileNumbers &_numbers;
	const std::function<void(std::string_view)> &_sink;
	std::string _text;
};

} // namespace

AgendaCsvWriter::AgendaCsvWriter(const Population &population, const Program &program, const FileNumbers &numbers, std::optional<int> weekday,
		std::function<void(std::string_view)> sink) :
		_population(population), _program(program), _numbers(numbers), _weekday(weekday), _sink(std::move(sink)) {}

void AgendaCsvWriter::write(const AgendaSet &agendas, PersonId first) {
	if (!_has_begun) {
		_has_begun = true;
		_sink("household,person,age,gender,day,start,end,kind,target,detail\n");
	}
	Rows(agendas, first, _population, _program, _numbers, _sink).write(_weekday);
}

std::string agendas_to_csv(const AgendaSet &agendas, const Population &population, const Program &program, const FileNumbers &numbers,
		std::optional<int> weekday) {
	std::string text;
	AgendaCsvWriter(population, program, numbers, weekday, [&](std::string_view bytes) { text += bytes; }).write(agendas);
	return text;
}

} // namespace pcg
