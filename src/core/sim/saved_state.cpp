#include "core/sim/saved_state.h"

#include "core/base/bytes.h"

// Each visit() names the fields of a record once, for writing and for reading.
namespace pcg {

namespace {

constexpr size_t pose_count = size_t(AgentPose::Sit) + 1;

// Sums of times from a damaged file must not overflow: they lie within the range of Duration::seconds.
template <typename Archive, typename Time> void visit_time(Archive &archive, Time &time, bool can_be_never = false) {
	constexpr int64_t most = 1'000'000'000'000'000;
	archive.whole(time.ms, most, can_be_never);
}

template <typename Archive, typename Vector> void visit_point(Archive &archive, Vector &point) { archive.values(point.x, point.y, point.z); }

template <typename Archive, typename Record> void visit_person(Archive &archive, Record &person) {
	for (auto *time : { &person.due, &person.entry_start, &person.entry_end, &person.rule_end, &person.queued }) {
		visit_time(archive, *time, true);
	}
	visit_point(archive, person.position);
	archive.values(person.place, person.walk, person.behavior, person.party, person.entry_task);
	archive.choice(person.state, size_t(PersonState::Waiting) + 1);
	archive.choice(person.place_kind, size_t(Target::Kind::Person) + 1);
	archive.choice(person.purpose, size_t(Purpose::Group) + 1);
	archive.choice(person.pose, pose_count);
	archive.choice(person.entry_kind, task_kind_count);
	archive.values(person.object_place, person.reserved_object, person.can_be_late);
	archive.choice(person.presence, size_t(Presence::Removed) + 1);
}

template <typename Archive, typename Record> void visit_walk(Archive &archive, Record &walk) {
	archive.list(walk.points, [](auto &inner, auto &point) { visit_point(inner, point); });
	archive.values(walk.length, walk.speed);
	visit_time(archive, walk.departure);
	visit_time(archive, walk.arrival);
}

template <typename Archive, typename Ids> void visit_ids(Archive &archive, Ids &ids) {
	archive.list(ids, [](auto &inner, auto &id) { inner.values(id); });
}

template <typename Archive, typename Record> void visit_party(Archive &archive, Record &party) {
	archive.values(party.group, party.leader, party.goal);
	visit_ids(archive, party.pending);
	visit_ids(archive, party.collected);
}

// Numbers and truths as such, everything else by its index, as in VmState.
template <typename Archive, typename V> void visit_value(Archive &archive, V &value) {
	archive.choice(value.type, size_t(ValueType::Variable) + 1);
	archive.choice(value.size_kind, size_t(SizeKind::Flexible) + 1);
	if (value.type == ValueType::Number || value.type == ValueType::Void) {
		archive.values(value.number);
	} else if (value.type == ValueType::Bool) {
		archive.values(value.boolean);
	} else {
		archive.values(value.index);
	}
}

template <typename Archive, typename Values> void visit_all(Archive &archive, Values &values) {
	archive.list(values, [](auto &inner, auto &value) { visit_value(inner, value); });
}

template <typename Archive, typename State> void visit_run(Archive &archive, State &run) {
	archive.values(run.fingerprint, run.seed, run.steps, run.random_key, run.random_counter, run.address, run.base);
	archive.list(run.frames, [](auto &inner, auto &frame) {
		inner.choice(frame.kind, size_t(VmFrame::Kind::Import) + 1);
		inner.values(frame.callable, frame.return_address, frame.base, frame.trail_mark);
	});
	archive.list(run.trail, [](auto &inner, auto &entry) {
		inner.values(entry.slot);
		visit_value(inner, entry.old);
	});
	visit_all(archive, run.stack);
	visit_all(archive, run.slots);
	visit_all(archive, run.attributes);
	archive.list(run.texts, [](auto &inner, auto &text) { inner.text(text); });
	archive.list(run.arrays, [](auto &inner, auto &array) {
		inner.values(array.rows, array.columns);
		inner.choice(array.element, size_t(ValueType::Variable) + 1);
		visit_all(inner, array.values);
	});
}

template <typename Archive, typename Saved> void visit_behavior(Archive &archive, Saved &behavior) {
	archive.values(behavior.person, behavior.rule);
	archive.choice(behavior.pose, pose_count);
	archive.values(behavior.uses_on_arrival, behavior.random_key, behavior.random_counter);
	visit_run(archive, behavior.run);
}

template <typename Archive, typename Figures> void visit_statistics(Archive &archive, Figures &figures) {
	archive.values(figures.trips, figures.late_arrivals, figures.outside, figures.peak_outside, figures.handled_moments);
	visit_time(archive, figures.peak_time);
	for (auto &count : figures.events) {
		archive.values(count);
	}
}

template <typename Archive, typename Attribute> void visit_attribute(Archive &archive, Attribute &attribute) {
	archive.text(attribute.name);
	auto type = uint8_t(attribute.value.index());
	archive.choice(type, std::variant_size_v<AttributeValue>);
	if constexpr (Archive::is_reading) {
		attribute.value = type == 0 ? AttributeValue(0.0) : type == 1 ? AttributeValue(false) : AttributeValue(std::string());
	}
	if (auto *const text = std::get_if<std::string>(&attribute.value)) {
		archive.text(*text);
	} else if (auto *const truth = std::get_if<bool>(&attribute.value)) {
		archive.values(*truth);
	} else {
		archive.values(std::get<double>(attribute.value));
	}
}

template <typename Archive, typename State> void visit_state(Archive &archive, State &state) {
	archive.values(state.program_fingerprint, state.seed, state.city_origin, state.buildings, state.zones, state.objects);
	archive.list(state.attributes, [](auto &inner, auto &attribute) { visit_attribute(inner, attribute); });
	visit_time(archive, state.patience);
	visit_time(archive, state.now);
	visit_statistics(archive, state.statistics);
	archive.list(state.persons, [](auto &inner, auto &person) { visit_person(inner, person); });
	archive.list(state.walks, [](auto &inner, auto &walk) { visit_walk(inner, walk); });
	archive.list(state.behaviors, [](auto &inner, auto &behavior) { visit_behavior(inner, behavior); });
	archive.list(state.parties, [](auto &inner, auto &party) { visit_party(inner, party); });
	archive.list(state.floating_taken, [](auto &inner, auto &day) { inner.values(day); });
}

} // namespace

std::string state_to_bytes(const SavedState &state) {
	ByteWriter writer;
	visit_state(writer, state);
	return writer.take();
}

bool state_from_bytes(std::string_view bytes, SavedState &state) {
	ByteReader reader(bytes);
	visit_state(reader, state);
	return reader.is_good() && reader.is_at_end();
}

} // namespace pcg
