#include "core/agenda/agenda.h"

#include <algorithm>
#include <array>

namespace pcg {

namespace {

constexpr int32_t day_ms = int32_t(one_day.ms);

// A span of time relative to 0h of one day.
struct Span {
	int32_t start;
	int32_t end;
};

// What is left of an old entry on those of its days on which the same occurrences of the new one fall.
class Remains {
public:
	explicit Remains(Span whole) : _spans{ whole }, _count(1) {}

	// At most three cuts: the new entry's occurrence of the day before, of the same day and of the day after.
	void cut(Span hole) {
		std::array<Span, 4> kept{};
		size_t count = 0;
		for (size_t i = 0; i < _count; ++i) {
			const Span span = _spans[i];
			const Span before{ span.start, std::min(span.end, hole.start) };
			const Span after{ std::max(span.start, hole.end), span.end };
			if (before.end > before.start) {
				kept[count++] = before;
			}
			if (after.end > after.start) {
				kept[count++] = after;
			}
		}
		_spans = kept;
		_count = count;
	}
	const Span *begin() const { return _spans.data(); }
	const Span *end() const { return _spans.data() + _count; }

private:
	std::array<Span, 4> _spans;
	size_t _count;
};

bool comes_before(const Task &a, const Task &b) {
	return a.start_ms != b.start_ms ? a.start_ms < b.start_ms : a.days < b.days;
}

bool is_same_but_for_days(const Task &a, const Task &b) {
	return a.start_ms == b.start_ms && a.end_ms == b.end_ms && a.kind == b.kind && a.target == b.target &&
			a.origin == b.origin && a.is_start_cut == b.is_start_cut && a.name == b.name && a.requirement == b.requirement &&
			a.days_later == b.days_later;
}

// Pieces that differ by their days only become one entry again.
void add_piece(std::vector<Task> &tasks, const Task &piece) {
	const bool can_join = piece.days != all_days;
	for (size_t i = 0; can_join && i < tasks.size(); ++i) {
		Task &task = tasks[i];
		if (is_same_but_for_days(task, piece)) {
			task.days |= piece.days;
			task.generation = std::max(task.generation, piece.generation);
			return;
		}
	}
	tasks.push_back(piece);
}

// Where one occurrence of `task`, `shift` days away, lies relative to 0h of a day.
Span occurrence(const Task &task, int shift) {
	return { task.start_ms + shift * day_ms, task.end_ms + shift * day_ms };
}

bool overlaps(const Task &old, Span hole) { return hole.start < old.end_ms && old.start_ms < hole.end; }

// Adds what `newest` leaves of `old` to `kept`. An entry lasts at most 24 h, so only the days next to a day matter.
void keep_remains(std::vector<Task> &kept, const Task &old, const Task &newest) {
	std::array<DayMask, 3> hit{}; // days of `old` on which the occurrence -1, 0, +1 days away cuts it
	unsigned cutting = 0; // which of the three do so on any day
	for (int shift = -1; shift <= 1; ++shift) {
		if (overlaps(old, occurrence(newest, shift))) {
			hit[size_t(shift + 1)] = old.days & rotate_days(newest.days, -shift);
			cutting |= hit[size_t(shift + 1)] != 0 ? 1u << (shift + 1) : 0u;
		}
	}
	if (cutting == 0) {
		add_piece(kept, old);
		return;
	}
	for (unsigned cuts = 0; cuts < 8; ++cuts) {
		if ((cuts & ~cutting) != 0) {
			continue; // on no day
		}
		DayMask days = old.days;
		Remains remains({ old.start_ms, old.end_ms });
		for (int i = 0; i < 3; ++i) {
			const bool is_cut = (cuts >> i) & 1u;
			days &= is_cut ? hit[size_t(i)] : DayMask(~hit[size_t(i)]);
			if (is_cut && days != 0) {
				remains.cut(occurrence(newest, i - 1));
			}
		}
		if (days == 0) {
			continue;
		}
		for (const Span &span : remains) {
			Task piece = old;
			piece.start_ms = span.start;
			piece.end_ms = span.end;
			piece.days = days;
			piece.is_start_cut = old.is_start_cut || span.start != old.start_ms;
			add_piece(kept, normalized(piece));
		}
	}
}

bool is_plain(const Task &task) { return task.days == all_days && task.end_ms <= day_ms; }

} // namespace

Agenda::Agenda(std::span<const Task> tasks) : _tasks(tasks.begin(), tasks.end()) {
	for (const Task &task : tasks) {
		_generation = std::max(_generation, task.generation);
		_is_same_every_day = _is_same_every_day && is_plain(task);
	}
}

bool Agenda::insert(const Task &task) {
	const int64_t length = int64_t(task.end_ms) - task.start_ms;
	if ((task.days & all_days) == 0 || length <= 0 || length > one_day.ms) {
		return false;
	}
	if (_generation < UINT16_MAX) {
		++_generation;
	}
	if (_is_same_every_day && task.start_ms >= 0 && is_plain(task)) {
		insert_same_every_day(task);
		return true;
	}
	_is_same_every_day = false;
	Task newest = task;
	newest.days &= all_days;
	newest.generation = _generation;
	insert_day_by_day(normalized(newest));
	return true;
}

// The usual case: entries are spans of one day, so those that overlap the new one lie side by side.
void Agenda::insert_same_every_day(const Task &task) {
	size_t first = 0;
	while (first < _tasks.size() && _tasks[first].end_ms <= task.start_ms) {
		++first;
	}
	size_t last = first;
	while (last < _tasks.size() && _tasks[last].start_ms < task.end_ms) {
		++last;
	}
	const bool has_left = first < last && _tasks[first].start_ms < task.start_ms;
	const bool has_right = first < last && _tasks[last - 1].end_ms > task.end_ms;
	const Task right = has_right ? _tasks[last - 1] : task;
	replace(first + has_left, last, 1 + has_right, task);
	if (has_left) {
		_tasks[first].end_ms = task.start_ms;
	}
	Task *place = _tasks.data() + first + has_left;
	*place = task;
	place->generation = _generation;
	if (has_right) {
		*++place = right;
		place->start_ms = task.end_ms;
		place->is_start_cut = true;
	}
}

// Makes room for `count` entries in place of those from `first` to `last`, which may be none; what stands there then is not said. `filler` is any
// entry.
void Agenda::replace(size_t first, size_t last, size_t count, const Task &filler) {
	const size_t size = _tasks.size();
	const size_t behind = first + count;
	if (behind < last) {
		_tasks.erase(_tasks.begin() + ptrdiff_t(behind), _tasks.begin() + ptrdiff_t(last));
		return;
	}
	for (size_t i = last; i < behind; ++i) {
		_tasks.push_back(filler);
	}
	std::move_backward(_tasks.begin() + ptrdiff_t(last), _tasks.begin() + ptrdiff_t(size), _tasks.end());
}

void Agenda::insert_day_by_day(const Task &task) {
	_scratch.clear();
	for (const Task &old : _tasks) {
		keep_remains(_scratch, old, task);
	}
	add_piece(_scratch, task);
	_tasks.swap(_scratch);
	std::sort(_tasks.begin(), _tasks.end(), comes_before);
}

void Agenda::remove(size_t index, DayMask days) {
	_is_same_every_day = false;
	_tasks[index].days &= DayMask(~days);
	if (_tasks[index].days == 0) {
		_tasks.erase(_tasks.begin() + ptrdiff_t(index));
	} else {
		std::sort(_tasks.begin(), _tasks.end(), comes_before);
	}
}

void Agenda::clear() {
	_tasks.clear();
	_generation = 0;
	_is_same_every_day = true;
}

const Task *Agenda::at(int weekday, Duration time_of_day) const {
	const DayMask today = DayMask(1u << weekday);
	const DayMask yesterday = rotate_days(today, -1);
	const int64_t now = time_of_day.ms;
	for (const Task &task : _tasks) {
		const bool holds_today = (task.days & today) && task.start_ms <= now && now < task.end_ms;
		const bool holds_since_yesterday = (task.days & yesterday) && now + day_ms < task.end_ms;
		if (holds_today || holds_since_yesterday) {
			return &task;
		}
	}
	return nullptr;
}

std::span<const Task> AgendaView::changed_on(int64_t day) const {
	const auto found = std::lower_bound(single_days.begin(), single_days.end(), day, [](const SingleDay &a, int64_t b) { return a.day < b; });
	return found != single_days.end() && found->day == day ? std::span<const Task>(found->tasks) : week;
}

std::vector<PersonId> joiners_on(const AgendaSet &agendas, uint32_t group, DayMask days, PersonId first) {
	const Group &plan = agendas.groups[group];
	std::vector<PersonId> result;
	for (PersonId joiner : plan.joiners) {
		const std::span<const Task> tasks = agendas.tasks_of(PersonId(index_of(joiner) - index_of(first)));
		if (std::ranges::any_of(tasks, [&](const Task &task) { return is_walk(task, group) && (set_out_days(plan, task) & days) != 0; })) {
			result.push_back(joiner);
		}
	}
	return result;
}

std::vector<PersonId> joiners_on_day(const AgendaSet &agendas, uint32_t group, int64_t day) {
	const Group &plan = agendas.groups[group];
	const auto walks_from = [&](PersonId joiner, int64_t begin) {
		return std::ranges::any_of(agendas.agenda_of(joiner).on(begin), [&](const Task &task) {
			const bool is_of_evening_before = task.start_ms < plan.start_ms;
			return is_walk(task, group) && ((task.days >> SimTime::at(begin, {}).weekday()) & 1) && is_of_evening_before == (begin != day);
		});
	};
	std::vector<PersonId> result;
	for (PersonId joiner : plan.joiners) {
		if (walks_from(joiner, day) || walks_from(joiner, day + 1)) {
			result.push_back(joiner);
		}
	}
	return result;
}

} // namespace pcg
