@tool
extends CodeEdit
## The text of one rule file, checked a second after the last key: errors stand in the gutter and under the mouse.

## The text was compiled: by itself after typing, or because of check().
signal checked(rules: PCGRuleSet)
## Someone asks for the place where a name is defined.
signal definition_wanted(file: String, line: int)
## A key was pressed for what is not done in the text itself: one of COMMANDS, or "ui_cancel".
signal command_wanted(command: String)
signal zoom_wanted(zoom: float)

const RuleLanguage := preload("res://addons/pcg/editor/rules/rule_language.gd")
const RuleHighlighter := preload("res://addons/pcg/editor/rules/rule_highlighter.gd")
const TextKeys := preload("res://addons/pcg/editor/rules/text_keys.gd")
const COMMANDS: PackedStringArray = ["script_text_editor/find", "script_text_editor/find_next", "script_text_editor/find_previous",
		"script_text_editor/replace", "script_text_editor/goto_line", "script_editor/close_file"] ## the script editor's shortcuts
const CHECK_DELAY := 1.0 ## seconds after the last key
const COMPLETION_DELAY := 0.15 ## seconds
const SHORTEST_PREFIX := 2 ## letters before names are offered unasked
const WORD_BREAKS := " \t()[]{},;:|=<>+-*/%!&'\"~"

var path := ""
var words: RuleLanguage
var rules: PCGRuleSet ## the last compilation of what stands here
var read_time := 0 ## when the file that this text is was last changed, as far as known
var zoom := 1.0:
	set = set_zoom
var _messages: Dictionary[int, Array] = {} # line (from 0) to its diagnostics
var _gutter := -1
var _is_taking_theme := false
var _check_timer := Timer.new()
var _completion_timer := Timer.new()


func _init() -> void:
	gutters_draw_line_numbers = true
	line_folding = true
	gutters_draw_fold_gutter = true
	highlight_current_line = true
	auto_brace_completion_enabled = true
	indent_automatic = true
	code_completion_enabled = true
	symbol_lookup_on_click = true
	caret_blink = true
	delimiter_comments = ["//", "/* */"]
	delimiter_strings = ["\" \""]
	code_completion_prefixes = ["@"]
	_gutter = get_gutter_count()
	add_gutter(_gutter)
	set_gutter_name(_gutter, "problems")
	set_gutter_type(_gutter, GUTTER_TYPE_ICON)
	_add_timer(_check_timer, CHECK_DELAY, check)
	_add_timer(_completion_timer, COMPLETION_DELAY, _offer_unasked)
	text_changed.connect(_on_text_changed)
	code_completion_requested.connect(_offer)
	symbol_validate.connect(_on_symbol_validate)
	symbol_lookup.connect(_on_symbol_lookup)
	set_tooltip_request_func(_tell_about)


func _add_timer(timer: Timer, seconds: float, action: Callable) -> void:
	timer.one_shot = true
	timer.wait_time = seconds
	timer.timeout.connect(action)
	add_child(timer)


func _notification(what: int) -> void:
	# Overriding the font is a change of the theme too.
	if what == NOTIFICATION_THEME_CHANGED and is_node_ready() and not _is_taking_theme:
		_take_theme()


func _ready() -> void:
	_take_theme()


func _take_theme() -> void:
	_is_taking_theme = true
	var theme_of_editor: Theme = EditorInterface.get_editor_theme()
	add_theme_font_override("font", theme_of_editor.get_font("source", "EditorFonts"))
	add_theme_font_size_override("font_size", roundi(theme_of_editor.get_font_size("source_size", "EditorFonts") * zoom))
	set_gutter_width(_gutter, roundi(18.0 * EditorInterface.get_editor_scale()))
	_is_taking_theme = false
	_show_problems()


## Reads the file anew; what was typed and not saved is lost.
func read(from: String) -> void:
	path = from
	words = RuleLanguage.new(PCGRuleSet.DIALECT_AGENDA if path.get_extension().to_lower() == "pcg" else PCGRuleSet.DIALECT_CGA)
	text = FileAccess.get_file_as_string(path)
	read_time = FileAccess.get_modified_time(path)
	clear_undo_history()
	tag_saved_version()
	check()


