@tool
extends "res://tests/editor/city_suite.gd"
## What becomes of rule files: closed with changes, written by other programs, moved, imported by others, and nothing that was typed is lost.

const GOOD := "@StartRule\nLot --> extrude(9) X.\n"
const TYPED := "@StartRule\nLot --> extrude(7) X.\n"
const RulesDock := preload("res://addons/pcg/editor/rules/rules_dock.gd")
const RuleEdit := preload("res://addons/pcg/editor/rules/rule_edit.gd")

var _dock: RulesDock


func before_each() -> void:
	await super()
	_dock = get_authoring().rules


func after_each() -> void:
	while _dock.get_current():
		_dock.get_current().tag_saved_version()
		_dock.close_current()
	await super()


func _open(path: String, text: String = GOOD) -> RuleEdit:
	_dock.open(write(path, text))
	await frames(2)
	return _dock.get_current()


## As another program does, some time later.
func _write_outside(path: String, text: String) -> void:
	var before: int = FileAccess.get_modified_time(path)
	while FileAccess.get_modified_time(path) == before: # whole seconds
		await get_tree().create_timer(0.2).timeout
		write(path, text)


## The editor looks for files that are new.
func _scan() -> void:
	EditorInterface.get_resource_filesystem().scan()
	while EditorInterface.get_resource_filesystem().is_scanning():
		await get_tree().process_frame


func _question(which: String) -> ConfirmationDialog:
	return _dock.get_node(which)


func test_closing_a_changed_file_asks() -> void:
	var edit: RuleEdit = await _open("res://typed/closed.cga")
	edit.text = TYPED
	_dock.close_current()
	check(_question("%CloseQuestion").visible and _dock.get_current() == edit, "it is still open, and somebody is asked")
	_question("%CloseQuestion").hide()
	check_equal(FileAccess.get_file_as_string(edit.path), GOOD, "nothing is written")
	_dock.close_current()
	_question("%CloseQuestion").custom_action.emit(RulesDock.DISCARD)
	check(_dock.get_current() == null and not _question("%CloseQuestion").visible, "closed")
	check_equal(FileAccess.get_file_as_string("res://typed/closed.cga"), GOOD, "without being saved, if that is wanted")
	_dock.open("res://typed/closed.cga")
	_dock.get_current().text = TYPED
	_dock.close_current()
	_question("%CloseQuestion").hide()
	_question("%CloseQuestion").confirmed.emit()
	check(_dock.get_current() == null, "closed")
	check_equal(FileAccess.get_file_as_string("res://typed/closed.cga"), TYPED, "and saved")


func test_the_editor_tells_what_is_not_saved_before_it_ends() -> void:
	var edit: RuleEdit = await _open("res://typed/unsaved.cga")
	check_equal(get_authoring().plugin._get_unsaved_status(""), "", "nothing")
	edit.text = TYPED
	check(get_authoring().plugin._get_unsaved_status("").contains("unsaved.cga"), "the file: %s" % get_authoring().plugin._get_unsaved_status(""))
	check_equal(get_authoring().plugin._get_unsaved_status("res://some.tscn"), "", "which is no scene's")
	get_authoring().plugin._save_external_data()
	check_equal(FileAccess.get_file_as_string(edit.path), TYPED, "Save & Quit writes it")


func test_what_was_typed_outlives_switching_the_addon_off() -> void:
	var path: String = (await _open("res://typed/kept.cga")).path
	_dock.get_current().text = TYPED
	EditorInterface.set_plugin_enabled("pcg", false)
	await frames(3)
	check_equal(FileAccess.get_file_as_string(path), GOOD, "nothing is written unasked")
	for round: int in 2:
		EditorInterface.set_plugin_enabled("pcg", true)
		await frames(5)
		_dock = get_authoring().rules
		if round == 0:
			check(_dock.get_current() != null and _dock.get_current().text == TYPED and _dock.get_current().is_modified(), "it is back, and not saved")
			_dock.get_current().tag_saved_version()
			EditorInterface.set_plugin_enabled("pcg", false)
			await frames(3)
	check(not _dock.get_unsaved_paths().has(path), "once")


func test_a_file_that_was_written_outside_is_read_again() -> void:
	var edit: RuleEdit = await _open("res://typed/outside.cga")
	var loaded: PCGRuleSet = load(edit.path)
	edit.set_caret_line(1)
	await _write_outside(edit.path, TYPED)
	_dock.reread_changed()
	check_equal([edit.text, edit.get_caret_line(), edit.is_modified()], [TYPED, 1, false], "where the caret was")
	check(not _question("%NewerQuestion").visible, "unasked: nothing was typed")
	EditorInterface.get_resource_filesystem().resources_reload.emit(PackedStringArray([edit.path]))
	check_equal(loaded.get_source(), TYPED, "and so are rules in memory")


