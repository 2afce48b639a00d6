#include "core/lang/source.h"

#include <algorithm>

#include "core/base/utf8.h"

namespace pcg {

Source::Source(std::string name, std::string text) : _name(std::move(name)), _text(std::move(text)) {
	_line_starts.push_back(0);
	for (size_t i = 0; i < _text.size(); ++i) {
		const bool is_lone_return = _text[i] == '\r' && (i + 1 == _text.size() || _text[i + 1] != '\n');
		if (_text[i] == '\n' || is_lone_return) {
			_line_starts.push_back(uint32_t(i + 1));
		}
		if (!starts_character(_text[i])) {
			_inner_bytes.push_back(uint32_t(i));
		}
	}
}

Source::Position Source::position(uint32_t offset) const {
	const auto after = std::upper_bound(_line_starts.begin(), _line_starts.end(), offset);
	const uint32_t line = uint32_t(after - _line_starts.begin());
	const uint32_t start = _line_starts[line - 1];
	const auto inner = std::lower_bound(_inner_bytes.begin(), _inner_bytes.end(), start);
	const auto inner_end = std::lower_bound(inner, _inner_bytes.end(), offset);
	return { line, offset - start - uint32_t(inner_end - inner) + 1 };
}

std::string_view Source::line(uint32_t line_number) const {
	if (line_number == 0 || line_number > _line_starts.size()) {
		return {};
	}
	const uint32_t start = _line_starts[line_number - 1];
	const uint32_t end = line_number < _line_starts.size() ? _line_starts[line_number] : uint32_t(_text.size());
	std::string_view text = std::string_view(_text).substr(start, end - start);
	while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) {
		text.remove_suffix(1);
	}
	return text;
}

Diagnostic Source::diagnostic(Severity severity, std::string_view id, uint32_t offset, std::string message, std::string hint) const {
	const Position at = position(offset);
	return { severity, id, _name, at.line, at.column, std::move(message), std::move(hint), excerpt(at.line, at.column) };
}

std::string Source::excerpt(uint32_t line_number, uint32_t column) const {
	constexpr uint32_t longest = 2000; // bytes: a diagnostic holds it for good, and there may be hundreds
	return column > longest ? std::string() : std::string(first_bytes(line(line_number), longest));
}

namespace {

// Length of the well-formed UTF-8 sequence at `i`, 0 if there is none.
size_t utf8_length(const std::string &bytes, size_t i) {
	const auto at = [&](size_t k) { return k < bytes.size() ? uint8_t(bytes[k]) : uint8_t(0); };
	const auto follows = [&](size_t k) { return (at(k) & 0xC0) == 0x80; };
	const uint8_t first = at(i);
	if (first < 0x80) {
		return 1;
	}
	if (first >= 0xC2 && first <= 0xDF) {
		return follows(i + 1) ? 2 : 0;
	}
	if (first >= 0xE0 && first <= 0xEF) {
		return follows(i + 1) && follows(i + 2) ? 3 : 0;
	}
	if (first >= 0xF0 && first <= 0xF4) {
		return follows(i + 1) && follows(i + 2) && follows(i + 3) ? 4 : 0;
	}
	return 0;
}

size_t first_bad_utf8(const std::string &bytes) {
	for (size_t i = 0; i < bytes.size();) {
		const size_t length = utf8_length(bytes, i);
		if (length == 0) {
			return i;
		}
		i += length;
	}
	return std::string::npos;
}

std::string latin1_to_utf8(const std::string &bytes) {
	std::string text;
	text.reserve(bytes.size() + bytes.size() / 8);
	for (char c : bytes) {
		const uint8_t byte = uint8_t(c);
		if (byte < 0x80) {
			text += c;
		} else {
			text += char(0xC0 | (byte >> 6));
			text += char(0x80 | (byte & 0x3F));
		}
	}
	return text;
}

bool refuse(const std::string &name, std::string_view id, std::string message, std::string hint, Diagnostics &diagnostics) {
	diagnostics.add({ Severity::Error, id, name, 0, 0, std::move(message), std::move(hint), {} });
	return false;
}

} // namespace

