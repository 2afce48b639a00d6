#include "core/agenda/agenda_generator.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "core/agenda/agenda_edit.h"
#include "core/agenda/generation_context.h"

namespace pcg {

namespace {

// Enough to keep threads busy, few enough to fit the cache; the same for any number of threads, or results would depend on it.
constexpr size_t households_per_batch = 256;

constexpr uint64_t agenda_stream = hash_text("agenda"); // keeps the rules' draws apart from those of the population

// What one piece of work wrote; group numbers count from 0 in each batch.
struct Batch {
	std::vector<Task> tasks;
	std::vector<uint32_t> task_counts; // by person
	std::vector<FloatingTask> floating_tasks;
	std::vector<uint32_t> floating_counts;
	std::vector<Group> groups;
	std::vector<std::string> names;
	std::vector<Requirement> requirements;
	std::vector<Diagnostic> diagnostics;
};

class Generation {
public:
	Generation(const Program &program, const agenda::World &world, const Population &population, const AgendaOptions &options, RuleId start) :
			_program(program), _world(world), _population(population), _options(options), _start(start) {
		_batches.resize((population.households.size() + households_per_batch - 1) / households_per_batch);
	}

	bool run() {
		return parallel_for(_batches.size(), _options.work, [this](size_t i) { fill(i); });
	}

	AgendaSet collect(Diagnostics &diagnostics) {
		AgendaSet set;
		set.first_task.reserve(_population.persons.size() + 1);
		set.first_floating_task.reserve(_population.persons.size() + 1);
		set.first_task.push_back(0);
		set.first_floating_task.push_back(0);
		size_t task_count = 0;
		for (const Batch &batch : _batches) {
			task_count += batch.tasks.size();
		}
		set.tasks.reserve(task_count);
		std::vector<Told> told;
		for (Batch &batch : _batches) {
			number_names(set, batch);
			append(set, batch);
			add_diagnostics(batch, told);
			batch = {};
		}
		tell(told, diagnostics);
		// A cancelled generation leaves the rest without entries.
		set.first_task.resize(_population.persons.size() + 1, uint32_t(set.tasks.size()));
		set.first_floating_task.resize(_population.persons.size() + 1, uint32_t(set.floating_tasks.size()));
		number_origins(set);
		return set;
	}

private:
	// A message, and how often it came again from the same place in the rules.
	struct Told {
		Diagnostic first;
		uint64_t repeats = 0;
	};

