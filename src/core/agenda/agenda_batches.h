#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/agenda/agenda.h"
#include "core/base/diagnostic.h"
#include "core/lang/program.h"

namespace pcg {

// What one piece of work wrote for households that follow each other. Groups, names and requirements are counted by each batch for itself, and the
// origin of an entry is an address in the program.
struct AgendaBatch {
	std::vector<Task> tasks;
	std::vector<uint32_t> task_counts; // by person
	std::vector<FloatingTask> floating_tasks;
	std::vector<uint32_t> floating_counts;
	std::vector<Group> groups;
	std::vector<std::string> names; // the first is empty; none if no rule names any
	std::vector<Requirement> requirements;
	std::vector<Diagnostic> diagnostics;
};

// One behind the other, with numbers that hold for all of them; persons behind the last batch have nothing. Entries are copied on `threads`
// threads (0: as many as the machine runs at once), with the same result for any number. The batches are empty afterwards, but for their diagnostics.
AgendaSet join_batches(std::vector<AgendaBatch> &batches, const Program &program, size_t person_count, unsigned threads);

} // namespace pcg
