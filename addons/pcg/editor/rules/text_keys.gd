@tool
extends RefCounted
## The keys of the script editor, as its user has set them, at work in another text. Only what `CodeEdit` does not do by itself.

const LINES := "script_text_editor/" ## where the shortcuts of actions on lines are
const COMMENT := "//"
const ZOOM_STEP := 1.1
const ZOOM_LIMIT := 3.0 ## times larger or smaller


## Which of these commands, shortcuts of the script editor by name, a key asks for; "" for none.
static func find_command(event: InputEvent, commands: PackedStringArray) -> String:
	var settings: EditorSettings = EditorInterface.get_editor_settings()
	var key := event as InputEventKey
	if key and key.pressed:
		for command: String in commands:
			var shortcut: Shortcut = settings.get_shortcut(command)
			if shortcut and shortcut.matches_event(event):
				return command
	return ""


## Does what a key asks for; false if it is none of those known here.
static func take(edit: CodeEdit, event: InputEvent) -> bool:
	var actions: Dictionary[String, Callable] = {
		LINES + "toggle_comment": toggle_comment.bind(edit),
		LINES + "move_up": edit.move_lines_up,
		LINES + "move_down": edit.move_lines_down,
		LINES + "delete_line": edit.delete_lines,
		LINES + "duplicate_lines": edit.duplicate_lines,
		LINES + "duplicate_selection": edit.duplicate_selection,
		LINES + "indent": edit.indent_lines,
		LINES + "unindent": edit.unindent_lines,
		LINES + "toggle_fold_line": edit.toggle_foldable_lines_at_carets,
		LINES + "fold_all_lines": edit.fold_all_lines,
		LINES + "unfold_all_lines": edit.unfold_all_lines,
	}
	var command: String = find_command(event, actions.keys())
	if not command.is_empty():
		actions[command].call()
	return not command.is_empty()


## Makes the lines of all carets comments, or text again where all of them are.
static func toggle_comment(edit: CodeEdit) -> void:
	var lines: Array[int] = []
	for carets: Vector2i in edit.get_line_ranges_from_carets():
		for line: int in range(carets.x, carets.y + 1):
			if not edit.get_line(line).strip_edges().is_empty():
				lines.append(line)
	var is_commented: bool = lines.all(func(line: int) -> bool: return edit.get_line(line).strip_edges().begins_with(COMMENT))
	edit.begin_complex_operation()
	for line: int in lines:
		var column: int = edit.get_first_non_whitespace_column(line)
		if is_commented:
			var has_space: bool = edit.get_line(line).substr(column + COMMENT.length(), 1) == " "
			edit.remove_text(line, column, line, column + COMMENT.length() + int(has_space))
		else:
			edit.insert_text(COMMENT + " ", line, column, true, false)
	edit.end_complex_operation()


## The zoom that a key or the wheel asks for; the one that is, for any other event.
static func find_zoom(event: InputEvent, zoom: float) -> float:
	var with_modifiers := event as InputEventWithModifiers
	if with_modifiers == null or not with_modifiers.is_command_or_control_pressed() or not event.is_pressed():
		return zoom
	var key := event as InputEventKey
	var wheel := event as InputEventMouseButton
	if key and key.keycode in [KEY_EQUAL, KEY_PLUS, KEY_KP_ADD] or wheel and wheel.button_index == MOUSE_BUTTON_WHEEL_UP:
		return minf(zoom * ZOOM_STEP, ZOOM_LIMIT)
	if key and key.keycode in [KEY_MINUS, KEY_KP_SUBTRACT] or wheel and wheel.button_index == MOUSE_BUTTON_WHEEL_DOWN:
		return maxf(zoom / ZOOM_STEP, 1.0 / ZOOM_LIMIT)
	return 1.0 if key and key.keycode in [KEY_0, KEY_KP_0] else zoom
