#include <csignal>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.h"
#include "core/base/diagnostic.h"

// `pcg`: the pipeline without an engine, for batch work, tests and continuous integration. Each command is a file of its own.
namespace pcg::cli {

extern const Command agenda_command;
extern const Command check_command;
extern const Command derive_command;
extern const Command docs_command;
extern const Command simulate_command;

namespace {

const Command *const commands[] = {
	&agenda_command,
	&check_command,
	&derive_command,
	&docs_command,
	&simulate_command,
};

void print(std::FILE *stream, std::string_view text) { std::fwrite(text.data(), 1, text.size(), stream); }

void print_overview(std::FILE *stream) {
	print(stream, "usage: pcg COMMAND ..    (pcg COMMAND --help tells more)\n");
	for (const Command *command : commands) {
		std::string line = "  " + std::string(command->name);
		line.resize(14, ' ');
		print(stream, line + std::string(command->summary) + "\n");
	}
}

const Command *find_command(std::string_view name) {
	for (const Command *command : commands) {
		if (command->name == name) {
			return command;
		}
	}
	return nullptr;
}

int run_unknown(std::string_view name) {
	std::vector<std::string_view> names;
	for (const Command *command : commands) {
		names.push_back(command->name);
	}
	const std::string_view closest = closest_name(name, names);
	print(stderr, "pcg: unknown command " + std::string(name) + (closest.empty() ? "" : "; did you mean " + std::string(closest) + "?") + "\n");
	print_overview(stderr);
	return 2;
}

int run(std::span<const std::string_view> args) {
	if (args.empty() || args[0] == "--help" || args[0] == "-h" || args[0] == "help") {
		print_overview(args.empty() ? stderr : stdout);
		return args.empty() ? 2 : 0;
	}
	const Command *const command = find_command(args[0]);
	if (command == nullptr) {
		return run_unknown(args[0]);
	}
	for (std::string_view argument : args.subspan(1)) {
		if (argument == "--help" || argument == "-h") {
			print(stdout, "usage: " + std::string(command->usage) + "\n");
			return 0;
		}
	}
	return command->run(args.subspan(1));
}

} // namespace

} // namespace pcg::cli

int main(int argc, char **argv) {
#ifdef SIGXFSZ
	std::signal(SIGXFSZ, SIG_IGN); // a limit of file sizes is an error of writing, which removes what was begun
#endif
	const std::vector<std::string_view> args(argv + (argc > 0 ? 1 : 0), argv + argc);
	const int status = pcg::cli::run(args);
	if (std::fflush(stdout) != 0 || std::ferror(stdout)) {
		std::fputs("pcg: standard output could not be written to its end; is the disk full?\n", stderr);
		return 1;
	}
	return status;
}
