extends "res://tests/godot/saved_suite.gd"
## A generated city as a scene: saved, loaded without generating, edited, and lots that are generated anew.

const HOUR := 3600.0


func _grown(lots: int = 20) -> PCGCity:
	var city: PCGCity = CityForTests.make_city(lots)
	add_child(city)
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	return city


func _nodes(city: Node, type: String) -> Array:
	return city.find_children("*", type, true, false)


func _records(city: PCGCity) -> Dictionary:
	var result := {}
	for door: PCGEntrance in _nodes(city, "PCGEntrance"):
		result["entrance %d" % door.entrance_id] = [door.type, door.capacity, door.building_id, door.global_position]
	for zone: PCGZone in _nodes(city, "PCGZone"):
		result["zone %d" % zone.zone_id] = [zone.type, zone.global_position, zone.polygon]
	for object: PCGObject in _nodes(city, "PCGObject"):
		result["object %d" % object.object_id] = [object.type, object.global_transform]
	return result


func test_a_saved_city_is_loaded_as_it_was_without_its_rules() -> void:
	for path: String in ["user://city_of_tests.scn", "user://city_of_tests.tscn"]:
		var city: PCGCity = _grown()
		var door: PCGEntrance = _nodes(city, "PCGEntrance")[2]
		(_nodes(city, "PCGEntrance")[5] as PCGEntrance).free() # leaves a gap among the numbers
		door.global_position += Vector3(0.5, 0, 0)
		await _settle()
		var records: Dictionary = _records(city)
		var distances: Array = _distances(city)
		var made: Dictionary = city.get_statistics()
		var meshes: int = _nodes(city, "MeshInstance3D").size()
		city.lot_types = []
		_save(city, path)
		city.free()
		var again: PCGCity = await _load(path)
		check_equal(_records(again), records, "%s: what has meaning" % path)
		check_equal(_distances(again), distances, "%s: ways" % path)
		for what: String in ["lots", "blocks", "buildings", "entrances", "zones", "objects", "faces"]:
			check_equal(again.get_statistics()[what], made[what], "%s: %s" % [path, what])
		check_equal(_nodes(again, "MeshInstance3D").size(), meshes, "%s: meshes" % path)
		for instance: MeshInstance3D in _nodes(again, "MeshInstance3D"):
			check(instance.mesh.get_surface_count() > 0, "a mesh with surfaces")
		again.free()


func test_a_city_that_is_saved_while_its_ground_is_baked_is_baked_when_it_is_loaded() -> void:
	for frames: int in [0, 1, 3, 400]:
		var city: PCGCity = _grown()
		await _settle()
		var lots: Array = _nodes(city, "PCGLot").filter(func(lot: PCGLot) -> bool: return lot.type == "house")
		var inside: Vector3 = lots[0].global_position + _nodes(lots[0], "PCGEntrance")[0].global_basis.z * 2.5 # a house takes the front 15 m of 20
		check_equal(city.find_path(inside, inside + Vector3(1, 0, 0)).size(), 0, "a house stands there")
		lots[0].free()
		(lots[1] as PCGLot).rotate_y(0.3)
		for frame: int in frames:
			await get_tree().process_frame
		while frames > 3 and city.is_updating_navigation():
			await get_tree().process_frame
		var path: String = "user://early_city_of_tests.%s" % ["scn" if frames == 1 else "tscn"]
		_save(city, path)
		city.free()
		var again: PCGCity = await _load(path)
		await _settle()
		check_equal(again.is_updating_navigation(), frames <= 3, "saved after %d frames: is anything left to bake" % frames)
		while again.is_updating_navigation():
			await get_tree().process_frame
		check(again.find_path(inside, inside + Vector3(1, 0, 0)).size() > 1, "saved after %d frames: people walk where it stood" % frames)
		again.free()


