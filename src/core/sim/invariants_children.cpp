#include <algorithm>

#include <glm/geometric.hpp>

#include "core/population/age_group.h"
#include "core/sim/invariants.h"

// Accompanied children are never alone on the way.
namespace pcg {

// A walk that began before the person was called to its group is its own, and stays so when it is led elsewhere because its goal moved.
void InvariantChecker::note_walk_begin(const SimEvent &event) {
	Life &known = life(event.person);
	const bool goes_on_alone = known.walks_alone && known.goal_changed == event.time;
	known.set_out = event.time;
	known.walks_alone = goes_on_alone || !is_valid(_simulation.view(event.person).leader);
	_excused += known.walks_alone && event.place == known.missed_goal && is_child(event.person) ? 1 : 0;
	known.missed_goal = {};
}

void InvariantChecker::note_child(const LivedSpan &span) {
	check_child(span.person, span.leader, span.position, span.end);
	const std::vector<Group> &groups = _simulation.agendas().groups;
	Life &known = life(span.person);
	const bool has_group = span.entry.kind == TaskKind::Accompany && !span.entry.is_hole() && span.entry.target < groups.size();
	if (!has_group || !known.walks_alone || !is_child(span.person) || span.person == groups[span.entry.target].leader ||
			span.place != target_of(groups[span.entry.target].goal) || known.set_out < std::max(known.begin, span.entry.start)) {
		return;
	}
	if (known.gave_up_waiting < span.entry.start && known.without_way < span.entry.start) {
		complain(Promise::NoChildAlone, span.person, span.start, "walks to the group's goal alone and has not waited for the group");
	}
}

// Somebody on the way at this moment.
void InvariantChecker::check_child(PersonId id, PersonId leader, glm::vec3 position, SimTime time) {
	const bool is_led = is_valid(leader) && leader != id && is_child(id) && !life(id).walks_alone;
	if (is_led && double(glm::distance(_simulation.position(leader), position)) > tolerance) {
		complain(Promise::NoChildAlone, id, time, "walks in a group without its leader beside it");
	}
}

bool InvariantChecker::is_child(PersonId id) const { return _simulation.population().person(id).age < adult_age; }

} // namespace pcg
