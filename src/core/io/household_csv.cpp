#include "core/io/household_csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>

#include "core/base/result.h"
#include "core/io/csv.h"
#include "core/population/household_words.h"

namespace pcg {

namespace {

constexpr int most_told = 1'000'000; // members of a cell; there are max_members at most
constexpr int oldest_told = 120; // years
constexpr size_t max_rows = 65'535; // a household keeps the row it was drawn from in 16 bits

int find_first_column(const CsvTable &csv, std::initializer_list<std::string_view> names) {
	for (std::string_view name : names) {
		if (const int column = csv.find_column(name); column >= 0) {
			return column;
		}
	}
	return -1;
}

struct Amount {
	int count = 0;
	bool is_open = false;
};

// Turns rows into patterns; every row that cannot be is an error, but for a household that is too large, which is left out with a warning.
class TableReader {
public:
	explicit TableReader(CsvTable &csv) : _csv(csv) {}

	// Not to be used after an error.
	HouseholdTable read(Diagnostics &diagnostics) {
		HouseholdTable table;
		table.file = _csv.file;
		if (!find_columns(diagnostics) || !has_rows(_csv, diagnostics)) {
			return table;
		}
		if (_csv.rows.size() > max_rows) {
			diagnostics.add(_csv.at(_csv.rows[max_rows], 0, "too-many-rows", "the table has more than 65535 kinds of households",
					"join rows that describe the same household"));
			return table;
		}
		double total = 0.0;
		for (const CsvRow &row : _csv.rows) {
			Result<HouseholdPattern> pattern = read_row(row);
			if (!pattern) {
				diagnostics.add(pattern.diagnostic());
				continue;
			}
			total += pattern->weight;
			table.patterns.push_back(std::move(*pattern));
		}
		if (!(total > 0.0) && !diagnostics.has_errors()) {
			diagnostics.add(_csv.at(_csv.rows.front(), size_t(_count), "no-households",
					table.patterns.empty() ? "no row is left: all households are too large" : "all counts are 0", "at least one kind of household has to occur"));
		}
		return table;
	}

private:
	bool find_columns(Diagnostics &diagnostics) {
		_descriptor = find_first_column(_csv, { "descriptor", "household", "household_type", "type", "composition" });
		_count = find_first_column(_csv, { "count", "households", "number", "occurrences" });
		if (_descriptor >= 0 && _count >= 0) {
			return true;
		}
		if (begins_with_a_row()) {
			_csv.rows.insert(_csv.rows.begin(), _csv.header);
			_descriptor = 0;
			_count = 1;
			return true;
		}
		diagnostics.add(_csv.at(_csv.header, 0, "missing-column",
				std::string("the first line names no column '") + (_descriptor < 0 ? "descriptor" : "count") + "'",
				"the first line has to name the columns: descriptor,count; it may be missing only where each row is a descriptor and a count"));
		return false;
	}

	// A table without a header: descriptor and count.
	bool begins_with_a_row() const {
		const std::vector<CsvField> &fields = _csv.header.fields;
		double value = 0.0;
		return _descriptor < 0 && _count < 0 && fields.size() == 2 && !fields[0].text.empty() &&
				std::from_chars(fields[1].text.data(), fields[1].text.data() + fields[1].text.size(), value).ec == std::errc();
	}

	Result<HouseholdPattern> read_row(const CsvRow &row) {
		const std::string &descriptor = row.fields[size_t(_descriptor)].text;
		if (descriptor.starts_with("..")) {
			return _csv.at(row, size_t(_descriptor), "sub-row", "'" + descriptor + "' is a part of a row above and counted there already",
					"take its count off that row, and write the whole descriptor without the dots");
		}
		if (descriptor.starts_with("Total ") || descriptor.starts_with("total ") || descriptor == "Total" || descriptor == "total") {
			return _csv.at(row, size_t(_descriptor), "total-row", "'" + descriptor + "' counts the households of other rows once more",
					"remove this row");
		}
		const Result<double> weight = read_count(row);
		if (!weight) {
			return weight.diagnostic();
		}
		Result<HouseholdPattern> pattern = has_columns(row) ? read_columns(row) : read_words(row, descriptor);
		if (pattern) {
			pattern->descriptor = descriptor;
			pattern->weight = *weight;
		}
		return pattern;
	}

