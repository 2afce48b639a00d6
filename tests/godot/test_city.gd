extends "res://tests/godot/suite.gd"
## Cities in the scene tree: what is made, that it repeats, and what is said when something is missing.

const CityForTests := preload("res://tests/godot/city_for_tests.gd")


func _grown(lots: int = 40, seed: int = 1) -> PCGCity:
	var city: PCGCity = CityForTests.make_city(lots)
	city.seed = seed
	add_child(city)
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	return city


func _count(city: PCGCity, group: StringName) -> int:
	return get_tree().get_nodes_in_group(group).filter(func(node: Node) -> bool: return city.is_ancestor_of(node)).size()


func test_the_same_seed_gives_the_same_city() -> void:
	var one: Dictionary = _grown(40, 7).get_statistics()
	var other: Dictionary = _grown(40, 7).get_statistics()
	for figure: String in ["seconds", "longest_hold"]:
		one.erase(figure)
		other.erase(figure)
	check_equal(one, other, "statistics")
	check(one["lots"] > 0 and one["faces"] > 0, "there is something: %s" % [one])


func test_what_has_meaning_has_a_node_in_a_group() -> void:
	var city: PCGCity = _grown()
	var made: Dictionary = city.get_statistics()
	var entrances := 0
	for count: int in made["entrances"].values():
		entrances += count
	check_equal(_count(city, &"pcg_lots"), made["lots"], "lots")
	check_equal(_count(city, &"pcg_entrances"), entrances, "entrances")
	check_equal(_count(city, &"pcg_zones"), made["zones"], "zones")
	var entrance: PCGEntrance = get_tree().get_first_node_in_group(&"pcg_entrances")
	check(made["entrances"].has(entrance.type), "an entrance knows its type")
	check(entrance.capacity > 0 and entrance.building_id >= 0, "and its capacity and building")
	var zone: PCGZone = get_tree().get_first_node_in_group(&"pcg_zones")
	check(zone.contains(zone.global_position), "a zone contains its own middle")
	check(not zone.contains(zone.global_position + Vector3(1000, 0, 0)), "and nothing far away")


func test_lots_have_few_surfaces() -> void:
	var city: PCGCity = _grown()
	for node: Node in city.find_children("Geometry", "MeshInstance3D", true, false):
		var instance := node as MeshInstance3D
		check(instance.mesh.get_surface_count() <= 4, "%s has %d surfaces" % [instance.get_path(), instance.mesh.get_surface_count()])


func test_generation_beside_the_main_thread_tells_its_progress() -> void:
	var city: PCGCity = CityForTests.make_city()
	var stages: Array[String] = []
	city.generation_progressed.connect(func(stage: String, fraction: float) -> void:
		check(fraction >= 0.0 and fraction <= 1.0, "a fraction")
		if stages.is_empty() or stages.back() != stage:
			stages.append(stage))
	add_child(city)
	check(city.generate(), "it begins")
	check(city.is_generating(), "and goes on")
	check_equal(await city.city_generated, true, "until it is told")
	check(city.is_generated() and not city.is_generating(), "and is there")
	check_equal(stages.slice(0, 4), ["lots", "scene", "navigation", "distances"] as Array[String], "stages in order")


func test_a_cancelled_generation_leaves_nothing() -> void:
	var city: PCGCity = CityForTests.make_city(200)
	add_child(city)
	city.generate()
	city.cancel()
	check(not city.is_generating() and not city.is_generated(), "nothing is there")
	check_equal(city.get_child_count(), 0, "no children")
	check_equal(await city.city_generated, false, "it is told")
	check(city.generate_now(), "and it can be generated again")


func test_every_generation_ends_in_one_signal_after_the_call() -> void:
	var city: PCGCity = CityForTests.make_city(12)
	var told: Array[bool] = []
	city.city_generated.connect(func(success: bool) -> void: told.append(success))
	expect_message("add it to the scene tree before generate()")
	check(not city.generate(), "outside the tree")
	check_equal(told, [] as Array[bool], "not told before the call returns")
	await get_tree().process_frame
	check_equal(told, [false] as Array[bool], "told that there is no city")
	add_child(city)
	city.generate_now()
	check_equal(told.size(), 1, "the same of generate_now()")
	await get_tree().process_frame
	check_equal(told, [false, true] as Array[bool], "told that there is a city")
	city.generate()
	expect_message("it is being generated already")
	check(not city.generate(), "a second call is refused")
	check_equal(await city.city_generated, true, "the first one goes on")
	expect_message("PCGCity has no layout")
	city.layout = null
	check(not city.generate(), "nothing to begin with")
	check_equal(await city.city_generated, false, "and still whoever awaits it goes on")
	check_equal(told, [false, true, true, false] as Array[bool], "once each")


