@tool
extends "res://tests/editor/city_suite.gd"
## Types of lots and streets in the dock: their rules, weights and attributes.

const RuleAttributes := preload("res://addons/pcg/editor/city/rule_attributes.gd")


func test_attributes_are_controls_by_their_annotations() -> void:
	var type := PCGLotType.new()
	type.rules = load("res://rules/cga/house.cga")
	var attributes := RuleAttributes.new(type, type.rules)
	attributes.set("roofType", "hip") # the rules draw it, and these, for each house
	attributes.set("wallColor", "#ff0000")
	attributes.set("hasDormers", "true")
	attributes.end_typing()
	var by_name: Dictionary = {}
	for property: Dictionary in attributes.get_property_list():
		by_name[property["name"]] = property
	check(str(by_name["floorHeight"]["hint_string"]).begins_with("2.5,3.5"), "a range: %s" % [by_name["floorHeight"]])
	check_equal(by_name["roofType"]["hint_string"], "gable,hip", "a list")
	check_equal(by_name["wallColor"]["type"], TYPE_COLOR, "a colour")
	check_equal(by_name["hasDormers"]["type"], TYPE_BOOL, "a truth value")
	check_equal(by_name["Colours"]["usage"], PROPERTY_USAGE_GROUP, "a group")
	var names: Array = by_name.keys()
	check_equal(names[names.find("lod") - 1], "General", "what stands before all groups has a heading of its own")
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
	var attributes := RuleAttributes.new(type, type.rules)
	check_equal(attributes.get("high"), 2.8, "a number, not the least that is allowed")
	check_equal(attributes.get("roof"), "hip", "a choice")
	check_equal(attributes.get("wall"), Color("#336699"), "a colour")
	check_equal([attributes.get("drawn"), attributes.get("isTall")], ["rand(2, 4)", "high == 3"], "what differs from lot to lot stands as it is written")
	for name: String in ["high", "roof", "wall", "drawn", "isTall"]:
		check(not attributes.property_can_revert(name), "nothing to revert of %s" % name)
	attributes.set("high", 3.0)
	attributes.set("drawn", "2.5")
	attributes.set("isTall", "perhaps")
	check_equal(attributes.get("isTall"), "perhaps", "what is typed stands there while it is typed")
	attributes.end_typing()
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
	check_equal(list.get_root().get_child_count(), types.size() + 1, "a row for each type, and one for the streets")
	check((_tab.get_node("%RemoveType") as Button).disabled, "nothing is chosen")
	_tab.get_node("%LandUse").call("add_type", load("res://rules/cga/town_hall.cga"))
	await frames(2)
	check_equal(city.lot_types.size(), types.size() + 1, "another type")
	var added: PCGLotType = city.lot_types[-1]
	check_equal([added.type, added.rules.get_file()], ["town_hall", "res://rules/cga/town_hall.cga"], "called like its rules")
	list.get_root().get_child(-2).select(0)
	check_equal(_tab.get_attributes().subject, added, "its attributes are shown when it is chosen")
	_tab.get_node("%LandUse").call("give_rules", added, load("res://rules/cga/plaza.cga"))
	await frames(2)
	check_equal(list.get_root().get_child(-2).get_text(2), "plaza.cga", "other rules")
	check_equal(_tab.get_attributes().subject, added, "it is still the chosen one")
	(_tab.get_node("%RemoveType") as Button).pressed.emit()
	await frames(2)
	check_equal(city.lot_types, types, "gone")
	check(_tab.get_attributes().subject == null, "and its attributes")
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
	_tab.get_node("%LandUse").call("take_row", item)
	await frames(2)
	check_equal(city.lot_types[0].weight, before + 5.0, "set")
	await undo(city)
	check_equal(city.lot_types[0].weight, before, "undone")
	check_equal((_tab.get_node("%Types") as Tree).get_root().get_child(0).get_range(1), before, "and shown so")


func _street_row() -> TreeItem:
	return (_tab.get_node("%Types") as Tree).get_root().get_child(-1)


func _has_problem(file: String) -> bool:
	return get_authoring().dock.problems.get_shown().any(func(problem: Dictionary) -> bool: return str(problem["file"]).ends_with(file))


