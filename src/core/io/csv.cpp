#include "core/io/csv.h"

#include <algorithm>
#include <cctype>

#include "core/base/result.h"
#include "core/base/utf8.h"
#include "core/io/atomic_file.h"

namespace pcg {

namespace {

constexpr size_t max_bytes = 256u << 20;

Diagnostic file_problem(std::string_view file, std::string_view id, std::string message, std::string hint) {
	Diagnostic diagnostic;
	diagnostic.id = id;
	diagnostic.file = std::string(file);
	diagnostic.message = std::move(message);
	diagnostic.hint = std::move(hint);
	return diagnostic;
}

// The mark between fields that the header uses most.
char separator_of(std::string_view header) {
	char best = ',';
	for (char candidate : { ';', '\t' }) {
		if (std::count(header.begin(), header.end(), candidate) > std::count(header.begin(), header.end(), best)) {
			best = candidate;
		}
	}
	return best;
}

std::string column_key(std::string_view name) {
	std::string key(name);
	for (char &c : key) {
		c = c == ' ' || c == '-' ? '_' : char(std::tolower(static_cast<unsigned char>(c)));
	}
	return key;
}

std::string trimmed(std::string_view text) {
	const size_t first = text.find_first_not_of(" \t\r");
	if (first == std::string_view::npos) {
		return {};
	}
	return std::string(text.substr(first, text.find_last_not_of(" \t\r") - first + 1));
}

// Reads rows one after the other; quoted fields may hold line breaks.
class Scanner {
public:
	Scanner(std::string_view text, std::string_view file) : _text(text), _file(file) {
		if (_text.substr(0, 3) == "\xEF\xBB\xBF") {
			_at = 3;
		}
		skip_remarks();
		_separator = separator_of(rest_of_line());
	}

	bool is_at_end() {
		skip_remarks();
		return _at >= _text.size();
	}

	Result<CsvRow> read_row() {
		CsvRow row;
		row.line = _line;
		row.source = std::string(rest_of_line());
		_line_start = _at;
		while (true) {
			CsvField field;
			if (!read_field(field)) {
				go_on_behind(row);
				return file_problem_at(row);
			}
			row.fields.push_back(std::move(field));
			if (_at >= _text.size() || _text[_at] == '\n') {
				++_at;
				++_line;
				return row;
			}
			++_at; // the separator
		}
	}

private:
	std::string_view rest_of_line() const {
		const size_t end = std::min(_text.find('\n', _at), _text.size());
		std::string_view line = _text.substr(_at, end - _at);
		return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
	}

	void skip_remarks() {
		while (_at < _text.size()) {
			const std::string line = trimmed(rest_of_line());
			if (!line.empty() && line[0] != '#') {
				return;
			}
			_at = std::min(_text.find('\n', _at), _text.size() - 1) + 1;
			++_line;
		}
	}

	// Where a row with odd quotes ends cannot be told: with its line.
	void go_on_behind(const CsvRow &row) {
		_at = std::min(_text.find('\n', _line_start), _text.size() - 1) + 1;
		_line = row.line + 1;
	}

	bool read_field(CsvField &field) {
		while (_at < _text.size() && _text[_at] == ' ') {
			++_at;
		}
		field.offset = uint32_t(_at - _line_start);
		if (_at < _text.size() && _text[_at] == '"') {
			return read_quoted(field);
		}
		const size_t start = _at;
		while (_at < _text.size() && _text[_at] != _separator && _text[_at] != '\n') {
			++_at;
		}
		field.text = trimmed(_text.substr(start, _at - start));
		return true;
	}

	bool read_quoted(CsvField &field) {
		for (++_at; _at < _text.size(); ++_at) {
			if (_text[_at] != '"') {
				_line += _text[_at] == '\n';
				field.text += _text[_at];
			} else if (_at + 1 < _text.size() && _text[_at + 1] == '"') {
				field.text += _text[++_at];
			} else {
				++_at;
				while (_at < _text.size() && (_text[_at] == ' ' || _text[_at] == '\r')) {
					++_at;
				}
				return _at >= _text.size() || _text[_at] == _separator || _text[_at] == '\n';
			}
		}
		return false;
	}