func test_an_error_in_lots_is_no_success_but_leaves_a_city() -> void:
	expect_message("there is no rule \"Nowhere\"")
	var city: PCGCity = CityForTests.make_city(12)
	city.lot_types[0].start_rule = "Nowhere"
	add_child(city)
	city.generate()
	check_equal(await city.city_generated, false, "it is told")
	check(city.is_generated(), "the other lots are there")


func test_a_generation_that_is_cut_off_is_told() -> void:
	var city: PCGCity = CityForTests.make_city(200)
	add_child(city)
	city.generate()
	city.clear()
	check_equal(await city.city_generated, false, "by clear()")
	city.generate()
	remove_child(city)
	check_equal(await city.city_generated, false, "by leaving the tree")
	check(not city.is_generating(), "and it has ended")
	city.queue_free()


func test_a_city_that_is_freed_while_it_grows_goes_quietly() -> void:
	var city: PCGCity = CityForTests.make_city(200)
	add_child(city)
	city.generate()
	await get_tree().process_frame
	city.free()
	check(not is_instance_valid(city), "it is gone")


func test_generating_again_replaces_what_was_there() -> void:
	var city: PCGCity = _grown()
	var before: int = city.get_child_count()
	check(city.generate_now(), "again")
	await get_tree().process_frame
	check_equal(city.get_child_count(), before, "as many children as before")
	var cleared: Array[int] = [0]
	city.city_cleared.connect(func() -> void: cleared[0] += 1)
	city.clear()
	check_equal(city.get_child_count(), 0, "clear() takes all away")
	city.clear()
	check_equal(cleared[0], 1, "which is told once")


func test_a_building_has_the_type_and_place_of_its_first_door() -> void:
	var city: PCGCity = CityForTests.make_city(12)
	city.position = Vector3(100.0, 2.0, -30.0)
	add_child(city)
	city.generate_now()
	var doors: Dictionary[int, PCGEntrance] = {} # by building
	for door: PCGEntrance in city.find_children("*", "PCGEntrance", true, false):
		if not doors.has(door.building_id) or door.entrance_id < doors[door.building_id].entrance_id:
			doors[door.building_id] = door
	check_equal(doors.size(), city.get_building_count(), "each building has a door")
	for building: int in doors:
		check_equal(city.get_building(building)["type"], doors[building].type, "the type of building %d" % building)
		check((city.get_building(building)["position"] as Vector3).is_equal_approx(doors[building].global_position), "its place in the world")
	var door: PCGEntrance = doors[0]
	door.type = "kiosk"
	city.update_model()
	check_equal(city.get_building(0)["type"], "kiosk", "after an edit")
	door.free()
	city.update_model()
	check_equal(city.get_building(0), {}, "without a door it is gone")
	expect_message("buildings are numbered from 0")
	check_equal(city.get_building(city.get_building_count()), {}, "one that is not there")


func test_every_kind_of_layout_makes_a_city_whose_doors_can_be_reached() -> void:
	for kind: PCGLayout.Kind in [PCGLayout.KIND_GRID, PCGLayout.KIND_RADIAL, PCGLayout.KIND_GROWN]:
		var city: PCGCity = CityForTests.make_city(60)
		city.layout.kind = kind
		city.layout.rings = 1
		city.layout.jitter = 0.1
		city.layout.removed = 0.1
		add_child(city)
		check(city.generate_now(), "kind %d: %s" % [kind, city.get_diagnostics()])
		var buildings: int = city.get_building_count()
		check(buildings > 20, "kind %d: %d buildings" % [kind, buildings])
		for i: int in range(1, buildings):
			check(is_finite(city.get_distance(0, i)), "kind %d: a way from building 0 to %d" % [kind, i])
		city.free()


func test_districts_decide_what_their_lots_become() -> void:
	var city: PCGCity = CityForTests.make_city(40)
	var west := PCGDistrict.new()
	west.area = Rect2(0, 0, 0.5, 1)
	west.weights = {"park": 1.0}
	city.layout.districts = [west]
	add_child(city)
	check(city.generate_now(), "%s" % [city.get_diagnostics()])
	for lot: PCGLot in get_tree().get_nodes_in_group(&"pcg_lots"):
		if city.is_ancestor_of(lot) and lot.global_position.x < -1.0:
			check_equal(lot.type, "park", "what lies in the west")


