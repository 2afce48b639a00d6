@tool
extends Control
## A person's week: a row for each day, above what the agenda plans, below what was lived so far.

## Somebody clicked on an entry of the agenda; `index` counts in the list that was shown. `is_double`: a double click.
signal entry_clicked(index: int, is_double: bool)

const TaskColors := preload("res://addons/pcg/editor/person/task_colors.gd")
const DAYS: PackedStringArray = ["mon", "tue", "wed", "thu", "fri", "sat", "sun"]
const DAY := 86400.0 ## seconds
const LIVED_PART := 0.3 ## of a row's height

var entries: Array[Dictionary] = [] # as CitizenManager.get_agenda() tells them
var home := -1 # where the person lives
var lived: Array[Dictionary] = [] # `start`, `end` (seconds since the first Monday), `kind`
var now := -1.0 # seconds since the first Monday
var selected := -1


func show_week(agenda: Array[Dictionary], lives_in: int) -> void:
	entries = agenda
	home = lives_in
	selected = -1
	queue_redraw()


func show_lived(spans: Array[Dictionary], present: float) -> void:
	lived = spans
	now = present
	queue_redraw()


func select(index: int) -> void:
	selected = index
	queue_redraw()


func _label_width() -> float:
	return get_theme_font("font", "Label").get_string_size("wed ", HORIZONTAL_ALIGNMENT_LEFT, -1, _font_size()).x


func _font_size() -> int:
	return get_theme_font_size("font_size", "Label") * 3 / 4


## Where an entry stands on a day (0: Monday), in this control; what runs past midnight ends there and goes on in the next row.
func get_entry_rects(entry: Dictionary) -> Array[Rect2]:
	var rects: Array[Rect2] = []
	for day: int in 7:
		if DAYS[day] in entry["days"]:
			_add_span(rects, day * DAY + float(entry["start"]), day * DAY + float(entry["end"]), 0.05, 1.0 - LIVED_PART - 0.1)
	return rects


# The span in seconds since Monday, cut at midnights; top and height are parts of a row.
func _add_span(rects: Array[Rect2], start: float, end: float, top: float, height: float) -> void:
	var from: float = start
	while from < end:
		var day: int = floori(from / DAY)
		var to: float = minf(end, (day + 1) * DAY)
		rects.append(_rect(posmod(day, 7), from - day * DAY, to - day * DAY, top, height))
		from = to


func _rect(day: int, from: float, to: float, top: float, height: float) -> Rect2:
	var left: float = _label_width()
	var width: float = size.x - left - 2.0
	var row: float = (size.y - _axis_height()) / 7.0
	return Rect2(left + width * from / DAY, row * (day + top), maxf(1.0, width * (to - from) / DAY), row * height)


func _axis_height() -> float:
	return get_theme_font("font", "Label").get_height(_font_size())


func _draw() -> void:
	var color: Color = get_theme_color("font_color", "Editor")
	_draw_axis(color)
	for index: int in entries.size():
		for rect: Rect2 in get_entry_rects(entries[index]):
			draw_rect(rect, TaskColors.of_entry(entries[index], home))
			draw_rect(rect, get_theme_color("accent_color", "Editor") if index == selected else Color(color, 0.25), false, 2.0 if index == selected else 1.0)
	for span: Dictionary in lived:
		var rects: Array[Rect2] = []
		_add_span(rects, span["start"], span["end"], 1.0 - LIVED_PART, LIVED_PART - 0.05)
		for rect: Rect2 in rects:
			draw_rect(rect, TaskColors.of(span["kind"]).darkened(0.15))
	if now >= 0.0:
		var present: Rect2 = _rect(posmod(floori(now / DAY), 7), fposmod(now, DAY), fposmod(now, DAY), 0.0, 1.0)
		draw_line(present.position, Vector2(present.position.x, present.end.y), get_theme_color("error_color", "Editor"), 2.0 * EditorInterface.get_editor_scale())


func _draw_axis(color: Color) -> void:
	var font: Font = get_theme_font("font", "Label")
	for day: int in 7:
		var row: Rect2 = _rect(day, 0.0, DAY, 0.0, 1.0)
		draw_string(font, Vector2(0.0, row.get_center().y + font.get_ascent(_font_size()) / 2.0), DAYS[day], HORIZONTAL_ALIGNMENT_LEFT, -1, _font_size(), color)
		draw_line(row.position, Vector2(row.end.x, row.position.y), Color(color, 0.12))
	for hour: int in range(0, 25, 6):
		var x: float = _rect(0, hour * 3600.0, hour * 3600.0, 0.0, 1.0).position.x
		var text: String = "%d h" % hour
		var width: float = font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, _font_size()).x
		draw_line(Vector2(x, 0.0), Vector2(x, size.y - _axis_height()), Color(color, 0.12))
		draw_string(font, Vector2(clampf(x - width / 2.0, 0.0, size.x - width), size.y - font.get_descent(_font_size())), text, HORIZONTAL_ALIGNMENT_LEFT, -1, _font_size(), Color(color, 0.7))


## The entry at a point; what came later in the list lies above. -1: none.
func find_entry(point: Vector2) -> int:
	for index: int in range(entries.size() - 1, -1, -1):
		if get_entry_rects(entries[index]).any(func(rect: Rect2) -> bool: return rect.has_point(point)):
			return index
	return -1


func _gui_input(event: InputEvent) -> void:
	var button: InputEventMouseButton = event as InputEventMouseButton
	if button and button.pressed and button.button_index == MOUSE_BUTTON_LEFT:
		var index: int = find_entry(button.position)
		if index >= 0:
			entry_clicked.emit(index, button.double_click)


func _get_tooltip(at: Vector2) -> String:
	var index: int = find_entry(at)
	return entries[index]["told"] if index >= 0 else ""
