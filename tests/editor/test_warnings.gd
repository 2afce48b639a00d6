@tool
extends "res://tests/editor/city_suite.gd"
## The signs of configuration warnings in the Scene dock: each comes with its cause and goes when that is mended.


const PATIENCE := 3000 ## milliseconds; the Scene dock gathers what is new for half a second


## What the sign beside a node tells; empty where there is none.
func _sign(node: Node) -> String:
	for tree: Tree in get_tree().root.find_children("*", "Tree", true, false):
		if tree.get_parent().is_class("SceneTreeEditor") and tree.is_inside_tree() and tree.get_root():
			var item: TreeItem = _find_item(tree.get_root(), node.get_path())
			if item:
				return _find_warning(item)
	return "there is no such row"


func _find_item(item: TreeItem, path: NodePath) -> TreeItem:
	if item.get_metadata(0) is NodePath and item.get_metadata(0) == path:
		return item
	for child: TreeItem in item.get_children():
		var found: TreeItem = _find_item(child, path)
		if found:
			return found
	return null


func _find_warning(item: TreeItem) -> String:
	for index: int in item.get_button_count(0):
		var told: String = item.get_button_tooltip_text(0, index)
		if told.contains("warning"):
			return told
	return ""


func _add(node: Node, parent: Node) -> Node:
	parent.add_child(node)
	node.owner = _root
	await frames(2)
	return node


func _wait_for(node: Node, is_so: Callable) -> String:
	var end: int = Time.get_ticks_msec() + PATIENCE
	while not is_so.call(_sign(node)) and Time.get_ticks_msec() < end:
		await get_tree().process_frame
	return _sign(node)


func _check_sign(node: Node, words: String) -> void:
	var told: String = await _wait_for(node, func(sign: String) -> bool: return sign.contains(words))
	check(told.contains(words), "%s: a sign that says \"%s\", not \"%s\"" % [node.name, words, told])


func _check_no_sign(node: Node, after: String) -> void:
	await get_tree().create_timer(0.6).timeout
	var told: String = await _wait_for(node, func(sign: String) -> bool: return sign.is_empty())
	check(told.is_empty(), "%s: no sign %s, not \"%s\"" % [node.name, after, told])


func _generated_city() -> PCGCity:
	var city: PCGCity = await _add_small_city()
	city.generate()
	await _generated(city)
	return city


func test_what_belongs_to_no_city_and_has_no_type() -> void:
	var city: PCGCity = await _generated_city()
	for kind: StringName in [&"PCGEntrance", &"PCGZone", &"PCGObject"]:
		var node: Node3D = ClassDB.instantiate(kind)
		node.position = Vector3(5000.0, 0.0, 0.0)
		if node is PCGZone:
			node.polygon = PackedVector3Array([Vector3.ZERO, Vector3(4.0, 0.0, 0.0), Vector3(0.0, 0.0, -4.0)])
		await _add(node, _root)
		await _check_sign(node, "has no type")
		await _check_sign(node, "belongs to no city")
		node.set("type", "bench")
		await _check_sign(node, "belongs to no city")
		node.global_position = Vector3(1.0, 0.0, 1.0)
		await _check_no_sign(node, "on a city's ground")
		node.set("type", "")
		await _check_sign(node, "has no type")
		node.set("type", "bench")
		node.global_position = Vector3(1.0, 0.0, 1.0)
		await _check_no_sign(node, "with a type")
	var below := PCGEntrance.new()
	below.type = "house"
	await _add(below, _root)
	below.reparent(city)
	await _check_no_sign(below, "below a city")


func test_a_zone_without_ground() -> void:
	var city: PCGCity = await _generated_city()
	var zone := PCGZone.new()
	zone.type = "park"
	await _add(zone, city)
	await _check_sign(zone, "has no ground")
	zone.polygon = PackedVector3Array([Vector3.ZERO, Vector3(4.0, 0.0, 0.0), Vector3(0.0, 0.0, -4.0)])
	await _check_no_sign(zone, "with a polygon")
	zone.position.y = 80.0
	await frames(20)
	await _check_sign(zone, "Nobody can walk to this zone")
	zone.position.y = 0.0
	await frames(20)
	await _check_no_sign(zone, "on the ground again")


func test_an_entrance_that_nobody_can_reach() -> void:
	var city: PCGCity = await _generated_city()
	var entrance := PCGEntrance.new()
	entrance.type = "house"
	entrance.position = Vector3(0.0, 80.0, 0.0) # nobody flies
	await _add(entrance, city)
	await frames(20)
	await _check_sign(entrance, "Nobody can walk to this entrance")
	entrance.transform = city.find_children("*", "PCGEntrance", true, false)[0].global_transform
	await frames(20)
	await _check_no_sign(entrance, "at a door")


func test_lots_that_overlap() -> void:
	var city: PCGCity = await _generated_city()
	var lots: Array[Node] = city.find_children("*", "PCGLot", true, false)
	var lot: PCGLot = lots[0]
	await _check_no_sign(lot, "at home")
	var home: Vector3 = lot.position
	lot.position += Vector3(8.0, 0.0, 0.0)
	await frames(20)
	await _check_sign(lot, "overlap by")
	lot.position = home
	await frames(20)
	await _check_no_sign(lot, "back home")


func test_a_city_without_layout_rules_or_with_errors_in_them() -> void:
	var city: PCGCity = await _add_small_city()
	await _check_no_sign(city, "as it comes")
	var layout: PCGLayout = city.layout
	city.layout = null
	await _check_sign(city, "has no layout")
	city.layout = layout
	await _check_no_sign(city, "with a layout")
	var types: Array[PCGLotType] = city.lot_types
	city.lot_types = [] as Array[PCGLotType]
	await _check_sign(city, "has no lot types")
	city.lot_types = types
	var rules: PCGRuleSet = types[0].rules
	types[0].rules = null
	await _check_sign(city, "has no rules")
	types[0].rules = load(write("res://typed/sign.cga", "@StartRule\nLot --> extrude(3\n"))
	await _check_sign(city, "have errors")
	get_authoring().rules.open("res://typed/sign.cga")
	get_authoring().rules.get_current().text = "@StartRule\nLot --> extrude(3) X.\n"
	get_authoring().rules.save_current()
	await _check_no_sign(city, "once its rules are mended and saved")
	get_authoring().rules.close_current()
	types[0].rules = rules


func test_citizens_without_city_rules_or_people() -> void:
	var city: PCGCity = await _add_small_city()
	var citizens := CitizenManager.new()
	await _add(citizens, _root)
	await _check_sign(citizens, "Nobody can live here")
	citizens.city = city
	await _check_sign(citizens, "Nobody knows what to do")
	citizens.rules = load(write("res://typed/sign.pcg", "@StartRule\nHousehold --> members {\n"))
	await _check_sign(citizens, "rules have errors")
	get_authoring().rules.open("res://typed/sign.pcg")
	get_authoring().rules.get_current().text = "@StartRule\nHousehold --> members { true: stayInside(0h, 24h, home) }\n"
	get_authoring().rules.save_current()
	get_authoring().rules.close_current()
	await _check_sign(citizens, "There are no households")
	var table := PCGHouseholdTable.new()
	table.source = "descriptor,weight\n"
	citizens.household_table = table
	await _check_sign(citizens, "household table has errors")
	table.source = CityForTests.HOUSEHOLDS
	await _check_no_sign(citizens, "with all that people need")
	citizens.person_count = 0
	await _check_sign(citizens, "Nobody is to be drawn")
	citizens.person_count = 20
	await _check_no_sign(citizens, "with all that people need")
