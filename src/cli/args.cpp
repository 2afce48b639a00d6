#include "cli/args.h"

#include <charconv>
#include <cstdio>

#include "core/base/diagnostic.h"

namespace pcg::cli {

namespace {

template <typename Number> bool parse_whole_text(std::string_view text, Number &value) {
	const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
	return !text.empty() && result.ec == std::errc() && result.ptr == text.data() + text.size();
}

} // namespace

Args::Args(std::span<const std::string_view> raw, std::initializer_list<OptionSpec> options) : _options(options) {
	for (size_t i = 0; i < raw.size(); ++i) {
		if (raw[i] == "--") {
			_positional.insert(_positional.end(), raw.begin() + std::ptrdiff_t(i) + 1, raw.end());
			return;
		}
		if (!raw[i].starts_with("--") || raw[i].size() < 3) {
			_positional.emplace_back(raw[i]);
			continue;
		}
		const size_t equals = raw[i].find('=');
		const OptionSpec *const option = find(raw[i].substr(0, equals));
		if (option == nullptr) {
			continue;
		}
		if (option->value.empty()) {
			if (equals != std::string_view::npos) {
				problem(std::string(option->name) + " takes no value");
			}
			_given.emplace_back(option->name, "");
		} else if (equals != std::string_view::npos) {
			_given.emplace_back(option->name, raw[i].substr(equals + 1));
		} else if (i + 1 < raw.size()) {
			_given.emplace_back(option->name, raw[++i]);
		} else {
			problem(std::string(option->name) + " needs a value: " + std::string(option->name) + " " + std::string(option->value));
			continue;
		}
		if (!option->value.empty() && _given.back().second.empty()) {
			problem(std::string(option->name) + " must not be empty: " + std::string(option->name) + " " + std::string(option->value));
		}
	}
}

const OptionSpec *Args::find(std::string_view name) {
	std::vector<std::string_view> names;
	for (const OptionSpec &option : _options) {
		if (option.name == name) {
			return &option;
		}
		names.push_back(option.name);
	}
	const std::string_view closest = closest_name(name, names);
	problem("unknown option " + std::string(name) + (closest.empty() ? "" : "; did you mean " + std::string(closest) + "?"));
	return nullptr;
}

bool Args::has(std::string_view name) const {
	for (const auto &[given, value] : _given) {
		if (given == name) {
			return true;
		}
	}
	return false;
}

std::string Args::text(std::string_view name, std::string_view fallback) const {
	std::string result(fallback);
	for (const auto &[given, value] : _given) {
		if (given == name) {
			result = value;
		}
	}
	return result;
}

std::vector<std::string> Args::all(std::string_view name) const {
	std::vector<std::string> values;
	for (const auto &[given, value] : _given) {
		if (given == name) {
			values.push_back(value);
		}
	}
	return values;
}

int64_t Args::whole(std::string_view name, int64_t fallback, int64_t low, int64_t high) {
	if (!has(name)) {
		return fallback;
	}
	int64_t value = 0;
	if (!parse_whole_text(text(name), value) || value < low || value > high) {
		const std::string range = "from " + std::to_string(low) + (high == INT64_MAX ? " on" : " to " + std::to_string(high));
		problem(std::string(name) + " takes a whole number " + range + ", not \"" + text(name) + "\"");
		return fallback;
	}
	return value;
}

double Args::number(std::string_view name, double fallback) {
	if (!has(name)) {
		return fallback;
	}
	double value = 0.0;
	if (!parse_whole_text(text(name), value)) {
		problem(std::string(name) + " takes a number, not \"" + text(name) + "\"");
		return fallback;
	}
	return value;
}

std::pair<double, double> Args::size(std::string_view name, std::pair<double, double> fallback) {
	if (!has(name)) {
		return fallback;
	}
	const std::string given = text(name);
	const size_t cross = given.find('x');
	std::pair<double, double> value;
	const bool is_good = cross != std::string::npos && parse_whole_text(given.substr(0, cross), value.first) &&
			parse_whole_text(given.substr(cross + 1), value.second) && value.first > 0.0 && value.second > 0.0 && value.first <= 1e6 && value.second <= 1e6;
	if (!is_good) {
		problem(std::string(name) + " takes two positive numbers such as 20x30, not \"" + given + "\"");
		return fallback;
	}
	return value;
}

void Args::require_positional(size_t at_least, size_t at_most, std::string_view what) {
	if (_positional.size() < at_least) {
		problem("missing: " + std::string(what));
	} else if (_positional.size() > at_most) {
		problem("unexpected argument \"" + _positional[at_most] + "\"");
	}
}

int Args::report(const Command &command) const {
	for (const std::string &text : _problems) {
		std::fprintf(stderr, "pcg %.*s: %s\n", int(command.name.size()), command.name.data(), text.c_str());
	}
	std::fprintf(stderr, "usage: %.*s\n", int(command.usage.size()), command.usage.data());
	return 2;
}

} // namespace pcg::cli
