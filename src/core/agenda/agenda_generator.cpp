#include "core/agenda/agenda_generator.h"

#include <algorithm>

#include "core/agenda/agenda_batches.h"
#include "core/agenda/generation_context.h"
#include "core/agenda/repeated_diagnostics.h"

namespace pcg {

namespace {

// Enough to keep threads busy, few enough to fit the cache; the same for any number of threads, or results would depend on it.
constexpr size_t households_per_batch = 256;

constexpr uint64_t agenda_stream = hash_text("agenda"); // keeps the rules' draws apart from those of the population

// Households that follow each other.
struct HouseholdRange {
	size_t first = 0;
	size_t end = 0;
};

HouseholdRange households_of(const Population &population, const AgendaOptions &options) {
	const size_t count = population.households.size();
	return { std::min<size_t>(index_of(options.first_household), count), count };
}

size_t first_person(const Population &population, size_t household) {
	return household < population.households.size() ? index_of(population.households[household].first_member) : population.persons.size();
}

size_t count_persons(const Population &population, HouseholdRange range) {
	return first_person(population, range.end) - first_person(population, range.first);
}

class Generation {
public:
	Generation(const Program &program, const agenda::World &world, const Population &population, const AgendaOptions &options, RuleId start,
			HouseholdRange range) :
			_program(program), _world(world), _population(population), _options(options), _start(start), _range(range) {
		_batches.resize((range.end - range.first + households_per_batch - 1) / households_per_batch);
	}

	bool run(const WorkOptions &work) {
		return parallel_for(_batches.size(), work, [this](size_t i) { fill(i); });
	}

	AgendaSet collect(RepeatedDiagnostics &messages) {
		AgendaSet set = join_batches(_batches, _program, count_persons(_population, _range), _options.work.threads);
		for (AgendaBatch &batch : _batches) { // in order, so what is kept is what the first household said
			for (Diagnostic &diagnostic : batch.diagnostics) {
				messages.add(std::move(diagnostic));
			}
		}
		return set;
	}

private:
	void fill(size_t index) {
		AgendaBatch &batch = _batches[index];
		agenda::GenerationContext context(_world);
		Vm vm(_program, context, _options.limits);
		for (const AttributeOverride &attribute : _options.overrides) {
			override_attribute(vm, attribute);
		}
		const size_t first = _range.first + index * households_per_batch;
		const size_t end = std::min(first + households_per_batch, _range.end);
		for (size_t i = first; i < end; ++i) {
			run_household(vm, context, HouseholdId(uint32_t(i)));
			context.finish_household();
			keep(batch, context);
		}
		batch.names = context.names();
		batch.requirements = context.requirements();
		batch.diagnostics = std::move(context.diagnostics());
	}

	void run_household(Vm &vm, agenda::GenerationContext &context, HouseholdId id) {
		const uint64_t seed = household_seed(_options.seed, id);
		context.begin_household(id);
		vm.begin(seed);
		vm.call(_start);
		if (!context.wants_single_days()) {
			return;
		}
		// The same stream each day: what the household has drawn (its workplaces, say) is the same on all of them.
		context.begin_household(id, DayMask(1));
		for (int day = 0; day < 7; ++day) {
			context.begin_days(DayMask(1u << day));
			vm.begin(seed);
			vm.call(_start);
		}
	}

	// Groups of what is added count on from those that are there.
	static void add_tasks(std::vector<Task> &all, const std::vector<Task> &tasks, uint32_t first_group) {
		const size_t first = all.size();
		all.insert(all.end(), tasks.begin(), tasks.end());
		for (size_t i = first; first_group != 0 && i < all.size(); ++i) {
			all[i].target += all[i].kind == TaskKind::Accompany ? first_group : 0;
		}
	}

	static void keep(AgendaBatch &batch, agenda::GenerationContext &context) {
		const uint32_t first_group = uint32_t(batch.groups.size());
		for (size_t i = 0; i < context.member_count(); ++i) {
			const PersonId member = context.member(i);
			add_tasks(batch.tasks, context.agenda_of(member).tasks(), first_group);
			const std::vector<FloatingTask> &floating = context.floating_tasks_of(member);
			batch.floating_tasks.insert(batch.floating_tasks.end(), floating.begin(), floating.end());
			batch.task_counts.push_back(uint32_t(context.agenda_of(member).tasks().size()));
			batch.floating_counts.push_back(uint32_t(floating.size()));
		}
		batch.groups.insert(batch.groups.end(), context.groups().begin(), context.groups().end());
	}