func test_streets_have_a_row_with_their_rules_and_attributes() -> void:
	var city: PCGCity = await _add_small_city()
	check_equal([_street_row().get_text(0), _street_row().is_checked(1)], ["streets", false], "built without rules")
	_street_row().set_checked(1, true)
	_tab.get_node("%LandUse").call("take_row", _street_row())
	await frames(2)
	check(city.use_street_rules, "with rules")
	check_equal(_street_row().get_text(2), "street.cga", "those that ship")
	_street_row().select(0)
	check((_tab.get_node("%RemoveType") as Button).disabled, "which cannot be taken back")
	check_equal(_tab.get_attributes().get("treeSpacing"), 12.0, "their attributes are shown")
	var names: Array = _tab.get_attributes().get_property_list().map(func(property: Dictionary) -> String: return property["name"])
	check(not names.has("streetWidth") and not names.has("lot/type"), "less those that the city says, and those of lots: %s" % [names])
	_tab.get_attributes().set("treeSpacing", 20.0)
	check_equal(city.street_attributes, {"treeSpacing": 20.0}, "and are set")
	_tab.get_node("%LandUse").call("give_rules", city, load(write("res://typed/streets.cga", CityForTests.STREETS)))
	await frames(2)
	check(_street_row().get_text(2) == "streets.cga" and _tab.get_attributes().subject == city, "other rules, still chosen")
	check_equal(_tab.get_attributes().get("stop"), "", "with their attributes")
	(_tab.get_node("%RemoveType") as Button).pressed.emit()
	await frames(2)
	check(city.street_rules == null, "taken back")
	await undo(city)
	check_equal(city.street_rules.get_file(), "res://typed/streets.cga", "and undone")
	await undo(city)
	await undo(city)
	check(city.street_rules == null and not city.use_street_rules and not _street_row().is_checked(1), "to the beginning")


func test_errors_of_street_rules_are_problems_and_saving_offers_to_regenerate() -> void:
	var city: PCGCity = await _add_small_city()
	city.street_rules = load(write("res://typed/streets.cga", CityForTests.STREETS))
	city.use_street_rules = true
	_tab.generate()
	await _generated(city)
	var faces: int = city.get_statistics()["faces"]
	var rules: Control = get_authoring().rules
	get_authoring().rules.open("res://typed/streets.cga")
	get_authoring().rules.get_current().text = CityForTests.STREETS.replace("s(1, 2, 1)", "s(1, 2, 1")
	get_authoring().rules.save_current()
	check(_has_problem("streets.cga"), "an error is listed while the file is open")
	get_authoring().rules.close_current()
	check(_has_problem("streets.cga"), "and when it is closed")
	check(_street_row().get_icon(2) != null, "and the row has a mark")
	get_authoring().rules.open("res://typed/streets.cga")
	get_authoring().rules.get_current().text = CityForTests.STREETS.replace("Junction --> t(0, -0.1, 0) Asphalt.", "Junction --> extrude(0.5) Asphalt.")
	get_authoring().rules.save_current()
	check(not _has_problem("streets.cga"), "mended: %s" % [get_authoring().dock.problems.get_shown()])
	check((rules.get_node("%Users") as Control).visible, "the city is told to use it")
	(rules.get_node("%Regenerate") as Button).pressed.emit()
	await _generated(city)
	check(int(city.get_statistics()["faces"]) != faces, "its streets are others: %d faces" % faces)
	get_authoring().rules.close_current()


func test_street_rules_that_ship_are_known_to_be_used() -> void:
	var city: PCGCity = await _add_small_city()
	check(not _tab.context.get_users("res://rules/cga/street.cga").has(city), "not without rules")
	city.use_street_rules = true
	check(_tab.context.get_users("res://rules/cga/street.cga").has(city), "a city that names none uses those that ship")
	check(_tab.context.get_users("res://rules/cga/furniture.cga").has(city), "and what they import")


func test_a_type_has_its_name_map_and_start_rule_beside_its_attributes() -> void:
	var city: PCGCity = await _add_small_city()
	(_tab.get_node("%Types") as Tree).get_root().get_child(0).select(0)
	var attributes: RuleAttributes = _tab.get_attributes()
	var map := GradientTexture2D.new()
	attributes.set("lot/weight_map", map)
	attributes.set("lot/start_rule", "Yard")
	check_equal([city.lot_types[0].weight_map, city.lot_types[0].start_rule], [map, "Yard"], "set")
	check(attributes.property_can_revert("lot/weight_map") and not RuleAttributes.new(city.lot_types[1], null).property_can_revert("lot/weight_map"), "and to be reverted")
	attributes.set("lot/weight_map", attributes.property_get_revert("lot/weight_map"))
	check(city.lot_types[0].weight_map == null, "to none")


func test_attributes_that_rules_gained_are_shown_when_they_are_saved() -> void:
	var city: PCGCity = await _add_small_city()
	city.lot_types[0].rules = load(write("res://typed/gained.cga", CityForTests.HOUSE))
	_tab.show_land_use()
	(_tab.get_node("%Types") as Tree).get_root().get_child(0).select(0)
	get_authoring().rules.open("res://typed/gained.cga")
	get_authoring().rules.get_current().text = "attr high = 6\n" + CityForTests.HOUSE.replace("extrude(6)", "extrude(high)")
	get_authoring().rules.save_current()
	check_equal(_tab.get_attributes().get("high"), 6.0, "the new attribute")
	get_authoring().rules.close_current()
