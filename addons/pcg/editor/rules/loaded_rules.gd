@tool
extends RefCounted
## Rule sets that are in memory, after a file of theirs was written.

const EXTENSIONS: PackedStringArray = ["cga", "pcg"]


## Compiles anew whatever is made of a rule file: its own rules, and those of files that import it. What has errors may have them for what was in that file.
static func renew(path: String) -> void:
	var files: PackedStringArray = _find_files(EditorInterface.get_resource_filesystem().get_filesystem())
	if not files.has(path): # new
		files.append(path)
	for file: String in files:
		var rules: PCGRuleSet = load(file) as PCGRuleSet if ResourceLoader.has_cached(file) else null
		if rules and (file == path or rules.has_errors() or is_made_of(rules, path)):
			rules.reload()


## Whether a file is that of the rules, or imported by them.
static func is_made_of(rules: PCGRuleSet, path: String) -> bool:
	return rules.get_file() == path or rules.get_definitions().any(func(entry: Dictionary) -> bool: return entry["file"] == path)


static func is_rule_file(path: String) -> bool:
	return path.get_extension().to_lower() in EXTENSIONS


static func _find_files(folder: EditorFileSystemDirectory) -> PackedStringArray:
	var found := PackedStringArray()
	for index: int in folder.get_file_count():
		if is_rule_file(folder.get_file_path(index)):
			found.append(folder.get_file_path(index))
	for index: int in folder.get_subdir_count():
		found.append_array(_find_files(folder.get_subdir(index)))
	return found
