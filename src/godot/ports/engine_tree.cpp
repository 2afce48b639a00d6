#include "godot/ports/engine_tree.h"

#include <map>

#include <godot_cpp/classes/dir_access.hpp>
#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/classes/resource_loader.hpp>

#include "godot/convert.h"
#include "godot/ports/engine_files.h"

using namespace godot;

namespace pcg {

namespace {

// What the engine has left of "box.obj": "box.obj.import" beside it or instead of it, "house.tscn.remap" instead of it.
String source_name(const String &name) { return name.trim_suffix(".import").trim_suffix(".remap"); }

} // namespace

bool EngineTree::has_file(const std::string &path) const {
	const String name = to_godot(std::string_view(path));
	return FileAccess::file_exists(name) || (name.contains("://") && ResourceLoader::get_singleton()->exists(name));
}

bool EngineTree::has_folder(const std::string &path) const { return DirAccess::dir_exists_absolute(to_godot(std::string_view(path))); }

std::vector<FileTree::Entry> EngineTree::list(const std::string &folder) const {
	std::vector<Entry> entries;
	const Ref<DirAccess> dir = DirAccess::open(to_godot(std::string_view(folder)));
	if (dir.is_null()) {
		return entries;
	}
	std::map<std::string, bool> names; // sorted; true: a folder
	dir->list_dir_begin();
	for (String name = dir->get_next(); !name.is_empty(); name = dir->get_next()) {
		const bool is_folder = dir->current_is_dir();
		if (!name.begins_with(".") && !name.ends_with(".uid")) { // the engine's own notes are in no exported game
			names.emplace(from_godot(is_folder ? name : source_name(name)), is_folder);
		}
	}
	dir->list_dir_end();
	for (const auto &[name, is_folder] : names) {
		entries.push_back({ name, is_folder });
	}
	return entries;
}

Result<std::string> EngineTree::read(const std::string &path, size_t limit) const { return read_engine_file(to_godot(std::string_view(path)), limit); }

std::string EngineTree::absolute(const std::string &path) const {
	const String name = to_godot(std::string_view(path)).replace("\\", "/");
	const bool is_relative = name.is_relative_path() && !name.contains("://");
	return from_godot((is_relative ? "res://" + name : name).simplify_path());
}

} // namespace pcg
