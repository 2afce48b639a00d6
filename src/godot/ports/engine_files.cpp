#include "godot/ports/engine_files.h"

#include <godot_cpp/classes/dir_access.hpp>
#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>

#include "godot/convert.h"

using namespace godot;

namespace pcg {

namespace {

Diagnostic failure(const String &path, std::string_view id, std::string message, std::string hint) {
	Diagnostic diagnostic;
	diagnostic.id = id;
	diagnostic.file = from_godot(path);
	diagnostic.message = std::move(message);
	diagnostic.hint = std::move(hint);
	return diagnostic;
}

} // namespace

Result<std::string> read_engine_file(const String &path, uint64_t limit) {
	if (DirAccess::dir_exists_absolute(path)) {
		return failure(path, "unreadable-file", "this is a folder, not a file", "name a file in it");
	}
	if (!FileAccess::file_exists(path)) {
		return failure(path, "missing-file", "there is no such file", "check the path; files of the project begin with res://");
	}
	const Ref<FileAccess> file = FileAccess::open(path, FileAccess::READ);
	if (file.is_null()) {
		return failure(path, "unreadable-file", "the file cannot be opened", "check that you may read it");
	}
	if (file->get_length() > limit) {
		return failure(path, "huge-file", "the file is larger than " + std::to_string(limit >> 20) + " MiB", "this is hardly the file that you mean");
	}
	const PackedByteArray bytes = file->get_buffer(int64_t(file->get_length()));
	return std::string(view_of(bytes));
}

Result<std::string> EngineFiles::read(const std::string &path) { return read_engine_file(to_godot(std::string_view(path))); }

} // namespace pcg
