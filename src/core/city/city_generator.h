#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/city/city.h"
#include "core/city/free_ground.h"

// From a layout to a city: derives every lot with the rules of its type (paper, "City generation", second step).
namespace pcg {

// Which rules build a type of lot.
struct LotRules {
	std::shared_ptr<const Program> program;
	std::string start_rule; // empty: the rule set's own
	std::vector<AttributeOverride> attributes; // what the host sets
};

// By lot type. The entry under "" builds all types that have none of their own.
using RulesByType = std::map<std::string, LotRules>;

struct CityOptions {
	WorkOptions work;
	cga::DeriveOptions derive;
	FreeGroundOptions free_ground;
	// Of the public ground, whose pieces bring their own start rules: see StreetShapes. Without a program all of it is plain.
	LotRules streets;
};

// The same city for any number of threads. A type without rules is an error, and its lots stay empty. Messages of rules name the lot. What the
// rules of a lot give no entrance and no zone of the lot's own type: a warning, for nobody can go there. Cancelled: nothing, without a message.
std::optional<City> generate_city(Layout layout, const RulesByType &rules, const CityOptions &options, Diagnostics &diagnostics);

// Builds one lot anew and touches no other: its generated records in the model are replaced (what was added by hand stays), its building
// keeps its id. False, and the lot stays as it was, if its type has no rules.
bool regenerate_lot(City &city, LotId lot, const RulesByType &rules, const CityOptions &options, Diagnostics &diagnostics);

} // namespace pcg
