#include "core/io/trace_csv.h"

#include <cstdio>

#include "core/io/csv.h"
#include "core/population/building_use.h"
#include "core/population/names.h"

namespace pcg {

namespace {

std::string person_text(const FileNumbers &numbers, PersonId id) { return is_valid(id) ? number_text(numbers.persons, id) : std::string(); }

// "building:12", "zone:3", ..; empty for none.
std::string place_text(const FileNumbers &numbers, Target place) {
	switch (place.kind) {
		case Target::Kind::None:
			return "";
		case Target::Kind::Building:
			return is_valid(place.building()) ? "building:" + number_text(numbers.buildings, place.building()) : "";
		case Target::Kind::Zone:
			return "zone:" + number_text(numbers.zones, place.zone());
		case Target::Kind::Object:
			return "object:" + number_text(numbers.objects, place.object());
		case Target::Kind::Person:
			return "person:" + number_text(numbers.persons, PersonId(place.index));
	}
	return "";
}

std::string type_text(const CityModel &city, const Population &population, const LivedEntry &entry) {
	if (is_valid(entry.place.building())) {
		return csv_quoted(building_use(city, population, entry.person, entry.place.building()));
	}
	TypeId type = TypeId::Invalid;
	if (is_valid(entry.place.zone())) {
		type = city.zone(entry.place.zone()).type;
	} else if (is_valid(entry.place.object())) {
		type = city.object(entry.place.object()).type;
	}
	return csv_quoted(city.types.name(type));
}

// The door of the row's building at which the person is.
std::string door_text(const CityModel &city, const LivedEntry &entry) {
	if (index_of(entry.place.building()) >= city.buildings().size()) {
		return {};
	}
	for (EntranceId id : city.building(entry.place.building()).entrances) {
		if (city.entrance(id).position == entry.position) {
			return std::to_string(index_of(id));
		}
	}
	return {};
}

// As a clock of the day on which the row starts: it goes on counting past midnight.
std::string clock_in_row(const LivedEntry &row, SimTime time) { return clock_text(time - SimTime::at(row.start.day(), {}), true); }

SimTime to_second(SimTime time) {
	const int64_t shifted = time.ms + 500;
	const int64_t remainder = ((shifted % 1000) + 1000) % 1000;
	return { shifted - remainder };
}

// By person, then by time, in whole seconds: what is over within one of them goes, and what was walked in it counts with the walk next to it.
std::vector<LivedEntry> in_seconds(const LivedLog &log) {
	std::vector<LivedEntry> rows;
	float metres = 0.0f; // of what went, for the next row
	for (LivedEntry entry : log.sorted()) {
		const bool is_new_life = rows.empty() || rows.back().person != entry.person;
		metres = is_new_life ? 0.0f : metres;
		entry.start = to_second(entry.start);
		entry.end = to_second(entry.end);
		const bool walks_on = !is_new_life && rows.back().state == PersonState::Walking;
		if (entry.start < entry.end) {
			entry.metres += entry.state == PersonState::Walking ? metres : 0.0f;
			metres = 0.0f;
			rows.push_back(entry);
		} else if (walks_on) {
			rows.back().metres += entry.metres;
		} else {
			metres += entry.metres;
		}
	}
	return rows;
}

std::string row_text(const CityModel &city, const Population &population, const FileNumbers &numbers, const LivedEntry &row) {
	const bool is_hole = row.planned_task == PlannedEntry::hole;
	char figures[128];
	std::snprintf(figures, sizeof figures, ",%.2f,%.2f,%.1f,", double(row.position.x), double(row.position.z), double(row.metres));
	std::string text = person_text(numbers, row.person) + ',' + csv_quoted(full_name(population, row.person)) + ',' +
			std::to_string(int(population.person(row.person).age)) + ',' + std::to_string(row.start.day()) + ',' +
			clock_in_row(row, row.start) + ',' + clock_in_row(row, row.end) + ',' + std::to_string((row.end - row.start).ms / 1000) + ',';
	text += std::string(state_name(row.state)) + ',' + place_text(numbers, row.place) + ',' + type_text(city, population, row) + ',' +
			door_text(city, row) + figures + person_text(numbers, row.leader) + ',';
	text += is_hole ? "home,," : std::string(task_kind_name(row.planned_kind)) + ',' + clock_in_row(row, row.planned_start) + ',' +
					clock_in_row(row, row.planned_end);
	return text + '\n';
}

} // namespace

TraceWriter::TraceWriter(AtomicFile &file, const Simulation &simulation, SimTime start, FileNumbers numbers)
	: _file(file), _simulation(simulation), _start(start), _numbers(numbers) {
	_file.write("seconds,person,event,place,x,z\n");
}

void TraceWriter::write(SimTime time, PersonId id, std::string_view what, Target goal, glm::vec3 position) {
	char line[256];
	const std::string person = person_text(_numbers, id);
	const std::string place = place_text(_numbers, goal);
	const int length = std::snprintf(line, sizeof line, "%.3f,%s,%.*s,%s,%.2f,%.2f\n", (time - _start).in_seconds(), person.c_str(),
			int(what.size()), what.data(), place.c_str(), double(position.x), double(position.z));
	_file.write({ line, size_t(length) });
}

void TraceWriter::on_event(const SimEvent &event) { write(event.time, event.person, event_name(event.kind), event.place, event.position); }

void TraceWriter::on_jump(SimTime from, SimTime to) {
	if (from != to) {
		char line[128];
		const int length = std::snprintf(
				line, sizeof line, "%.3f,,jumped,%.3f,,\n", (to - _start).in_seconds(), (from - _start).in_seconds());
		_file.write({ line, size_t(length) });
	}
	for (uint32_t i = 0; i < _simulation.person_count(); ++i) {
		const PersonView view = _simulation.view(PersonId(i));
		if (view.presence != Presence::Removed) {
			write(to, PersonId(i), state_name(view.state), view.place, view.position);
		}
	}
}

bool write_lived_csv(const std::string &path, const CityModel &city, const Population &population, const LivedLog &log,
		const FileNumbers &numbers, Diagnostics &diagnostics) {
	AtomicFile file(path);
	file.write("person,name,age,day,start,end,seconds,state,place,type,entrance,x,z,metres,leader,planned,planned_start,planned_end\n");
	for (const LivedEntry &row : in_seconds(log)) {
		file.write(row_text(city, population, numbers, row));
	}
	return file.commit(diagnostics);
}

} // namespace pcg