func test_a_loaded_city_is_lived_in_and_edited() -> void:
	var city: PCGCity = _grown()
	_save(city, "user://city_of_tests.scn")
	city.free()
	city = await _load("user://city_of_tests.scn")
	var citizens: CitizenManager = CityForTests.make_citizens(city, 20)
	add_child(citizens)
	check(citizens.generate_population() and citizens.start(), "people: %s" % [citizens.get_diagnostics()])
	citizens.jump_to(0, 12 * HOUR)
	var at_school: int = 0
	for id: int in citizens.get_statistics()["persons"]:
		at_school += int(citizens.get_person(id)["place"]["id"] != citizens.get_person(id)["home"])
	check(at_school > 5, "at noon %d are elsewhere" % at_school)
	var door: PCGEntrance = _nodes(city, "PCGEntrance")[0]
	var lot: Node = door.get_parent()
	var updated: Array[int] = [0]
	city.navigation_updated.connect(func() -> void: updated[0] += 1)
	await _settle()
	check(not city.is_updating_navigation(), "nothing is baked for loading")
	lot.free()
	for frame: int in 2000:
		await get_tree().process_frame
		if updated[0] > 0:
			break
	check_equal(updated[0], 1, "the ground of a deleted lot is baked")
	check_equal(city.get_statistics()["lots"], 20, "the layout keeps its lots")


func test_edits_are_saved_too_and_come_back() -> void:
	var city: PCGCity = _grown()
	var door: PCGEntrance = _nodes(city, "PCGEntrance")[0]
	var lot: PCGLot = door.get_parent()
	var copy: PCGLot = lot.duplicate()
	lot.get_parent().add_child(copy)
	copy.owner = city
	for child: Node in copy.get_children():
		child.owner = city
	var park: PCGLot = _nodes(city, "PCGLot").filter(func(one: PCGLot) -> bool: return one.type == "park")[0]
	copy.global_position = park.global_position
	park.free()
	var bench := PCGObject.new()
	bench.type = "bench"
	city.add_child(bench)
	bench.owner = city
	await _settle()
	var records: Dictionary = _records(city)
	_save(city, "user://city_of_tests.scn")
	city.free()
	city = await _load("user://city_of_tests.scn")
	check_equal(_records(city), records, "what has meaning")
	check_equal(city.get_statistics()["objects"], 1, "the bench")


func test_bytes_that_are_damaged_are_refused() -> void:
	var city: PCGCity = _grown(6)
	var bytes: PackedByteArray = city.saved_city
	check(bytes.size() > 1000, "there is something to save")
	var scene := PackedScene.new()
	scene.pack(city)
	var again: PCGCity = scene.instantiate()
	again.saved_city = bytes.slice(0, bytes.size() / 2)
	expect_message("the saved layout of this city is damaged")
	add_child(again)
	check(not again.is_generated() and not again.is_generating(), "there is no city")
	check(again.generate_now(), "but it can be generated")
	await _settle()
	check_equal(_nodes(again, "PCGLot").size(), 6, "in place of what was there")


func test_a_city_of_an_older_version_is_told_once_and_can_be_generated_anew() -> void:
	var city: PCGCity = _grown(6)
	var bytes: PackedByteArray = city.saved_city
	bytes[0] -= 1 # the lowest byte of the version
	var scene := PackedScene.new()
	scene.pack(city)
	var again: PCGCity = scene.instantiate()
	again.saved_city = bytes
	expect_message("this city was saved by another version")
	add_child(again)
	check_equal(again.get_diagnostics().size(), 1, "one message: %s" % [again.get_diagnostics()])
	check(not again.is_generated() and not again.is_generating(), "there is no city")
	check(again.generate_now(), "but it can be generated")
	await _settle()
	check_equal(_nodes(again, "PCGLot").size(), 6, "in place of what was there")
	check_equal(again.get_diagnostics().size(), 0, "and nothing is told any more: %s" % [again.get_diagnostics()])


