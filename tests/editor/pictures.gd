@tool
extends Node
## Takes pictures of the editor with the addon at work, for the documentation and for whoever looks whether all is in its place.
##
##     xvfb-run -a godot --editor --path build/picture_project --rendering-driver opengl3 -- --pictures FOLDER
##
## tools/editor_pictures.py does that, in the light and the dark theme and at 100 and 200 %.

const Authoring := preload("res://addons/pcg/editor/authoring.gd")

const PICTURED_PERSONS := 60
const AFTER_SCHOOL := 17.0 ## o'clock
const PICTURED_LOTS := 20 ## few, because pictures are drawn without a graphics card

var authoring: Authoring
var folder := ""


func run(of: Authoring, into: String) -> void:
	RenderingServer.render_loop_enabled = false
	authoring = of
	folder = into
	await _wait(20)
	await _take_rules()
	await _take_city()
	await _take_people()
	await _take_gizmos()


func _take_rules() -> void:
	authoring.show_place("res://rules/cga/house.cga", 0)
	var edit: CodeEdit = authoring.rules.get_current()
	_break_rule(edit)
	await _wait(6)
	_save("rules")
	_mend_rule(edit)
	await _wait(6)
	_save("rules_good")
	await _take_rules_questions(edit)
	authoring.plugin.hide_bottom_panel()


# What is looked for in a rule file, and what is asked when it is closed or was written by another program.
func _take_rules_questions(edit: CodeEdit) -> void:
	EditorInterface.get_file_system_dock().navigate_to_path("res://rules/cga/house.cga")
	var bar: Node = authoring.rules.get_node("%FindBar")
	bar.call("open", true)
	(bar.get_node("%Query") as LineEdit).text = "split"
	bar.call("find")
	await _wait(6)
	_save("rules_find")
	bar.call("close")
	edit.insert_line_at(0, "// changed")
	authoring.rules.close_current()
	await _wait(4)
	_save("rules_close")
	(authoring.rules.get_node("%CloseQuestion") as Window).hide()
	edit.set("read_time", 1)
	authoring.rules.reread_changed()
	await _wait(4)
	_save("rules_newer")
	var question: ConfirmationDialog = authoring.rules.get_node("%NewerQuestion")
	question.hide()
	question.canceled.emit()
	edit.undo()
	edit.tag_saved_version()


func _break_rule(edit: CodeEdit) -> void:
	edit.set_line(42, edit.get_line(42).replace("split(x)", "split(x"))
	edit.call("check")
	edit.call("go_to", 43, 13)


func _mend_rule(edit: CodeEdit) -> void:
	edit.undo()
	edit.call("check")
	edit.tag_saved_version()


func _take_city() -> void:
	authoring.dock.city_tab.create_city()
	_show_dock(authoring.dock)
	await _wait(5)
	var city: PCGCity = authoring.context.city
	city.layout.fit_lots(PICTURED_LOTS)
	authoring.dock.city_tab.generate()
	while city.is_generating():
		await get_tree().process_frame
	EditorInterface.get_selection().clear()
	printerr("generated after ", Time.get_ticks_msec(), " ms")
	await _look_at(Vector3.ZERO, 190.0)
	await _wait(8)
	_save("city")
	var pages: TabContainer = authoring.dock.city_tab.get_node("%Pages")
	pages.current_tab = 1
	await _wait(5)
	_save("city_layout")
	pages.current_tab = 2
	(authoring.dock.city_tab.get_node("%Types") as Tree).get_root().get_child(0).select(0)
	await _wait(5)
	_save("city_rules")


func _take_people() -> void:
	var dock: Authoring.PCGDock = authoring.dock
	dock.show_page(1)
	authoring.context.citizens.person_count = PICTURED_PERSONS
	authoring.dock.population_tab.generate()
	await _wait(4)
	_save("population")
	(authoring.dock.population_tab.get_node("%Pages") as TabContainer).current_tab = 1
	await _wait(3)
	_save("shares")
	authoring.context.citizens.jump_to(0, 7.95 * 3600.0)
	dock.show_page(2)
	authoring.dock.simulation_tab.start_survey()
	await authoring.dock.simulation_tab.survey.ended
	(authoring.dock.simulation_tab.get_node("%Heat") as CheckBox).button_pressed = true
	authoring.context.citizens.paused = true
	await _look_at(_find_crowd(), 26.0)
	await _wait(4)
	_save("simulation")
	(authoring.dock.simulation_tab.get_node("%Heat") as CheckBox).button_pressed = false
	await _look_at(Vector3(-75.0, 0.0, 0.0), 70.0)
	dock.show_page(3)
	authoring.context.choose_person(_find_child())
	(authoring.dock.person_tab.get_node("%Ways") as CheckBox).button_pressed = true
	await _live_until(AFTER_SCHOOL)
	_save("person")
	var dialog: Window = authoring.dock.person_tab.get_node("%EntryDialog")
	dialog.call("ask", authoring.context, {})
	await _wait(4)
	_save("entry")
	dialog.hide()
	await _take_problems()


