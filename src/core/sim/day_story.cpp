#include "core/sim/day_story.h"

#include <algorithm>
#include <cmath>

#include "core/population/age_group.h"
#include "core/population/building_use.h"
#include "core/population/names.h"

namespace pcg {

namespace {

constexpr Duration worth_waiting_for = Duration::minutes(1); // shorter waits are not told

// What one person did between two changes of state or place; spans that only the agenda separates are one.
struct Stretch {
	PersonId person = PersonId::Invalid;
	SimTime start, end;
	PersonState state = PersonState::Inside;
	Target place;
	Target from; // where it was before
	PersonId leader = PersonId::Invalid;
};

struct Line {
	SimTime time;
	int order = 0; // arrivals before departures at one moment
	std::vector<PersonId> who;
	std::string what;
};

class Storyteller {
public:
	Storyteller(const CityModel &city, const Population &population, HouseholdId household)
		: _city(city), _population(population), _first_member(population.household(household).first_member),
		  _home(population.household(household).home) {}

	std::vector<std::string> tell(const std::vector<LivedEntry> &entries, HouseholdId household, SimTime from, SimTime to);

private:
	std::vector<Stretch> stretches_of(const std::vector<LivedEntry> &entries, PersonId id) const;
	void add(const Stretch &stretch);
	void add_line(SimTime time, int order, PersonId who, std::string what);
	std::string place_name(Target place) const;
	std::string name(PersonId id);
	std::string names(const std::vector<PersonId> &who, size_t first);

