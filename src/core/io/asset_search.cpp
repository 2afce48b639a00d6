#include "core/io/asset_search.h"

#include <algorithm>

#include "core/lang/source.h"

namespace pcg {

namespace {

constexpr int max_levels_up = 4; // from the rule file's folder to its project's
constexpr size_t max_listed = 100'000; // files that one search looks at
constexpr size_t max_depth = 24; // of folders; links may lead in circles

std::string with_slashes(std::string_view path) {
	std::string result(path);
	std::ranges::replace(result, '\\', '/');
	return result;
}

std::string lower(std::string_view text) {
	std::string result(text);
	for (char &c : result) {
		c = c >= 'A' && c <= 'Z' ? char(c + 32) : c;
	}
	return result;
}

std::string extension_of(std::string_view name) {
	const size_t dot = name.find_last_of('.');
	return dot == std::string_view::npos ? std::string() : std::string(name.substr(dot + 1));
}

} // namespace

Project find_project(const FileTree &files, const std::string &rule_file) {
	const std::string own = folder_of(files.absolute(with_slashes(rule_file)));
	Project project;
	project.root = own;
	std::string folder = own;
	for (int level = 0; level <= max_levels_up; ++level) {
		const bool is_rules = lower(file_name_of(folder)) == "rules";
		if (is_rules || files.has_folder(joined(folder, "assets")) || files.has_folder(joined(folder, "rules"))) {
			project.root = is_rules ? folder_of(folder) : folder;
			project.is_known = true;
			break;
		}
		if (folder_of(folder) == folder) {
			break;
		}
		folder = folder_of(folder);
	}
	project.workspace = folder_of(project.root);
	project.name = project.workspace == project.root ? std::string() : std::string(file_name_of(project.root));
	return project;
}

FileQuery::FileQuery(std::string_view text) {
	const size_t first = std::min(text.find_first_not_of(" \t\n"), text.size());
	text.remove_prefix(first);
	if (text.starts_with('$')) {
		_is_regex = _spans_workspace = true;
		_regex = Regex::compile(text.substr(1));
		return;
	}
	std::string term;
	for (size_t i = 0; i <= text.size(); ++i) {
		const bool is_kept_blank = i + 1 < text.size() && text[i] == '\\' && text[i + 1] == ' ';
		if (is_kept_blank) {
			term += text[++i];
		} else if (i == text.size() || text[i] == ' ' || text[i] == '\t' || text[i] == '\n') {
			add_term(term);
			term.clear();
		} else {
			term += text[i] == '\\' ? '/' : text[i];
		}
	}
}

void FileQuery::add_term(std::string_view text) {
	if (text.empty()) {
		return;
	}
	for (const std::string_view property : { "Name", "Ext", "Project", "Path" }) {
		if (text.starts_with(property) && text.substr(property.size()).starts_with('=')) {
			_terms.push_back({ std::string(property), std::string(text.substr(property.size() + 1)) });
			_spans_workspace = true;
			return;
		}
	}
	_terms.push_back({ {}, std::string(text) });
	_spans_workspace |= text[0] == '/' || text[0] == '*' || text[0] == '?';
}

bool FileQuery::matches(const SearchedFile &file) const {
	if (_is_regex) {
		return _regex && (_regex->matches_all(file.path) || (!file.to_project.empty() && _regex->matches_all(file.to_project)) ||
									(!file.to_assets.empty() && _regex->matches_all(file.to_assets)));
	}
	const std::string_view name = file_name_of(file.path);
	for (const Term &term : _terms) {
		const bool fits = term.property == "Name" ? matches_wildcard(term.pattern, name)
				: term.property == "Ext"			? matches_wildcard(term.pattern, extension_of(name))
				: term.property == "Project"		? matches_wildcard(term.pattern, file.project)
				: term.property == "Path"			? matches_wildcard(term.pattern, file.path)
													: matches_wildcard(term.pattern, file.path) ||
							(!file.to_project.empty() && matches_wildcard(term.pattern, file.to_project)) ||
							(!file.to_assets.empty() && matches_wildcard(term.pattern, file.to_assets));
		if (!fits) {
			return false;
		}
	}
	return !_terms.empty();
}

AssetSearch::AssetSearch(const FileTree &files, std::vector<std::string> folders) : _files(files) {
	for (const std::string &folder : folders) {
		_folders.push_back(_files.absolute(with_slashes(folder)));
	}
}

std::vector<std::string> AssetSearch::candidates(const std::string &name, const std::string &rule_file) const {
	std::vector<std::string> result;
	const std::string rule_folder = folder_of(_files.absolute(with_slashes(rule_file)));
	if (name.find("://") != std::string::npos || (name.size() > 2 && name[1] == ':' && name[2] == '/')) {
		return { name };
	}
	if (name.starts_with('/')) { // "/Project/assets/..": the workspace is one of the folders above the rule file
		for (std::string folder = rule_folder;; folder = folder_of(folder)) {
			result.push_back(resolve_import({}, joined(folder, name.substr(1))));
			if (folder_of(folder) == folder) {
				break;
			}
		}
	} else {
		const Project project = find_project(_files, rule_file);
		for (const std::string &folder : { joined(project.root, "assets"), project.root, rule_folder }) {
			result.push_back(resolve_import({}, joined(folder, name)));
		}
	}
	for (const std::string &folder : _folders) {
		result.push_back(resolve_import({}, joined(folder, name.substr(name.starts_with('/') ? 1 : 0))));
	}
	if (name.starts_with('/')) {
		result.push_back(resolve_import({}, name));
	}
	return result;
}

// The file that differs from `path` by upper and lower case only, the first by name; empty: none.
std::string AssetSearch::ignoring_case(const std::string &path) const {
	const std::string folder = folder_of(path);
	if (folder == path) {
		return {};
	}
	std::string real_folder = folder;
	if (!folder.empty() && folder_of(folder) != folder && !_files.has_folder(folder)) {
		real_folder = ignoring_case(folder);
		if (real_folder.empty()) {
			return {};
		}
	}
	const std::string wanted = lower(file_name_of(path));
	for (const FileTree::Entry &entry : _files.list(real_folder)) {
		if (lower(entry.name) == wanted) {
			return joined(real_folder, entry.name);
		}
	}
	return {};
}

std::string AssetSearch::locate(std::string_view name, const std::string &rule_file) const {
	const std::string wanted = with_slashes(name);
	if (wanted.empty() || wanted.size() > 4096 || wanted.find('\0') != std::string::npos) {
		return {};
	}
	const std::vector<std::string> paths = candidates(wanted, rule_file);
	for (const std::string &path : paths) {
		if (_files.has_file(path)) {
			return path;
		}
	}
	for (const std::string &path : paths) {
		const std::string found = ignoring_case(path);
		if (!found.empty() && _files.has_file(found)) {
			return found;
		}
	}
	return {};
}

// Names count from `folder`.
void AssetSearch::list_below(const std::string &folder, std::vector<std::string> &found) const {
	std::vector<std::pair<std::string, size_t>> open = { { "", 0 } };
	size_t left = max_listed;
	while (!open.empty() && left > 0) {
		const auto [below, depth] = open.back();
		open.pop_back();
		for (const FileTree::Entry &entry : _files.list(below.empty() ? folder : joined(folder, below))) {
			if (left-- == 0) {
				return;
			}
			if (!entry.is_folder) {
				found.push_back(joined(below, entry.name));
			} else if (depth < max_depth) {
				open.emplace_back(joined(below, entry.name), depth + 1);
			}
		}
	}
}

std::vector<std::string> AssetSearch::search(std::string_view text, const std::string &rule_file) const {
	const FileQuery query(text);
	const Project project = find_project(_files, rule_file);
	std::vector<std::string> result, files;
	const auto add = [&](const std::string &root, const std::string &name, const std::string &prefix, bool is_own) {
		files.clear();
		list_below(root, files);
		for (const std::string &file : files) {
			const std::string to_assets = file.starts_with("assets/") ? file.substr(7) : std::string();
			const SearchedFile searched{ joined(prefix, file), name, is_own ? file : std::string(), is_own ? to_assets : std::string() };
			if (query.matches(searched)) {
				result.push_back(searched.path);
			}
		}
	};
	add(project.root, project.name, project.name.empty() ? "/" : "/" + project.name, true);
	if (query.spans_workspace() && project.is_known && !project.name.empty()) {
		for (const FileTree::Entry &entry : _files.list(project.workspace)) {
			if (entry.is_folder && entry.name != project.name) {
				add(joined(project.workspace, entry.name), entry.name, "/" + entry.name, false);
			}
		}
	}
	for (const std::string &folder : _folders) {
		add(folder, std::string(file_name_of(folder)), folder, true);
	}
	std::ranges::sort(result);
	result.erase(std::unique(result.begin(), result.end()), result.end());
	return result;
}

} // namespace pcg
