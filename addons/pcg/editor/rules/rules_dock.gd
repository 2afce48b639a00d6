@tool
extends MarginContainer
## Edits rule files: a list of those that are open, the text of one, and what is wrong with it.

## Rules were checked; `diagnostics` are those of `path` and of what it imports.
signal rules_checked(path: String, diagnostics: Array[Dictionary])
signal rules_saved(path: String)
signal rules_closed(path: String)
## Whoever uses these rules shall be made anew.
signal regeneration_wanted(path: String)

const RuleEdit := preload("res://addons/pcg/editor/rules/rule_edit.gd")
const ProblemList := preload("res://addons/pcg/editor/problems/problem_list.gd")
const FindBar := preload("res://addons/pcg/editor/rules/find_bar.gd")
const LinePopup := preload("res://addons/pcg/editor/rules/line_popup.gd")
const LoadedRules := preload("res://addons/pcg/editor/rules/loaded_rules.gd")
const UnsavedRules := preload("res://addons/pcg/editor/rules/unsaved_rules.gd")
const DISCARD := &"discard" ## what the button "Don't Save" asks for
const NARROW := 700.0 ## pixels at 100 %
const FIRST_LINES := {
	"cga": "// What this file builds.\nattr height = 9\n\n@StartRule\nLot -->\n\textrude(height)\n\tMass\n\nMass -->\n\tcolor(\"#d8c7a8\")\n",
	"pcg": "// What this week is about.\n\n@StartRule\nHousehold -->\n\tmembers { true: stayInside(0h, 24h, home) }\n",
}

## Tells how many nodes of the edited scene use a rule file: func(path: String) -> int.
var count_users: Callable
var _edits: Array[RuleEdit] = []
var _current: RuleEdit
var _dialog: EditorFileDialog
var _newer: Array[RuleEdit] = [] # typed in here and written by somebody else, too: asked about now
var _zoom := 1.0

@onready var _files: ItemList = %Files
@onready var _holder: PanelContainer = %Edits
@onready var _problems: ProblemList = %Problems
@onready var _main: SplitContainer = %Main
@onready var _users: Control = %Users
@onready var _find_bar: FindBar = %FindBar
@onready var _close_question: ConfirmationDialog = %CloseQuestion
@onready var _newer_question: ConfirmationDialog = %NewerQuestion
@onready var _line_popup: LinePopup = %LinePopup


func _ready() -> void:
	(%New as Button).pressed.connect(_ask_for_file.bind(true))
	(%Open as Button).pressed.connect(_ask_for_file.bind(false))
	(%Save as Button).pressed.connect(save_current)
	(%Close as Button).pressed.connect(close_current)
	(%Regenerate as Button).pressed.connect(_on_regenerate)
	(%Dismiss as Button).pressed.connect(_users.hide)
	_main.resized.connect(_arrange)
	_files.item_selected.connect(func(index: int) -> void: _show(_edits[index]))
	_close_question.add_button("Don't Save", true, DISCARD)
	_close_question.confirmed.connect(func() -> void: _close(_current, true))
	_close_question.custom_action.connect(_on_close_action)
	_newer_question.confirmed.connect(func() -> void: _end_newer_question(true))
	_newer_question.canceled.connect(func() -> void: _end_newer_question(false))
	_line_popup.line_chosen.connect(func(line: int) -> void: _current.go_to(line, 1))
	_problems.problem_activated.connect(func(entry: Dictionary) -> void: open(entry["file"], entry["line"], entry["column"]))
	_take_theme()
	_show(null)


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_node_ready():
		_take_theme()
	elif what == NOTIFICATION_APPLICATION_FOCUS_IN:
		reread_changed()


func _take_theme() -> void:
	for entry: Array in [[%New, "New"], [%Open, "Load"], [%Save, "Save"], [%Close, "Close"]]:
		(entry[0] as Button).icon = get_theme_icon(entry[1], "EditorIcons")
	(%Side as Control).custom_minimum_size.x = 150.0 * EditorInterface.get_editor_scale()
	_problems.custom_minimum_size = Vector2(240.0, 90.0) * EditorInterface.get_editor_scale()
	custom_minimum_size.y = 260.0 * EditorInterface.get_editor_scale()


# In a narrow editor messages stand below the text, so that lines stay long enough to be read.
func _arrange() -> void:
	_main.vertical = _main.size.x < NARROW * EditorInterface.get_editor_scale()


