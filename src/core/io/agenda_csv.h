#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/agenda/agenda.h"
#include "core/base/file_ids.h"
#include "core/lang/program.h"
#include "core/population/population.h"

// Agendas as a table: a row for each entry and day of the week on which it starts, person after person, day after day, by start. Columns:
// household, person, age, gender (w m), day (mon .. sun), start, end (seconds since 0h of that day; the end may lie beyond 86400), kind
// (stayInside goToBuilding accompany delayedRule floatingSlot floatingTask), target (a building; of floating slots none), detail (the
// group's leader and joiners, or the rule). A floating task has no start, and its duration as the end.
namespace pcg {

// Takes the agendas of a population part by part.
class AgendaCsvWriter {
public:
	// `weekday` (0 Monday) for one day only. All that is referred to outlives the writer.
	AgendaCsvWriter(const Population &population, const Program &program, const FileNumbers &numbers, std::optional<int> weekday,
			std::function<void(std::string_view)> sink);
	// Of the persons from `first` on; parts follow each other. The first begins with the line of names.
	void write(const AgendaSet &agendas, PersonId first = PersonId(0));

private:
	const Population &_population;
	const Program &_program;
	FileNumbers _numbers;
	std::optional<int> _weekday;
	std::function<void(std::string_view)> _sink;
	bool _has_begun = false;
};

std::string agendas_to_csv(const AgendaSet &agendas, const Population &population, const Program &program, const FileNumbers &numbers,
		std::optional<int> weekday);

} // namespace pcg
