#pragma once

#include <array>
#include <cstdint>

#include "core/base/sim_time.h"
#include "core/sim/observer.h"

namespace pcg {

struct SimulationStatistics {
	uint64_t trips = 0; // walks that reached their goal, counted per walker
	// Persons who went in more than a second after a stayInside there was to begin. What a newer entry left of an older one begins when that one
	// is over, not at a time that a rule wrote: nobody is late for it.
	uint64_t late_arrivals = 0;
	uint32_t outside = 0; // now
	uint32_t peak_outside = 0;
	SimTime peak_time; // the first moment of the peak
	uint64_t handled_moments = 0; // taken from the queue: what the work is proportional to
	std::array<uint64_t, sim_event_kind_count> events{}; // by SimEventKind

	uint64_t count(SimEventKind kind) const { return events[size_t(kind)]; }
};

} // namespace pcg