	Diagnostic file_problem_at(const CsvRow &row) const {
		Diagnostic diagnostic = file_problem(_file, "bad-quotes", "the quotes of this row are not in pairs",
				"put a text that holds commas between two quotes, and write a quote inside it twice");
		diagnostic.line = row.line;
		diagnostic.column = 1;
		diagnostic.source = row.source;
		return diagnostic;
	}

	std::string_view _text;
	std::string_view _file;
	size_t _at = 0;
	size_t _line_start = 0;
	uint32_t _line = 1;
	char _separator = ',';
};

bool has_unique_columns(const CsvTable &table, Diagnostics &diagnostics) {
	for (size_t i = 0; i < table.header.fields.size(); ++i) {
		const std::string &name = table.header.fields[i].text;
		if (!name.empty() && table.find_column(column_key(name)) != int(i)) {
			diagnostics.add(table.at(table.header, i, "duplicate-column", "there are two columns '" + name + "'", "remove one of them, or name it otherwise"));
			return false;
		}
	}
	return true;
}

// Those that can be; each of the others is an error.
void read_rows(Scanner &scanner, CsvTable &table, Diagnostics &diagnostics) {
	while (!scanner.is_at_end()) {
		Result<CsvRow> row = scanner.read_row();
		if (!row) {
			diagnostics.add(row.diagnostic());
			continue;
		}
		if (row->fields.size() == table.header.fields.size()) {
			table.rows.push_back(std::move(*row));
			continue;
		}
		diagnostics.add(table.at(*row, 0, "bad-row",
				"this row has " + std::to_string(row->fields.size()) + " fields, the first line " + std::to_string(table.header.fields.size()),
				"put texts that hold commas between quotes, and leave unused fields empty"));
	}
}

} // namespace

int CsvTable::find_column(std::string_view name) const {
	for (size_t i = 0; i < header.fields.size(); ++i) {
		if (column_key(header.fields[i].text) == name) {
			return int(i);
		}
	}
	return -1;
}

Diagnostic CsvTable::at(const CsvRow &row, size_t field, std::string_view id, std::string message, std::string hint) const {
	Diagnostic diagnostic = file_problem(file, id, std::move(message), std::move(hint));
	diagnostic.line = row.line;
	const size_t before = field < row.fields.size() ? row.fields[field].offset : 0;
	const size_t behind_line = before - std::min(before, row.source.size()); // where a quoted text broke the line
	diagnostic.column = uint32_t(count_characters(first_bytes(row.source, before)) + behind_line + 1);
	diagnostic.source = row.source;
	return diagnostic;
}

bool has_rows(const CsvTable &table, Diagnostics &diagnostics) {
	if (table.rows.empty() && !diagnostics.has_errors()) { // or all of them were bad
		diagnostics.add(file_problem(table.file, "no-rows", "the table has a header but no rows", "add a row for each record"));
	}
	return !table.rows.empty();
}

std::optional<CsvTable> parse_csv(std::string_view text, std::string_view file, Diagnostics &diagnostics) {
	if (text.find('\0') != std::string_view::npos) {
		diagnostics.add(file_problem(file, "not-text", "this is not a text file", "save the table as CSV in UTF-8"));
		return std::nullopt;
	}
	Scanner scanner(text, file);
	if (scanner.is_at_end()) {
		diagnostics.add(file_problem(file, "empty-file", "the table is empty", "it needs a header and a row for each record"));
		return std::nullopt;
	}
	CsvTable table;
	table.file = std::string(file);
	Result<CsvRow> header = scanner.read_row();
	if (!header) {
		diagnostics.add(header.diagnostic());
		return std::nullopt;
	}
	table.header = std::move(*header);
	if (!has_unique_columns(table, diagnostics)) {
		return std::nullopt;
	}
	read_rows(scanner, table, diagnostics);
	return table;
}

std::optional<CsvTable> read_csv(const std::string &path, Diagnostics &diagnostics) {
	const Result<std::string> text = read_file(path, max_bytes);
	if (!text) {
		diagnostics.add(text.diagnostic());
		return std::nullopt;
	}
	return parse_csv(*text, path, diagnostics);
}

std::string csv_quoted(std::string_view text) {
	if (text.find_first_of(",;\t\"\n\r") == std::string_view::npos) {
		return std::string(text);
	}
	std::string quoted = "\"";
	for (char c : text) {
		quoted += c;
		if (c == '"') {
			quoted += c;
		}
	}
	return quoted + "\"";
}

} // namespace pcg