	Result<double> read_count(const CsvRow &row) const {
		const std::string &text = row.fields[size_t(_count)].text;
		double value = 0.0;
		const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
		if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
			return _csv.at(row, size_t(_count), "not-a-number", "'" + text + "' is not a number of households",
					"write digits only, without marks for thousands");
		}
		if (value < 0.0) {
			return _csv.at(row, size_t(_count), "negative-count", "a negative number of households: " + text,
					"counts are 0 or larger");
		}
		constexpr double most = 1e12;
		if (value != std::floor(value) || value > most) {
			return _csv.at(row, size_t(_count), "not-a-number",
					"'" + text + "' is not a number of households" + (value > most ? ": it is beyond 1000000000000" : ": households are counted whole"),
					"write a whole number");
		}
		return value;
	}

	Result<HouseholdPattern> read_words(const CsvRow &row, const std::string &descriptor) {
		const Result<Amount> from = cell(row, "adult_from", adult_age);
		if (!from) {
			return from.diagnostic();
		}
		Result<HouseholdPattern> pattern = read_household_words(descriptor, std::clamp(from->count, 1, 30));
		if (!pattern) {
			return problem_at(row, pattern.diagnostic());
		}
		return pattern;
	}

	Diagnostic problem_at(const CsvRow &row, const Diagnostic &problem) const {
		Diagnostic diagnostic = _csv.at(row, size_t(_descriptor), problem.id,
				"\"" + row.fields[size_t(_descriptor)].text + "\": " + problem.message, problem.hint);
		diagnostic.severity = problem.severity;
		return diagnostic;
	}

	bool has_columns(const CsvRow &row) const {
		for (std::string_view name : { "adults", "elders", "minors" }) {
			const int column = _csv.find_column(name);
			if (column >= 0 && !row.fields[size_t(column)].text.empty()) {
				return true;
			}
		}
		return false;
	}

