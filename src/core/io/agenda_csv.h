#pragma once

#include <optional>
#include <string>

#include "core/agenda/agenda.h"
#include "core/base/diagnostic.h"
#include "core/io/city_json.h"
#include "core/lang/program.h"
#include "core/population/population.h"

// Agendas as a table: a row for each entry and day of the week on which it starts, person after person, day after day, by start. Columns:
// household, person, age, gender (w m), day (mon .. sun), start, end (seconds since 0h of that day; the end may lie beyond 86400), kind
// (stayInside goToBuilding accompany delayedRule floatingSlot floatingTask), target (a building; of floating slots none), detail (the
// group's leader and joiners, or the rule). A floating task has no start, and its duration as the end.
namespace pcg {

// Numbers for ids; null: dense ids.
struct AgendaCsvIds {
	const FileIds *households = nullptr;
	const FileIds *persons = nullptr;
	const FileIds *buildings = nullptr;
};

// Writes the file whole or not at all; `weekday` (0 Monday) for one day only. False after an error.
bool write_agendas(const std::string &path, const AgendaSet &agendas, const Population &population, const Program &program,
		const AgendaCsvIds &ids, std::optional<int> weekday, Diagnostics &diagnostics);
// The same rows as text.
std::string agendas_to_csv(const AgendaSet &agendas, const Population &population, const Program &program, const AgendaCsvIds &ids,
		std::optional<int> weekday);

} // namespace pcg
