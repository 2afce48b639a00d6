#pragma once

#include <span>
#include <string>
#include <string_view>

// One subcommand of `pcg`. Exit status: 0 done, 1 the input is wrong (told on standard error), 2 the command line is wrong.
namespace pcg::cli {

struct Command {
	std::string_view name;
	std::string_view usage; // "pcg derive RULE.cga [--seed N] ..": several lines
	std::string_view summary; // one line for the list of commands
	int (*run)(std::span<const std::string_view> args);
};

} // namespace pcg::cli
