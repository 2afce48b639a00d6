@tool
extends VBoxContainer
## Finds words in a text and replaces them, below that text. The script editor has such a bar, but not for others.

const RuleEdit := preload("res://addons/pcg/editor/rules/rule_edit.gd")
const TextKeys := preload("res://addons/pcg/editor/rules/text_keys.gd")
const MOST_DIGITS := "000 of 000"
const NEXT := "script_text_editor/find_next"
const PREVIOUS := "script_text_editor/find_previous"

var edit: RuleEdit: ## the text that is looked through
	set = set_edit

@onready var _query: LineEdit = %Query
@onready var _replacement: LineEdit = %Replacement
@onready var _matches: Label = %Matches


func _ready() -> void:
	hide()
	_query.text_changed.connect(func(_text: String) -> void: _find_from_caret())
	for field: LineEdit in [_query, _replacement]:
		field.gui_input.connect(_on_field_input.bind(field))
	_replacement.text_submitted.connect(func(_text: String) -> void: replace())
	(%Next as Button).pressed.connect(find)
	(%Previous as Button).pressed.connect(find.bind(true))
	(%Replace as Button).pressed.connect(replace)
	(%ReplaceAll as Button).pressed.connect(replace_all)
	(%Close as Button).pressed.connect(close)
	for button: Button in [%MatchCase, %WholeWords]:
		button.toggled.connect(func(_is_on: bool) -> void: _find_from_caret())
	_take_theme()


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_node_ready():
		_take_theme()


func _take_theme() -> void:
	for entry: Array in [[%Previous, "MoveUp"], [%Next, "MoveDown"], [%Close, "Close"]]:
		(entry[0] as Button).icon = get_theme_icon(entry[1], "EditorIcons")
	var font: Font = _matches.get_theme_font("font")
	_matches.custom_minimum_size.x = font.get_string_size(MOST_DIGITS, HORIZONTAL_ALIGNMENT_LEFT, -1, _matches.get_theme_font_size("font_size")).x


# Marks of what was looked for stay with the bar, not with the text.
func set_edit(shown: RuleEdit) -> void:
	if is_instance_valid(edit):
		edit.set_search_text("")
		edit.text_changed.disconnect(_show_matches)
	edit = shown
	if edit:
		edit.text_changed.connect(_show_matches)
	visible = visible and edit != null
	_show_matches()


func open(with_replacement: bool) -> void:
	show()
	(%Replacing as Control).visible = with_replacement
	if edit.has_selection() and edit.get_selection_from_line() == edit.get_selection_to_line():
		_query.text = edit.get_selected_text()
	_query.grab_focus()
	_query.select_all()
	_show_matches()


func close() -> void:
	hide()
	if edit:
		edit.grab_focus()
	_show_matches()


func _flags() -> int:
	return (TextEdit.SEARCH_MATCH_CASE if (%MatchCase as Button).button_pressed else 0) \
			| (TextEdit.SEARCH_WHOLE_WORDS if (%WholeWords as Button).button_pressed else 0)


## Where what is looked for stands: columns and lines, from 0, in order.
func find_all() -> Array[Vector2i]:
	var found: Array[Vector2i] = []
	var from := Vector2i.ZERO
	while edit and not _query.text.is_empty():
		var at: Vector2i = edit.search(_query.text, _flags(), from.y, from.x)
		if at.x < 0 or not found.is_empty() and (at.y < found[-1].y or at.y == found[-1].y and at.x <= found[-1].x):
			break # it began again
		found.append(at)
		from = Vector2i(at.x + _query.text.length(), at.y)
	return found


## Selects the next place behind the caret, or the one before it; the first follows the last.
func find(is_backwards: bool = false) -> void:
	var places: Array[Vector2i] = find_all()
	if places.is_empty():
		_show_matches()
		return
	var here := Vector2i(edit.get_selection_from_column(), edit.get_selection_from_line())
	var before: int = places.reduce(func(sum: int, place: Vector2i) -> int: return sum + int(_is_before(place, here)), 0)
	var is_here: bool = _is_selected(places)
	_select(places, posmod(before - 1 if is_backwards else before + int(is_here), places.size()))


static func _is_before(one: Vector2i, other: Vector2i) -> bool:
	return one.y < other.y or one.y == other.y and one.x < other.x


func _is_selected(places: Array[Vector2i]) -> bool:
	return edit.has_selection() and edit.get_selected_text().length() == _query.text.length() \
			and places.has(Vector2i(edit.get_selection_from_column(), edit.get_selection_from_line()))


# While somebody types, the place stays as long as it fits.
func _find_from_caret() -> void:
	if edit:
		var from := Vector2i(edit.get_selection_from_column(), edit.get_selection_from_line())
		edit.deselect()
		edit.set_caret_line(from.y)
		edit.set_caret_column(from.x)
		find()


func _select(places: Array[Vector2i], index: int) -> void:
	var at: Vector2i = places[index]
	edit.unfold_line(at.y)
	edit.select(at.y, at.x, at.y, at.x + _query.text.length())
	edit.center_viewport_to_caret()
	_show_matches()


## Replaces what is selected if it is what is looked for, and goes on to the next.
func replace() -> void:
	if edit and _is_selected(find_all()):
		edit.insert_text_at_caret(_replacement.text)
	find()


## Replaces all places in one step to undo; returns their number.
func replace_all() -> int:
	var places: Array[Vector2i] = find_all()
	places.reverse()
	if not places.is_empty():
		edit.begin_complex_operation()
		for at: Vector2i in places:
			edit.remove_text(at.y, at.x, at.y, at.x + _query.text.length())
			edit.insert_text(_replacement.text, at.y, at.x)
		edit.end_complex_operation()
	_show_matches()
	return places.size()


func _show_matches() -> void:
	if edit == null:
		return
	edit.set_search_text(_query.text if visible else "")
	edit.set_search_flags(_flags())
	edit.queue_redraw()
	var places: Array[Vector2i] = find_all() if visible else ([] as Array[Vector2i])
	var here: int = places.find(Vector2i(edit.get_selection_from_column(), edit.get_selection_from_line())) if _is_selected(places) else -1
	_matches.text = "%d of %d" % [here + 1, places.size()] if here >= 0 else str(places.size()) if not places.is_empty() else "none"
	if _query.text.is_empty():
		_matches.text = ""


func _on_field_input(event: InputEvent, field: LineEdit) -> void:
	var key := event as InputEventKey
	if key == null or not key.pressed:
		return
	var command: String = TextKeys.find_command(event, [NEXT, PREVIOUS])
	if field == _query and key.keycode in [KEY_ENTER, KEY_KP_ENTER]:
		command = PREVIOUS if key.shift_pressed else NEXT
	if key.is_action(&"ui_cancel"):
		close()
	elif command.is_empty():
		return
	else:
		find(command == PREVIOUS)
	field.accept_event()
