#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/regex.h"
#include "core/io/file_tree.h"

// Where the file names in rules lead to (CGA reference: cga_assetSearch, func_fileSearch).
namespace pcg {

// CityEngine's workspace is a folder of projects, each with rules/ and assets/.
struct Project {
	std::string root;
	std::string workspace; // the folder above
	std::string name; // of the root; empty: there is no folder above
	bool is_known = false; // by its folder rules or assets; else it is just the rule file's folder
};
Project find_project(const FileTree &files, const std::string &rule_file);

// One file of a workspace as queries see it.
struct SearchedFile {
	std::string path; // "/Project/assets/a.png"
	std::string project;
	std::string to_project; // "assets/a.png"; empty in other projects than the rule file's
	std::string to_assets; // "a.png"; empty if it is not in assets/
};

// Wildcards (* and ?, also across folders), a regular expression after $, or Name= Ext= Project= Path=; blanks mean and.
class FileQuery {
public:
	explicit FileQuery(std::string_view text);

	bool matches(const SearchedFile &file) const;
	// Whether files of other projects than the rule file's may fit.
	bool spans_workspace() const { return _spans_workspace; }

private:
	struct Term {
		std::string property; // empty: the whole path
		std::string pattern;
	};

	void add_term(std::string_view text);

	std::vector<Term> _terms;
	std::optional<Regex> _regex;
	bool _is_regex = false;
	bool _spans_workspace = false;
};

// `folders` are further places: of assets, and of projects for names that begin with /.
class AssetSearch {
public:
	AssetSearch(const FileTree &files, std::vector<std::string> folders);

	// Empty: there is no such file. Where it is not found as it is written, upper and lower case do not matter: rules come from Windows.
	std::string locate(std::string_view name, const std::string &rule_file) const;
	std::vector<std::string> search(std::string_view query, const std::string &rule_file) const;

private:
	std::vector<std::string> candidates(const std::string &name, const std::string &rule_file) const;
	std::string ignoring_case(const std::string &path) const;
	void list_below(const std::string &folder, std::vector<std::string> &found) const;

	const FileTree &_files;
	std::vector<std::string> _folders;
};

} // namespace pcg
