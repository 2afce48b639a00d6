#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/lang/attribute_override.h"
#include "core/lang/vm.h"
#include "core/sim/party.h"
#include "core/sim/person_record.h"
#include "core/sim/statistics.h"
#include "core/sim/walk_pool.h"

// The state of a simulation as plain data, and that as bytes. What follows from the rest (who holds which seat, how many are inside) is not kept,
// nor since when people do what they do: observers of a loaded simulation hear of the time from loading on.
namespace pcg {

// A delayed rule that waits.
struct SavedBehavior {
	PersonId person = PersonId::Invalid;
	RuleId rule = RuleId::Invalid;
	AgentPose pose = AgentPose::Stand;
	bool uses_on_arrival = false;
	uint64_t random_key = 0;
	uint64_t random_counter = 0;
	VmState run;
};

struct SavedState {
	uint64_t program_fingerprint = 0; // 0: none
	uint64_t seed = 0;
	std::vector<AttributeOverride> attributes; // of the rules, that the host set
	Duration patience;
	uint64_t city_origin = 0; // CityModel::origin
	uint64_t buildings = 0, zones = 0, objects = 0; // that the city had
	SimTime now;
	SimulationStatistics statistics;
	std::vector<PersonRecord> persons; // their walks, behaviors and parties are indices of these lists
	std::vector<Walk> walks;
	std::vector<SavedBehavior> behaviors;
	std::vector<Party> parties;
	std::vector<int32_t> floating_taken;
};

std::string state_to_bytes(const SavedState &state);
// False: the bytes are no state. What the numbers in it mean is not checked.
bool state_from_bytes(std::string_view bytes, SavedState &state);

} // namespace pcg
