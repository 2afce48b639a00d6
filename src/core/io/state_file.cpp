#include "core/io/state_file.h"

#include "core/base/bytes.h"
#include "core/base/random.h"
#include "core/io/atomic_file.h"

namespace pcg {

namespace {

constexpr std::string_view magic = "PCGSTATE";

uint64_t checksum_of(std::string_view people, std::string_view simulation) {
	return derive_seed(hash_text(people), hash_text(simulation));
}

struct Header {
	uint32_t version = state_version;
	uint64_t people_size = 0, simulation_size = 0, checksum = 0;
};
constexpr size_t header_size = magic.size() + 4 + 3 * 8;

std::optional<StateFile> refuse(Diagnostics &diagnostics, const std::string &file, std::string message, std::string hint) {
	Diagnostic diagnostic;
	diagnostic.id = "bad-state";
	diagnostic.file = file;
	diagnostic.message = std::move(message);
	diagnostic.hint = std::move(hint);
	diagnostics.add(std::move(diagnostic));
	return std::nullopt;
}

} // namespace

std::string state_file_bytes(const Simulation &simulation) {
	const std::string people = people_to_bytes(simulation.population(), simulation.agendas());
	const std::string state = simulation.save();
	ByteWriter header;
	header.values(state_version, uint64_t(people.size()), uint64_t(state.size()), checksum_of(people, state));
	return std::string(magic) + header.bytes() + people + state;
}

std::optional<StateFile> read_state_file(std::string_view bytes, const std::string &file, Diagnostics &diagnostics) {
	if (!bytes.starts_with(magic)) {
		return refuse(diagnostics, file, "this is no saved simulation", "give a file that was written by saving one");
	}
	Header header;
	ByteReader reader(bytes.substr(magic.size()));
	reader.values(header.version);
	if (reader.is_good() && header.version != state_version) {
		const bool is_newer = header.version > state_version;
		return refuse(diagnostics, file, std::string("it was saved by ") + (is_newer ? "a newer" : "an older") + " version (format " +
						std::to_string(header.version) + ", this one reads format " + std::to_string(state_version) + ")",
				is_newer ? "use the version that saved it, or a later one" : "use the version that saved it");
	}
	reader.values(header.people_size, header.simulation_size, header.checksum);
	const uint64_t rest = bytes.size() < header_size ? 0 : bytes.size() - header_size;
	StateFile result;
	const bool has_sizes = reader.is_good() && header.people_size <= rest && header.simulation_size == rest - header.people_size;
	if (has_sizes) {
		const std::string_view people = bytes.substr(header_size, header.people_size);
		result.simulation = bytes.substr(header_size + header.people_size);
		if (checksum_of(people, result.simulation) == header.checksum &&
				people_from_bytes(people, result.people)) {
			return result;
		}
	}
	return refuse(diagnostics, file, "the saved simulation is damaged", "load another one");
}

bool save_state(const std::string &path, const Simulation &simulation, Diagnostics &diagnostics) {
	return write_file(path, state_file_bytes(simulation), diagnostics);
}

std::optional<StateFile> load_state(const std::string &path, Diagnostics &diagnostics) {
	const Result<std::string> bytes = read_file(path);
	if (!bytes) {
		diagnostics.add(bytes.diagnostic());
		return std::nullopt;
	}
	return read_state_file(*bytes, path, diagnostics);
}

} // namespace pcg