func _take_problems() -> void:
	authoring.show_place("res://rules/cga/house.cga", 0)
	_break_rule(authoring.rules.get_current())
	_show_dock(authoring.dock)
	authoring.plugin.hide_bottom_panel()
	authoring.dock.show_page(4)
	await _wait(5)
	_save("problems")
	_mend_rule(authoring.rules.get_current())


# So that there is something lived below what is planned.
func _live_until(hour: float) -> void:
	while authoring.context.citizens.time < hour * 3600.0:
		authoring.context.citizens.advance(120.0)
		await _wait(1)
	await _wait(4)


# Where somebody outdoors has most others around.
func _find_crowd() -> Vector3:
	var places: Array = Array(authoring.context.citizens.get_persons_outside()).map(func(person: int) -> Vector3:
		return authoring.context.citizens.get_person(person)["position"])
	var count_near := func(place: Vector3) -> int:
		return places.filter(func(other: Vector3) -> bool: return place.distance_to(other) < 8.0).size()
	places.sort_custom(func(one: Vector3, other: Vector3) -> bool: return count_near.call(one) > count_near.call(other))
	return places[0] if not places.is_empty() else Vector3.ZERO


# Whose week has most ways.
func _find_child() -> int:
	for person: int in authoring.context.count_persons():
		if int(authoring.context.citizens.get_person(person)["age"]) in range(7, 15):
			return person
	return 0


func _take_gizmos() -> void:
	(authoring.dock.person_tab.get_node("%Ways") as CheckBox).button_pressed = false
	authoring.dock.show_page(0)
	for picture: Array in [["gizmos", "PCGZone", 24.0], ["gizmos_door", "PCGEntrance", 9.0], ["gizmos_object", "PCGObject", 7.0]]:
		var nodes: Array[Node] = authoring.context.city.find_children("*", picture[1], true, false)
		EditorInterface.edit_node(nodes[0])
		await _look_at((nodes[0] as Node3D).global_position, picture[2])
		await _wait(3)
		_save(picture[0])
	await _take_courtyard()


# A lot with a courtyard: the only one of a footprint that is drawn with a hole.
func _take_courtyard() -> void:
	var city: PCGCity = authoring.context.city
	var outline: Polygon2D = _draw(Rect2(300, 0, 40, 40))
	outline.add_child(_draw(Rect2(310, 10, 20, 20)))
	city.add_child(outline)
	city.layout = PCGLayout.new()
	city.layout.kind = PCGLayout.KIND_FOOTPRINTS
	city.lot_types = city.lot_types.slice(0, 1)
	city.use_street_rules = false
	authoring.dock.city_tab.generate()
	while city.is_generating():
		await get_tree().process_frame
	EditorInterface.edit_node(city.find_children("*", "PCGLot", true, false)[0])
	await _look_at(Vector3(320, 0, 20), 60.0)
	await _wait(3)
	_save("gizmos_courtyard")


static func _draw(rect: Rect2) -> Polygon2D:
	var drawn := Polygon2D.new()
	drawn.polygon = [rect.position, rect.position + Vector2(0, rect.size.y), rect.end, rect.position + Vector2(rect.size.x, 0)]
	drawn.visible = false
	return drawn


func _show_dock(content: Control) -> void:
	(content.get_parent() as EditorDock).make_visible()


# Puts the editor's camera where it sees a point from `metres` away; it stays there until somebody moves it.
func _look_at(point: Vector3, metres: float) -> void:
	EditorInterface.set_main_screen_editor("3D")
	await _wait(3)
	var camera: Camera3D = EditorInterface.get_editor_viewport_3d(0).get_camera_3d()
	camera.look_at_from_position(point + Vector3(0.5, 0.75, 0.75).normalized() * metres, point)


# Drawing without a graphics card takes most of the time, so nothing is drawn while nobody looks.
func _wait(frames: int) -> void:
	RenderingServer.render_loop_enabled = false
	for frame: int in frames:
		await get_tree().process_frame


func _save(picture: String) -> void:
	printerr("picture ", picture, " after ", Time.get_ticks_msec(), " ms")
	# An editor in which nothing moves draws no frames, so one cannot wait for one.
	for frame: int in 2:
		RenderingServer.force_draw()
	var image: Image = get_tree().root.get_texture().get_image()
	image.convert(Image.FORMAT_RGB8)
	image.save_png(folder.path_join(picture + ".png"))