func test_a_lot_that_is_generated_anew_touches_no_other() -> void:
	var city: PCGCity = _grown()
	var lots: Array = _nodes(city, "PCGLot").filter(func(lot: PCGLot) -> bool: return lot.type == "house")
	var moved: PCGLot = lots[1]
	var door: PCGEntrance = _nodes(moved, "PCGEntrance")[0]
	door.global_position += Vector3(1, 0, 0)
	var bench := PCGObject.new()
	bench.type = "bench"
	(lots[0] as PCGLot).add_child(bench)
	await _settle()
	var target: PCGLot = lots[0]
	var home: int = (_nodes(target, "PCGEntrance")[0] as PCGEntrance).building_id
	var before: Dictionary = _records(city)
	var count: int = city.get_child_count()
	city.lot_types[0].rules = CityForTests.make_rules(CityForTests.HOUSE.replace("extrude(6)", "extrude(9)"))
	var mesh: Mesh = (target.get_node("Geometry") as MeshInstance3D).mesh
	var other: Mesh = (moved.get_node("Geometry") as MeshInstance3D).mesh
	check(city.regenerate_lot(target.lot_id), "it is generated: %s" % [city.get_diagnostics()])
	await _settle()
	check((target.get_node("Geometry") as MeshInstance3D).mesh.get_aabb().size.y > mesh.get_aabb().size.y + 2.0, "the house is higher")
	check((moved.get_node("Geometry") as MeshInstance3D).mesh == other, "the other one is the same")
	check_equal(city.get_child_count(), count, "nothing else was made")
	check_equal((_nodes(target, "PCGEntrance")[0] as PCGEntrance).building_id, home, "the address stays")
	check_equal(_nodes(target, "PCGEntrance").size(), 1, "with one door")
	check(is_instance_valid(bench) and bench.is_inside_tree(), "what was put there by hand stays")
	var after: Dictionary = _records(city)
	for key: String in before:
		var is_doors: bool = before[key] is Array and before[key].size() == 4 and before[key][2] == home
		check(is_doors or after.get(key) == before[key], "%s is as it was" % key)
	check_equal(city.get_statistics()["entrances"]["house"], lots.size(), "as many doors as before")


func test_lots_that_are_generated_anew_say_what_is_wrong_with_them_now() -> void:
	var city: PCGCity = CityForTests.make_city(12)
	city.lot_types[0].rules = CityForTests.make_rules(CityForTests.HOUSE.replace("X.", "i(\"no_yard.obj\")"))
	add_child(city)
	expect_message("no_yard.obj")
	city.generate_now()
	var said := func(text: String) -> bool: return city.get_diagnostics().any(func(entry: Dictionary) -> bool: return str(entry["message"]).contains(text))
	check(said.call("no_yard.obj"), "a file is missing: %s" % [city.get_diagnostics()])
	city.lot_types[0].rules = CityForTests.make_rules(CityForTests.HOUSE)
	for lot: PCGLot in city.find_children("*", "PCGLot", true, false).filter(func(node: PCGLot) -> bool: return node.type == "house"):
		city.regenerate_lot(lot.lot_id)
	check(not said.call("no_yard.obj"), "no more: %s" % [city.get_diagnostics()])
	city.lot_types[0].rules = CityForTests.make_rules(CityForTests.HOUSE.replace("X.", "i(\"no_hedge.obj\")"))
	expect_message("no_hedge.obj")
	city.regenerate_lot(city.find_children("*", "PCGLot", true, false).filter(func(node: PCGLot) -> bool: return node.type == "house")[0].lot_id)
	check(said.call("no_hedge.obj"), "another one is: %s" % [city.get_diagnostics()])


