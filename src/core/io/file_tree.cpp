#include "core/io/file_tree.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>

#include "core/io/atomic_file.h"

namespace pcg {

namespace {

bool is_top(std::string_view path) {
	return path.empty() || path == "/" || path.ends_with("://") || (path.size() == 3 && path.substr(1) == ":/");
}

void sort_by_name(std::vector<FileTree::Entry> &entries) {
	std::ranges::sort(entries, {}, &FileTree::Entry::name);
}

} // namespace

std::string folder_of(const std::string &path) {
	if (is_top(path)) {
		return path;
	}
	const size_t slash = path.find_last_of('/');
	if (slash == std::string::npos) {
		return {};
	}
	const std::string with_slash = path.substr(0, slash + 1);
	return is_top(with_slash) ? with_slash : path.substr(0, slash);
}

std::string joined(const std::string &folder, std::string_view name) {
	const bool needs_slash = !folder.empty() && !folder.ends_with('/');
	return folder + (needs_slash ? "/" : "") + std::string(name);
}

std::string_view file_name_of(std::string_view path) {
	const size_t slash = path.find_last_of("/\\");
	return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

bool DiskTree::has_file(const std::string &path) const {
	std::error_code error;
	return std::filesystem::is_regular_file(path, error);
}

bool DiskTree::has_folder(const std::string &path) const {
	std::error_code error;
	return std::filesystem::is_directory(path.empty() ? "." : path, error);
}

std::vector<FileTree::Entry> DiskTree::list(const std::string &folder) const {
	std::vector<Entry> entries;
	std::error_code error;
	std::filesystem::directory_iterator entry(folder.empty() ? "." : folder, std::filesystem::directory_options::skip_permission_denied, error);
	for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
		std::string name = entry->path().filename().generic_string();
		std::error_code ignored;
		const bool is_folder = entry->is_directory(ignored);
		if (!name.starts_with('.') && (is_folder || entry->is_regular_file(ignored))) {
			entries.push_back({ std::move(name), is_folder });
		}
	}
	sort_by_name(entries);
	return entries;
}

Result<std::string> DiskTree::read(const std::string &path, size_t limit) const {
	return read_file(path, limit);
}

std::string DiskTree::absolute(const std::string &path) const {
	std::error_code error;
	const std::filesystem::path full = std::filesystem::absolute(path, error);
	return error ? path : full.lexically_normal().generic_string();
}

std::vector<FileTree::Entry> MemoryTree::list(const std::string &folder) const {
	const std::string start = joined(folder, "");
	std::set<std::pair<std::string, bool>> found;
	for (const auto &[path, bytes] : _files) {
		if (path.starts_with(start)) {
			const std::string rest = path.substr(start.size());
			const size_t slash = rest.find('/');
			found.emplace(rest.substr(0, slash), slash != std::string::npos);
		}
	}
	std::vector<Entry> entries;
	for (const auto &[name, is_folder] : found) {
		entries.push_back({ name, is_folder });
	}
	return entries;
}

Result<std::string> MemoryTree::read(const std::string &path, size_t limit) const {
	const auto found = _files.find(path);
	if (found == _files.end() || found->second.size() > limit) {
		return Diagnostic{ Severity::Error, "cannot-read-file", path, 0, 0, "there is no such file", "check the name", {} };
	}
	return found->second;
}

} // namespace pcg