## Reads the file anew where it was changed, and stays at the same place.
func reread() -> void:
	var place := Vector2i(get_caret_column(), get_caret_line())
	var scroll: float = scroll_vertical
	read(path)
	set_caret_line(mini(place.y, get_line_count() - 1))
	set_caret_column(place.x)
	scroll_vertical = scroll


## Whether the file was written by somebody else since it was read or saved here.
func is_newer_on_disk() -> bool:
	return FileAccess.file_exists(path) and FileAccess.get_modified_time(path) != read_time


## From now on the text is that of the file, whatever the file says.
func keep_typed() -> void:
	read_time = FileAccess.get_modified_time(path)


func is_modified() -> bool:
	return get_version() != get_saved_version()


## Writes the file as a whole or not at all.
func save() -> Error:
	var copy: PCGRuleSet = PCGRuleSet.from_text(path, text)
	var error: Error = ResourceSaver.save(copy, path)
	if error == OK:
		read_time = FileAccess.get_modified_time(path)
		tag_saved_version()
	return error


func set_zoom(shown: float) -> void:
	zoom = shown
	if is_node_ready():
		_take_theme()


func _gui_input(event: InputEvent) -> void:
	_note_key(event as InputEventKey)
	var command: String = TextKeys.find_command(event, COMMANDS)
	var wanted: float = TextKeys.find_zoom(event, zoom)
	if not command.is_empty():
		command_wanted.emit(command)
	elif wanted != zoom:
		zoom_wanted.emit(wanted)
	elif not TextKeys.take(self, event):
		if event.is_action_pressed(&"ui_cancel") and get_code_completion_options().is_empty():
			command_wanted.emit("ui_cancel")
		return
	accept_event()


## Compiles the text as it stands here, saved or not.
func check() -> void:
	_check_timer.stop()
	rules = PCGRuleSet.from_text(path, text)
	words.take_definitions(rules)
	_messages.clear()
	for diagnostic: Dictionary in rules.get_diagnostics():
		if diagnostic["file"] == path:
			var line: int = clampi(int(diagnostic["line"]) - 1, 0, get_line_count() - 1)
			_messages.get_or_add(line, []).append(diagnostic)
	if is_node_ready():
		_show_problems()
	checked.emit(rules)


## Puts the caret at a line and column, both from 1.
func go_to(line: int, column: int) -> void:
	var row: int = clampi(line - 1, 0, get_line_count() - 1)
	unfold_line(row)
	set_caret_line(row)
	set_caret_column(maxi(column - 1, 0))
	center_viewport_to_caret()
	scroll_horizontal = 0
	adjust_viewport_to_caret()
	grab_focus()


func get_messages_at(line: int) -> Array:
	return _messages.get(line, [])


func _show_problems() -> void:
	var names := PackedStringArray()
	for entry: Dictionary in words.find_definitions(text) if words else ([] as Array[Dictionary]):
		if entry["kind"] == "rule":
			names.append(entry["name"])
	syntax_highlighter = RuleHighlighter.make(words, names) if words else null
	for line: int in get_line_count():
		var messages: Array = get_messages_at(line)
		var severity: String = _worst(messages)
		set_line_gutter_icon(line, _gutter, null if severity.is_empty() else get_theme_icon(severity, "EditorIcons"))
		set_line_background_color(line, Color(get_theme_color("error_color", "Editor"), 0.12) if severity == "StatusError" else Color.TRANSPARENT)


static func _worst(messages: Array) -> String:
	if messages.any(func(message: Dictionary) -> bool: return message["severity"] == "error"):
		return "StatusError"
	return "" if messages.is_empty() else "StatusWarning"


func _on_text_changed() -> void:
	_check_timer.start()


