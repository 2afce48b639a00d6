#include "core/io/text_asset.h"

#include <algorithm>

namespace pcg {

namespace {

void append_utf8(std::string &text, uint32_t code) {
	if (code < 0x80) {
		text += char(code);
	} else if (code < 0x800) {
		text += char(0xC0 | code >> 6);
		text += char(0x80 | (code & 0x3F));
	} else if (code < 0x10000) {
		text += char(0xE0 | code >> 12);
		text += char(0x80 | (code >> 6 & 0x3F));
		text += char(0x80 | (code & 0x3F));
	} else {
		text += char(0xF0 | code >> 18);
		text += char(0x80 | (code >> 12 & 0x3F));
		text += char(0x80 | (code >> 6 & 0x3F));
		text += char(0x80 | (code & 0x3F));
	}
}

std::string from_utf16(std::string_view bytes, bool is_big_endian) {
	const auto unit = [&](size_t i) {
		const uint32_t first = uint8_t(bytes[i]), second = uint8_t(bytes[i + 1]);
		return is_big_endian ? first << 8 | second : second << 8 | first;
	};
	std::string text;
	for (size_t i = 0; i + 1 < bytes.size(); i += 2) {
		uint32_t code = unit(i);
		if (code >= 0xD800 && code < 0xDC00 && i + 3 < bytes.size() && unit(i + 2) >= 0xDC00 && unit(i + 2) < 0xE000) {
			code = 0x10000 + ((code - 0xD800) << 10) + (unit(i + 2) - 0xDC00);
			i += 2;
		} else if (code >= 0xD800 && code < 0xE000) {
			code = '?';
		}
		append_utf8(text, code);
	}
	return text;
}

// How many bytes follow the first one of a character; 4: this cannot begin one.
size_t utf8_tail(uint8_t first) {
	return first < 0x80 ? 0 : first < 0xC2 ? 4 : first < 0xE0 ? 1 : first < 0xF0 ? 2 : first < 0xF5 ? 3 : 4;
}

bool is_utf8(std::string_view bytes) {
	for (size_t i = 0; i < bytes.size(); ++i) {
		const size_t tail = utf8_tail(uint8_t(bytes[i]));
		if (tail == 4 || i + tail >= bytes.size()) {
			return false;
		}
		for (size_t k = 0; k < tail; ++k) {
			if ((uint8_t(bytes[++i]) & 0xC0) != 0x80) {
				return false;
			}
		}
	}
	return true;
}

std::string to_utf8(std::string_view bytes) {
	if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
		return from_utf16(bytes.substr(2), bytes[0] == '\xFE');
	}
	if (bytes.starts_with("\xEF\xBB\xBF")) {
		bytes.remove_prefix(3);
	}
	if (is_utf8(bytes)) {
		return std::string(bytes);
	}
	std::string text;
	for (char c : bytes) {
		append_utf8(text, uint8_t(c));
	}
	return text;
}

char separator_of(std::string_view text) {
	const std::string_view line = text.substr(0, text.find('\n'));
	char best = ' ';
	std::ptrdiff_t most = 0;
	for (char candidate : { ',', ';', '\t' }) {
		const std::ptrdiff_t count = std::count(line.begin(), line.end(), candidate);
		if (count > most) {
			best = candidate;
			most = count;
		}
	}
	return best;
}

// Reads one field and leaves `at` on what ends it.
std::string read_field(std::string_view text, size_t &at, char separator) {
	std::string field;
	while (at < text.size() && text[at] == ' ') {
		++at;
	}
	if (at < text.size() && text[at] == '"') {
		for (++at; at < text.size() && (text[at] != '"' || (at + 1 < text.size() && text[at + 1] == '"')); ++at) {
			field += text[at];
			at += text[at] == '"' ? 1 : 0;
		}
		at = std::min(text.find_first_of(std::string{ separator, '\n' }, std::min(at + 1, text.size())), text.size());
		return field;
	}
	const size_t end = std::min(text.find_first_of(std::string{ separator, '\n' }, at), text.size());
	field = text.substr(at, end - at);
	field.erase(field.find_last_not_of(' ') + 1);
	at = end;
	return field;
}

} // namespace

std::string decode_text(std::string_view bytes) {
	std::string text = to_utf8(bytes);
	size_t kept = 0;
	for (size_t i = 0; i < text.size(); ++i) {
		const char c = text[i];
		if (c == '\r') {
			i += i + 1 < text.size() && text[i + 1] == '\n' ? 1 : 0;
			text[kept++] = '\n';
		} else {
			text[kept++] = (uint8_t(c) < 32 && c != '\n' && c != '\t') || c == 127 ? '?' : c;
		}
	}
	text.resize(kept);
	return text;
}

TextTable parse_table(std::string_view text) {
	const char separator = separator_of(text);
	std::vector<std::vector<std::string>> rows;
	size_t columns = 0;
	for (size_t at = 0; at < text.size();) {
		auto &row = rows.emplace_back();
		for (bool is_row_over = false; !is_row_over;) {
			row.push_back(read_field(text, at, separator));
			is_row_over = at >= text.size() || text[at] == '\n';
			++at;
		}
		const bool is_blank = row.size() == 1 && row[0].empty();
		if (is_blank) {
			rows.pop_back();
			continue;
		}
		if (separator == ' ') {
			std::erase(row, std::string());
		}
		columns = std::max(columns, row.size());
	}
	TextTable table;
	table.rows = uint32_t(rows.size());
	table.columns = uint32_t(columns);
	for (std::vector<std::string> &row : rows) {
		row.resize(columns);
		std::ranges::move(row, std::back_inserter(table.cells));
	}
	return table;
}

} // namespace pcg