	void fill(size_t index) {
		Batch &batch = _batches[index];
		agenda::GenerationContext context(_world);
		Vm vm(_program, context, _options.limits);
		for (const AttributeOverride &override_value : _options.overrides) {
			vm.override_attribute(override_value.name, override_value.value);
		}
		const size_t first = index * households_per_batch;
		const size_t end = std::min(first + households_per_batch, _population.households.size());
		for (size_t i = first; i < end; ++i) {
			run_household(vm, context, HouseholdId(uint32_t(i)));
			context.drop_unmet_tasks();
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

	static void keep(Batch &batch, agenda::GenerationContext &context) {
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

	// Batches count names and requirements by themselves.
	static void number_names(AgendaSet &set, Batch &batch) {
		if (batch.names.size() == 1 && batch.requirements.size() == 1) {
			return;
		}
		std::vector<uint16_t> name_of;
		std::vector<uint8_t> requirement_of;
		for (const std::string &name : batch.names) {
			name_of.push_back(task_name(set, name));
		}
		for (Requirement requirement : batch.requirements) {
			requirement.name = name_of[requirement.name];
			requirement.outer = requirement.outer != 0 ? requirement_of[requirement.outer] : uint8_t(0);
			requirement_of.push_back(task_requirement(set, requirement));
		}
		for (Task &task : batch.tasks) {
			task.name = name_of[task.name];
			task.requirement = requirement_of[task.requirement];
		}
	}

	static void append(AgendaSet &set, Batch &batch) {
		add_tasks(set.tasks, batch.tasks, uint32_t(set.groups.size()));
		set.floating_tasks.insert(set.floating_tasks.end(), batch.floating_tasks.begin(), batch.floating_tasks.end());
		for (size_t i = 0; i < batch.task_counts.size(); ++i) {
			set.first_task.push_back(set.first_task.back() + batch.task_counts[i]);
			set.first_floating_task.push_back(set.first_floating_task.back() + batch.floating_counts[i]);
		}
		std::move(batch.groups.begin(), batch.groups.end(), std::back_inserter(set.groups));
	}

	// Batches come in order, so what is kept is what the first household said.
	static void add_diagnostics(Batch &batch, std::vector<Told> &told) {
		for (Diagnostic &diagnostic : batch.diagnostics) {
			const auto found =
					std::find_if(told.begin(), told.end(), [&](const Told &other) { return agenda::is_repeat(other.first, diagnostic); });
			if (found != told.end()) {
				++found->repeats;
			} else {
				told.push_back({ std::move(diagnostic), 0 });
			}
		}
	}

	static void tell(std::vector<Told> &told, Diagnostics &diagnostics) {
		for (Told &one : told) {
			// Of a warning an interpreter tells only the first; these two are all told.
			const bool is_counted = one.first.severity == Severity::Error || one.first.id == "requirement-unmet";
			if (one.repeats > 0 && is_counted) {
				one.first.message += ", and the same " + std::to_string(one.repeats) + (one.repeats == 1 ? " time more" : " times more");
			}
			diagnostics.add(std::move(one.first));
		}
	}

	// Addresses in the program become dense numbers in the order of the program.
	void number_origins(AgendaSet &set) const {
		std::vector<uint32_t> number_of(_program.code.size() + 1, 0);
		for (const Task &task : set.tasks) {
			number_of[task.origin] = 1;
		}
		for (uint32_t address = 0; address < number_of.size(); ++address) {
			if (number_of[address] != 0) {
				number_of[address] = uint32_t(set.origins.size());
				set.origins.push_back(origin_at(address));
			}
		}
		for (Task &task : set.tasks) {
			task.origin = number_of[task.origin];
		}
	}

	// The rule around a call is the last one that begins before it in the same file.
	TaskOrigin origin_at(uint32_t address) const {
		const SourcePlace place = _program.places[address > 0 ? address - 1 : 0];
		const auto position = [](const SourcePlace &at) { return std::tie(at.line, at.column); };
		const RuleInfo *rule = nullptr;
		for (const RuleInfo &candidate : _program.rules) {
			if (candidate.place.file == place.file && !(position(place) < position(candidate.place)) &&
					(rule == nullptr || position(rule->place) < position(candidate.place))) {
				rule = &candidate;
			}
		}
		return { rule != nullptr ? rule->name : std::string(), place.file < _program.files.size() ? _program.files[place.file] : std::string(),
			place.line };
	}

	const Program &_program;
	const agenda::World &_world;
	const Population &_population;
	const AgendaOptions &_options;
	RuleId _start;
	std::vector<Batch> _batches;
};

AgendaSet empty_agendas(const Population &population) {
	AgendaSet set;
	set.first_task.assign(population.persons.size() + 1, 0);
	set.first_floating_task.assign(population.persons.size() + 1, 0);
	return set;
}

RuleId find_start(const Program &program, const AgendaOptions &options, Diagnostics &diagnostics) {
	const RuleId start = options.start_rule.empty() ? program.start_rule : program.find_rule(options.start_rule);
	if (is_valid(start)) {
		return start;
	}
	Diagnostic missing;
	missing.id = "no-start-rule";
	missing.file = program.files.empty() ? std::string() : program.files[0];
	if (options.start_rule.empty()) {
		missing.message = "the rules mark no rule as the start";
		missing.hint = "write @StartRule before the rule that a household begins with";
	} else {
		std::vector<std::string_view> names;
		for (const RuleInfo &rule : program.rules) {
			if (rule.params.empty()) {
				names.push_back(rule.name);
			}
		}
		const std::string_view closest = closest_name(options.start_rule, names);
		missing.message = "the rules have no rule '" + options.start_rule + "' without parameters to start with";
		missing.hint = closest.empty() ? "name another start rule, or none for the one that is marked @StartRule" : "did you mean '" + std::string(closest) + "'?";
	}
	diagnostics.add(std::move(missing));
	return start;
}

// What a Vm would say of every household is said once.
bool check_overrides(const Program &program, const AgendaOptions &options, Diagnostics &diagnostics) {
	bool is_good = true;
	for (const AttributeOverride &override_value : options.overrides) {
		const int index = program.find_attribute(override_value.name);
		if (index < 0 || program.attributes[size_t(index)].kind == AttributeInfo::Kind::Constant) {
			std::vector<std::string_view> names;
			for (const AttributeInfo &attribute : program.attributes) {
				names.push_back(attribute.name);
			}
			const std::string_view closest = index < 0 ? closest_name(override_value.name, names) : std::string_view();
			diagnostics.error("unknown-attribute",
					"'" + override_value.name + (index < 0 ? "' is no attribute of the rules" : "' is const in the rules and cannot be set"),
					closest.empty() ? std::string() : "did you mean '" + std::string(closest) + "'?");
			is_good = false;
		}
	}
	return is_good;
}

} // namespace

uint64_t household_seed(uint64_t seed, HouseholdId id) { return derive_seed(seed ^ agenda_stream, index_of(id)); }

AgendaSet generate_agendas(const Program &program, const CityModel &city, const PathProvider &paths, const Population &population,
		const AgendaOptions &options, Diagnostics &diagnostics) {
	const RuleId start = find_start(program, options, diagnostics);
	if (!is_valid(start) || !check_overrides(program, options, diagnostics)) {
		return empty_agendas(population);
	}
	const agenda::World world = agenda::make_world(program, city, paths, population);
	Generation generation(program, world, population, options, start);
	if (!generation.run()) {
		diagnostics.warning("cancelled", "the generation of agendas was cancelled; some households have none");
		return empty_agendas(population);
	}
	return generation.collect(diagnostics);
}

} // namespace pcg
