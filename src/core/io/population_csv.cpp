#include "core/io/population_csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <iterator>
#include <span>
#include <unordered_map>

#include "core/base/diagnostic.h"
#include "core/base/random.h"
#include "core/io/csv.h"
#include "core/population/names.h"

namespace pcg {

namespace {

constexpr std::array<std::string_view, 6> columns{ "household", "person", "home", "age", "gender", "speed" };
enum Column : size_t { HouseholdColumn, PersonColumn, HomeColumn, AgeColumn, GenderColumn, SpeedColumn };

// How people look and what they are called: what a table does not tell follows from the ids.
constexpr std::array<std::string_view, 4> look_columns{ "first_name", "family_name", "hair", "clothes" };
enum LookColumn : size_t { FirstNameColumn, FamilyNameColumn, HairColumn, ClothesColumn };
constexpr uint64_t looks_seed = hash_text("looks");

struct Row {
	const CsvRow *csv = nullptr;
	int64_t number = 0;
	int64_t home = 0;
	Person person;
};

// What members of a household say of a look that all of them share.
struct SharedLook {
	std::string told; // by the first; empty: nobody
	bool is_doubted = false;
};

struct Members {
	std::vector<Row> rows;
	const CsvRow *first_left_out = nullptr;
	size_t left_out = 0;
};

// Every bad cell is an error of its own.
class PeopleReader {
public:
	PeopleReader(const CsvTable &csv, const FileIds *buildings, Diagnostics &diagnostics) :
			_csv(csv), _buildings(buildings), _diagnostics(diagnostics) {}

	// Not to be used after an error.
	PopulationFile read() {
		if (!find_columns() || !has_rows(_csv, _diagnostics)) {
			return {};
		}
		for (const CsvRow &csv : _csv.rows) {
			read_row(csv);
		}
		for (size_t i = 0; i < _members.size(); ++i) {
			add_household(_members[i], i);
		}
		return std::move(_result);
	}

private:
	bool find_columns() {
		for (size_t i = 0; i < columns.size(); ++i) {
			const int column = _csv.find_column(columns[i]);
			if (column < 0) {
				_diagnostics.add(_csv.at(_csv.header, 0, "missing-column", "the first line names no column '" + std::string(columns[i]) + "'",
						"the first line has to name the columns: household,person,home,age,gender,speed"));
				return false;
			}
			_column[i] = size_t(column);
		}
		for (size_t i = 0; i < look_columns.size(); ++i) {
			_look_column[i] = _csv.find_column(look_columns[i]);
		}
		return true;
	}

	bool fail(const CsvRow &row, Column column, std::string_view id, std::string message, std::string hint) {
		_diagnostics.add(_csv.at(row, _column[column], id, std::move(message), std::move(hint)));
		return false;
	}

	template <typename T> bool number(const CsvRow &row, Column column, T low, T high, T &value) {
		const std::string &field = row.fields[_column[column]].text;
		const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
		if (error != std::errc() || end != field.data() + field.size() || !(value >= low && value <= high)) {
			return fail(row, column, "not-a-number", "'" + field + "' is not a value for '" + std::string(columns[column]) + "'",
					column == AgeColumn		   ? "write years, 0 to 150"
							: column == SpeedColumn ? "write metres per second, above 0 and not above 20"
							: column == HomeColumn	? "write the id of a building, a whole number"
													: "write a whole number, 0 or larger");
		}
		return true;
	}

	bool gender(const CsvRow &row, Gender &value) {
		const std::string &field = row.fields[_column[GenderColumn]].text;
		value = field == "w" ? Gender::Woman : Gender::Man;
		return field == "w" || field == "m" ||
				fail(row, GenderColumn, "bad-gender", "'" + field + "' is not a gender of this table", "write w (woman) or m (man)");
	}

	bool home(const CsvRow &row, int64_t &value) {
		if (!number<int64_t>(row, HomeColumn, INT64_MIN, INT64_MAX, value)) {
			return false;
		}
		return _buildings == nullptr || is_valid(building(value)) ||
				fail(row, HomeColumn, "unknown-building", "the city has no building " + std::to_string(value),
						"write the id of a building of the city's file");
	}

	BuildingId building(int64_t number) const { return _buildings != nullptr ? BuildingId(_buildings->index_of(number)) : BuildingId::Invalid; }

