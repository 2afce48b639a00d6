#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/command.h"

// Command line options with types. Every problem is remembered and told at once:
//     Args args(raw, { { "--seed", "N" }, { "--json", "FILE" }, { "--quiet", "" } });
//     const uint64_t seed = args.whole("--seed", 1);
//     if (!args.is_valid()) { return args.report(derive_command); }
namespace pcg::cli {

struct OptionSpec {
	std::string_view name; // with its dashes
	std::string_view value; // what it takes, for messages ("N", "FILE"); empty: a flag
};

class Args {
public:
	// `--name value`, `--name=value` and positional arguments in any order; everything after `--` is positional.
	Args(std::span<const std::string_view> raw, std::initializer_list<OptionSpec> options);

	bool has(std::string_view name) const;
	// The last one given, or the fallback.
	std::string text(std::string_view name, std::string_view fallback = {}) const;
	// Every one given, in order.
	std::vector<std::string> all(std::string_view name) const;
	// A whole number in [low, high].
	int64_t whole(std::string_view name, int64_t fallback, int64_t low = 0, int64_t high = INT64_MAX);
	double number(std::string_view name, double fallback);
	// "20x30": two positive numbers.
	std::pair<double, double> size(std::string_view name, std::pair<double, double> fallback);
	const std::vector<std::string> &positional() const { return _positional; }
	// Notes a problem unless there are exactly / at least so many positional arguments.
	void require_positional(size_t at_least, size_t at_most, std::string_view what);

	void problem(std::string message) { _problems.push_back(std::move(message)); }
	bool is_valid() const { return _problems.empty(); }
	// Prints the problems and the command's usage on standard error; the exit status for a wrong command line.
	int report(const Command &command) const;

private:
	const OptionSpec *find(std::string_view name);

	std::vector<OptionSpec> _options;
	std::vector<std::pair<std::string_view, std::string>> _given;
	std::vector<std::string> _positional;
	std::vector<std::string> _problems;
};

} // namespace pcg::cli
