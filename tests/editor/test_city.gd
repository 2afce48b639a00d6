@tool
extends "res://tests/editor/editor_suite.gd"
## The dock's page for a city: added to an empty project, generated, undone, done again.

const CityForTests := preload("res://tests/godot/city_for_tests.gd")
const CityTab := preload("res://addons/pcg/editor/city/city_tab.gd")
const RuleAttributes := preload("res://addons/pcg/editor/city/rule_attributes.gd")

var _tab: CityTab
var _root: Node3D


func before_each() -> void:
	_tab = get_authoring().dock.city_tab
	EditorInterface.close_scene()
	_root = Node3D.new()
	_root.name = "World"
	EditorInterface.add_root_node(_root)
	await frames(2)


func after_each() -> void:
	EditorInterface.close_scene()
	await frames(2)


func _add_small_city() -> PCGCity:
	var city: PCGCity = CityForTests.make_city(12)
	_root.add_child(city)
	city.owner = _root
	await frames(2)
	return city


func _generated(city: PCGCity) -> void:
	while city.is_generating():
		await get_tree().process_frame
	await frames(2)


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
	await get_tree().create_timer(0.5).timeout
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


func test_attributes_are_controls_by_their_annotations() -> void:
	var type := PCGLotType.new()
	type.rules = load("res://rules/cga/house.cga")
	var attributes := RuleAttributes.new(type)
	attributes.set("roofType", "hip") # the rules draw it, and these, for each house
	attributes.set("wallColor", "#ff0000")
	attributes.set("hasDormers", "true")
	var by_name: Dictionary = {}
	for property: Dictionary in attributes.get_property_list():
		by_name[property["name"]] = property
	check(str(by_name["floorHeight"]["hint_string"]).begins_with("2.5,3.5"), "a range: %s" % [by_name["floorHeight"]])
	check_equal(by_name["roofType"]["hint_string"], "gable,hip", "a list")
	check_equal(by_name["wallColor"]["type"], TYPE_COLOR, "a colour")
	check_equal(by_name["hasDormers"]["type"], TYPE_BOOL, "a truth value")
	check_equal(by_name["Colours"]["usage"], PROPERTY_USAGE_GROUP, "a group")
	check(not by_name.has("plinthColor"), "names without attr are the rules' own")
	check_equal(type.attributes, {"roofType": "hip", "wallColor": "#ff0000", "hasDormers": true}, "as the rules want it")
	attributes.set("wallColor", Color("#00ff00"))
	check_equal(type.attributes["wallColor"], "#00ff00", "also by a colour")


func test_attributes_that_are_left_to_the_rules_show_what_those_say() -> void:
	var type := PCGLotType.new()
	type.rules = CityForTests.make_rules("""@Range(min=2, max=5)
attr high =
	2.8 // on the next line
@Range(min=1, max=9)
attr drawn = rand(2, 4)
attr isTall = high == 3
@Enum("gable", "hip")
attr roof = "hip"
@Color
attr wall = "#336699"
@StartRule
Lot --> extrude(high) X.
""")
	var attributes := RuleAttributes.new(type)
	check_equal(attributes.get("high"), 2.8, "a number, not the least that is allowed")
	check_equal(attributes.get("roof"), "hip", "a choice")
	check_equal(attributes.get("wall"), Color("#336699"), "a colour")
	check_equal([attributes.get("drawn"), attributes.get("isTall")], ["rand(2, 4)", "high == 3"], "what differs from lot to lot stands as it is written")
	for name: String in ["high", "roof", "wall", "drawn", "isTall"]:
		check(not attributes.property_can_revert(name), "nothing to revert of %s" % name)
	attributes.set("high", 3.0)
	attributes.set("drawn", "2.5")
	attributes.set("isTall", "perhaps")
	check_equal(type.attributes, {"high": 3.0, "drawn": 2.5}, "what is a value is set")
	check_equal([attributes.get("drawn"), attributes.get("isTall")], [2.5, "high == 3"], "and shown")
	for name: String in ["high", "drawn"]:
		check(attributes.property_can_revert(name), "%s can be reverted" % name)
		attributes.set(name, attributes.property_get_revert(name))
	check_equal(type.attributes, {}, "to what the rules say")


func test_setting_an_attribute_can_be_undone() -> void:
	var city: PCGCity = await _add_small_city()
	city.lot_types[0].rules = load("res://rules/cga/house.cga")
	_tab.show_attributes(city.lot_types[0])
	await frames(2)
	var controls: Array = _tab.get_node("%Attributes").find_children("*", "EditorProperty", true, false)
	var control: EditorProperty = controls.filter(func(other: EditorProperty) -> bool: return other.get_edited_property() == &"houseWidth")[0]
	control.emit_changed(&"houseWidth", "11")
	check_equal(city.lot_types[0].attributes, {"houseWidth": 11.0}, "in place of what the rules draw")
	await undo(_tab.get_attributes())
	check_equal(city.lot_types[0].attributes, {}, "undone")


func test_types_of_lots_are_added_given_rules_and_removed() -> void:
	var city: PCGCity = await _add_small_city()
	var types: Array[PCGLotType] = city.lot_types
	var list: Tree = _tab.get_node("%Types")
	check_equal(list.get_root().get_child_count(), types.size(), "a row for each type")
	check((_tab.get_node("%RemoveType") as Button).disabled, "nothing is chosen")
	_tab.get_node("%LandUse").call("add_type", load("res://rules/cga/town_hall.cga"))
	await frames(2)
	check_equal(city.lot_types.size(), types.size() + 1, "another type")
	var added: PCGLotType = city.lot_types[-1]
	check_equal([added.type, added.rules.get_file()], ["town_hall", "res://rules/cga/town_hall.cga"], "called like its rules")
	list.get_root().get_child(-1).select(0)
	check_equal(_tab.get_attributes().lot_type, added, "its attributes are shown when it is chosen")
	_tab.get_node("%LandUse").call("give_rules", added, load("res://rules/cga/plaza.cga"))
	await frames(2)
	check_equal(list.get_root().get_child(-1).get_text(2), "plaza.cga", "other rules")
	check_equal(_tab.get_attributes().lot_type, added, "it is still the chosen one")
	(_tab.get_node("%RemoveType") as Button).pressed.emit()
	await frames(2)
	check_equal(city.lot_types, types, "gone")
	check(_tab.get_attributes().lot_type == null, "and its attributes")
	await undo(city)
	await undo(city)
	check_equal([city.lot_types[-1], added.rules.get_file()], [added, "res://rules/cga/town_hall.cga"], "back, with its first rules")
	await undo(city)
	check_equal(city.lot_types, types, "and as in the beginning")


func test_a_weight_is_set_in_the_list_and_undone() -> void:
	var city: PCGCity = await _add_small_city()
	var item: TreeItem = (_tab.get_node("%Types") as Tree).get_root().get_child(0)
	var before: float = city.lot_types[0].weight
	(_tab.get_node("%Types") as Tree).set_selected(item, 1)
	item.set_range(1, before + 5.0)
	_tab.get_node("%LandUse").call("set_weight", item)
	await frames(2)
	check_equal(city.lot_types[0].weight, before + 5.0, "set")
	await undo(city)
	check_equal(city.lot_types[0].weight, before, "undone")
	check_equal((_tab.get_node("%Types") as Tree).get_root().get_child(0).get_range(1), before, "and shown so")


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
