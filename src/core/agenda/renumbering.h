#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/agenda/agenda.h"

namespace pcg {

// For tasks that come behind others: groups, origins, names and requirements that they count for themselves get the numbers of the whole set.
class Renumbering {
public:
	// What the set does not know of `names` and `requirements` is added to it; both as in AgendaSet. `origins` gives the new number for each one that
	// the tasks have, and outlives this; groups come behind `first_group` others.
	Renumbering(AgendaSet &set, std::span<const std::string> names, std::span<const Requirement> requirements, std::span<const uint32_t> origins,
			size_t first_group);

	Task apply(Task task) const {
		task.origin = _origins[task.origin];
		task.target += task.kind == TaskKind::Accompany ? _first_group : 0;
		task.name = task.name != 0 ? _names[task.name] : task.name;
		task.requirement = task.requirement != 0 ? _requirements[task.requirement] : task.requirement;
		return task;
	}

private:
	std::span<const uint32_t> _origins;
	std::vector<uint16_t> _names;
	std::vector<uint8_t> _requirements;
	uint32_t _first_group;
};

} // namespace pcg