func test_a_block_is_generated_anew_without_the_lot_that_was_deleted() -> void:
	var city: PCGCity = _grown()
	var lots: Array = _nodes(city, "PCGLot").filter(func(lot: PCGLot) -> bool: return lot.block_id == 0)
	var count: int = lots.size()
	(lots[0] as PCGLot).free()
	await _settle()
	check(city.regenerate_block(0), "it is generated")
	await _settle()
	lots = _nodes(city, "PCGLot").filter(func(lot: PCGLot) -> bool: return lot.block_id == 0)
	check_equal(lots.size(), count - 1, "what was deleted stays away")
	for lot: PCGLot in lots:
		check(lot.get_child_count() > 0, "the others have something on them")
	expect_message("there is no lot of this number")
	check(not city.regenerate_lot(1000), "no such lot")


func test_what_stands_on_streets_is_saved_with_the_city() -> void:
	var city: PCGCity = CityForTests.make_city(12)
	city.use_street_rules = true
	city.street_rules = CityForTests.make_rules(CityForTests.STREETS)
	city.street_attributes = {"stop": "bus"}
	add_child(city)
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	await _settle()
	var records: Dictionary = _records(city)
	var faces: int = city.get_statistics()["faces"]
	_save(city, "user://streets_of_tests.scn")
	city.free()
	city = await _load("user://streets_of_tests.scn")
	check_equal(_records(city), records, "what has meaning")
	check_equal(city.get_statistics()["faces"], faces, "faces")
	var object: PCGObject = _nodes(city, "PCGObject")[0]
	object.free()
	await _settle()
	check_equal(city.get_statistics()["objects"], records.keys().filter(func(key: String) -> bool: return key.begins_with("object")).size() - 1, "objects")


func test_a_loaded_city_says_what_it_needs_to_be_written_as_a_model() -> void:
	var city: PCGCity = _grown(6)
	var types: Array[PCGLotType] = city.lot_types
	city.lot_types = []
	_save(city, "user://city_of_tests.scn")
	city.free()
	city = await _load("user://city_of_tests.scn")
	expect_message("Call generate() with its rules first")
	check_equal(city.save_gltf("user://city_of_tests.glb"), ERR_UNAVAILABLE, "the scene holds no such geometry")
	check(not FileAccess.file_exists("user://city_of_tests.glb"), "nothing is written")
	city.lot_types = types
	check(city.generate_now(), "made anew")
	check_equal(city.save_gltf("user://city_of_tests.glb"), OK, "it is written")
	check(FileAccess.get_file_as_bytes("user://city_of_tests.glb").size() > 10000, "with all that stands there")
	DirAccess.remove_absolute("user://city_of_tests.glb")


func test_a_loaded_city_keeps_its_regions_and_batches() -> void:
	var city: PCGCity = CityForTests.make_city(12)
	city.asset_folders = ["res://tests/assets"]
	city.lot_types[0].rules = CityForTests.make_rules(CityForTests.HOUSE.replace("Yard --> X.", "Yard --> split(x) { 1: i(\"crate.obj\") X. }*"))
	add_child(city)
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	var batches: Array = _nodes(city, "MultiMeshInstance3D").map(func(node: MultiMeshInstance3D) -> int: return node.multimesh.instance_count)
	var regions: Array = _nodes(city, "NavigationRegion3D").map(func(node: NavigationRegion3D) -> int: return node.navigation_mesh.get_polygon_count())
	check(not batches.is_empty() and batches[0] > 3, "there are batches: %s" % [batches])
	check(not regions.is_empty() and regions[0] > 3, "and regions: %s" % [regions])
	var paths: Array[String] = ["user://city_of_tests.scn", "user://city_of_tests.tscn"]
	for path: String in paths:
		_save(city, path)
	city.free() # two cities in one place are too much for the map
	for path: String in paths:
		await get_tree().physics_frame
		var again: PCGCity = await _load(path)
		check_equal(_nodes(again, "MultiMeshInstance3D").map(func(node: MultiMeshInstance3D) -> int: return node.multimesh.instance_count), batches, "batches")
		check_equal(_nodes(again, "NavigationRegion3D").map(func(node: NavigationRegion3D) -> int: return node.navigation_mesh.get_polygon_count()), regions, "regions")
		again.free()
