#pragma once

#include <string>

#include "core/base/diagnostic.h"
#include "core/io/atomic_file.h"
#include "core/io/city_json.h"
#include "core/population/population.h"
#include "core/sim/lived_log.h"
#include "core/sim/observer.h"

// What happened in a simulation, as tables.
namespace pcg {

// The numbers that the user's files gave; dense ids where null.
struct FileNumbers {
	const FileIds *buildings = nullptr;
	const FileIds *zones = nullptr;
	const FileIds *objects = nullptr;
	const FileIds *persons = nullptr;

	// "building:12", "zone:3", ..; empty for none.
	std::string text(Target place) const;
	std::string text(PersonId id) const;
};

// Writes every event as it comes: columns seconds (since `start`), person, event, place, x, z.
class TraceWriter : public SimulationObserver {
public:
	TraceWriter(AtomicFile &file, SimTime start, FileNumbers numbers = {});

	void on_event(const SimEvent &event) override;
	void on_jump(SimTime from, SimTime to) override;

private:
	AtomicFile &_file;
	SimTime _start;
	FileNumbers _numbers;
};

// A row for every lived stretch, by person, then by time: who, when, in which state where, how far it walked, with whom, and the entry of the
// agenda that it served. False, with one error, if the file could not be written.
bool write_lived_csv(const std::string &path, const CityModel &city, const Population &population, const LivedLog &log,
		const FileNumbers &numbers, Diagnostics &diagnostics);

} // namespace pcg