	void read_row(const CsvRow &csv) {
		Row row;
		row.csv = &csv;
		int64_t household = 0;
		const bool cells[] = { number<int64_t>(csv, HouseholdColumn, 0, INT64_MAX, household),
			number<int64_t>(csv, PersonColumn, 0, INT64_MAX, row.number), home(csv, row.home),
			number<float>(csv, AgeColumn, 0.0f, 150.0f, row.person.age), gender(csv, row.person.gender),
			number<float>(csv, SpeedColumn, 0.01f, 20.0f, row.person.walking_speed) };
		if (std::find(std::begin(cells), std::end(cells), false) == std::end(cells)) {
			join_household(row, household);
		}
	}

	void join_household(const Row &row, int64_t number) {
		if (_result.household_ids.index_of(number) == index_of(HouseholdId::Invalid)) {
			_result.household_ids.add(number);
			_members.emplace_back();
		}
		Members &members = _members[_result.household_ids.index_of(number)];
		if (!members.rows.empty() && members.rows.front().home != row.home) {
			fail(*row.csv, HomeColumn, "two-homes", "household " + std::to_string(number) + " has two homes",
					"all members of a household live in one building");
		} else if (members.rows.size() < max_household_size) {
			members.rows.push_back(row);
		} else {
			members.first_left_out = members.left_out == 0 ? row.csv : members.first_left_out;
			++members.left_out;
		}
	}

	void add_household(const Members &members, size_t index) {
		Population &population = _result.population;
		Random looks(looks_seed, index);
		Household household;
		household.home = building(members.rows.front().home);
		household.first_member = PersonId(uint32_t(population.persons.size()));
		household.member_count = uint16_t(members.rows.size());
		household.family_name = uint32_t(looks.index(family_names().size()));
		household.hair_color = draw_hair_color(looks);
		SharedLook family, hair;
		for (const Row &row : members.rows) {
			if (is_first_to_tell(*row.csv, FamilyNameColumn, family)) {
				read_name(*row.csv, FamilyNameColumn, family_names(), household.family_name);
				family.told = look(*row.csv, FamilyNameColumn);
			}
			if (is_first_to_tell(*row.csv, HairColumn, hair) && read_color(*row.csv, HairColumn, hair_colors(), household.hair_color)) {
				hair.told = look(*row.csv, HairColumn);
			}
			add_person(row, HouseholdId(uint32_t(index)), looks);
		}
		population.households.push_back(household);
		if (members.left_out > 0) {
			tell_left_out(members, index);
		}
	}

	void add_person(const Row &row, HouseholdId household, Random &looks) {
		if (!_result.person_ids.add(row.number)) {
			fail(*row.csv, PersonColumn, "repeated-person", "person " + std::to_string(row.number) + " stands in the table twice",
					"every person needs a number of its own");
		}
		Person person = row.person;
		person.household = household;
		person.name = uint32_t(looks.index(first_names(person.gender).size()));
		person.clothes_color = uint8_t(looks.index(clothes_colors().size()));
		read_name(*row.csv, FirstNameColumn, first_names(person.gender), person.name);
		read_color(*row.csv, ClothesColumn, clothes_colors(), person.clothes_color);
		_result.population.persons.push_back(person);
	}

	void tell_left_out(const Members &members, size_t index) {
		Diagnostic diagnostic = _csv.at(*members.first_left_out, _column[HouseholdColumn], "household-too-large",
				"household " + std::to_string(_result.household_ids.number_of(uint32_t(index))) + " has " +
						std::to_string(members.rows.size() + members.left_out) + " members, more than " + std::to_string(max_household_size) +
						": from here on " + std::to_string(members.left_out) + " are left out",
				"split the household");
		diagnostic.severity = Severity::Warning;
		_diagnostics.add(std::move(diagnostic));
	}

	// Empty where the table tells nothing.
	const std::string &look(const CsvRow &row, LookColumn column) const {
		static const std::string nothing;
		return _look_column[column] < 0 ? nothing : row.fields[size_t(_look_column[column])].text;
	}

	// Whether it is to be read. Who tells another one afterwards is not followed, which is told of the first.
	bool is_first_to_tell(const CsvRow &row, LookColumn column, SharedLook &shared) {
		const std::string &text = look(row, column);
		if (shared.told.empty() || text.empty()) {
			return !text.empty();
		}
		if (text != shared.told && !shared.is_doubted) {
			shared.is_doubted = true;
			warn(row, column, "two-looks",
					"the " + std::string(look_columns[column]) + " of a household is that of its first member who has one, '" + shared.told + "', not '" + text + "'",
					"write the same for all members, or leave it empty");
		}
		return false;
	}

