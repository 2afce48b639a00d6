#include "core/io/atomic_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

#ifdef _WIN32
#include <io.h>
#include <process.h>
#else
#include <unistd.h>
#endif

namespace pcg {

namespace {

#ifdef _WIN32
bool flush_to_disk(std::FILE *file) { return std::fflush(file) == 0 && _commit(_fileno(file)) == 0; }
int process_id() { return _getpid(); }
#else
bool flush_to_disk(std::FILE *file) {
	// Pipes and some network file systems cannot sync (EINVAL); what they can do is done by then.
	return std::fflush(file) == 0 && (fsync(fileno(file)) == 0 || errno == EINVAL);
}
int process_id() { return int(getpid()); }
#endif

Diagnostic file_error(std::string_view id, const std::string &path, std::string message, std::string hint) {
	return { Severity::Error, id, path, 0, 0, std::move(message), std::move(hint), {} };
}

} // namespace

AtomicFile::AtomicFile(std::string path) : _path(std::move(path)) {
	namespace fs = std::filesystem;
	std::error_code error;
	if (_path.empty() || fs::is_directory(_path, error)) {
		_failure = _path.empty() ? "the file name is empty" : "this is a folder";
		return;
	}
	const fs::path folder = fs::path(_path).parent_path();
	if (!folder.empty() && !fs::is_directory(folder, error) && !fs::create_directories(folder, error)) {
		_failure = "cannot make the folder `" + folder.string() + "`: " + error.message();
		return;
	}
	// A link keeps pointing where it points; a device or a pipe would be replaced by the finished file.
	if (fs::is_symlink(_path, error)) {
		const fs::path target = fs::weakly_canonical(_path, error);
		_path = error ? _path : target.string();
	}
	if (fs::exists(_path, error) && !fs::is_regular_file(_path, error)) {
		_failure = "this is a device or a pipe, not a file";
		return;
	}
	_temporary = _path + "." + std::to_string(process_id()) + ".tmp";
	_file = std::fopen(_temporary.c_str(), "wb");
	if (!_file) {
		fail("cannot write here");
	}
}

AtomicFile::~AtomicFile() {
	if (_file) {
		std::fclose(_file);
		std::remove(_temporary.c_str());
	}
}

void AtomicFile::write(std::string_view bytes) {
	if (_file && std::fwrite(bytes.data(), 1, bytes.size(), _file) != bytes.size()) {
		fail("cannot write all of it");
	}
}

bool AtomicFile::commit(Diagnostics &diagnostics) {
	if (_file && !flush_to_disk(_file)) {
		fail("cannot write all of it");
	}
	if (_file) {
		std::fclose(_file);
		_file = nullptr;
		std::error_code error;
		std::filesystem::rename(_temporary, _path, error);
		if (error) {
			std::remove(_temporary.c_str());
			_failure = "cannot put the finished file in its place: " + error.message();
		}
	}
	if (!_failure.empty()) {
		diagnostics.add(file_error("cannot-write-file", _path, _failure, "name a file in a folder that you may write to"));
		return false;
	}
	return true;
}

void AtomicFile::fail(std::string_view what) {
	_failure = std::string(what) + ": " + std::strerror(errno);
	if (_file) {
		std::fclose(_file);
		std::remove(_temporary.c_str());
		_file = nullptr;
	}
}

bool write_file(const std::string &path, std::string_view bytes, Diagnostics &diagnostics) {
	AtomicFile file(path);
	file.write(bytes);
	return file.commit(diagnostics);
}

Result<std::string> read_file(const std::string &path, size_t limit) {
	std::error_code error;
	if (std::filesystem::is_directory(path, error)) {
		return file_error("cannot-read-file", path, "this is a folder", "name a file");
	}
	std::FILE *file = std::fopen(path.c_str(), "rb");
	if (!file) {
		return file_error("cannot-read-file", path, std::string("cannot open this file: ") + std::strerror(errno),
				"check the name and its folder");
	}
	std::string bytes;
	char buffer[1 << 16];
	for (size_t got = 1; got > 0 && bytes.size() <= limit;) {
		got = std::fread(buffer, 1, sizeof(buffer), file);
		bytes.append(buffer, got);
	}
	const bool has_failed = std::ferror(file) != 0;
	std::fclose(file);
	if (has_failed) {
		return file_error("cannot-read-file", path, "cannot read this file to its end", "check the disk");
	}
	if (bytes.size() > limit) {
		return file_error("file-too-large", path, "this file is larger than " + std::to_string(limit) + " bytes", "name a smaller file");
	}
	return bytes;
}

} // namespace pcg