func _show_problems(diagnostics: Array[Dictionary]) -> void:
	_problems.visible = not diagnostics.is_empty()
	_problems.show_diagnostics(diagnostics)


func _shortcut_input(event: InputEvent) -> void:
	var key: InputEventKey = event as InputEventKey
	var has_focus_inside: bool = _current != null and _current.has_focus()
	if key and key.pressed and has_focus_inside and key.keycode == KEY_S and key.is_command_or_control_pressed() and not key.shift_pressed:
		save_current()
		accept_event()


## Shows a rule file, its caret at line and column (from 1; 0: where it was). False if there is no such file.
func open(path: String, line: int = 0, column: int = 1) -> bool:
	if not FileAccess.file_exists(path):
		EditorInterface.get_editor_toaster().push_toast("PCG: there is no file %s" % path, EditorToaster.SEVERITY_WARNING)
		return false
	var edit: RuleEdit = find_edit(path)
	if edit == null:
		edit = RuleEdit.new()
		edit.checked.connect(_on_checked.bind(edit))
		edit.definition_wanted.connect(open)
		edit.text_changed.connect(_refresh_names)
		edit.command_wanted.connect(_on_command)
		edit.zoom_wanted.connect(_set_zoom)
		edit.zoom = _zoom
		_edits.append(edit)
		_holder.add_child(edit)
		edit.read(path)
	_show(edit)
	if line > 0:
		edit.go_to(line, column)
	return true


func find_edit(path: String) -> RuleEdit:
	for edit: RuleEdit in _edits:
		if edit.path == path:
			return edit
	return null


func get_current() -> RuleEdit:
	return _current


func get_open_paths() -> PackedStringArray:
	return PackedStringArray(_edits.map(func(edit: RuleEdit) -> String: return edit.path))


func get_unsaved_paths() -> PackedStringArray:
	return PackedStringArray(_edits.filter(func(edit: RuleEdit) -> bool: return edit.is_modified())
			.map(func(edit: RuleEdit) -> String: return edit.path))


func save_current() -> void:
	if _current:
		_save(_current)


func save_all() -> void:
	for edit: RuleEdit in _edits:
		if edit.is_modified():
			_save(edit)


## Closes the file that is shown; if it was changed, somebody is asked first.
func close_current() -> void:
	if _current and _current.is_modified():
		_close_question.dialog_text = "Close %s and save what was changed?" % _current.path.get_file()
		_close_question.popup_centered()
	elif _current:
		_close(_current, false)


func _on_close_action(action: StringName) -> void:
	_close_question.hide()
	if action == DISCARD:
		_close(_current, false)


# What could not be saved stays open.
func _close(edit: RuleEdit, saves: bool) -> void:
	if edit == null or saves and not _save(edit):
		return
	var index: int = _edits.find(edit)
	_edits.remove_at(index)
	rules_closed.emit(edit.path)
	edit.queue_free()
	if edit == _current:
		_show(_edits[mini(index, _edits.size() - 1)] if not _edits.is_empty() else null)
	_refresh_names()


## Takes over what other programs wrote; where something was typed here, too, somebody is asked.
func reread_changed() -> void:
	for edit: RuleEdit in _edits:
		if not edit.is_newer_on_disk():
			continue
		if not edit.is_modified():
			edit.reread()
		elif not _newer.has(edit):
			_newer.append(edit)
	if not _newer.is_empty() and not _newer_question.visible:
		_newer_question.dialog_text = "Newer on disk than what you changed here:\n%s" % "\n".join(_newer.map(func(edit: RuleEdit) -> String: return edit.path))
		_newer_question.popup_centered()


func _end_newer_question(reloads: bool) -> void:
	for edit: RuleEdit in _newer.filter(func(edit: Variant) -> bool: return is_instance_valid(edit)):
		if reloads:
			edit.reread()
		else:
			edit.keep_typed()
	_newer.clear()


## A file has another place now.
func follow_move(from: String, to: String) -> void:
	var edit: RuleEdit = find_edit(from)
	if edit:
		rules_closed.emit(from)
		edit.path = to
		edit.keep_typed()
		edit.check()


## A file is gone. Text that was not saved stays.
func follow_removal(path: String) -> void:
	var edit: RuleEdit = find_edit(path)
	if edit and not edit.is_modified():
		_close(edit, false)


