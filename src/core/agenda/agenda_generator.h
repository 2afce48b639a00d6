#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/agenda/agenda.h"
#include "core/base/diagnostic.h"
#include "core/base/file_ids.h"
#include "core/base/ids.h"
#include "core/base/parallel.h"
#include "core/lang/attribute_override.h"
#include "core/lang/program.h"
#include "core/lang/vm.h"
#include "core/population/population.h"
#include "core/ports/path_provider.h"
#include "core/semantics/city_model.h"

namespace pcg {

struct AgendaOptions {
	uint64_t seed = 1;
	std::string start_rule; // empty: the one marked @StartRule
	std::vector<AttributeOverride> overrides;
	// Only this household and those behind it get agendas, and the set counts persons from its first member on: for who comes later.
	HouseholdId first_household{ 0 };
	FileNumbers numbers; // of the user's files: rules and messages use them
	VmLimits limits{ .max_steps = 2'000'000 }; // per household
	WorkOptions work;
};

// Of the interpreter while it runs rules for a household, in both phases, so that attributes that draw keep their values.
uint64_t household_seed(uint64_t seed, HouseholdId id);

// Writes everybody's agenda: the start rule once for each household, nobody focused (paper, Algorithm 1). Households are independent and
// draw from streams of (seed, household), so the result does not depend on the number of threads. A household whose rules fail keeps
// what was written until then. Errors and warnings name the household; a warning is told once for each place in the rules.
// `paths` has to answer from several threads at once.
AgendaSet generate_agendas(const Program &program, const CityModel &city, const PathProvider &paths, const Population &population,
		const AgendaOptions &options, Diagnostics &diagnostics);

// The same, so many households at a time (1 or more): `take` gets the agendas of each part, which count persons from `first` on, and they need not
// all be in memory at once. False if the rules cannot start or the work was cancelled; what was taken by then is only a part.
bool generate_agendas_in_parts(const Program &program, const CityModel &city, const PathProvider &paths, const Population &population,
		const AgendaOptions &options, size_t households, const std::function<void(AgendaSet part, PersonId first)> &take, Diagnostics &diagnostics);

} // namespace pcg
