#include "core/io/population_csv.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "core/base/random.h"
#include "core/io/csv.h"
#include "core/population/names.h"

namespace pcg {

namespace {

constexpr std::array<std::string_view, 6> columns{ "household", "person", "home", "age", "gender", "speed" };
enum Column : size_t { HouseholdColumn, PersonColumn, HomeColumn, AgeColumn, GenderColumn, SpeedColumn };

constexpr uint64_t looks_seed = hash_text("looks"); // names and colors are not in the table: they follow from the ids

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
			for (const Row &row : members) {
				if (!_result.person_ids.add(row.person)) {
					fail(row, PersonColumn, "repeated-person", "person " + std::to_string(row.person) + " stands in the table twice",
							"every person needs a number of its own");
					return _problem;
				}
				Person person = row.record;
				person.household = HouseholdId(uint32_t(population.households.size()));
				person.name = uint32_t(looks.index(first_names(person.gender).size()));
				person.clothes_color = uint8_t(looks.index(clothes_colors().size()));
				population.persons.push_back(person);
			}
			population.households.push_back(household);
		}
		return std::move(_result);
	}

	const CsvTable &_csv;
	const FileIds &_buildings;
	std::array<size_t, columns.size()> _column{};
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
	std::string text = "household,person,home,age,gender,speed\n";
	for (size_t i = 0; i < population.persons.size(); ++i) {
		const Person &person = population.persons[i];
		const uint32_t home = index_of(population.household(person.household).home);
		const long long home_number = building_ids != nullptr ? (long long)(building_ids->number_of(home)) : (long long)(home);
		char row[160];
		std::snprintf(row, sizeof(row), "%u,%zu,%lld,%.9g,%c,%.9g\n", index_of(person.household), i, home_number, double(person.age),
				person.gender == Gender::Woman ? 'w' : 'm', double(person.walking_speed));
		text += row;
	}
	return text;
}

} // namespace pcg
