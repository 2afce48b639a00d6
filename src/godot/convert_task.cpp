#include "godot/convert_task.h"

#include <algorithm>
#include <cmath>

#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

#include "core/agenda/agenda_edit.h"
#include "core/base/day_names.h"
#include "core/base/diagnostic.h"
#include "godot/convert.h"

using namespace godot;

namespace pcg {

namespace {

constexpr double week_seconds = 7.0 * 86400.0;

PackedStringArray to_names(DayMask days) {
	PackedStringArray result;
	for (size_t day = 0; day < 7; ++day) {
		if ((days >> day) & 1) {
			result.push_back(to_godot(short_day_name(day)));
		}
	}
	return result;
}

bool is_number(const Variant &value) { return value.get_type() == Variant::INT || value.get_type() == Variant::FLOAT; }
bool is_text(const Variant &value) { return value.get_type() == Variant::STRING || value.get_type() == Variant::STRING_NAME; }

String closest_hint(const String &name, const std::vector<std::string_view> &known) {
	const std::string_view closest = closest_name(from_godot(name), known);
	return closest.empty() ? String() : "; did you mean '" + to_godot(closest) + "'?";
}

void add_group(Dictionary &entry, const Task &walk, const AgendaSet &agendas, std::optional<int64_t> day) {
	const Group &group = agendas.groups[walk.target];
	const int64_t evening_before = walk.start_ms < group.start_ms ? 1 : 0;
	PackedInt32Array joiners;
	for (const PersonId joiner : day ? joiners_on_day(agendas, walk.target, *day - evening_before)
									 : joiners_on(agendas, walk.target, set_out_days(group, walk))) {
		joiners.push_back(int32_t(index_of(joiner)));
	}
	entry["leader"] = int64_t(index_of(group.leader));
	entry["joiners"] = joiners;
}

} // namespace

Dictionary to_godot(const Task &task, const AgendaSet &agendas, const Program &program, std::optional<int64_t> day) {
	Dictionary entry;
	entry["kind"] = to_godot(task_kind_name(task.kind));
	entry["start"] = task.start().in_seconds();
	entry["end"] = task.end().in_seconds();
	entry["target"] = task.target == 0xFFFFFFFF ? int64_t(-1) : int64_t(task.target);
	entry["days"] = to_names(task.days);
	if (task.kind == TaskKind::DelayedRule && task.target < program.rules.size()) {
		entry["delayed_rule"] = to_godot(std::string_view(program.rules[task.target].name));
	} else if (task.kind == TaskKind::Accompany) {
		add_group(entry, task, agendas, day);
	}
	if (task.name != 0) {
		entry["name"] = to_godot(std::string_view(agendas.names[task.name]));
	}
	PackedStringArray required, before;
	for (uint8_t number = task.requirement; number != 0; number = agendas.requirements[number].outer) {
		const Requirement &requirement = agendas.requirements[number];
		(requirement.is_after ? before : required).push_back(to_godot(std::string_view(agendas.names[requirement.name])));
	}
	if (!required.is_empty()) {
		entry["requires"] = required;
	}
	if (!before.is_empty()) {
		entry["after"] = before;
	}
	if (task.origin < agendas.origins.size()) {
		const TaskOrigin &origin = agendas.origins[task.origin];
		entry["rule"] = to_godot(std::string_view(origin.rule));
		entry["file"] = to_godot(std::string_view(origin.file));
		entry["line"] = origin.line;
	}
	return entry;
}

bool TaskReader::fail(const String &problem) {
	_problem = problem;
	return false;
}

std::optional<WrittenTask> TaskReader::read(const Dictionary &task) {
	static const std::vector<std::string_view> known{ "kind", "start", "end", "target", "delayed_rule", "day", "days", "name", "requires", "after", "leader", "joiners",
		"rule", "file", "line" };
	const Array keys = task.keys();
	for (int64_t i = 0; i < keys.size(); ++i) {
		const String key = keys[i];
		if (std::find(known.begin(), known.end(), from_godot(key)) == known.end()) {
			fail("there is no key '" + key + "'" + closest_hint(key, known));
			return std::nullopt;
		}
	}
	if (!read_kind(task.get("kind", Variant())) || !read_times(task) || !read_target(task) || !read_days(task) || !read_names(task)) {
		return std::nullopt;
	}
	return _written;
}

bool TaskReader::read_kind(const Variant &kind) {
	static const std::vector<std::string_view> kinds{ "stayInside", "goToBuilding", "accompany", "delayedRule", "floatingSlot" };
	if (!is_text(kind)) {
		return fail("`kind` has to be one of stayInside, goToBuilding, delayedRule and floatingSlot");
	}
	const std::string name = from_godot(String(kind));
	const auto found = std::find(kinds.begin(), kinds.end(), name);
	if (found == kinds.end()) {
		return fail("there is no kind '" + String(kind) + "'" + closest_hint(String(kind), kinds));
	}
	_written.task.kind = TaskKind(found - kinds.begin());
	return _written.task.kind != TaskKind::Accompany || fail("walks together are made by rules only; give each of them a goToBuilding");
}

bool TaskReader::read_times(const Dictionary &task) {
	const Variant start = task.get("start", Variant()), end = task.get("end", Variant());
	if (!is_number(start) || !is_number(end)) {
		return fail("`start` and `end` have to be seconds of the day");
	}
	const double from = start, to = end;
	if (!(std::abs(from) <= week_seconds) || !std::isfinite(to)) {
		return fail("`start` has to be within a week of the day, and `end` finite");
	}
	if (!(from < to) || to - from > 86400.0) {
		return fail("it has to end after it starts, 24 hours later at most");
	}
	_written.task.start_ms = int32_t(Duration::seconds(from).ms);
	_written.task.end_ms = int32_t(Duration::seconds(to).ms);
	return _written.task.start_ms < _written.task.end_ms || fail("it has to last a millisecond");
}

bool TaskReader::read_target(const Dictionary &task) {
	if (_written.task.kind == TaskKind::FloatingSlot) {
		return true;
	}
	if (_written.task.kind != TaskKind::DelayedRule) {
		const Variant target = task.get("target", Variant());
		if (!is_number(target) || double(target) < 0.0 || double(target) >= 4294967295.0 || double(target) != std::floor(double(target))) {
			return fail("`target` has to be the number of a building");
		}
		_written.task.target = uint32_t(int64_t(target));
		return true;
	}
	const Variant rule = task.get("delayed_rule", Variant());
	std::vector<std::string_view> names;
	for (const RuleInfo &each : _program.rules) {
		if (each.params.empty()) {
			names.push_back(each.name);
		}
	}
	const std::string name = is_text(rule) ? from_godot(String(rule)) : std::string();
	if (std::find(names.begin(), names.end(), name) == names.end()) {
		return fail("`delayed_rule` has to be the name of a rule without parameters" + (is_text(rule) ? ", and there is no '" + String(rule) + "'" + closest_hint(String(rule), names) : String()));
	}
	_written.task.target = index_of(_program.find_rule(name));
	return true;
}

// A day counted from the first Monday, or names of days of the week; every day without either.
bool TaskReader::read_days(const Dictionary &task) {
	if (task.has("day")) {
		const Variant day = task["day"];
		if (!is_number(day) || std::abs(double(day)) > 1e6 || double(day) != std::floor(double(day))) {
			return fail("`day` has to be a whole number, 0 for the first Monday");
		}
		_written.day = int64_t(day);
		return true;
	}
	if (!task.has("days")) {
		return true;
	}
	const Variant days = task["days"];
	if (days.get_type() != Variant::ARRAY && days.get_type() != Variant::PACKED_STRING_ARRAY) {
		return fail("`days` has to be an array of names such as [\"mon\", \"sat\"]");
	}
	const PackedStringArray names = days;
	_written.task.days = 0;
	for (int64_t i = 0; i < names.size(); ++i) {
		const std::optional<int> weekday = weekday_named(from_godot(names[i]));
		if (!weekday) {
			return fail("there is no day '" + names[i] + "'; they are mon tue wed thu fri sat sun");
		}
		_written.task.days |= DayMask(1u << *weekday);
	}
	return _written.task.days != 0 || fail("`days` names no day");
}

bool TaskReader::read_names(const Dictionary &task) {
	const Variant name = task.get("name", String());
	if (!is_text(name)) {
		return fail("`name` has to be text");
	}
	if (!String(name).is_empty()) {
		_written.task.name = task_name(_agendas, from_godot(String(name)));
		if (_written.task.name == 0) {
			return fail("there are too many different names of entries already");
		}
	}
	return require(task.get("requires", PackedStringArray()), false) && require(task.get("after", PackedStringArray()), true);
}

// A name, or several.
bool TaskReader::require(const Variant &names, bool is_after) {
	const bool is_list = names.get_type() == Variant::ARRAY || names.get_type() == Variant::PACKED_STRING_ARRAY;
	if (!is_list && !is_text(names)) {
		return fail("`requires` and `after` have to be names of entries");
	}
	PackedStringArray list;
	if (is_list) {
		list = names;
	} else {
		list.push_back(String(names));
	}
	for (int64_t i = 0; i < list.size(); ++i) {
		const uint16_t name = list[i].is_empty() ? uint16_t(0) : task_name(_agendas, from_godot(list[i]));
		const uint8_t requirement = name == 0 ? uint8_t(0) : task_requirement(_agendas, { name, is_after, _written.task.requirement });
		if (requirement == 0) {
			return fail("there are too many different requirements already, or one without a name");
		}
		_written.task.requirement = requirement;
	}
	return true;
}

} // namespace pcg
