#pragma once

#include <vector>

#include "core/sim/person_record.h"

namespace pcg {

// One group task on one day (PCG language, section 5).
struct Party {
	uint32_t group = PersonRecord::none;
	PersonId leader = PersonId::Invalid;
	BuildingId goal = BuildingId::Invalid;
	std::vector<PersonId> pending; // joiners that the leader has not met yet, ascending
	std::vector<PersonId> collected;
};

} // namespace pcg
