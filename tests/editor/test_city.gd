@tool
extends "res://tests/editor/city_suite.gd"
## The dock's page for a city: added to an empty project, generated, undone, done again.


func test_a_city_with_people_is_one_click_and_one_undo() -> void:
	check((_tab.get_node("%Empty") as Control).visible, "without a city there is one button")
	_tab.create_city()
	await frames(3)
	check(_tab.context.city != null, "the dock shows the city")
	check(_tab.context.city.lot_types.size() >= 6 and _tab.context.citizens.rules != null, "with the shipped rules")
	check_equal(_tab.context.citizens.city, _tab.context.city, "people live in it")
	check(_tab.context.citizens.household_table.get_households().size() > 3, "and come from a table")
	await undo(_root)
	check(_tab.context.city == null and _root.get_child_count() == 0, "gone")
	await redo(_root)
	check(_tab.context.city != null, "and back")


func test_generating_is_one_step_to_undo() -> void:
	var city: PCGCity = await _add_small_city()
	_tab.generate()
	await _generated(city)
	check(city.is_generated(), "it is there")
	check_equal((_tab.get_node("%Progress") as Control).visible, false, "and the progress gone")
	var faces: int = city.get_statistics()["faces"]
	await undo(city)
	check(not city.is_generated(), "undone: it is gone")
	await redo(city)
	await _generated(city)
	check_equal(city.get_statistics()["faces"], faces, "done again: the same city")


func test_statistics_tell_times_with_their_unit() -> void:
	var city: PCGCity = await _add_small_city()
	_tab.generate()
	await _generated(city)
	var rows: Dictionary[String, TreeItem] = {}
	for row: TreeItem in (_tab.get_node("%Statistics") as Tree).get_root().get_children():
		rows[row.get_text(0)] = row
	check_equal(rows["Lots"].get_text(1), str(city.get_statistics()["lots"]), "a number is a number")
	for row: TreeItem in rows["Time"].get_children() + [rows["Longest Hold"]] as Array[TreeItem]:
		check(row.get_text(1).ends_with("s") and row.get_text(1).to_float() >= 0.0, "a time has its unit: %s %s" % [row.get_text(0), row.get_text(1)])


func test_the_dice_change_the_city_and_undo_brings_the_old_one_back() -> void:
	var city: PCGCity = await _add_small_city()
	_tab.generate()
	await _generated(city)
	var seed_before: int = city.seed
	_tab.throw_dice()
	await _generated(city)
	check(city.seed != seed_before, "another seed")
	await undo(city)
	await _generated(city)
	check_equal(city.seed, seed_before, "the old seed")
	check(city.is_generated(), "and its city")


func test_selected_lots_and_blocks_are_generated_anew_with_what_their_types_have() -> void:
	var city: PCGCity = await _add_small_city()
	_tab.generate()
	await _generated(city)
	var lot: PCGLot = city.find_children("*", "PCGLot", true, false).filter(func(node: PCGLot) -> bool: return node.type == "house")[0]
	var number: int = lot.lot_id
	EditorInterface.get_selection().clear()
	EditorInterface.get_selection().add_node(lot.get_child(0))
	check_equal(_tab.get_selected_lots(), [number] as Array[int], "the lot of what is selected")
	city.lot_types[0].rules = CityForTests.make_rules(CityForTests.HOUSE.replace("extrude(6)", "extrude(9) split(y) { 3: X. | ~1: X. }"))
	var faces: int = city.get_statistics()["faces"]
	_tab.generate_selected()
	await frames(3)
	check(int(city.get_statistics()["faces"]) != faces, "the lot is another")
	await undo(city)
	check_equal(city.get_statistics()["faces"], faces, "and the old one again")
	EditorInterface.get_selection().clear()
	EditorInterface.get_selection().add_node(city)
	check_equal(_tab.get_selected_lots().size(), city.get_statistics()["lots"], "a node above them means all of them")


func test_undo_makes_the_city_that_stood_there_with_its_lots_of_other_rules() -> void:
	var city: PCGCity = await _add_small_city()
	_tab.generate()
	await _generated(city)
	var lot: PCGLot = city.find_children("*", "PCGLot", true, false).filter(func(node: PCGLot) -> bool: return node.type == "house")[0]
	var old_rules: PCGRuleSet = city.lot_types[0].rules
	var new_rules: PCGRuleSet = CityForTests.make_rules(CityForTests.HOUSE.replace("extrude(6)", "extrude(9) split(y) { 3: X. | ~1: X. }"))
	city.lot_types[0].rules = new_rules
	EditorInterface.get_selection().clear()
	EditorInterface.get_selection().add_node(lot)
	_tab.generate_selected()
	await frames(3)
	var faces: int = city.get_statistics()["faces"]
	_tab.throw_dice()
	await _generated(city)
	check(int(city.get_statistics()["faces"]) != faces, "a city of the new rules only")
	await undo(city)
	await _generated(city)
	check_equal(city.get_statistics()["faces"], faces, "one house is of the new rules, the others of the old ones")
	check_equal(city.lot_types[0].rules, new_rules, "which its type has")
	await undo(city)
	check_equal(city.lot_types[0].rules, old_rules, "before that the old ones")
	await redo(city)
	check_equal(city.get_statistics()["faces"], faces, "and again")


