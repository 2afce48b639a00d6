#include "core/population/population_generator.h"

#include <algorithm>

#include "core/population/alias_table.h"
#include "core/population/home_finder.h"
#include "core/population/household_draw.h"
#include "core/population/names.h"
#include "core/population/walking_speed.h"

namespace pcg {

namespace {

// The last household is drawn again so often, so that the number of persons asked for is met.
constexpr uint64_t max_redraws = 64;
constexpr uint64_t households_between_reports = 4096;

struct Draw {
	uint16_t pattern = 0;
	std::vector<DrawnMember> members;
};

class Generator {
public:
	Generator(const HouseholdTable &table, const CityModel &city, const PopulationOptions &options) :
			_table(table), _options(options), _homes(city, options.home_type, options.default_capacity), _patterns(weights_of(table)) {}

	Population run(Diagnostics &diagnostics) {
		_population.home_type = _options.home_type;
		if (_patterns.is_empty()) {
			diagnostics.error("no-households", "the household table has no household that occurs", "check the counts of the table");
			return {};
		}
		if (_homes.is_empty()) {
			count_unhoused(0, 0);
			report_no_homes(diagnostics);
			return {};
		}
		uint64_t persons = 0;
		for (uint64_t number = 0; !is_done(number, persons); ++number) {
			if (number % households_between_reports == 0 && !report_progress(number, persons)) {
				diagnostics.warning("cancelled", "the drawing of households was cancelled; nobody lives in the city");
				return {};
			}
			const Draw draw = draw_household(number, persons);
			persons += draw.members.size();
			if (!house(draw, number)) {
				_homeless += draw.members.size();
				if (_homes.most_free() < _smallest) {
					count_unhoused(number + 1, persons);
					break;
				}
			}
		}
		report(diagnostics);
		return std::move(_population);
	}

	std::vector<uint32_t> count_by_row() {
		std::vector<uint32_t> counts(_table.patterns.size());
		uint64_t persons = 0;
		for (uint64_t number = 0; !_patterns.is_empty() && !is_done(number, persons); ++number) {
			const Draw draw = draw_household(number, persons);
			persons += draw.members.size();
			++counts[draw.pattern];
		}
		return counts;
	}

private:
	// False: cancelled.
	bool report_progress(uint64_t households, uint64_t persons) const {
		const WorkOptions &work = _options.work;
		if (work.progress) {
			_options.households > 0 ? work.progress(households, _options.households) : work.progress(persons, _options.persons);
		}
		return work.cancel == nullptr || !work.cancel->load(std::memory_order_relaxed);
	}

	void report(Diagnostics &diagnostics) const {
		if (_too_large > 0) {
			diagnostics.warning("homes-too-small",
					std::to_string(_too_large) + (_too_large == 1 ? " household was" : " households were") + " larger than the largest home, which takes " +
							std::to_string(_homes.largest()) + (_homes.largest() == 1 ? " person" : " persons") + ", and drawn again",
					"give some entrances of type '" + _options.home_type + "' a larger capacity");
		}
		if (_homeless > 0) {
			diagnostics.warning("too-few-homes", homeless_text(), "ask for fewer persons, or give the city more homes or larger capacities");
		}
	}

	// Both figures; places may be left although persons are.
	std::string homeless_text() const {
		const uint64_t persons = _population.persons.size() + _homeless;
		const std::string left_out = std::to_string(_homeless) + (_homeless == 1 ? " was" : " were") + " left out";
		const std::string free = std::to_string(_homes.free()) + (_homes.free() == 1 ? " place stays" : " places stay") +
				" free, but no home has enough of them for a whole household";
		if (persons <= _homes.total()) {
			return std::to_string(persons) + " persons, of whom " + left_out + ": " + free;
		}
		return std::to_string(persons) + " persons, but the homes of the city take " + std::to_string(_homes.total()) + ": " + left_out +
				(_homes.free() > 0 ? "; " + free : "");
	}

