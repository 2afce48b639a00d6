#include "core/io/trace_csv.h"

#include <cstdio>

#include "core/io/csv.h"
#include "core/population/names.h"

namespace pcg {

namespace {

std::string number_text(const FileIds *ids, uint32_t index) {
	return std::to_string(ids ? ids->number_of(index) : int64_t(index));
}

std::string type_text(const CityModel &city, Target place) {
	TypeId type = TypeId::Invalid;
	if (index_of(place.building()) < city.buildings().size()) {
		const EntranceId entrance = city.entrance_of(place.building());
		type = is_valid(entrance) ? city.entrance(entrance).type : type;
	} else if (is_valid(place.zone())) {
		type = city.zone(place.zone()).type;
	} else if (is_valid(place.object())) {
		type = city.object(place.object()).type;
	}
	return is_valid(type) ? csv_quoted(city.types.name(type)) : std::string();
}

std::string moment_text(SimTime time) { return clock_text(time.time_of_day(), true); }

} // namespace

std::string FileNumbers::text(PersonId id) const { return is_valid(id) ? number_text(persons, index_of(id)) : std::string(); }

std::string FileNumbers::text(Target place) const {
	switch (place.kind) {
		case Target::Kind::None:
			return "";
		case Target::Kind::Building:
			return is_valid(place.building()) ? "building:" + number_text(buildings, place.index) : "";
		case Target::Kind::Zone:
			return "zone:" + number_text(zones, place.index);
		case Target::Kind::Object:
			return "object:" + number_text(objects, place.index);
		case Target::Kind::Person:
			return "person:" + number_text(persons, place.index);
	}
	return "";
}

TraceWriter::TraceWriter(AtomicFile &file, SimTime start, FileNumbers numbers)
	: _file(file), _start(start), _numbers(numbers) {
	_file.write("seconds,person,event,place,x,z\n");
}

void TraceWriter::on_event(const SimEvent &event) {
	char line[256];
	const std::string person = _numbers.text(event.person);
	const std::string place = _numbers.text(event.place);
	const std::string_view kind = event_name(event.kind);
	const int length = std::snprintf(line, sizeof line, "%.3f,%s,%.*s,%s,%.2f,%.2f\n", (event.time - _start).in_seconds(),
			person.c_str(), int(kind.size()), kind.data(), place.c_str(), double(event.position.x), double(event.position.z));
	_file.write({ line, size_t(length) });
}

void TraceWriter::on_jump(SimTime from, SimTime to) {
	if (from == to) {
		return;
	}
	char line[128];
	const int length = std::snprintf(
			line, sizeof line, "%.3f,,jumped,%.3f,,\n", (to - _start).in_seconds(), (from - _start).in_seconds());
	_file.write({ line, size_t(length) });
}

bool write_lived_csv(const std::string &path, const CityModel &city, const Population &population, const LivedLog &log,
		const FileNumbers &numbers, Diagnostics &diagnostics) {
	AtomicFile file(path);
	file.write("person,name,age,day,start,end,seconds,state,place,type,x,z,metres,leader,planned,planned_start,planned_end\n");
	for (const LivedEntry &entry : log.sorted()) {
		const bool is_hole = entry.planned_task == PlannedEntry::hole;
		char figures[128];
		std::snprintf(figures, sizeof figures, "%.2f,%.2f,%.1f", double(entry.position.x), double(entry.position.z), double(entry.metres));
		char span[64];
		std::snprintf(span, sizeof span, "%.3f", (entry.end - entry.start).in_seconds());
		std::string row = numbers.text(entry.person) + ',' + csv_quoted(full_name(population, entry.person)) + ',' +
				std::to_string(int(population.person(entry.person).age)) + ',' + std::to_string(entry.start.day()) + ',' +
				moment_text(entry.start) + ',' + moment_text(entry.end) + ',' + span + ',';
		row += std::string(state_name(entry.state)) + ',' + numbers.text(entry.place) + ',' + type_text(city, entry.place) + ',' +
				figures + ',' + numbers.text(entry.leader) + ',';
		row += is_hole ? "home,," : std::string(task_kind_name(entry.planned_kind)) + ',' + moment_text(entry.planned_start) + ',' +
						moment_text(entry.planned_end);
		file.write(row + '\n');
	}
	return file.commit(diagnostics);
}

} // namespace pcg