bool decode_rule_text(const std::string &name, std::string &bytes, Diagnostics &diagnostics) {
	constexpr size_t max_size = size_t(64) << 20;
	if (bytes.size() > max_size) {
		return refuse(name, "file-too-large", "the file has " + std::to_string(bytes.size() >> 20) + " MiB; a rule file has at most 64",
				"is this a rule file?", diagnostics);
	}
	if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
		return refuse(name, "not-utf-8", "the file is UTF-16", "save it as UTF-8", diagnostics);
	}
	if (bytes.find('\0') != std::string::npos) {
		return refuse(name, "binary-file", "the file is binary, not rule text", "is this the right file?", diagnostics);
	}
	if (bytes.starts_with("\xEF\xBB\xBF")) {
		bytes.erase(0, 3);
	}
	if (bytes.find_first_not_of(" \t\r\n\f\v") == std::string::npos) {
		return refuse(name, "empty-file", "the file is empty", "a rule file has at least one rule: Name --> commands", diagnostics);
	}
	const size_t bad = first_bad_utf8(bytes);
	if (bad != std::string::npos) {
		const uint32_t line = 1 + uint32_t(std::count(bytes.begin(), bytes.begin() + std::ptrdiff_t(bad), '\n'));
		const size_t line_start = bytes.rfind('\n', bad) == std::string::npos ? 0 : bytes.rfind('\n', bad) + 1;
		diagnostics.add({ Severity::Warning, "not-utf-8", name, line, uint32_t(bad - line_start + 1),
				"the file is not UTF-8; it is read as Latin-1", "save it as UTF-8", {} });
		bytes = latin1_to_utf8(bytes);
	}
	return true;
}

namespace {

// Everything up to the part that "." and ".." walk in: "res://", "/", "C:/", or nothing.
size_t root_length(std::string_view path) {
	const size_t scheme = path.find("://");
	if (scheme != std::string_view::npos) {
		return scheme + 3;
	}
	if (path.size() > 2 && path[1] == ':' && path[2] == '/') {
		return 3;
	}
	return path.starts_with('/') ? 1 : 0;
}

} // namespace

std::string resolve_import(std::string_view importer, std::string_view path) {
	std::string joined(path);
	std::replace(joined.begin(), joined.end(), '\\', '/');
	if (root_length(joined) == 0) {
		const size_t slash = importer.find_last_of("/\\");
		joined.insert(0, slash == std::string_view::npos ? std::string_view() : importer.substr(0, slash + 1));
		std::replace(joined.begin(), joined.end(), '\\', '/');
	}
	const size_t root = root_length(joined);
	std::vector<std::string_view> parts;
	const std::string_view rest = std::string_view(joined).substr(root);
	for (size_t start = 0; start <= rest.size();) {
		const size_t end = std::min(rest.find('/', start), rest.size());
		const std::string_view part = rest.substr(start, end - start);
		if (part == ".." && !parts.empty() && parts.back() != "..") {
			parts.pop_back();
		} else if (!part.empty() && part != "." && (part != ".." || root == 0)) {
			parts.push_back(part);
		}
		start = end + 1;
	}
	std::string result = joined.substr(0, root);
	for (size_t i = 0; i < parts.size(); ++i) {
		result += (i > 0 ? "/" : "") + std::string(parts[i]);
	}
	return result;
}

namespace {

constexpr int max_levels_up = 8;

// "a/b/" of "a/b/c"; of "a/", too. Relative paths go on with "../".
std::string folder_above(const std::string &path) {
	const size_t root = root_length(path);
	const std::string_view below = std::string_view(path).substr(root);
	const std::string_view rest = below.ends_with('/') ? below.substr(0, below.size() - 1) : below;
	if (rest.empty() || rest == ".." || rest.ends_with("/..")) {
		return root > 0 ? path : path + "../";
	}
	const size_t slash = rest.find_last_of('/');
	return path.substr(0, root + (slash == std::string_view::npos ? 0 : slash + 1));
}

} // namespace

std::string find_import(SourceProvider &provider, const std::string &importer, std::string_view path) {
	const std::string first = resolve_import(importer, path);
	const bool counts_from_workspace = path.starts_with('/') || path.starts_with('\\');
	if (path.empty() || (!counts_from_workspace && (root_length(path) > 0 || provider.has(first)))) {
		return first;
	}
	std::string folder = importer;
	std::replace(folder.begin(), folder.end(), '\\', '/');
	for (int level = 0; level < max_levels_up; ++level) {
		const std::string above = folder_above(folder);
		if (above == folder) {
			break;
		}
		folder = above;
		if (counts_from_workspace) {
			const std::string candidate = resolve_import({}, folder + std::string(path.substr(1)));
			if (provider.has(candidate)) {
				return candidate;
			}
		} else if (folder.ends_with("/rules/") || folder == "rules/") {
			const std::string candidate = resolve_import({}, folder + std::string(path));
			return provider.has(candidate) ? candidate : first;
		}
	}
	return first;
}

} // namespace pcg
