@tool
extends RefCounted
## Says in one sentence or two why the addon's native library is not at work, and what to do about it.

const MANIFEST := "res://addons/pcg/pcg.gdextension"
const NATIVE_CLASS := &"PCGCity"
const REMEDY := "Install the release zip (not the source zip) into res://addons/pcg and restart the editor; in a checkout of the project, run ./dev setup."


## An empty string when the library is loaded.
static func find_problem() -> String:
	if ClassDB.class_exists(NATIVE_CLASS):
		return ""
	return explain(MANIFEST)


## Why the library that `manifest` names is not loaded. [param manifest] is a res:// path.
static func explain(manifest: String) -> String:
	if not FileAccess.file_exists(manifest):
		return "PCG for Godot: its native library is missing: there is no %s. %s" % [manifest, REMEDY]
	var config := ConfigFile.new()
	if config.load(manifest) != OK:
		return "PCG for Godot: %s cannot be read. %s" % [manifest, REMEDY]
	var library: String = _expected_library(config)
	if library.is_empty():
		return "PCG for Godot: %s names no library for %s. %s" % [manifest, _platform(), REMEDY]
	if not FileAccess.file_exists(library):
		return "PCG for Godot: its native library is missing: there is no %s. %s" % [library, REMEDY]
	var minimum: String = str(config.get_value("configuration", "compatibility_minimum", ""))
	var reason: String = "it is damaged, or was not built for %s" % _platform()
	if _is_older_than(minimum):
		reason = "it needs Godot %s or newer, and this is Godot %s" % [minimum, Engine.get_version_info()["string"]]
	return "PCG for Godot: %s is there but was not loaded; %s. %s" % [library, reason, REMEDY]


static func _is_older_than(minimum: String) -> bool:
	var version: Dictionary = Engine.get_version_info()
	return int(version["major"]) * 1000 + int(version["minor"]) < minimum.get_slice(".", 0).to_int() * 1000 + minimum.get_slice(".", 1).to_int()


static func _expected_library(config: ConfigFile) -> String:
	for key: String in config.get_section_keys("libraries") if config.has_section("libraries") else PackedStringArray():
		var tags: PackedStringArray = key.split(".")
		if Array(tags).all(func(tag: String) -> bool: return OS.has_feature(tag)):
			return str(config.get_value("libraries", key))
	return ""


static func _platform() -> String:
	return "%s (%s)" % [OS.get_name(), Engine.get_architecture_name()]