func test_painted_land_use() -> void:
	var city: PCGCity = CityForTests.make_city(40)
	var picture: Image = Image.create(2, 1, false, Image.FORMAT_RGB8)
	picture.set_pixel(1, 0, Color.WHITE) # the east
	(city.lot_types[1] as PCGLotType).weight_map = ImageTexture.create_from_image(picture)
	add_child(city)
	check(city.generate_now(), "%s" % [city.get_diagnostics()])
	var workplaces: Array = city.find_children("*", "PCGLot", true, false).filter(func(lot: PCGLot) -> bool: return lot.type == "workplace")
	check(workplaces.size() > 2, "there are workplaces")
	check(workplaces.all(func(lot: PCGLot) -> bool: return lot.global_position.x > -60.0), "where they are painted")


func test_a_parameter_out_of_its_limits_is_named_with_its_limits() -> void:
	expect_message("the number of spokes is 3, but must be from 5 to 64")
	var city: PCGCity = CityForTests.make_city()
	city.layout.kind = PCGLayout.KIND_RADIAL
	city.layout.spokes = 3
	check_equal(city.layout.get_lot_count(), 0, "no lots")
	add_child(city)
	check(not city.generate_now(), "it says no")


func test_no_lots_are_refused_with_one_message() -> void:
	expect_message("number of blocks")
	var city: PCGCity = CityForTests.make_city()
	city.layout.blocks_x = 0
	add_child(city)
	check(not city.generate_now(), "it says no")
	check_equal(city.get_diagnostics().size(), 1, "with one diagnostic")


func test_a_city_without_lot_types_says_what_to_add() -> void:
	expect_message("PCGCity has no lot types")
	var city := PCGCity.new()
	city.layout = PCGLayout.new()
	add_child(city)
	check(not city.generate_now(), "it says no")


func test_rules_with_errors_are_named_with_file_and_line() -> void:
	expect_message("rules.cga:2:")
	var city: PCGCity = CityForTests.make_city()
	city.lot_types = [CityForTests.make_type("house", 1, "@StartRule\nLot --> extrude(\n")]
	add_child(city)
	check(not city.generate_now(), "it says no")


func test_agenda_rules_do_not_build_lots() -> void:
	expect_message("the rules of lot type \"house\" write agendas")
	var city: PCGCity = CityForTests.make_city()
	city.lot_types[0].rules = CityForTests.make_rules(CityForTests.WEEKDAY, PCGRuleSet.DIALECT_AGENDA)
	add_child(city)
	check(not city.generate_now(), "it says no")


func test_without_a_city_no_two_buildings_are_near() -> void:
	expect_message("there is no city yet, so no distances. Call generate()")
	var city: PCGCity = CityForTests.make_city(12)
	add_child(city)
	check_equal(city.get_distance(0, 1), INF, "before it is generated")
	check(city.generate_now(), "it generates")
	check_equal(city.get_distance(0, 0), 0.0, "a building is where it is")
	check(city.get_distance(0, 1) < INF, "and another one can be reached")
	expect_message("buildings are numbered from 0")
	check_equal(city.get_distance(0, city.get_building_count()), INF, "one that is not there")


func test_entrances_that_nobody_reaches_are_one_warning_and_marked() -> void:
	var city: PCGCity = CityForTests.make_city(12)
	city.lot_types = [CityForTests.make_type("house", 1, CityForTests.WALLED_HOUSE)]
	add_child(city)
	expect_message("12 of 12 entrances cannot be reached on foot")
	check(city.generate_now(), "it generates")
	var warnings: Array = city.get_diagnostics().filter(func(one: Dictionary) -> bool: return one["id"] == "unreachable-entrance")
	check_equal(warnings.size(), 1, "one warning: %s" % [warnings])
	var entrances: Array[Node] = get_tree().get_nodes_in_group(&"pcg_entrances").filter(func(node: Node) -> bool: return city.is_ancestor_of(node))
	check_equal(entrances.size(), 12, "doors")
	for node: Node in entrances:
		check(not (node as PCGEntrance).reachable, "%s knows it" % [node.name])


