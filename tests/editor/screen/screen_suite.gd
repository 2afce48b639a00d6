@tool
extends "res://tests/editor/editor_suite.gd"
## What tests extend that use the editor as a user does: clicks and keys at what is seen, and pictures of it. The suite's screen is one in memory.


## Clicks on a control: in its middle, or at a point of it.
func click(control: Control, at: Vector2 = control.size / 2.0, is_double: bool = false) -> void:
	for is_pressed: bool in [true, false]:
		var event := InputEventMouseButton.new()
		event.button_index = MOUSE_BUTTON_LEFT
		event.button_mask = MOUSE_BUTTON_MASK_LEFT if is_pressed else 0
		event.pressed = is_pressed
		event.double_click = is_double and is_pressed
		event.position = control.get_global_transform_with_canvas() * at
		event.global_position = event.position
		control.get_viewport().push_input(event)
	await frames(2)


## Clicks on the first row of a list that has this text in a column. False if none has, or if it is not seen.
func click_row(tree: Tree, text: String, column: int = 0, is_double: bool = false) -> bool:
	var rows: Array = range(0, int(tree.size.y), 2).filter(func(y: int) -> bool:
		var item: TreeItem = tree.get_item_at_position(Vector2(24.0, y))
		return item != null and item.get_text(column).contains(text))
	if rows.is_empty():
		return false
	var found: TreeItem = tree.get_item_at_position(Vector2(24.0, rows[0]))
	rows = rows.filter(func(y: int) -> bool: return tree.get_item_at_position(Vector2(24.0, y)) == found)
	for is_second: bool in ([false, true] if is_double else [false]):
		await click(tree, Vector2(24.0, rows[rows.size() / 2]), is_second)
	return true


## Presses and releases a key.
func press(key: Key, is_control: bool = false, unicode: int = 0, is_shift: bool = false) -> void:
	for is_pressed: bool in [true, false]:
		var event := InputEventKey.new()
		event.keycode = key
		event.physical_keycode = key
		event.unicode = unicode
		event.ctrl_pressed = is_control
		event.shift_pressed = is_shift
		event.pressed = is_pressed
		get_tree().root.push_input(event)
	await frames(2)


func type(text: String) -> void:
	for index: int in text.length():
		await press(KEY_NONE, false, text.unicode_at(index))


## What is seen of the editor now. Nothing is drawn between pictures: without a graphics card that takes most of the time.
func take_picture() -> Image:
	for frame: int in 2:
		RenderingServer.force_draw()
	return get_tree().root.get_texture().get_image()


## Which part of a rectangle looks different in two pictures, 0 to 1; every fourth pixel is looked at.
static func compare(one: Image, other: Image, area: Rect2i) -> float:
	var different := 0
	var looked_at := 0
	for y: int in range(area.position.y, area.end.y, 4):
		for x: int in range(area.position.x, area.end.x, 4):
			looked_at += 1
			different += int(one.get_pixel(x, y) != other.get_pixel(x, y))
	return float(different) / maxi(looked_at, 1)


## Labels and buttons of `holder` that stick out of it sideways, or whose text is clipped, less those of the engine's inspectors; and `holder` itself where it
## needs more room than it asks for.
static func find_cut(holder: Control) -> PackedStringArray:
	var cut := PackedStringArray()
	var room: Rect2 = holder.get_global_rect().grow(1.0)
	if holder.get_combined_minimum_size().x > maxf(holder.custom_minimum_size.x, 1.0) + 1.0:
		cut.append("%s needs %d pixels" % [holder.name, holder.get_combined_minimum_size().x])
	var inspectors: Array[Node] = holder.find_children("*", "EditorInspector", true, false)
	for control: Control in holder.find_children("*", "Control", true, false):
		if inspectors.any(func(inspector: Node) -> bool: return inspector.is_ancestor_of(control)):
			continue
		var area: Rect2 = control.get_global_rect()
		var is_out: bool = area.position.x < room.position.x or area.end.x > room.end.x
		if control.is_visible_in_tree() and (control is Label or control is BaseButton) and (is_out or _is_clipped(control)):
			cut.append("%s %s" % [holder.get_path_to(control), area])
	return cut


static func _is_clipped(control: Control) -> bool:
	var label := control as Label
	var button := control as Button
	if label and label.autowrap_mode != TextServer.AUTOWRAP_OFF:
		return label.get_visible_line_count() < label.get_line_count()
	if label:
		return label.get_theme_font("font").get_string_size(label.text, 0, -1, label.get_theme_font_size("font_size")).x > label.size.x + 1.0
	if button == null or not button.clip_text and button.text_overrun_behavior == TextServer.OVERRUN_NO_TRIMMING:
		return false
	var text: float = button.get_theme_font("font").get_string_size(button.text, 0, -1, button.get_theme_font_size("font_size")).x
	return text + button.get_theme_stylebox("normal").get_minimum_size().x > button.size.x + 1.0


func wait_until(is_so: Callable, seconds: float = 20.0) -> bool:
	var end: float = Time.get_ticks_msec() + 1000.0 * seconds
	while not await is_so.call() and Time.get_ticks_msec() < end:
		await get_tree().process_frame
	return await is_so.call()
