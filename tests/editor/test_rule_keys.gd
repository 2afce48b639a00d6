@tool
extends "res://tests/editor/editor_suite.gd"
## What keys do in a rule file beside typing: find, replace, comment, move lines, zoom, go to a line. All of it can be undone.

const TEXT := "attr width = 3\n\n@StartRule\nLot -->\n\textrude(width)\n\tMass\n\nMass --> X. Mass2 mass\n"
const RulesDock := preload("res://addons/pcg/editor/rules/rules_dock.gd")
const RuleEdit := preload("res://addons/pcg/editor/rules/rule_edit.gd")
const FindBar := preload("res://addons/pcg/editor/rules/find_bar.gd")

var _dock: RulesDock
var _edit: RuleEdit
var _bar: FindBar


func before_each() -> void:
	_dock = get_authoring().rules
	_dock.open(write("res://typed/keys.cga", TEXT))
	_edit = _dock.get_current()
	_bar = _dock.get_node("%FindBar")
	await frames(2)


func after_each() -> void:
	_edit.tag_saved_version()
	_dock.close_current()
	_bar.close()


## A key with the modifiers of one of the script editor's shortcuts.
func _press(shortcut: String) -> void:
	var settings: EditorSettings = EditorInterface.get_editor_settings()
	var event: InputEventKey = settings.get_shortcut(shortcut).events[0].duplicate()
	event.pressed = true
	_edit.call("_gui_input", event)


func _look_for(query: String) -> void:
	var field: LineEdit = _bar.get_node("%Query")
	field.text = query
	field.text_changed.emit(query)


func _matches() -> String:
	return (_bar.get_node("%Matches") as Label).text


func test_find_goes_from_place_to_place_and_round() -> void:
	_press("script_text_editor/find")
	check(_bar.visible and not (_bar.get_node("%Replacing") as Control).visible, "Ctrl+F opens a line to search")
	_look_for("mass")
	check_equal(_bar.find_all(), [Vector2i(1, 5), Vector2i(0, 7), Vector2i(12, 7), Vector2i(18, 7)] as Array[Vector2i], "columns and lines, any case")
	check_equal([_edit.get_selection_from_line(), _edit.get_selected_text(), _matches()], [5, "Mass", "1 of 4"], "the first is selected")
	_bar.find()
	check_equal([_edit.get_selection_from_line(), _edit.get_selection_from_column()], [7, 0], "then the next")
	_bar.find(true)
	_bar.find(true)
	check_equal([_edit.get_selection_from_column(), _matches()], [18, "4 of 4"], "the last comes before the first")
	_press("script_text_editor/find_next")
	check_equal(_matches(), "1 of 4", "and the first after the last")
	_look_for("nothing like that")
	check_equal(_matches(), "none", "it tells when there is none")


func test_find_minds_case_and_words() -> void:
	_bar.open(false)
	_look_for("mass")
	(_bar.get_node("%MatchCase") as Button).button_pressed = true
	check_equal(_bar.find_all(), [Vector2i(18, 7)] as Array[Vector2i], "as it is written")
	(_bar.get_node("%MatchCase") as Button).button_pressed = false
	(_bar.get_node("%WholeWords") as Button).button_pressed = true
	check_equal(_bar.find_all().size(), 3, "whole words only")
	(_bar.get_node("%WholeWords") as Button).button_pressed = false


func test_replace_is_undone_in_one_step() -> void:
	_press("script_text_editor/replace")
	check((_bar.get_node("%Replacing") as Control).visible, "Ctrl+R asks for what to put")
	(_bar.get_node("%Replacement") as LineEdit).text = "Body"
	_look_for("Mass")
	_bar.replace()
	check_equal(_edit.get_line(5), "\tBody", "the one that is selected")
	check_equal(_edit.get_selection_from_line(), 7, "and on to the next")
	check_equal(_bar.replace_all(), 3, "all others")
	check_equal(_edit.get_line(7), "Body --> X. Body2 Body", "in the whole text")
	_edit.undo()
	check_equal(_edit.get_line(7), "Mass --> X. Mass2 mass", "undone in one step")
	_edit.undo()
	check_equal(_edit.text, TEXT, "and the first")


func test_lines_become_comments_and_text_again() -> void:
	_edit.select(3, 0, 5, 2)
	_press("script_text_editor/toggle_comment")
	check_equal([_edit.get_line(3), _edit.get_line(4)], ["// Lot -->", "\t// extrude(width)"], "behind what indents them")
	check_equal(_edit.get_line(6), "", "others stay")
	_press("script_text_editor/toggle_comment")
	check_equal(_edit.text, TEXT, "and back")
	_press("script_text_editor/toggle_comment")
	_edit.undo()
	check_equal(_edit.text, TEXT, "one step to undo")


func test_lines_are_moved_doubled_and_deleted() -> void:
	_edit.set_caret_line(4)
	_press("script_text_editor/move_down")
	check_equal([_edit.get_line(4), _edit.get_line(5)], ["\tMass", "\textrude(width)"], "down")
	_press("script_text_editor/move_up")
	_press("script_text_editor/duplicate_lines")
	check_equal([_edit.get_line(4), _edit.get_line(5)], ["\textrude(width)", "\textrude(width)"], "twice")
	_press("script_text_editor/delete_line")
	check_equal(_edit.text, TEXT, "and gone")


func test_the_zoom_is_that_of_all_files() -> void:
	var size: int = _edit.get_theme_font_size("font_size")
	var wheel := InputEventMouseButton.new()
	wheel.button_index = MOUSE_BUTTON_WHEEL_UP
	wheel.ctrl_pressed = true
	wheel.pressed = true
	for turn: int in 3:
		_edit.call("_gui_input", wheel)
	check(_edit.get_theme_font_size("font_size") > size, "larger by the wheel with Ctrl")
	_dock.open(write("res://typed/other.cga", TEXT))
	check_equal(_dock.get_current().get_theme_font_size("font_size"), _edit.get_theme_font_size("font_size"), "in the next file, too")
	_dock.close_current()
	var key := InputEventKey.new()
	key.keycode = KEY_0
	key.ctrl_pressed = true
	key.pressed = true
	_edit.call("_gui_input", key)
	check_equal(_edit.get_theme_font_size("font_size"), size, "Ctrl+0 makes it as it was")


func test_a_line_is_asked_for() -> void:
	_press("script_text_editor/goto_line")
	var popup: Window = _dock.get_node("%LinePopup")
	check(popup.visible, "by a key")
	(popup.find_children("*", "LineEdit", true, false)[0] as LineEdit).text_submitted.emit("8")
	check(not popup.visible, "answered")
	check_equal(_edit.get_caret_line(), 7, "the caret stands there")
