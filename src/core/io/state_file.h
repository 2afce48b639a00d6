#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/diagnostic.h"
#include "core/sim/saved_people.h"
#include "core/sim/simulation.h"

// A simulation in a file: "PCGSTATE", the version of the format (32 bits), the sizes of the two parts (64 bits each), a checksum of them
// (64 bits), the people with their agendas, the state. All numbers have their least byte first.
namespace pcg {

constexpr uint32_t state_version = 3;

struct StateFile {
	SavedPeople people; // to make the simulation with that takes the rest
	std::string simulation; // for Simulation::restore
};

std::string state_file_bytes(const Simulation &simulation);
// Nothing, with one error that says why, if the bytes are damaged, of a newer version, or no state at all. `file` is its name for the message.
std::optional<StateFile> read_state_file(std::string_view bytes, const std::string &file, Diagnostics &diagnostics);

// Whole or not at all. False after an error.
bool save_state(const std::string &path, const Simulation &simulation, Diagnostics &diagnostics);
std::optional<StateFile> load_state(const std::string &path, Diagnostics &diagnostics);

} // namespace pcg
