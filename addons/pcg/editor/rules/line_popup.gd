@tool
extends PopupPanel
## Asks for the line to go to.

signal line_chosen(line: int)

const WIDTH := 160.0 ## pixels at 100 %

var _field := LineEdit.new()


func _init() -> void:
	_field.placeholder_text = "Line number"
	_field.text_submitted.connect(_on_submitted)
	add_child(_field)


## Appears at the upper right of a text.
func ask(over: CodeEdit) -> void:
	_field.custom_minimum_size.x = WIDTH * EditorInterface.get_editor_scale()
	_field.text = str(over.get_caret_line() + 1)
	reset_size()
	popup(Rect2i(Vector2i(over.get_screen_position() + Vector2(over.size.x - size.x, 0.0)), size))
	_field.grab_focus()
	_field.select_all()


func _on_submitted(text: String) -> void:
	hide()
	if text.is_valid_int():
		line_chosen.emit(text.to_int())
