#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>

#include "cli/args.h"
#include "cli/people.h"
#include "cli/progress.h"
#include "core/agenda/agenda_generator.h"
#include "core/io/atomic_file.h"
#include "core/io/png.h"
#include "core/io/rule_loader.h"
#include "core/io/trace_csv.h"
#include "core/navigation/straight_line_paths.h"
#include "core/sim/day_story.h"
#include "core/sim/dialect.h"
#include "core/sim/heat_map.h"
#include "core/sim/heat_map_image.h"
#include "core/sim/invariants.h"
#include "core/sim/lived_log.h"
#include "core/sim/simulation.h"

namespace pcg::cli {

extern const Command simulate_command;

namespace {

using Clock = std::chrono::steady_clock;

// Looking at everybody costs time: more often than this a day, in persons looked at, would slow large cities down.
constexpr double looks_a_day = 2e7;
constexpr Duration shortest_check = Duration{ 10'000 };

struct Request : PeopleRequest {
	std::string rules, trace, json, lived, heat_map;
	int64_t days = 1;
	uint32_t threads = 0;
	std::optional<Duration> jump;
	bool wants_story = false;
};

// "7:30" or "07:30:15"; beyond 24:00 it is a later day.
std::optional<Duration> clock_time(const std::string &text) {
	int hours = 0, minutes = 0, seconds = 0, length = 0;
	const bool has_minutes = std::sscanf(text.c_str(), "%d:%d%n", &hours, &minutes, &length) == 2;
	if (has_minutes && size_t(length) < text.size()) {
		int more = 0;
		if (std::sscanf(text.c_str() + length, ":%d%n", &seconds, &more) == 1) {
			length += more;
		}
	}
	const bool is_whole = has_minutes && size_t(length) == text.size();
	if (!is_whole || hours < 0 || hours > 10'000 || minutes < 0 || minutes > 59 || seconds < 0 || seconds > 59) {
		return std::nullopt;
	}
	return Duration{ ((int64_t(hours) * 60 + minutes) * 60 + seconds) * 1000 };
}

Request read_request(Args &args) {
	args.require_positional(1, 1, "a rule file");
	Request request;
	static_cast<PeopleRequest &>(request) = read_people_request(args);
	request.rules = args.positional().empty() ? "" : args.positional()[0];
	request.days = args.whole("--days", 1, 1, 3650);
	request.threads = uint32_t(args.whole("--threads", 0, 0, 1024));
	request.trace = args.text("--trace");
	request.json = args.text("--json");
	request.lived = args.text("--lived");
	request.heat_map = args.text("--heat-map");
	request.wants_story = args.has("--story");
	const NamedFile outputs[] = { { "--trace", request.trace }, { "--json", request.json }, { "--lived", request.lived }, { "--heat-map", request.heat_map } };
	check_people_outputs(args, request, request.rules, outputs);
	if (args.has("--jump")) {
		request.jump = clock_time(args.text("--jump"));
		if (!request.jump || *request.jump >= Duration{ request.days * one_day.ms }) {
			args.problem("--jump takes a time of the simulated days, such as 7:30 or 31:00 (7:00 of the second day)");
		}
	}
	return request;
}

struct World {
	std::shared_ptr<const Program> program;
	std::optional<CityFile> city;
	PopulationFile people;
	std::unique_ptr<StraightLinePaths> paths;
	AgendaSet agendas;
};

bool load_world(const Request &request, World &world, Diagnostics &diagnostics) {
	world.program = load_program(request.rules, pcg_dialect(), diagnostics);
	world.city = load_city_json(request.city, diagnostics);
	if (!world.program || !world.city || diagnostics.has_errors() ||
			!make_people(request, *world.city, world.people, diagnostics)) {
		return false;
	}
	world.paths = std::make_unique<StraightLinePaths>(world.city->city);
	AgendaOptions options;
	options.seed = request.seed;
	options.overrides = attributes_of(*world.program, request.attributes);
	options.numbers = numbers_of(request, *world.city, world.people);
	options.work = long_work("agendas", request.threads);
	world.agendas = generate_agendas(
			*world.program, world.city->city, *world.paths, world.people.population, options, diagnostics);
	end_progress();
	return !was_cancelled() && (!world.agendas.tasks.empty() || !diagnostics.has_errors());
}

FileNumbers numbers_of(const Request &request, const World &world) { return numbers_of(request, *world.city, world.people); }

// Lives the days with everybody looked at now and then; gives the seconds that living took.
double live(const Request &request, Simulation &simulation, InvariantChecker &checker) {
	const SimTime end = SimTime::at(request.days, {});
	const int64_t between = int64_t(double(one_day.ms) * double(simulation.person_count()) / looks_a_day);
	const Duration step{ std::max(shortest_check.ms, between) };
	double seconds = 0.0;
	auto last_told = Clock::now();
	bool has_told = false;
	const auto timed = [&](auto &&work) {
		const Clock::time_point start = Clock::now();
		work();
		seconds += std::chrono::duration<double>(Clock::now() - start).count();
		checker.check();
	};
	timed([&] { simulation.start(SimTime{}); });
	if (request.jump) {
		timed([&] { simulation.jump_to(SimTime{ request.jump->ms }); });
	}
	while (simulation.now() < end && !was_cancelled()) {
		timed([&] { simulation.advance_to(std::min(simulation.now() + step, end)); });
		if (Clock::now() - last_told > std::chrono::seconds(2)) {
			last_told = Clock::now();
			has_told = true;
			std::fprintf(stderr, "\rsimulate: day %lld, %s", (long long)simulation.now().day(),
					clock_text(simulation.now().time_of_day()).c_str());
		}
	}
	if (has_told) {
		std::fputc('\n', stderr);
	}
	simulation.flush_lived();
	checker.finish();
	return seconds;
}

std::string summary_json(const Simulation &simulation, const InvariantChecker &checker, double seconds) {
	const SimulationStatistics &figures = simulation.statistics();
	const auto number = [](uint64_t value) { return std::to_string(value); };
	std::string text = "{\n \"persons\": " + number(simulation.person_count());
	text += ",\n \"trips\": " + number(figures.trips);
	text += ",\n \"peak_outside\": " + number(figures.peak_outside);
	text += ",\n \"peak_day\": " + std::to_string(figures.peak_time.day());
	text += ",\n \"peak_time\": \"" + clock_text(figures.peak_time.time_of_day(), true) + "\"";
	text += ",\n \"late_arrivals\": " + number(figures.late_arrivals);
	text += ",\n \"rules_failed\": " + number(figures.count(SimEventKind::RuleFailed));
	text += ",\n \"patience_ran_out\": " + number(figures.count(SimEventKind::PatienceRanOut));
	text += ",\n \"children_alone_after_waiting\": " + number(checker.children_alone_after_waiting());
	text += ",\n \"unreachable\": " + number(figures.count(SimEventKind::Unreachable));
	text += ",\n \"broken_promises\": {";
	for (size_t i = 0; i < promise_count; ++i) {
		text += std::string(i > 0 ? ", " : "") + "\"" + std::string(promise_name(Promise(i))) + "\": " + number(checker.broken(Promise(i)));
	}
	char took[64];
	std::snprintf(took, sizeof took, "%.3f", seconds);
	return text + "},\n \"seconds\": " + took + "\n}\n";
}

void tell_story(const World &world, const LivedLog &log, int64_t days) {
	const HouseholdId household = choose_household(world.people.population, log);
	const SimTime end = SimTime::at(std::min<int64_t>(days, 1), {});
	for (const std::string &line : tell_day(world.city->city, world.people.population, log, household, SimTime{}, end)) {
		std::printf("%s\n", line.c_str());
	}
}

int finish(const Diagnostics &diagnostics, bool is_done) {
	std::fputs(to_text(diagnostics).c_str(), stderr);
	return is_done ? 0 : 1;
}

// What observers of this run are attached, as the request wants.
struct Observers {
	std::unique_ptr<AtomicFile> trace_file;
	std::unique_ptr<TraceWriter> trace;
	LivedLog log;
	std::unique_ptr<HeatMap> heat;

	Observers(const Request &request, const World &world, Simulation &simulation) {
		if (!request.trace.empty()) {
			trace_file = std::make_unique<AtomicFile>(request.trace);
			trace = std::make_unique<TraceWriter>(*trace_file, simulation, SimTime{}, numbers_of(request, world));
			simulation.add_observer(*trace);
		}
		if (!request.lived.empty() || request.wants_story) {
			simulation.add_observer(log);
		}
		if (!request.heat_map.empty()) {
			heat = std::make_unique<HeatMap>(grid_over(world.city->city));
			simulation.add_observer(*heat);
		}
	}
};

bool write_results(const Request &request, const World &world, Observers &observers, const std::string &summary, Diagnostics &diagnostics) {
	bool is_done = !observers.trace_file || observers.trace_file->commit(diagnostics);
	if (!request.lived.empty()) {
		is_done &= write_lived_csv(request.lived, world.city->city, world.people.population, observers.log, numbers_of(request, world),
				diagnostics);
	}
	if (observers.heat) {
		is_done &= write_png(request.heat_map, draw_heat_map(*observers.heat, {}), diagnostics);
	}
	if (request.json.empty()) {
		std::fputs(summary.c_str(), stdout);
	} else {
		is_done &= write_file(request.json, summary, diagnostics);
	}
	return is_done;
}

int simulate(const Request &request) {
	Diagnostics diagnostics;
	World world;
	if (!load_world(request, world, diagnostics)) {
		return finish(diagnostics, false);
	}
	AgentHost host;
	SimulationSettings settings;
	settings.seed = request.seed;
	settings.overrides = attributes_of(*world.program, request.attributes);
	settings.numbers = numbers_of(request, world);
	settings.has_live_bodies = false;
	Simulation simulation(world.city->city, *world.paths, world.people.population, world.agendas, world.program, settings, host);
	Observers observers(request, world, simulation);
	InvariantChecker checker(simulation);
	const double seconds = live(request, simulation, checker);
	if (was_cancelled()) {
		return finish(diagnostics, false);
	}
	for (const std::string &example : checker.examples()) {
		std::fprintf(stderr, "broken promise: %s\n", example.c_str());
	}
	diagnostics.append(simulation.diagnostics());
	if (request.wants_story) {
		tell_story(world, observers.log, request.days);
	}
	const bool is_written = write_results(request, world, observers, summary_json(simulation, checker, seconds), diagnostics);
	return finish(diagnostics, is_written && !diagnostics.has_errors() && checker.broken_total() == 0);
}

int run(std::span<const std::string_view> raw) {
	Args args(raw,
			{ { "--city", "CITY.json" }, { "--households", "TABLE.csv" }, { "--persons", "N" }, { "--population", "PEOPLE.csv" },
					{ "--seed", "N" }, { "--attr", "NAME=VALUE" }, { "--days", "N" }, { "--jump", "H:M" }, { "--threads", "N" }, { "--trace", "FILE.csv" },
					{ "--json", "FILE.json" }, { "--lived", "FILE.csv" }, { "--heat-map", "FILE.png" }, { "--story", "" } });
	const Request request = read_request(args);
	if (!args.is_valid()) {
		return args.report(simulate_command);
	}
	return simulate(request);
}

} // namespace

const Command simulate_command = { "simulate",
	"pcg simulate RULES.pcg --city CITY.json (--households TABLE.csv --persons N | --population PEOPLE.csv)\n"
	"             [--seed N] [--attr NAME=VALUE].. [--days N] [--jump H:M] [--threads N] [--trace TRACE.csv]\n"
	"             [--json SUMMARY.json] [--lived PERSONS.csv] [--heat-map MAP.png] [--story]\n"
	"  Writes everybody's agenda and lives it from Monday 0h on, on straight lines; --jump starts with a time jump. The trace has a row\n"
	"  for every event, and at the start and after a jump one for everybody; --lived has one for every stretch of every life; --story\n"
	"  tells one household's first day. The summary goes to standard output unless --json names a file; late are those who went in more\n"
	"  than a second after a stayInside was to begin. Exit status 1 also if a promise of the simulation was broken.",
	"simulate days of a city's people", run };

} // namespace pcg::cli
