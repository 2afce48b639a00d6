#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"

// Files and folders by path: this machine's, an engine's packed resources, a table in a test.
namespace pcg {

// Safe to ask from several threads.
class FileTree {
public:
	struct Entry {
		std::string name;
		bool is_folder = false;
	};

	virtual ~FileTree() = default;
	virtual bool has_file(const std::string &path) const = 0;
	virtual bool has_folder(const std::string &path) const = 0;
	// Sorted by name, without hidden ones (.git); empty if there is no such folder.
	virtual std::vector<Entry> list(const std::string &folder) const = 0;
	virtual Result<std::string> read(const std::string &path, size_t limit) const = 0;
	// With `/` only, and so that the folders above can be told.
	virtual std::string absolute(const std::string &path) const { return path; }
};

class DiskTree final : public FileTree {
public:
	bool has_file(const std::string &path) const override;
	bool has_folder(const std::string &path) const override;
	std::vector<Entry> list(const std::string &folder) const override;
	Result<std::string> read(const std::string &path, size_t limit) const override;
	std::string absolute(const std::string &path) const override;
};

class MemoryTree final : public FileTree {
public:
	void add(std::string path, std::string bytes) { _files[std::move(path)] = std::move(bytes); }
	bool has_file(const std::string &path) const override { return _files.contains(path); }
	bool has_folder(const std::string &path) const override { return !list(path).empty(); }
	std::vector<Entry> list(const std::string &folder) const override;
	Result<std::string> read(const std::string &path, size_t limit) const override;

private:
	std::map<std::string, std::string> _files;
};

// "a/b" of "a/b/c"; tops ("/", "res://", "") are their own.
std::string folder_of(const std::string &path);
std::string joined(const std::string &folder, std::string_view name);
std::string_view file_name_of(std::string_view path);

} // namespace pcg