## Keeps what was not saved for take_back_unsaved(), as before the addon is switched off.
func keep_unsaved() -> void:
	var texts: Dictionary[String, String] = {}
	for edit: RuleEdit in _edits:
		if edit.is_modified():
			texts[edit.path] = edit.text
	UnsavedRules.keep(texts)


func take_back_unsaved() -> void:
	var texts: Dictionary[String, String] = UnsavedRules.take()
	for path: String in texts:
		if open(path):
			_current.text = texts[path]
			_current.check()


func _on_command(command: String) -> void:
	match command.get_file():
		"find", "replace":
			_find_bar.open(command.get_file() == "replace")
		"find_next", "find_previous":
			_find_bar.find(command.get_file() == "find_previous")
		"goto_line":
			_line_popup.ask(_current)
		"close_file":
			close_current()
		"ui_cancel":
			_find_bar.close()


func _set_zoom(zoom: float) -> void:
	_zoom = zoom
	for edit: RuleEdit in _edits:
		edit.zoom = zoom


func _save(edit: RuleEdit) -> bool:
	var error: Error = edit.save()
	if error != OK:
		EditorInterface.get_editor_toaster().push_toast("PCG: %s was not saved: %s" % [edit.path, error_string(error)], EditorToaster.SEVERITY_ERROR)
		return false
	edit.check()
	EditorInterface.get_resource_filesystem().update_file(edit.path)
	LoadedRules.renew(edit.path)
	_refresh_names()
	rules_saved.emit(edit.path)
	_offer_regeneration(edit)
	return true


func _offer_regeneration(edit: RuleEdit) -> void:
	var users: int = count_users.call(edit.path) if count_users.is_valid() else 0
	_users.visible = users > 0 and not edit.rules.has_errors()
	(%UsersText as Label).text = "%s is used by %s of this scene." % [edit.path.get_file(), "one node" if users == 1 else "%d nodes" % users]


func _on_regenerate() -> void:
	_users.hide()
	if _current:
		regeneration_wanted.emit(_current.path)


func _show(edit: RuleEdit) -> void:
	_current = edit
	_find_bar.edit = edit
	for other: RuleEdit in _edits:
		other.visible = other == edit
	(%Hint as Control).visible = edit == null
	for button: Button in [%Save, %Close]:
		button.disabled = edit == null
	_users.hide()
	_show_problems(edit.rules.get_diagnostics() if edit else ([] as Array[Dictionary]))
	_refresh_names()


func _refresh_names() -> void:
	_files.clear()
	for edit: RuleEdit in _edits:
		var index: int = _files.add_item(edit.path.get_file() + ("(*)" if edit.is_modified() else ""))
		_files.set_item_tooltip(index, edit.path)
		_files.set_item_icon(index, null if edit.rules == null or not edit.rules.has_errors() else get_theme_icon("StatusError", "EditorIcons"))
		if edit == _current:
			_files.select(index)


func _on_checked(rules: PCGRuleSet, edit: RuleEdit) -> void:
	if edit == _current:
		_show_problems(rules.get_diagnostics())
	_refresh_names()
	rules_checked.emit(edit.path, rules.get_diagnostics())


func _ask_for_file(is_new: bool) -> void:
	if _dialog == null:
		_dialog = EditorFileDialog.new()
		_dialog.access = EditorFileDialog.ACCESS_RESOURCES
		_dialog.add_filter("*.cga", "Rules that build lots")
		_dialog.add_filter("*.pcg", "Rules that write agendas")
		_dialog.file_selected.connect(_on_file_selected)
		add_child(_dialog)
	_dialog.file_mode = EditorFileDialog.FILE_MODE_SAVE_FILE if is_new else EditorFileDialog.FILE_MODE_OPEN_FILE
	_dialog.popup_file_dialog()


func _on_file_selected(path: String) -> void:
	if _dialog.file_mode == EditorFileDialog.FILE_MODE_SAVE_FILE:
		create(path)
	open(path)


## Writes a rule file to begin with, in place of what was there.
func create(path: String) -> Error:
	var first_lines: String = FIRST_LINES.get(path.get_extension().to_lower(), FIRST_LINES["cga"])
	var error: Error = ResourceSaver.save(PCGRuleSet.from_text(path, first_lines), path)
	if error == OK:
		EditorInterface.get_resource_filesystem().update_file(path)
	return error
