extends "res://tests/godot/suite.gd"
## What the addon says about its own library: one sentence for each way in which it can be absent.

const LibraryCheck := preload("res://addons/pcg/editor/library_check.gd")

var _manifest := "user://library_check.gdextension"


func after_each() -> void:
	DirAccess.remove_absolute(_manifest)


func _write(libraries: String) -> void:
	var file := FileAccess.open(_manifest, FileAccess.WRITE)
	file.store_string("[configuration]\ncompatibility_minimum = \"4.6\"\n%s" % libraries)
	file.close()


func test_the_library_is_loaded_here_so_there_is_no_problem() -> void:
	check_equal(LibraryCheck.find_problem(), "", "nothing to say")


func test_a_missing_manifest_is_named() -> void:
	check(LibraryCheck.explain(_manifest).contains("there is no " + _manifest), "the manifest's path is in the message")


func test_a_manifest_without_a_library_for_this_platform_says_so() -> void:
	_write("[libraries]\nplan9.debug = \"res://nowhere.so\"\n")
	check(LibraryCheck.explain(_manifest).contains("names no library for " + OS.get_name()), "the platform is named")
	_write("")
	check(LibraryCheck.explain(_manifest).contains("names no library for"), "no [libraries] at all is the same")


func test_a_missing_library_file_is_named() -> void:
	_write("[libraries]\n%s.debug = \"res://nowhere.so\"\n" % OS.get_name().to_lower())
	check(LibraryCheck.explain(_manifest).contains("there is no res://nowhere.so"), "the file's path is in the message")


func test_a_library_that_is_there_but_did_not_load_is_told_apart() -> void:
	_write("[libraries]\n%s.debug = \"res://project.godot\"\n" % OS.get_name().to_lower())
	var message: String = LibraryCheck.explain(_manifest)
	check(message.contains("was not loaded; it is damaged, or was not built for " + OS.get_name()), "it says why: %s" % message)
	_write("[configuration]\ncompatibility_minimum = \"99.1\"\n[libraries]\n%s.debug = \"res://project.godot\"\n" % OS.get_name().to_lower())
	check(LibraryCheck.explain(_manifest).contains("it needs Godot 99.1 or newer, and this is Godot 4."), "or what it needs")


func test_every_message_says_what_to_do_and_is_one_line() -> void:
	var message: String = LibraryCheck.explain(_manifest)
	check(message.contains("./dev setup") and not message.contains("\n"), "remedy on the same line")
