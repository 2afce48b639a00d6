#pragma once

#include <cstdio>
#include <string>
#include <string_view>

#include "core/base/diagnostic.h"
#include "core/base/result.h"

// Files that are there whole or not at all.
namespace pcg {

// A file in the making: written beside its final place, put there by commit(), thrown away when it is destroyed before that. An existing
// file stays as it was until then. Folders on the way are made.
class AtomicFile {
public:
	explicit AtomicFile(std::string path);
	~AtomicFile();
	AtomicFile(const AtomicFile &) = delete;
	AtomicFile &operator=(const AtomicFile &) = delete;

	// After a failure (disk full) all further calls do nothing; commit() reports it.
	void write(std::string_view bytes);
	// Flushes to the disk and renames. False, with one error in `diagnostics`, if that or anything before it failed.
	bool commit(Diagnostics &diagnostics);

private:
	void fail(std::string_view what);

	std::string _path;
	std::string _temporary;
	std::string _failure;
	std::FILE *_file = nullptr;
};

bool write_file(const std::string &path, std::string_view bytes, Diagnostics &diagnostics);

// The whole file as bytes. Errors: missing, a folder, unreadable, larger than `limit` bytes.
Result<std::string> read_file(const std::string &path, size_t limit = size_t(1) << 31);

} // namespace pcg
