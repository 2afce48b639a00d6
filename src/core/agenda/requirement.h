#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/agenda/agenda.h"

// Entries that make sense only if another one is lived: nobody fetches a child who was never brought. Rules name entries, task("bring")
// { .. }, and others ask for them, requires("bring") { .. } or after("bring") { .. }. What newer entries took away can be required no more.
namespace pcg {

// The place of a value in a list whose first element means none; it is added if it is new. 0: the list has `most` elements already.
template <typename T> uint16_t number_in(std::vector<T> &list, const T &wanted, size_t most) {
	if (list.empty()) {
		list.emplace_back();
	}
	for (size_t i = 0; i < list.size(); ++i) {
		if (list[i] == wanted) {
			return uint16_t(i);
		}
	}
	if (list.size() >= most) {
		return 0;
	}
	list.push_back(wanted);
	return uint16_t(list.size() - 1);
}

// A named entry as it was written. It is lived on a day as long as it, or what is left of it, ends there when it was meant to.
struct NamedTask {
	PersonId person = PersonId::Invalid;
	Task task;
};

// Ids of the warnings that tell of them, each of which is told of every household.
constexpr std::string_view requirement_unmet_id = "requirement-unmet";
constexpr std::string_view deserted_id = "group-deserted";
constexpr std::string_view leaderless_id = "group-leaderless";
constexpr bool is_told_of_all(std::string_view id) { return id == requirement_unmet_id || id == deserted_id || id == leaderless_id; }

enum class Unmet : uint8_t {
	No,
	Missing, // nobody of the household had an entry of that name
	Lost, // newer entries took it away, or its end
	NotOver, // it is not over when the requiring entry begins
	Deserted, // a leader's walk together: another leader called everybody away who was to come along
	Leaderless, // a joiner's walk together, which is a walk of its own now: the leader has something else to do
};

// An entry that was taken out, or became another one, because what it needs is not there.
struct DroppedTask {
	PersonId person = PersonId::Invalid;
	Task task; // its days are those on which it was dropped
	Unmet reason = Unmet::No;
	uint16_t name = 0; // of the entry that it required, in AgendaSet::names; 0: Deserted, Leaderless
	std::optional<int64_t> day; // the only one on which it was dropped, as SimTime counts; without: every week
};

// The agendas of one household, members one behind the other.
struct HouseholdAgendas {
	PersonId first_member = PersonId::Invalid;
	std::span<Agenda *const> members;
	std::span<const Group> groups; // Task::target of Accompany

	Agenda &of(PersonId person) const { return *members[index_of(person) - index_of(first_member)]; }
};

// Takes out, day by day, the walks of leaders from whom others called everybody away, and what requires an entry that is not lived, and then what
// required that. The required entry is one written for the same day (an entry at 30 h belongs to the day before the morning it begins on); of `after`
// it is over when the requiring one begins. Whoever has entries of the name needs one of its own, everybody else anybody's in the household. A walk
// together is lived while the leader and one joiner are left; where a leader's walk falls out the joiners' walks do too, and the leader's with the
// last joiner's. Joiners whose leader was taken away by newer entries go by themselves: their walks become goToBuilding to the same goal in the same
// time.
// `named`: entries in order of writing; `requirements` as in AgendaSet.
std::vector<DroppedTask> drop_unmet(const HouseholdAgendas &household, std::span<const NamedTask> named, std::span<const Requirement> requirements);

} // namespace pcg
