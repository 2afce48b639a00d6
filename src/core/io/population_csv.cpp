#include "core/io/population_csv.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

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

std::string_view name_of(std::string_view name) { return name; }
std::string_view name_of(const NamedColor &color) { return color.name; }

struct Row {
	const CsvRow *csv = nullptr;
	int64_t person = 0;
	BuildingId home = BuildingId::Invalid;
	Person record;
};

class PeopleReader {
public:
	PeopleReader(const CsvTable &csv, const FileIds &buildings) : _csv(csv), _buildings(buildings) {}

	Result<PopulationFile> read() {
		for (size_t i = 0; i < columns.size(); ++i) {
			const int column = _csv.find_column(columns[i]);
			if (column < 0) {
				return _csv.at(_csv.header, 0, "missing-column", "the header has no column '" + std::string(columns[i]) + "'",
						"the first line has to name the columns: household,person,home,age,gender,speed");
			}
			_column[i] = size_t(column);
		}
		for (size_t i = 0; i < look_columns.size(); ++i) {
			_look_column[i] = _csv.find_column(look_columns[i]);
		}
		for (const CsvRow &csv : _csv.rows) {
			Row row;
			row.csv = &csv;
			if (!read_row(row)) {
				return _problem;
			}
		}
		return assemble();
	}

private:
	const std::string &text(const Row &row, Column column) const { return row.csv->fields[_column[column]].text; }

	bool fail(const Row &row, Column column, std::string_view id, std::string message, std::string hint) {
		_problem = _csv.at(*row.csv, _column[column], id, std::move(message), std::move(hint));
		return false;
	}

	template <typename T> bool number(const Row &row, Column column, T low, T high, T &value) {
		const std::string &field = text(row, column);
		const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
		if (error != std::errc() || end != field.data() + field.size() || !(value >= low && value <= high)) {
			return fail(row, column, "not-a-number", "'" + field + "' is not a value for '" + std::string(columns[column]) + "'",
					column == AgeColumn		   ? "write years, 0 to 150"
							: column == SpeedColumn ? "write metres per second, above 0 and not above 20"
													: "write a whole number, 0 or larger");
		}
		return true;
	}

	bool read_row(Row &row) {
		int64_t household = 0;
		int64_t home = 0;
		constexpr int64_t largest = INT64_MAX;
		if (!number<int64_t>(row, HouseholdColumn, 0, largest, household) || !number<int64_t>(row, PersonColumn, 0, largest, row.person) ||
				!number<int64_t>(row, HomeColumn, 0, largest, home) || !number<float>(row, AgeColumn, 0.0f, 150.0f, row.record.age) ||
				!number<float>(row, SpeedColumn, 0.01f, 20.0f, row.record.walking_speed)) {
			return false;
		}
		const std::string &gender = text(row, GenderColumn);
		if (gender != "w" && gender != "m") {
			return fail(row, GenderColumn, "bad-gender", "'" + gender + "' is not a gender of this table", "write w (woman) or m (man)");
		}
		row.record.gender = gender == "w" ? Gender::Woman : Gender::Man;
		row.home = BuildingId(_buildings.index_of(home));
		if (!is_valid(row.home)) {
			return fail(row, HomeColumn, "unknown-building", "the city has no building " + text(row, HomeColumn),
					"write the id of a building of the city's file");
		}
		return join_household(row, household);
	}

	// The place in the list of what the table says; as it was where it says nothing.
	template <typename List, typename Index> bool look(const CsvRow &row, LookColumn column, const List &list, Index &index) {
		if (_look_column[column] < 0 || row.fields[size_t(_look_column[column])].text.empty()) {
			return true;
		}
		const std::string &text = row.fields[size_t(_look_column[column])].text;
		std::vector<std::string_view> known;
		for (size_t i = 0; i < list.size(); ++i) {
			known.push_back(name_of(list[i]));
			if (known.back() == text) {
				index = Index(i);
				return true;
			}
		}
		const std::string_view closest = closest_name(text, known);
		_problem = _csv.at(row, size_t(_look_column[column]), "unknown-look", "there is no " + std::string(look_columns[column]) + " '" + text + "'",
				closest.empty() ? "leave the column empty, or write " + std::string(known.front()) : "did you mean '" + std::string(closest) + "'?");
		return false;
	}

