#include "cli/file_names.h"

#include <filesystem>
#include <vector>

namespace pcg::cli {

namespace {

bool is_file(const NamedFile &file) { return !file.path.empty() && file.path != "-"; }

// By name, and through links where the files exist.
bool is_same_file(const std::string &a, const std::string &b) {
	namespace fs = std::filesystem;
	std::error_code error;
	if (fs::equivalent(a, b, error) && !error) {
		return !fs::is_character_file(a, error); // /dev/null takes everything
	}
	const fs::path left = fs::weakly_canonical(fs::absolute(a, error), error), right = fs::weakly_canonical(fs::absolute(b, error), error);
	return !error && left == right;
}

} // namespace

void check_outputs(Args &args, std::span<const NamedFile> inputs, std::span<const NamedFile> outputs) {
	std::vector<NamedFile> taken(inputs.begin(), inputs.end());
	for (const NamedFile &output : outputs) {
		for (const NamedFile &other : taken) {
			if (is_file(output) && is_file(other) && is_same_file(output.path, other.path)) {
				args.problem(std::string(output.option) + " would overwrite " + std::string(other.option) + " \"" + other.path + "\"; name another file");
				break;
			}
		}
		taken.push_back(output);
	}
}

} // namespace pcg::cli