	// A number of persons or an age; `fallback` where the column or its text is missing.
	Result<Amount> cell(const CsvRow &row, std::string_view name, int fallback) const {
		const int column = _csv.find_column(name);
		if (column < 0 || row.fields[size_t(column)].text.empty()) {
			return Amount{ fallback, false };
		}
		std::string_view text = row.fields[size_t(column)].text;
		Amount amount;
		if (text.ends_with('+')) {
			amount.is_open = true;
			text.remove_suffix(1);
		}
		const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), amount.count);
		const bool is_large = error == std::errc::result_out_of_range && text[0] != '-';
		const bool is_age = name.ends_with("_age") || name == "adult_from";
		amount.count = is_large ? most_told : std::min(amount.count, most_told);
		if ((error != std::errc() && !is_large) || end != text.data() + text.size() || amount.count < 0 || (is_age && amount.count > oldest_told)) {
			return _csv.at(row, size_t(column), "not-a-number",
					"'" + row.fields[size_t(column)].text + "' is not a value for '" + std::string(name) + "'",
					is_age ? "write an age in whole years, 0 to " + std::to_string(oldest_told) : "write a whole number, or 2+ for two or more");
		}
		return amount;
	}

	struct Cells {
		Amount adults, elders, minors, women, men, min_age, max_age, adult_from;
	};

	Result<HouseholdPattern> read_columns(const CsvRow &row) {
		Cells cells;
		const std::array<std::pair<std::string_view, Amount *>, 8> targets{ { { "adults", &cells.adults },
				{ "elders", &cells.elders }, { "minors", &cells.minors }, { "women", &cells.women }, { "men", &cells.men },
				{ "adult_from", &cells.adult_from }, { "min_age", &cells.min_age }, { "max_age", &cells.max_age } } };
		for (const auto &[name, target] : targets) {
			const int fallback = name == "max_age" ? 99 : name == "min_age" ? -1 : name == "adult_from" ? adult_age : 0;
			const Result<Amount> amount = cell(row, name, fallback);
			if (!amount) {
				return amount.diagnostic();
			}
			*target = *amount;
		}
		if (cells.min_age.count < 0) {
			cells.min_age.count = cells.adult_from.count;
		}
		return pattern_of(row, cells);
	}

	Result<HouseholdPattern> pattern_of(const CsvRow &row, const Cells &cells) const {
		const int grown = cells.adults.count + cells.elders.count;
		if (grown == 0) {
			return bad_columns(row, "a household needs at least one adult or elder");
		}
		if (grown + cells.minors.count > max_members) {
			return problem_at(row, too_large_household());
		}
		if (cells.women.count + cells.men.count > grown) {
			return bad_columns(row, "women and men together are more than adults and elders");
		}
		if (cells.max_age.count < cells.min_age.count || cells.min_age.count > 99 || cells.adult_from.count < 1) {
			return bad_columns(row, "the ages leave nobody");
		}
		HouseholdPattern pattern;
		int women = cells.women.count;
		int men = cells.men.count;
		add_grown(pattern, cells.adults, women, men, uint8_t(cells.min_age.count), uint8_t(std::min(cells.max_age.count, 99)));
		add_grown(pattern, cells.elders, women, men, uint8_t(elder_age), 99);
		if (cells.minors.count > 0 || cells.minors.is_open) {
			pattern.groups.push_back({ uint8_t(cells.minors.count), cells.minors.is_open, MemberGroup::Sex::Any, true, 0,
					uint8_t(std::min(cells.adult_from.count, 99) - 1) });
		}
		pattern.is_couple = grown == 2 && cells.women.count == 1 && cells.men.count == 1;
		return pattern;
	}

	static void add_grown(HouseholdPattern &pattern, Amount amount, int &women, int &men, uint8_t first, uint8_t last) {
		const int some_women = std::min(women, amount.count);
		const int some_men = std::min(men, amount.count - some_women);
		const int others = amount.count - some_women - some_men;
		women -= some_women;
		men -= some_men;
		const std::array<std::pair<MemberGroup::Sex, int>, 3> parts{ { { MemberGroup::Sex::Woman, some_women },
				{ MemberGroup::Sex::Man, some_men }, { MemberGroup::Sex::Any, others } } };
		for (const auto &[sex, count] : parts) {
			const bool is_open = amount.is_open && sex == MemberGroup::Sex::Any;
			if (count > 0 || is_open) {
				pattern.groups.push_back({ uint8_t(count), is_open, sex, false, first, last });
			}
		}
	}

	Diagnostic bad_columns(const CsvRow &row, std::string message) const {
		return _csv.at(row, size_t(_descriptor), "bad-household", "\"" + row.fields[size_t(_descriptor)].text + "\": " + message,
				"correct the columns adults, elders, minors, women, men, min_age, max_age, adult_from of this row");
	}

	CsvTable &_csv;
	int _descriptor = -1;
	int _count = -1;
};

std::optional<HouseholdTable> read_table(std::optional<CsvTable> csv, Diagnostics &found, Diagnostics &diagnostics) {
	return read_records(std::move(csv), found, diagnostics, [&](CsvTable &table) { return TableReader(table).read(found); });
}

} // namespace

std::optional<HouseholdTable> parse_household_table(std::string_view text, std::string_view file, Diagnostics &diagnostics) {
	Diagnostics found(max_table_problems);
	return read_table(parse_csv(text, file, found), found, diagnostics);
}

std::optional<HouseholdTable> read_household_table(const std::string &path, Diagnostics &diagnostics) {
	Diagnostics found(max_table_problems);
	return read_table(read_csv(path, found), found, diagnostics);
}

} // namespace pcg