	// Of the whole household: all members that tell it tell the same. `told` is what those before said.
	template <typename List, typename Index>
	bool shared_look(const CsvRow &row, LookColumn column, const List &list, Index &index, std::string &told) {
		const std::string text = _look_column[column] < 0 ? std::string() : row.fields[size_t(_look_column[column])].text;
		if (!text.empty() && !told.empty() && text != told) {
			_problem = _csv.at(row, size_t(_look_column[column]), "two-looks",
					"another member of the household has the " + std::string(look_columns[column]) + " '" + told + "'",
					"write the same for all members, or leave it empty");
			return false;
		}
		told = text.empty() ? told : text;
		return look(row, column, list, index);
	}

	bool join_household(Row &row, int64_t number) {
		if (_result.household_ids.index_of(number) == index_of(HouseholdId::Invalid)) {
			_result.household_ids.add(number);
			_members.emplace_back();
		}
		std::vector<Row> &members = _members[_result.household_ids.index_of(number)];
		if (!members.empty() && members.front().home != row.home) {
			return fail(row, HomeColumn, "two-homes", "household " + std::to_string(number) + " has two homes",
					"all members of a household live in one building");
		}
		if (members.size() >= UINT16_MAX) {
			return fail(row, HouseholdColumn, "household-too-large", "household " + std::to_string(number) + " has more than 65535 members",
					"split the household");
		}
		members.push_back(row);
		return true;
	}

	Result<PopulationFile> assemble() {
		Population &population = _result.population;
		for (const std::vector<Row> &members : _members) {
			Random looks(looks_seed, population.households.size());
			Household household;
			household.home = members.front().home;
			household.first_member = PersonId(uint32_t(population.persons.size()));
			household.member_count = uint16_t(members.size());
			household.family_name = uint16_t(looks.index(family_names().size()));
			household.hair_color = uint8_t(looks.index(hair_colors().size()));
			std::string family, hair;
			for (const Row &row : members) {
				if (!shared_look(*row.csv, FamilyNameColumn, family_names(), household.family_name, family) ||
						!shared_look(*row.csv, HairColumn, hair_colors(), household.hair_color, hair)) {
					return _problem;
				}
				if (!_result.person_ids.add(row.person)) {
					fail(row, PersonColumn, "repeated-person", "person " + std::to_string(row.person) + " stands in the table twice",
							"every person needs a number of its own");
					return _problem;
				}
				Person person = row.record;
				person.household = HouseholdId(uint32_t(population.households.size()));
				person.name = uint32_t(looks.index(first_names(person.gender).size()));
				person.clothes_color = uint8_t(looks.index(clothes_colors().size()));
				if (!look(*row.csv, FirstNameColumn, first_names(person.gender), person.name) ||
						!look(*row.csv, ClothesColumn, clothes_colors(), person.clothes_color)) {
					return _problem;
				}
				population.persons.push_back(person);
			}
			population.households.push_back(household);
		}
		return std::move(_result);
	}

	const CsvTable &_csv;
	const FileIds &_buildings;
	std::array<size_t, columns.size()> _column{};
	std::array<int, look_columns.size()> _look_column{}; // -1: not in the table
	Diagnostic _problem;
	PopulationFile _result;
	std::vector<std::vector<Row>> _members; // by dense household
};

} // namespace

Result<PopulationFile> parse_population(std::string_view text, std::string_view file, const FileIds &building_ids) {
	const Result<CsvTable> csv = parse_csv(text, file);
	if (!csv) {
		return csv.diagnostic();
	}
	return PeopleReader(*csv, building_ids).read();
}

Result<PopulationFile> read_population(const std::string &path, const FileIds &building_ids) {
	const Result<CsvTable> csv = read_csv(path);
	if (!csv) {
		return csv.diagnostic();
	}
	return PeopleReader(*csv, building_ids).read();
}

std::string population_to_csv(const Population &population, const FileIds *building_ids) {
	std::string text = "household,person,home,age,gender,speed,first_name,family_name,hair,clothes\n";
	for (size_t i = 0; i < population.persons.size(); ++i) {
		const Person &person = population.persons[i];
		const Household &household = population.household(person.household);
		const uint32_t home = index_of(household.home);
		const long long home_number = building_ids != nullptr ? (long long)(building_ids->number_of(home)) : (long long)(home);
		char row[160];
		std::snprintf(row, sizeof(row), "%u,%zu,%lld,%.9g,%c,%.9g", index_of(person.household), i, home_number, double(person.age),
				person.gender == Gender::Woman ? 'w' : 'm', double(person.walking_speed));
		text += row;
		const auto add = [&text](const auto &list, size_t index) { text += "," + std::string(name_of(list[index % list.size()])); };
		add(first_names(person.gender), person.name);
		add(family_names(), household.family_name);
		add(hair_colors(), household.hair_color);
		add(clothes_colors(), person.clothes_color);
		text += "\n";
	}
	return text;
}

} // namespace pcg
