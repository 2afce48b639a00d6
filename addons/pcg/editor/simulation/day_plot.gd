@tool
extends Control
## Plots how many are outdoors over the hours of a day, with the present time.

const HOURS_MARKED: Array[int] = [0, 6, 12, 18, 24]

var counts := PackedInt32Array()
var hour := -1.0


func show_day(shown: PackedInt32Array) -> void:
	counts = shown
	queue_redraw()


func show_hour(present: float) -> void:
	if absf(present - hour) > 0.02:
		hour = present
		queue_redraw()


func _draw() -> void:
	var font: Font = get_theme_font("font", "Label")
	var font_size: int = get_theme_font_size("font_size", "Label") * 3 / 4
	var color: Color = get_theme_color("font_color", "Editor")
	var accent: Color = get_theme_color("accent_color", "Editor")
	var line: float = font.get_height(font_size)
	var area := Rect2(2.0, line, size.x - 4.0, size.y - 2.0 * line)
	for mark: int in HOURS_MARKED:
		var x: float = area.position.x + area.size.x * mark / 24.0
		draw_line(Vector2(x, area.position.y), Vector2(x, area.end.y), Color(color, 0.15))
		var text: String = "%d h" % mark
		var width: float = font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size).x
		draw_string(font, Vector2(clampf(x - width / 2.0, 0.0, size.x - width), size.y - font.get_descent(font_size)), text, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size, Color(color, 0.7))
	var greatest: int = maxi(1, Array(counts).max()) if not counts.is_empty() else 1
	var title: String = "outdoors, at most %d" % greatest if not counts.is_empty() else "\"Survey the day\" plots who is outdoors"
	draw_string(font, Vector2(2.0, font.get_ascent(font_size)), title, HORIZONTAL_ALIGNMENT_LEFT, size.x, font_size, Color(color, 0.7))
	if counts.size() > 1:
		_draw_curve(_find_curve(area, greatest), accent)
	if hour >= 0.0:
		var x: float = area.position.x + area.size.x * hour / 24.0
		draw_line(Vector2(x, area.position.y), Vector2(x, area.end.y), get_theme_color("warning_color", "Editor"), 2.0 * EditorInterface.get_editor_scale())


# Piece by piece: where a line turns back sharply the engine cuts off its tip, and with it the height that the title tells.
func _draw_curve(points: PackedVector2Array, color: Color) -> void:
	for index: int in points.size() - 1:
		draw_line(points[index], points[index + 1], color, 2.0 * EditorInterface.get_editor_scale(), true)


func _find_curve(area: Rect2, greatest: int) -> PackedVector2Array:
	var points := PackedVector2Array()
	for index: int in counts.size():
		points.append(Vector2(area.position.x + area.size.x * (index + 1.0) / counts.size(), area.end.y - area.size.y * counts[index] / float(greatest)))
	return points