	const Program &_program;
	const agenda::World &_world;
	const Population &_population;
	const AgendaOptions &_options;
	RuleId _start;
	HouseholdRange _range;
	std::vector<AgendaBatch> _batches;
};

AgendaSet empty_agendas(size_t persons) {
	AgendaSet set;
	set.first_task.assign(persons + 1, 0);
	set.first_floating_task.assign(persons + 1, 0);
	return set;
}

RuleId find_start(const Program &program, const AgendaOptions &options, Diagnostics &diagnostics) {
	if (options.start_rule.empty()) {
		return require_start_rule(program, diagnostics);
	}
	const RuleId start = program.find_rule(options.start_rule);
	if (is_valid(start)) {
		return start;
	}
	std::vector<std::string_view> names;
	for (const RuleInfo &rule : program.rules) {
		if (rule.params.empty()) {
			names.push_back(rule.name);
		}
	}
	const std::string_view closest = closest_name(options.start_rule, names);
	Diagnostic missing;
	missing.id = "no-start-rule";
	missing.file = program.files.empty() ? std::string() : program.files[0];
	missing.message = "the rules have no rule '" + options.start_rule + "' without parameters to start with";
	missing.hint = closest.empty() ? "name another start rule, or none for the one that is marked @StartRule" : "did you mean '" + std::string(closest) + "'?";
	diagnostics.add(std::move(missing));
	return start;
}

// What a Vm would say of every household is said once.
bool check_overrides(const Program &program, const AgendaOptions &options, Diagnostics &diagnostics) {
	bool is_good = true;
	for (const AttributeOverride &attribute : options.overrides) {
		if (std::optional<Diagnostic> problem = attribute_problem(program, attribute)) {
			diagnostics.add(std::move(*problem));
			is_good = false;
		}
	}
	return is_good;
}

} // namespace

uint64_t household_seed(uint64_t seed, HouseholdId id) { return derive_seed(seed ^ agenda_stream, index_of(id)); }

AgendaSet generate_agendas(const Program &program, const CityModel &city, const PathProvider &paths, const Population &population,
		const AgendaOptions &options, Diagnostics &diagnostics) {
	const HouseholdRange all = households_of(population, options);
	AgendaSet result = empty_agendas(count_persons(population, all));
	generate_agendas_in_parts(program, city, paths, population, options, std::max<size_t>(1, all.end - all.first),
			[&result](AgendaSet part, PersonId) { result = std::move(part); }, diagnostics);
	return result;
}

bool generate_agendas_in_parts(const Program &program, const CityModel &city, const PathProvider &paths, const Population &population,
		const AgendaOptions &options, size_t households, const std::function<void(AgendaSet part, PersonId first)> &take, Diagnostics &diagnostics) {
	const RuleId start = find_start(program, options, diagnostics);
	if (!is_valid(start) || !check_overrides(program, options, diagnostics)) {
		return false;
	}
	const agenda::World world = agenda::make_world(program, city, paths, population, options.numbers);
	const HouseholdRange all = households_of(population, options);
	RepeatedDiagnostics messages;
	bool is_complete = true;
	HouseholdRange part{ all.first, all.first };
	do { // once at least: of nobody there is a part, too
		part = { part.end, std::min(part.end + households, all.end) };
		Generation generation(program, world, population, options, start, part);
		WorkOptions work = options.work;
		if (work.progress) {
			work.progress = [&, part](size_t done, size_t total) {
				options.work.progress(part.first - all.first + done * (part.end - part.first) / total, all.end - all.first);
			};
		}
		is_complete = generation.run(work);
		if (is_complete) {
			take(generation.collect(messages), PersonId(uint32_t(first_person(population, part.first))));
		}
	} while (is_complete && part.end < all.end);
	if (!is_complete) {
		diagnostics.warning("cancelled", "the generation of agendas was cancelled; some households have none");
		return false;
	}
	messages.tell(diagnostics);
	return true;
}

} // namespace pcg