func test_a_saved_scene_comes_back_with_its_city_and_its_rules() -> void:
	var city: PCGCity = await _add_small_city()
	city.lot_types[0].rules = load(write("res://typed/house.cga", CityForTests.HOUSE))
	_tab.generate()
	await _generated(city)
	var figures: Dictionary = city.get_statistics()
	EditorInterface.save_scene_as("res://typed/world.tscn", false)
	EditorInterface.close_scene()
	await frames(3)
	check(_tab.context.city == null, "closed")
	EditorInterface.open_scene_from_path("res://typed/world.tscn")
	await frames(5)
	check(_tab.context.city != null and _tab.context.city.is_generated(), "the city is there")
	for figure: String in ["lots", "faces", "buildings", "entrances"]:
		check_equal(_tab.context.city.get_statistics()[figure], figures[figure], figure)
	check_equal(_tab.context.city.lot_types[0].rules.get_file(), "res://typed/house.cga", "built by its rule file")


func test_saving_rules_offers_to_regenerate_what_uses_them() -> void:
	var city: PCGCity = await _add_small_city()
	city.lot_types[0].rules = load(write("res://typed/used.cga", CityForTests.HOUSE))
	_tab.generate()
	await _generated(city)
	var faces: int = city.get_statistics()["faces"]
	var rules: Control = get_authoring().rules
	get_authoring().rules.open("res://typed/used.cga")
	get_authoring().rules.get_current().text = CityForTests.HOUSE.replace("extrude(6)", "extrude(9) split(y) { 3: X. | ~1: X. }")
	get_authoring().rules.save_current()
	check((rules.get_node("%Users") as Control).visible, "it tells that a node uses them")
	(rules.get_node("%Regenerate") as Button).pressed.emit()
	await _generated(city)
	check(int(city.get_statistics()["faces"]) != faces, "the city is another")
	get_authoring().rules.close_current()


func test_a_click_on_a_building_selects_its_lot() -> void:
	var city: PCGCity = await _add_small_city()
	_tab.generate()
	await _generated(city)
	var lot: PCGLot = city.find_children("*", "PCGLot", true, false)[0]
	var geometry: Node = lot.get_node("Geometry")
	var click := InputEventMouseButton.new()
	click.button_index = MOUSE_BUTTON_LEFT
	click.pressed = true
	get_authoring().take_viewport_input(EditorInterface.get_editor_viewport_3d(0).get_camera_3d(), click)
	EditorInterface.edit_node(geometry)
	await frames(3)
	check_equal(EditorInterface.get_selection().get_selected_nodes(), [lot] as Array[Node], "by a click")
	await frames(5)
	EditorInterface.edit_node(geometry)
	await frames(3)
	check_equal(EditorInterface.get_selection().get_selected_nodes(), [geometry] as Array[Node], "the geometry in the scene dock")


func test_cancelling_leaves_nothing_running() -> void:
	var city: PCGCity = await _add_small_city()
	_tab.generate()
	await frames(1)
	(_tab.get_node("%Cancel") as Button).pressed.emit()
	await _generated(city)
	check(not city.is_generated(), "cancelled")
	check(not (_tab.get_node("%Generate") as Button).disabled, "and ready to begin again")


func test_problems_of_the_scene_are_listed_and_lead_to_their_place() -> void:
	var city: PCGCity = await _add_small_city()
	write("res://typed/wrong.cga", "@StartRule\nLot -->\n\textrud(3)\n")
	var types: Array[PCGLotType] = city.lot_types
	types[0].rules = load("res://typed/wrong.cga")
	_tab.context.changed.emit()
	await frames(2)
	var shown: Array[Dictionary] = get_authoring().dock.problems.get_shown()
	check(shown.size() > 0 and str(shown[0]["file"]).ends_with("wrong.cga"), "the rules' message: %s" % [shown])
	get_authoring().dock.problems.problem_activated.emit(shown[0])
	await frames(2)
	check_equal(get_authoring().rules.get_current().get_caret_line(), 2, "its line")
	get_authoring().rules.close_current()


func test_undo_brings_back_streets_and_cells_that_the_city_was_made_with() -> void:
	var city: PCGCity = await _add_small_city()
	_tab.generate()
	await _generated(city)
	var faces: int = city.get_statistics()["faces"]
	city.use_street_rules = true
	city.street_attributes = {"stop": "yes"}
	city.street_rules = load(write("res://typed/streets.cga", CityForTests.STREETS))
	city.cell_size = 0.5
	_tab.generate()
	await _generated(city)
	check(int(city.get_statistics()["faces"]) != faces, "streets by rules")
	await undo(city)
	await _generated(city)
	check_equal(city.get_statistics()["faces"], faces, "plain ones again")
	check_equal([city.use_street_rules, city.street_attributes, city.street_rules == null, city.cell_size], [false, {}, true, 0.0], "with their settings")
	await redo(city)
	await _generated(city)
	check_equal([city.use_street_rules, city.street_attributes, city.cell_size], [true, {"stop": "yes"}, 0.5], "and those of the other")


func test_settings_of_the_city_that_change_elsewhere_are_shown() -> void:
	var city: PCGCity = await _add_small_city()
	var settings: EditorInspector = _tab.get_node("%Settings").find_children("*", "EditorInspector", false, false)[0]
	check_equal(settings.get_edited_object(), city, "the city's own settings")
	var layout: PCGLayout = city.layout
	var undo_redo: EditorUndoRedoManager = EditorInterface.get_editor_undo_redo()
	undo_redo.create_action("no layout", UndoRedo.MERGE_DISABLE, city)
	undo_redo.add_do_property(city, &"layout", null)
	undo_redo.add_undo_property(city, &"layout", layout)
	undo_redo.commit_action()
	await frames(2)
	check((_tab.get_node("%LayoutText") as Label).visible, "that there is no layout is told")
	await undo(city)
	check(not (_tab.get_node("%LayoutText") as Label).visible, "and is over")