	void warn(const CsvRow &row, LookColumn column, std::string_view id, std::string message, std::string hint) {
		Diagnostic diagnostic = _csv.at(row, size_t(_look_column[column]), id, std::move(message), std::move(hint));
		diagnostic.severity = Severity::Warning;
		_diagnostics.add(std::move(diagnostic));
	}

	// Names that are in no list are kept beside them.
	void read_name(const CsvRow &row, LookColumn column, std::span<const std::string_view> list, uint32_t &index) {
		const std::string &text = look(row, column);
		if (text.empty()) {
			return;
		}
		const auto known = std::find(list.begin(), list.end(), text);
		index = uint32_t(known - list.begin());
		if (known == list.end()) {
			std::vector<std::string> &names = _result.population.names;
			const auto [own, is_new] = _own_names.try_emplace(text, uint32_t(names.size()));
			index += own->second;
			if (is_new) {
				names.push_back(text);
			}
		}
	}

	// False, and as it was, where the table says nothing, or no color, which is told.
	bool read_color(const CsvRow &row, LookColumn column, std::span<const NamedColor> list, uint8_t &index) {
		const std::string &text = look(row, column);
		if (text.empty()) {
			return false;
		}
		std::vector<std::string_view> known;
		for (size_t i = 0; i < list.size(); ++i) {
			known.push_back(list[i].name);
			if (list[i].name == text) {
				index = uint8_t(i);
				return true;
			}
		}
		const std::string_view closest = closest_name(text, known);
		warn(row, column, "unknown-look", "there is no " + std::string(look_columns[column]) + " '" + text + "', so it counts as empty",
				closest.empty() ? "leave the column empty, or write " + std::string(known.front()) : "did you mean '" + std::string(closest) + "'?");
		return false;
	}

	const CsvTable &_csv;
	const FileIds *_buildings;
	Diagnostics &_diagnostics;
	std::array<size_t, columns.size()> _column{};
	std::array<int, look_columns.size()> _look_column{}; // -1: not in the table
	PopulationFile _result;
	std::vector<Members> _members; // by dense household
	std::unordered_map<std::string, uint32_t> _own_names; // where they are in Population::names
};

std::optional<PopulationFile> read_people(std::optional<CsvTable> csv, const FileIds *buildings, Diagnostics &found, Diagnostics &diagnostics) {
	return read_records(std::move(csv), found, diagnostics, [&](const CsvTable &table) { return PeopleReader(table, buildings, found).read(); });
}

} // namespace

std::optional<PopulationFile> parse_population(std::string_view text, std::string_view file, const FileIds *building_ids, Diagnostics &diagnostics) {
	Diagnostics found(max_table_problems);
	return read_people(parse_csv(text, file, found), building_ids, found, diagnostics);
}

std::optional<PopulationFile> read_population(const std::string &path, const FileIds *building_ids, Diagnostics &diagnostics) {
	Diagnostics found(max_table_problems);
	return read_people(read_csv(path, found), building_ids, found, diagnostics);
}

std::string population_to_csv(const Population &population, const FileNumbers &numbers) {
	std::string text = "household,person,home,age,gender,speed,first_name,family_name,hair,clothes\n";
	for (size_t i = 0; i < population.persons.size(); ++i) {
		const PersonId id = PersonId(uint32_t(i));
		const Person &person = population.persons[i];
		const Household &household = population.household(person.household);
		char row[80];
		std::snprintf(row, sizeof(row), ",%.9g,%c,%.9g,", double(person.age), person.gender == Gender::Woman ? 'w' : 'm', double(person.walking_speed));
		text += number_text(numbers.households, person.household) + "," + number_text(numbers.persons, id) + "," +
				number_text(numbers.buildings, household.home) + row;
		text += csv_quoted(first_name(population, id)) + "," + csv_quoted(family_name(population, person.household)) + ",";
		text += std::string(hair_colors()[household.hair_color].name) + "," + std::string(clothes_colors()[person.clothes_color].name) + "\n";
	}
	return text;
}

} // namespace pcg
