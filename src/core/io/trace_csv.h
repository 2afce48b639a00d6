#pragma once

#include <string>

#include "core/base/diagnostic.h"
#include "core/base/file_ids.h"
#include "core/io/atomic_file.h"
#include "core/population/population.h"
#include "core/sim/lived_log.h"
#include "core/sim/simulation.h"

// What happened in a simulation, as tables.
namespace pcg {

// Writes every event as it comes: columns seconds (since `start`), person, event, place, x, z. At the start and after a time jump, which is a row
// `jumped` whose place is the moment before, a row for everybody tells where it is: inside, walking (there), at-place or waiting.
class TraceWriter : public SimulationObserver {
public:
	TraceWriter(AtomicFile &file, const Simulation &simulation, SimTime start, FileNumbers numbers = {});

	void on_event(const SimEvent &event) override;
	void on_jump(SimTime from, SimTime to) override;

private:
	void write(SimTime time, PersonId person, std::string_view what, Target place, glm::vec3 position);

	AtomicFile &_file;
	const Simulation &_simulation;
	SimTime _start;
	FileNumbers _numbers;
};

// A row for every lived stretch, by person, then by time; the rows of a person follow each other without a gap. Columns:
//   person, name, age
//   day, start, end, seconds      whole seconds; all clock times count from 0h of `day` on, past 24:00:00 if need be
//   state                         inside, walking, at-place (of a zone or object), waiting (outdoors)
//   place, type                   where the person is, or walks to; of a building what it is to this person (see building_use.h)
//   entrance                      index of the door by which it came in; where nobody saw it come in, the building's first
//   x, z                          where it is at the end of the row; indoors, that door. It leaves by the door that is nearest to where it goes
//   metres                        walked in the row
//   leader                        of the group that it walks with, or waits for
//   planned, planned_start, planned_end    the entry of the agenda that it serves; "home" is a hole in the agenda
// False, with one error, if the file could not be written.
bool write_lived_csv(const std::string &path, const CityModel &city, const Population &population, const LivedLog &log,
		const FileNumbers &numbers, Diagnostics &diagnostics);

} // namespace pcg
