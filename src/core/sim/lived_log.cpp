#include "core/sim/lived_log.h"

#include <algorithm>

namespace pcg {

void LivedLog::on_lived(const LivedSpan &span) {
	LivedEntry entry;
	entry.person = span.person;
	entry.start = span.start;
	entry.end = span.end;
	entry.position = span.position;
	entry.metres = float(span.last_metre - span.first_metre);
	entry.place = span.place;
	entry.leader = span.leader;
	entry.planned_start = span.entry.start;
	entry.planned_end = span.entry.end;
	entry.planned_task = span.entry.task;
	entry.planned_kind = span.entry.kind;
	entry.state = span.state;
	_entries.push_back(entry);
}

std::vector<LivedEntry> LivedLog::sorted() const {
	std::vector<LivedEntry> result = _entries;
	std::stable_sort(result.begin(), result.end(), [](const LivedEntry &a, const LivedEntry &b) {
		return a.person != b.person ? index_of(a.person) < index_of(b.person) : a.start < b.start;
	});
	return result;
}

std::vector<LivedEntry> LivedLog::of(PersonId id) const {
	std::vector<LivedEntry> result;
	std::copy_if(_entries.begin(), _entries.end(), std::back_inserter(result),
			[id](const LivedEntry &entry) { return entry.person == id; });
	return result;
}

std::string_view state_name(PersonState state) {
	switch (state) {
		case PersonState::Inside:
			return "inside";
		case PersonState::Walking:
			return "walking";
		case PersonState::AtPlace:
			return "at-place";
		case PersonState::Waiting:
			return "waiting";
	}
	return "";
}

} // namespace pcg