# Names are offered to who types words, not where lines are moved, changes undone or words replaced.
func _note_key(key: InputEventKey) -> void:
	if key and key.pressed and key.unicode > 0 and not key.is_command_or_control_pressed():
		_completion_timer.start()
	elif key and key.pressed:
		_completion_timer.stop()


func _offer_unasked() -> void:
	var caret := Vector2i(get_caret_column(), get_caret_line())
	var is_prose: bool = is_in_comment(caret.y, caret.x) >= 0 or is_in_string(caret.y, caret.x) >= 0
	if has_focus() and not is_prose and _word_before_caret().length() >= SHORTEST_PREFIX:
		request_code_completion()


func _offer() -> void:
	var prefix: String = _word_before_caret()
	for entry: Dictionary in words.find_completions(prefix, text):
		var name: String = entry["name"]
		var shown: String = entry.get("signature", name)
		# The engine replaces the word without its dots and @: only what stands behind them is put.
		var inserted: String = name.substr(maxi(prefix.rfind("."), 1 if prefix.begins_with("@") else 0) + (1 if prefix.contains(".") else 0))
		if str(entry["kind"]) in ["operation", "function"] and shown.contains("("):
			inserted += "("
		add_code_completion_option(_completion_kind(entry["kind"]), shown.left(80), inserted, get_theme_color("font_color", "Editor"))
	update_code_completion_options(true)


static func _completion_kind(kind: String) -> CodeEdit.CodeCompletionKind:
	match kind:
		"operation", "function":
			return CodeEdit.KIND_FUNCTION
		"rule":
			return CodeEdit.KIND_CLASS
		"attribute", "variable":
			return CodeEdit.KIND_MEMBER
	return CodeEdit.KIND_PLAIN_TEXT


func _word_before_caret() -> String:
	return get_line(get_caret_line()).left(get_caret_column()).substr(_word_start(get_line(get_caret_line()), get_caret_column()))


static func _word_start(line: String, column: int) -> int:
	var start: int = column
	while start > 0 and not WORD_BREAKS.contains(line[start - 1]):
		start -= 1
	return start


# The word with its dots: scope.sx is one name.
func _word_at(line: int, column: int) -> String:
	var whole: String = get_line(line)
	var start: int = _word_start(whole, clampi(column, 0, whole.length()))
	var end: int = start
	while end < whole.length() and not WORD_BREAKS.contains(whole[end]):
		end += 1
	return whole.substr(start, end - start)


func _tell_about(_word: String) -> String:
	var at: Vector2i = get_line_column_at_pos(Vector2i(get_local_mouse_position()), false)
	return get_tooltip_at(at.y, at.x) if at.y >= 0 else ""


## What hovering tells: what is wrong with that line, then what the word means. Line and column from 0.
func get_tooltip_at(line: int, column: int) -> String:
	var parts := PackedStringArray()
	for message: Dictionary in get_messages_at(line):
		parts.append("%s: %s%s" % [message["severity"], message["message"], "" if str(message["hint"]).is_empty() else "\n" + str(message["hint"])])
	var word: String = _word_at(line, column)
	var help: String = words.get_help(word)
	if help.is_empty() and word.contains("."):
		help = words.get_help(word.get_slice(".", 0))
	if not help.is_empty():
		parts.append(help)
	return _wrapped("\n\n".join(parts))


static func _wrapped(told: String, width: int = 90) -> String:
	var lines := PackedStringArray()
	for line: String in told.split("\n"):
		while line.length() > width:
			var at: int = line.rfind(" ", width)
			at = width if at <= 0 else at
			lines.append(line.left(at))
			line = line.substr(at + 1)
		lines.append(line)
	return "\n".join(lines)


func _on_symbol_validate(symbol: String) -> void:
	set_symbol_lookup_word_as_valid(not words.find_definition(symbol, path, text).is_empty())


func _on_symbol_lookup(symbol: String, _line: int, _column: int) -> void:
	var place: Dictionary = words.find_definition(symbol, path, text)
	if not place.is_empty():
		definition_wanted.emit(place["file"], place["line"])
