#include "core/sim/inserted_entries.h"

#include <algorithm>

namespace pcg {

namespace {

bool comes_before(const InsertedEntry &a, const InsertedEntry &b) {
	return a.person != b.person ? index_of(a.person) < index_of(b.person) : a.start < b.start;
}

} // namespace

void InsertedEntries::insert(const InsertedEntry &entry) {
	std::vector<InsertedEntry> kept;
	for (const InsertedEntry &old : _entries) {
		if (old.person != entry.person || old.end <= entry.start || old.start >= entry.end) {
			kept.push_back(old);
			continue;
		}
		InsertedEntry before = old;
		before.end = entry.start;
		if (before.start < before.end) {
			kept.push_back(before);
		}
		InsertedEntry after = old;
		after.start = entry.end;
		after.is_start_cut = true;
		if (after.start < after.end) {
			kept.push_back(after);
		}
	}
	kept.insert(std::upper_bound(kept.begin(), kept.end(), entry, comes_before), entry);
	_entries = std::move(kept);
}

void InsertedEntries::drop_before(SimTime time) {
	std::erase_if(_entries, [time](const InsertedEntry &entry) { return entry.end <= time; });
}

void InsertedEntries::drop(PersonId person) {
	std::erase_if(_entries, [person](const InsertedEntry &entry) { return entry.person == person; });
}

std::span<const InsertedEntry> InsertedEntries::of(PersonId person) const {
	InsertedEntry any;
	any.person = person;
	const auto [first, last] = std::equal_range(_entries.begin(), _entries.end(), any,
			[](const InsertedEntry &a, const InsertedEntry &b) { return index_of(a.person) < index_of(b.person); });
	return { first, last };
}

const InsertedEntry *InsertedEntries::at(PersonId person, SimTime time) const {
	for (const InsertedEntry &entry : of(person)) {
		if (entry.start <= time && time < entry.end) {
			return &entry;
		}
	}
	return nullptr;
}

bool InsertedEntries::restore(std::vector<InsertedEntry> entries) {
	for (size_t i = 0; i < entries.size(); ++i) {
		const bool follows = i == 0 || index_of(entries[i - 1].person) < index_of(entries[i].person) ||
				(entries[i - 1].person == entries[i].person && entries[i - 1].end <= entries[i].start);
		if (!follows || entries[i].end <= entries[i].start) {
			return false;
		}
	}
	_entries = std::move(entries);
	return true;
}

} // namespace pcg