func test_a_file_that_was_changed_here_and_outside_asks() -> void:
	var edit: RuleEdit = await _open("res://typed/both.cga")
	edit.text = TYPED
	await _write_outside(edit.path, GOOD + "// outside\n")
	_dock.reread_changed()
	check(_question("%NewerQuestion").visible and _question("%NewerQuestion").dialog_text.contains("both.cga"), "it asks")
	check_equal(edit.text, TYPED, "and takes nothing away")
	_question("%NewerQuestion").hide()
	_question("%NewerQuestion").canceled.emit()
	_dock.reread_changed()
	check(edit.text == TYPED and not _question("%NewerQuestion").visible, "once, for those who keep what they typed")
	await _write_outside(edit.path, GOOD + "// again\n")
	_dock.reread_changed()
	_question("%NewerQuestion").hide()
	_question("%NewerQuestion").confirmed.emit()
	check_equal([edit.text, edit.is_modified()], [GOOD + "// again\n", false], "the others get the file")


func test_a_file_is_followed_when_it_is_moved_and_closed_when_it_is_deleted() -> void:
	var edit: RuleEdit = await _open("res://typed/before.cga")
	var loaded: PCGRuleSet = load(edit.path)
	DirAccess.rename_absolute("res://typed/before.cga", "res://typed/after.cga")
	loaded.take_over_path("res://typed/after.cga") # as the FileSystem dock does
	EditorInterface.get_file_system_dock().files_moved.emit("res://typed/before.cga", "res://typed/after.cga")
	check_equal(_dock.get_open_paths(), PackedStringArray(["res://typed/after.cga"]), "open under its new name")
	check_equal([loaded.get_file(), loaded.has_errors(), loaded.get_source()], ["res://typed/after.cga", false, GOOD], "loaded rules, too")
	edit.text = TYPED
	_dock.save_current()
	check_equal([FileAccess.get_file_as_string("res://typed/after.cga"), loaded.get_source()], [TYPED, TYPED], "saved there")
	check(not FileAccess.file_exists("res://typed/before.cga"), "and not where it was")
	DirAccess.remove_absolute("res://typed/after.cga")
	EditorInterface.get_file_system_dock().file_removed.emit("res://typed/after.cga")
	check(_dock.get_current() == null, "a file that is gone is closed")


func test_whoever_imports_a_file_follows_it_too() -> void:
	write("res://typed/part.cga", "Part --> extrude(3) X.\n")
	write("res://typed/whole.cga", "import part : \"part.cga\"\n@StartRule\nLot --> zone(\"house\") part.Part\n")
	await _scan()
	var city: PCGCity = await _add_small_city()
	city.lot_types[0].rules = load("res://typed/whole.cga")
	check(not city.lot_types[0].rules.has_errors(), city.lot_types[0].rules.get_diagnostics_text())
	_dock.open("res://typed/part.cga")
	_dock.get_current().text = "Part --> extrude(3\n"
	_dock.save_current()
	check(city.lot_types[0].rules.has_errors(), "an error in what they import is theirs")
	_dock.get_current().text = "Part --> extrude(40) X.\n"
	_dock.save_current()
	check(not city.lot_types[0].rules.has_errors(), "mended")
	check((_dock.get_node("%Users") as Control).visible, "it offers to generate what uses it: %s" % (_dock.get_node("%UsersText") as Label).text)
	(_dock.get_node("%Regenerate") as Button).pressed.emit()
	await _generated(city)
	var meshes: Array = city.find_children("*", "MeshInstance3D", true, false)
	check(meshes.any(func(mesh: MeshInstance3D) -> bool: return mesh.get_aabb().size.y > 39.0), "and it is as high as the part says now")


func test_a_scene_opens_whatever_its_rules_are() -> void:
	var city: PCGCity = await _add_small_city()
	write("res://typed/sound.cga", GOOD)
	city.lot_types[0].rules = load("res://typed/sound.cga")
	EditorInterface.save_scene_as("res://typed/broken_rules.tscn", false)
	EditorInterface.close_scene()
	await frames(3)
	write("res://typed/sound.cga", "Lot --> extrude(3\n")
	EditorInterface.get_resource_filesystem().resources_reload.emit(PackedStringArray(["res://typed/sound.cga"]))
	EditorInterface.open_scene_from_path("res://typed/broken_rules.tscn")
	await frames(5)
	var opened: PCGCity = get_authoring().context.city
	check(opened != null and opened.lot_types.size() == 4, "the scene is whole")
	check(opened != null and opened.lot_types[0].rules.get_diagnostics().size() > 0, "its rules tell what is wrong with them")
