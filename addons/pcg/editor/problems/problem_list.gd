@tool
extends VBoxContainer
## A list of diagnostics: counted, filtered by severity and by words, each a double click away from its place.

## A double click on a diagnostic, or Enter.
signal problem_activated(diagnostic: Dictionary)

var _diagnostics: Array[Dictionary] = []

@onready var _errors: Button = %Errors
@onready var _warnings: Button = %Warnings
@onready var _filter: LineEdit = %Filter
@onready var _list: Tree = %List


func _ready() -> void:
	for button: Button in [_errors, _warnings]:
		button.toggled.connect(func(_is_on: bool) -> void: _fill())
	_filter.text_changed.connect(func(_text: String) -> void: _fill())
	_list.item_activated.connect(_on_item_activated)
	_list.set_column_expand(1, false)
	for column: int in 2:
		_list.set_column_clip_content(column, true)
	_take_theme()


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_node_ready():
		_take_theme()


func _take_theme() -> void:
	_errors.icon = get_theme_icon("StatusError", "EditorIcons")
	_warnings.icon = get_theme_icon("StatusWarning", "EditorIcons")
	_filter.right_icon = get_theme_icon("Search", "EditorIcons")
	_list.set_column_custom_minimum_width(1, roundi(130.0 * EditorInterface.get_editor_scale()))
	_fill()


## Takes dictionaries as [method PCGRuleSet.get_diagnostics] gives them, perhaps with `node`, the node that they are about. Errors stand first.
func show_diagnostics(diagnostics: Array[Dictionary]) -> void:
	var is_error := func(entry: Dictionary) -> bool: return entry["severity"] == "error"
	_diagnostics = diagnostics.filter(is_error) + diagnostics.filter(func(entry: Dictionary) -> bool: return not is_error.call(entry))
	if is_node_ready():
		_fill()


func get_shown() -> Array[Dictionary]:
	return _diagnostics.filter(_is_shown)


func _count(severity: String) -> int:
	return _diagnostics.reduce(func(sum: int, entry: Dictionary) -> int: return sum + int(entry["severity"] == severity), 0)


func _is_shown(entry: Dictionary) -> bool:
	var button: Button = _errors if entry["severity"] == "error" else _warnings
	var told: String = "%s %s %s" % [entry["message"], entry["file"], entry["id"]]
	return button.button_pressed and (_filter.text.is_empty() or told.containsn(_filter.text))


func _fill() -> void:
	_errors.text = "%d" % _count("error")
	_warnings.text = "%d" % _count("warning")
	_list.clear()
	var root: TreeItem = _list.create_item()
	for entry: Dictionary in get_shown():
		var item: TreeItem = _list.create_item(root)
		item.set_icon(0, get_theme_icon("StatusError" if entry["severity"] == "error" else "StatusWarning", "EditorIcons"))
		item.set_text(0, entry["message"])
		item.set_autowrap_mode(0, TextServer.AUTOWRAP_WORD_SMART)
		item.set_tooltip_text(0, "%s\n%s" % [entry["message"], entry["hint"]])
		item.set_text(1, _place_text(entry))
		item.set_tooltip_text(1, entry["file"])
		item.set_metadata(0, entry)


static func _place_text(entry: Dictionary) -> String:
	if str(entry["file"]).is_empty():
		var node: Node = entry.get("node")
		return str(node.name) if node else ""
	return "%s:%d" % [str(entry["file"]).get_file(), entry["line"]]


func _on_item_activated() -> void:
	var item: TreeItem = _list.get_selected()
	if item:
		problem_activated.emit(item.get_metadata(0))
