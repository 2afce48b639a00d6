#pragma once

#include <chrono>
#include <string>

#include <sys/resource.h>

#include "bench/allocation_count.h"
#include "bench/figure.h"
#include "core/sim/simulation.h"

// What it costs to live: a day, a jump in time, a frame when most are outdoors, and memory. All in wall time.
namespace pcg::bench {

inline double seconds_of(auto &&work) {
	const auto start = std::chrono::steady_clock::now();
	work();
	return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The most that this program ever had, in 10^6 bytes.
inline double most_resident_mb() {
	rusage usage{};
	getrusage(RUSAGE_SELF, &usage);
	return double(usage.ru_maxrss) * 1024.0 / 1e6;
}

// Frames at 60 a second and 60 times real time.
inline void measure_frames(Simulation &simulation, const std::string &name) {
	constexpr int frames = 600;
	int quiet_frames = 0;
	const uint64_t before = heap.allocations;
	const double seconds = seconds_of([&] {
		for (int frame = 0; frame < frames; ++frame) {
			const uint64_t asked = heap.allocations;
			simulation.step(Duration::seconds(1.0));
			quiet_frames += heap.allocations == asked;
		}
	});
	print(name + "_frame_at_peak", seconds / frames * 1000.0, "ms");
	print(name + "_allocations_per_frame", double(heap.allocations - before) / frames, "allocations");
	print(name + "_frames_without_allocations", 100.0 * quiet_frames / frames, "%");
}

// A day from midnight on, a jump to eight o'clock of the third day, and what comes then, `to_peak` later. `peer`: person hours a second.
inline void measure_life(Simulation &simulation, const std::string &name, Duration to_peak, double peer) {
	const double persons = double(simulation.person_count());
	print(name + "_start", seconds_of([&] { simulation.start(SimTime{}); }), "s");
	const double day = seconds_of([&] { simulation.advance_to(SimTime::at(1, {})); });
	print(name + "_day", day, "s");
	print(name + "_person_hours_per_second", persons * 24.0 / day, "person h/s", peer);
	print(name + "_trips", double(simulation.statistics().trips), "trips");
	print(name + "_most_outdoors", double(simulation.statistics().peak_outside), "persons");
	print(name + "_jump", seconds_of([&] { simulation.jump_to(SimTime::at(2, Duration::hours(8))); }) * 1000.0, "ms");
	simulation.step(to_peak);
	measure_frames(simulation, name);
	print(name + "_memory", most_resident_mb(), "MB");
}

} // namespace pcg::bench
