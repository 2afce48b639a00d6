#pragma once

#include <optional>

#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/string.hpp>

#include "core/agenda/agenda.h"
#include "core/lang/program.h"

// Entries of agendas as scripts see them: what CitizenManager.get_agenda() gives, and insert_task() takes.
namespace pcg {

// Keys: kind, start, end, target, days; `delayed_rule` that it runs; `leader` and `joiners` of a walk together; `name`, `requires`, `after` where it has
// them; rule, file, line of its origin. Joiners are those of the `day` on which it begins, as SimTime counts; without one, of any of its days.
godot::Dictionary to_godot(const Task &task, const AgendaSet &agendas, const Program &program, std::optional<int64_t> day = std::nullopt);

struct WrittenTask {
	Task task;
	std::optional<int64_t> day; // the only one; without: every week
};

class TaskReader {
public:
	// Names that are new are added to the agendas.
	TaskReader(AgendaSet &agendas, const Program &program) : _agendas(agendas), _program(program) {}

	// Nothing if a key is unknown or a value cannot be; problem() says why. Whether a target exists is not looked at.
	std::optional<WrittenTask> read(const godot::Dictionary &task);
	godot::String problem() const { return _problem; }

private:
	bool read_kind(const godot::Variant &kind);
	bool read_times(const godot::Dictionary &task);
	bool read_target(const godot::Dictionary &task);
	bool read_days(const godot::Dictionary &task);
	bool read_names(const godot::Dictionary &task);
	bool require(const godot::Variant &names, bool is_after);
	bool fail(const godot::String &problem);

	AgendaSet &_agendas;
	const Program &_program;
	WrittenTask _written;
	godot::String _problem;
};

} // namespace pcg