	void report_no_homes(Diagnostics &diagnostics) const {
		if (_homeless > 0) {
			diagnostics.warning("no-homes",
					std::to_string(_homeless) + " persons, but the homes of the city take 0, for no building has an entrance of type '" +
							_options.home_type + "': all " + std::to_string(_homeless) + " were left out",
					"give houses an entrance(\"" + _options.home_type + "\")");
		}
	}

	static std::vector<double> weights_of(const HouseholdTable &table) {
		std::vector<double> weights;
		for (const HouseholdPattern &pattern : table.patterns) {
			weights.push_back(pattern.weight);
		}
		return weights;
	}

	bool is_done(uint64_t households, uint64_t persons) const {
		return _options.households > 0 ? households >= _options.households : persons >= _options.persons;
	}

	Draw draw_household(uint64_t number, uint64_t persons) {
		Draw draw;
		bool was_too_large = false;
		for (uint64_t attempt = 0; attempt < max_redraws; ++attempt) {
			Random random(derive_seed(_options.seed, hash_text("household") + attempt), number);
			draw.pattern = uint16_t(_patterns.draw(random));
			draw.members = draw_members(_table.patterns[draw.pattern], random);
			const bool is_too_large = !_homes.is_empty() && draw.members.size() > _homes.largest();
			was_too_large = was_too_large || is_too_large;
			if (!is_too_large && (_options.households > 0 || persons + draw.members.size() <= _options.persons)) {
				break;
			}
		}
		_too_large += was_too_large;
		return draw;
	}

	bool house(const Draw &draw, uint64_t number) {
		Random random(derive_seed(_options.seed, hash_text("home")), number);
		const BuildingId home = _homes.take(random, uint32_t(draw.members.size()));
		if (!is_valid(home)) {
			return false;
		}
		Household household;
		household.home = home;
		household.first_member = PersonId(uint32_t(_population.persons.size()));
		household.member_count = uint16_t(draw.members.size());
		household.pattern = draw.pattern;
		household.family_name = uint32_t(random.index(family_names().size()));
		household.hair_color = draw_hair_color(random);
		for (const DrawnMember &member : draw.members) {
			Person person;
			person.household = HouseholdId(uint32_t(_population.households.size()));
			person.gender = member.gender;
			person.age = float(member.age);
			person.name = uint32_t(random.index(first_names(member.gender).size()));
			person.walking_speed = draw_walking_speed(random, member.gender, person.age);
			person.clothes_color = uint8_t(random.index(clothes_colors().size()));
			_population.persons.push_back(person);
		}
		_population.households.push_back(household);
		return true;
	}

	// Members of the smallest household that occurs.
	static uint32_t smallest_of(const HouseholdTable &table) {
		uint32_t smallest = max_members;
		for (const HouseholdPattern &pattern : table.patterns) {
			uint32_t members = 0;
			for (const MemberGroup &group : pattern.groups) {
				members += group.count;
			}
			smallest = pattern.weight > 0.0 ? std::min(smallest, members) : smallest;
		}
		return smallest;
	}

	// No home has room for any household: what else was asked for has no place either.
	void count_unhoused(uint64_t households, uint64_t persons) {
		if (_options.households == 0) {
			_homeless += _options.persons > persons ? _options.persons - persons : 0;
			return;
		}
		for (; households < _options.households; ++households) {
			_homeless += draw_household(households, 0).members.size();
		}
	}

	const HouseholdTable &_table;
	const PopulationOptions &_options;
	HomeFinder _homes;
	AliasTable _patterns;
	Population _population;
	uint32_t _smallest = smallest_of(_table);
	uint64_t _homeless = 0; // persons
	uint64_t _too_large = 0; // households
};

} // namespace

Population generate_population(const HouseholdTable &table, const CityModel &city, const PopulationOptions &options, Diagnostics &diagnostics) {
	return Generator(table, city, options).run(diagnostics);
}

std::vector<uint32_t> preview_households(const HouseholdTable &table, const PopulationOptions &options) {
	return Generator(table, CityModel(), options).count_by_row();
}

} // namespace pcg