	const CityModel &_city;
	const Population &_population;
	PersonId _first_member;
	BuildingId _home;
	std::vector<Line> _lines;
	std::vector<PersonId> _introduced;
};

std::string Storyteller::place_name(Target place) const {
	std::string_view word;
	if (place.kind == Target::Kind::Building) {
		if (place.building() == _home) {
			return "home";
		}
		word = building_use(_city, _population, _first_member, place.building());
	} else if (place.kind == Target::Kind::Zone) {
		word = _city.types.name(_city.zone(place.zone()).type);
	} else if (place.kind == Target::Kind::Object) {
		return "a " + std::string(_city.types.name(_city.object(place.object()).type));
	} else if (place.kind == Target::Kind::Person) {
		return std::string(first_name(_population, PersonId(place.index)));
	}
	if (word.empty()) {
		return place.kind == Target::Kind::Building ? "a building" : "the street";
	}
	return (word == _population.home_type ? "another " : "the ") + std::string(word);
}

// With the age at the first mention.
std::string Storyteller::name(PersonId id) {
	std::string result(first_name(_population, id));
	if (std::count(_introduced.begin(), _introduced.end(), id) == 0) {
		_introduced.push_back(id);
		result += " (" + std::to_string(int(_population.person(id).age)) + ")";
	}
	return result;
}

std::string Storyteller::names(const std::vector<PersonId> &who, size_t first) {
	std::string result;
	for (size_t i = first; i < who.size(); ++i) {
		result += i == first ? "" : (i + 1 == who.size() ? " and " : ", ");
		result += name(who[i]);
	}
	return result;
}

std::vector<Stretch> Storyteller::stretches_of(const std::vector<LivedEntry> &entries, PersonId id) const {
	std::vector<Stretch> result;
	for (const LivedEntry &entry : entries) {
		if (entry.person != id) {
			continue;
		}
		const bool goes_on = !result.empty() && result.back().state == entry.state && result.back().place == entry.place &&
				result.back().end == entry.start && result.back().leader == entry.leader;
		if (goes_on || (!result.empty() && entry.state == PersonState::Inside && result.back().state == entry.state &&
								 result.back().place == entry.place)) {
			result.back().end = entry.end;
			continue;
		}
		const bool was_walking = !result.empty() && result.back().state == PersonState::Walking;
		const bool turns_round = was_walking && entry.state == PersonState::Walking;
		const Target before = result.empty() || turns_round ? Target{} : (was_walking ? result.back().from : result.back().place);
		result.push_back({ id, entry.start, entry.end, entry.state, entry.place, before, entry.leader });
	}
	return result;
}

// One line for those to whom the same happens at the same moment.
void Storyteller::add_line(SimTime time, int order, PersonId who, std::string what) {
	for (Line &line : _lines) {
		if (line.time == time && line.what == what) {
			line.who.push_back(who);
			return;
		}
	}
	_lines.push_back({ time, order, { who }, std::move(what) });
}

void Storyteller::add(const Stretch &stretch) {
	const std::string place = place_name(stretch.place);
	switch (stretch.state) {
		case PersonState::Walking: {
			const std::string goal = place == "home" ? "home" : "to " + place;
			const bool leaves = is_valid(stretch.from.building());
			const std::string from = leaves ? "leaves " + place_name(stretch.from) + "@ for " + place : "walks@ " + goal;
			add_line(stretch.start, 1, stretch.person, from);
			break;
		}
		case PersonState::Inside:
			add_line(stretch.start, 0, stretch.person, "@is at " + place);
			break;
		case PersonState::AtPlace:
			add_line(stretch.start, 0, stretch.person,
					stretch.place.kind == Target::Kind::Object ? "@takes a place on " + place : "@is in " + place);
			break;
		case PersonState::Waiting:
			if (stretch.end - stretch.start > worth_waiting_for) {
				add_line(stretch.start, 0, stretch.person, "@waits outdoors");
			}
			break;
	}
}

std::vector<std::string> Storyteller::tell(
		const std::vector<LivedEntry> &entries, HouseholdId household, SimTime from, SimTime to) {
	const Household &family = _population.household(household);
	for (uint32_t i = 0; i < family.member_count; ++i) {
		std::vector<Stretch> stretches = stretches_of(entries, PersonId(index_of(family.first_member) + i));
		if (!stretches.empty()) {
			stretches.erase(stretches.begin()); // where the day began is no news
		}
		for (const Stretch &stretch : stretches) {
			if (stretch.start >= from && stretch.start < to) {
				add(stretch);
			}
		}
	}
	std::stable_sort(_lines.begin(), _lines.end(), [](const Line &a, const Line &b) {
		return a.time != b.time ? a.time < b.time : a.order < b.order;
	});
	std::vector<std::string> result;
	for (const Line &line : _lines) {
		const size_t mark = line.what.find('@');
		const bool is_together = line.order == 1 && line.who.size() > 1;
		std::string text = clock_text(line.time.time_of_day()) + " ";
		text += is_together ? name(line.who[0]) : names(line.who, 0);
		std::string what = line.what;
		if (line.order == 0 && line.who.size() > 1) { // several subjects
			const size_t verb = mark + 1;
			what = what.compare(verb, 2, "is") == 0 ? "are" + what.substr(verb + 2)
					: what.compare(verb, 5, "takes") == 0 ? "take" + what.substr(verb + 5)
														  : "wait" + what.substr(verb + 5);
		} else {
			what.replace(mark, 1, is_together ? " with " + names(line.who, 1) : "");
		}
		result.push_back(text + " " + what);
	}
	return result;
}

} // namespace

std::vector<std::string> tell_day(const CityModel &city, const Population &population, const LivedLog &log, HouseholdId household,
		SimTime from, SimTime to) {
	if (index_of(household) >= population.households.size()) {
		return {};
	}
	return Storyteller(city, population, household).tell(log.sorted(), household, from, to);
}

HouseholdId choose_household(const Population &population, const LivedLog &log) {
	struct Score {
		uint32_t shared_walks = 0; // of children with a leader
		uint32_t walks = 0;
		uint32_t places = 0;
		uint32_t value() const { return std::min(shared_walks, 4u) * 100 + std::min(places, 4u) * 20 + std::min(walks, 30u); }
	};
	std::vector<Score> scores(population.households.size());
	for (const LivedEntry &entry : log.entries()) {
		const Person &person = population.person(entry.person);
		Score &score = scores[index_of(person.household)];
		const bool walks = entry.state == PersonState::Walking;
		const bool is_led_child = walks && is_valid(entry.leader) && entry.leader != entry.person && person.age < adult_age;
		score.shared_walks += is_led_child;
		score.walks += walks;
		score.places += entry.state == PersonState::AtPlace;
	}
	HouseholdId best = HouseholdId::Invalid;
	for (uint32_t i = 0; i < scores.size(); ++i) {
		if (!is_valid(best) || scores[i].value() > scores[index_of(best)].value()) {
			best = HouseholdId(i);
		}
	}
	return log.entries().empty() ? HouseholdId::Invalid : best;
}

} // namespace pcg
