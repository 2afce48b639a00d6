#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>

#include "cli/args.h"
#include "cli/people.h"
#include "cli/progress.h"
#include "core/agenda/agenda_generator.h"
#include "core/base/day_names.h"
#include "core/io/agenda_csv.h"
#include "core/io/atomic_file.h"
#include "core/io/city_json.h"
#include "core/io/population_csv.h"
#include "core/io/rule_loader.h"
#include "core/navigation/straight_line_paths.h"
#include "core/sim/dialect.h"

namespace pcg::cli {

extern const Command agenda_command;

namespace {

using Clock = std::chrono::steady_clock;

constexpr size_t households_at_a_time = 100'000; // some 40 MB of agendas

struct Request : PeopleRequest {
	std::string rules, people_out, out;
	uint32_t threads = 0;
	std::optional<int> weekday;
};

Request read_request(Args &args) {
	args.require_positional(1, 1, "a rule file");
	Request request;
	static_cast<PeopleRequest &>(request) = read_people_request(args);
	request.rules = args.positional().empty() ? "" : args.positional()[0];
	request.people_out = args.text("--save-population");
	request.out = args.text("--out");
	request.threads = uint32_t(args.whole("--threads", 0, 0, 1024));
	if (args.has("--day")) {
		request.weekday = weekday_named(args.text("--day"));
		if (!request.weekday) {
			args.problem("--day is one of mon tue wed thu fri sat sun");
		}
	}
	const NamedFile outputs[] = { { "--out", request.out }, { "--save-population", request.people_out } };
	check_people_outputs(args, request, request.rules, outputs);
	return request;
}

int finish(const Diagnostics &diagnostics) {
	std::fputs(to_text(diagnostics).c_str(), stderr);
	return diagnostics.has_errors() || was_cancelled() ? 1 : 0;
}

int write_people(const Request &request, const CityFile &city, const PopulationFile &people, Diagnostics &diagnostics) {
	if (!request.people_out.empty()) {
		write_file(request.people_out, population_to_csv(people.population, numbers_of(request, city, people)), diagnostics);
	}
	return finish(diagnostics);
}

// Part by part, so that memory holds everybody, but not everybody's agenda. False: nothing was written.
bool write_agendas(const Request &request, const Program &program, const CityFile &city, const PopulationFile &people, Diagnostics &diagnostics) {
	const StraightLinePaths paths(city.city);
	AgendaOptions options;
	options.seed = request.seed;
	options.overrides = attributes_of(program, request.attributes);
	options.work = long_work("agendas", request.threads);
	options.numbers = numbers_of(request, city, people);
	const std::unique_ptr<AtomicFile> file = request.out.empty() ? nullptr : std::make_unique<AtomicFile>(request.out);
	AgendaCsvWriter writer(people.population, program, options.numbers, request.weekday,
			[&file](std::string_view bytes) { file ? file->write(bytes) : void(std::fwrite(bytes.data(), 1, bytes.size(), stdout)); });
	size_t entries = 0;
	const auto take = [&](const AgendaSet &agendas, PersonId first) {
		entries += agendas.tasks.size();
		writer.write(agendas, first);
	};
	const Clock::time_point start = Clock::now();
	const bool is_complete = generate_agendas_in_parts(program, city.city, paths, people.population, options, households_at_a_time, take, diagnostics);
	const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
	end_progress();
	if (!is_complete || (entries == 0 && diagnostics.has_errors()) || (file && !file->commit(diagnostics))) {
		return false;
	}
	if (file) {
		std::fprintf(stderr, "%zu persons in %zu households, %zu entries in %.2f s: %s\n", people.population.persons.size(),
				people.population.households.size(), entries, seconds, request.out.c_str());
	}
	return true;
}

int generate(const Request &request) {
	Diagnostics diagnostics;
	const std::shared_ptr<const Program> program = load_program(request.rules, pcg_dialect(), diagnostics);
	const std::optional<CityFile> city = load_city_json(request.city, diagnostics);
	PopulationFile people;
	if (!program || !city || diagnostics.has_errors() || !make_people(request, *city, people, diagnostics)) {
		return finish(diagnostics);
	}
	if (!write_agendas(request, *program, *city, people, diagnostics)) {
		return finish(diagnostics);
	}
	return write_people(request, *city, people, diagnostics);
}

int run(std::span<const std::string_view> raw) {
	Args args(raw,
			{ { "--city", "CITY.json" }, { "--households", "TABLE.csv" }, { "--persons", "N" }, { "--population", "PEOPLE.csv" },
					{ "--save-population", "PEOPLE.csv" }, { "--seed", "N" }, { "--attr", "NAME=VALUE" }, { "--out", "AGENDAS.csv" }, { "--day", "DAY" }, { "--threads", "N" } });
	const Request request = read_request(args);
	if (!args.is_valid()) {
		return args.report(agenda_command);
	}
	return generate(request);
}

} // namespace

const Command agenda_command = { "agenda",
	"pcg agenda RULES.pcg --city CITY.json (--households TABLE.csv --persons N | --population PEOPLE.csv)\n"
	"           [--seed N] [--attr NAME=VALUE].. [--day mon|tue|wed|thu|fri|sat|sun] [--threads N]\n"
	"           [--save-population PEOPLE.csv] [--out AGENDAS.csv]\n"
	"  Writes everybody's agenda as a table, to standard output unless --out names a file. Distances are straight lines.\n"
	"  --attr sets an attribute of the rules, to a number, a time such as 8h30m, true, false or a text; it may be given several times.",
	"write everybody's agenda by rules", run };

} // namespace pcg::cli