func test_a_city_is_written_as_gltf_or_not_at_all() -> void:
	var path := "user://city_of_tests.glb"
	var city: PCGCity = _grown(12)
	check_equal(city.save_gltf(path), OK, "it is written")
	var document := GLTFDocument.new()
	var state := GLTFState.new()
	check_equal(document.append_from_file(path, state), OK, "the engine reads it")
	check(state.get_meshes().size() > 0, "and finds meshes")
	DirAccess.remove_absolute(path)


func test_a_generation_that_is_cut_off_in_any_stage_goes_quietly() -> void:
	for stage: String in ["lots", "scene", "navigation", "distances"]:
		var city: PCGCity = CityForTests.make_city(40)
		add_child(city)
		var seen: Array[bool] = [false]
		city.generation_progressed.connect(func(now: String, _fraction: float) -> void: seen[0] = seen[0] or now == stage)
		city.generate()
		while not seen[0] and city.is_generating():
			await get_tree().process_frame
		check(seen[0], "%s was reached" % stage)
		city.free()


func test_nobody_walks_below_what_is_lower_than_people() -> void:
	var ways: Array[bool] = []
	for height: float in [1.75, 3.0]: # a roof over the whole lot, 2.5 m up
		var city: PCGCity = CityForTests.make_city(1)
		city.agent_height = height
		city.lot_types = [CityForTests.make_type("house", 1, """@StartRule
Lot --> entrance("house", 4) t(0, 2.5, 0) extrude(1) X.
""")]
		add_child(city)
		city.generate_now()
		var lot: PCGLot = city.find_children("*", "PCGLot", true, false)[0]
		var front: Vector3 = lot.to_global((lot.polygon[0] + lot.polygon[1]) / 2.0)
		ways.append(city.find_path(front + (front - lot.global_position) * 0.1, lot.global_position).size() > 1)
		city.free()
	check_equal(ways, [true, false] as Array[bool], "with people of 1.75 m, and of 3 m")


func test_lots_that_were_drawn_and_measured_become_a_city() -> void:
	var path := "user://footprints_of_tests.geojson"
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.store_string(JSON.stringify({"type": "FeatureCollection", "features": [{"type": "Feature",
			"properties": {"height": 9.0, "building": "school"},
			"geometry": {"type": "Polygon", "coordinates": [[[200, 200], [230, 200], [230, 220], [200, 220], [200, 200]]]}}]}))
	file.close()
	var city: PCGCity = CityForTests.make_city()
	city.layout.kind = PCGLayout.KIND_FOOTPRINTS
	city.layout.geojson = path
	var drawn := Path3D.new()
	drawn.curve = Curve3D.new()
	for corner: Vector3 in [Vector3(250, 0, -200), Vector3(250, 0, -230), Vector3(270, 0, -230), Vector3(270, 0, -200), Vector3(250, 0, -200)]:
		drawn.curve.add_point(corner)
	drawn.set_meta("lot_type", "house")
	city.add_child(drawn)
	var flat := Polygon2D.new()
	flat.polygon = PackedVector2Array([Vector2(0, 0), Vector2(30, 0), Vector2(30, 30), Vector2(0, 30)])
	flat.position = Vector2(290, -230)
	flat.set_meta("lot_type", "park")
	city.add_child(flat)
	add_child(city)
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	var types: Array = city.find_children("*", "PCGLot", true, false).map(func(lot: PCGLot) -> String: return lot.type)
	types.sort()
	check_equal(types, ["house", "park", "school"], "what each is")
	check(is_finite(city.get_distance(0, 1)), "people walk between them")
	DirAccess.remove_absolute(path)


func test_footprints_that_are_missing_or_damaged_are_refused() -> void:
	var path := "user://damaged_of_tests.geojson"
	var city: PCGCity = CityForTests.make_city()
	city.layout.kind = PCGLayout.KIND_FOOTPRINTS
	add_child(city)
	city.layout.geojson = "user://there_is_no.geojson"
	expect_message("there is no such file")
	check(not city.generate_now(), "a file that is missing is told")
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.store_string("{\"type\": \"FeatureCollection\",\n \"features\": [{]}")
	file.close()
	city.layout.geojson = path
	expect_message("damaged_of_tests.geojson:2:")
	check(not city.generate_now(), "one that is damaged is told with its line")
	DirAccess.remove_absolute(path)
	city.layout.geojson = ""
	expect_message("there are no footprints to lay out")
	check(not city.generate_now(), "and so is nothing at all")
