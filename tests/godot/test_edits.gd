extends "res://tests/godot/suite.gd"
## What a user does by hand in a finished city: the model, ways and people follow.

const CityForTests := preload("res://tests/godot/city_for_tests.gd")
const HOUR := 3600.0
const BENCHES := """@StartRule
Lot --> zone("park") Lawn. split(x) { ~1: NIL | 2: split(z) { 3: NIL | 1: Bench | ~1: NIL } | ~1: NIL }
@Object("bench")
Bench --> extrude(0.5) X.
"""
const SITTERS := """@StartRule
Household --> members { true: stayInside(0h, 8h, home) } members { true: Out }
Out --> delayedRule(8h, 20h, Sit)
Sit --> set(bench, findObject("bench")) case isValid(bench): goToObject(bench) interact(bench, "sit") wait(10m) Sit else: wait(10m) Sit
"""

var _city: PCGCity


func before_each() -> void:
	_city = CityForTests.make_city(20)
	add_child(_city)
	check(_city.generate_now(), "it generates: %s" % [_city.get_diagnostics()])


func _count(group: StringName) -> int:
	return get_tree().get_nodes_in_group(group).filter(func(node: Node) -> bool: return _city.is_ancestor_of(node)).size()


func _first(group: StringName) -> Node3D:
	for node: Node in get_tree().get_nodes_in_group(group):
		if _city.is_ancestor_of(node):
			return node
	return null


func _settle() -> void:
	await get_tree().process_frame
	await get_tree().process_frame


func _wait_for_navigation() -> void:
	await _settle()
	for frame: int in 2000:
		if not _city.is_updating_navigation():
			return
		await get_tree().process_frame
	check(false, "navigation is ready within 2000 frames")


func test_a_generated_city_is_not_edited() -> void:
	var edits: Array[int] = [0]
	_city.city_edited.connect(func() -> void: edits[0] += 1)
	await _settle()
	for place: Vector3 in [Vector3(100, 0, 50), Vector3(-20000, 0, 30000)] as Array[Vector3]:
		_city.position = place
		_city.rotation = Vector3(0, 0.7, 0)
		await _settle()
		check_equal(edits[0], 0, "nothing was edited, also where the whole city is moved to %s" % place)
		check(not _city.is_updating_navigation(), "and nothing has to be baked")


func test_a_moved_entrance_is_where_its_node_is() -> void:
	var doors: Array = get_tree().get_nodes_in_group(&"pcg_entrances").filter(func(node: Node) -> bool: return _city.is_ancestor_of(node))
	var door: PCGEntrance = doors[0]
	var other: PCGEntrance = doors[doors.size() - 1]
	var before: float = _city.get_distance(door.building_id, other.building_id)
	var told: Array[int] = [0]
	_city.city_edited.connect(func() -> void: told[0] += 1)
	door.global_position = other.global_position + Vector3(0.5, 0, 0)
	await _settle()
	var after: float = _city.get_distance(door.building_id, other.building_id)
	check(before > 5.0 and after < 2.0, "from %s m to %s m" % [before, after])
	check_equal(told[0], 1, "told once")
	door.global_position = Vector3(0, 500, 0)
	await _settle()
	check(not door.reachable, "a door in the sky cannot be reached, which it knows")
	check_equal(_city.get_distance(door.building_id, other.building_id), INF, "nor its building")


func test_a_deleted_entrance_takes_its_building_with_it() -> void:
	var door: PCGEntrance = _first(&"pcg_entrances")
	var building: int = door.building_id
	var buildings: int = _city.get_statistics()["buildings"]
	var parent: Node = door.get_parent()
	parent.remove_child(door)
	await _settle()
	check_equal(_city.get_distance(building, (building + 1) % buildings), INF, "nobody gets there")
	check_equal(_city.get_statistics()["buildings"], buildings - 1, "it is no longer counted")
	parent.add_child(door)
	await _settle()
	check_equal(door.building_id, building, "undone: the same building")
	check(is_finite(_city.get_distance(building, (building + 1) % buildings)), "which is back")


func test_a_copied_lot_is_a_building_of_its_own_and_stands_in_the_way() -> void:
	var door: PCGEntrance = _first(&"pcg_entrances")
	var lot: PCGLot = door.get_parent()
	var park: PCGLot = null
	for node: Node in get_tree().get_nodes_in_group(&"pcg_lots"):
		if _city.is_ancestor_of(node) and (node as PCGLot).type == "park":
			park = node
	check(park != null, "there is a park")
	var spot: Vector3 = park.global_position
	check(_city.find_path(spot, door.global_position).size() > 1, "people walk on its lawn")
	park.free()
	var copy: PCGLot = lot.duplicate()
	_city.add_child(copy)
	copy.global_transform = lot.global_transform
	copy.global_position = spot
	await _wait_for_navigation()
	var copied: PCGEntrance = copy.find_children("*", "PCGEntrance", true, false)[0]
	check(copied.entrance_id != door.entrance_id and copied.building_id != door.building_id, "a door and a building of its own")
	check(copied.building_id >= 0, "with a number")
	check(is_finite(_city.get_distance(copied.building_id, door.building_id)), "to which people walk")
	var inside: Vector3 = spot + copied.global_basis.z * 2.5 # a house takes the front 15 m of 20
	check_equal(_city.find_path(inside, door.global_position).size(), 0, "nobody walks inside of it: %s" % [inside])


func test_a_moved_and_a_deleted_lot_leave_free_ground() -> void:
	var door: PCGEntrance = _first(&"pcg_entrances")
	var lot: PCGLot = door.get_parent()
	var lots: int = _city.get_statistics()["lots"]
	var other: PCGEntrance = get_tree().get_nodes_in_group(&"pcg_entrances").filter(
			func(node: Node) -> bool: return _city.is_ancestor_of(node) and node != door).back()
	var inside: Vector3 = lot.global_position + door.global_basis.z * 2.5 # a house takes the front 15 m of 20
	check_equal(_city.find_path(inside, other.global_position).size(), 0, "a house stands there")
	var updated: Array[int] = [0]
	_city.navigation_updated.connect(func() -> void: updated[0] += 1)
	lot.free()
	await _wait_for_navigation()
	check_equal(updated[0], 1, "the ground was baked once")
	check(_city.find_path(inside, other.global_position).size() > 1, "people walk where it stood")
	check_equal(_city.get_statistics()["lots"], lots, "the layout is as it was")
	var map: RID = _city.get_world_3d().navigation_map
	for frame: int in 60:
		await get_tree().physics_frame
	var way: PackedVector3Array = NavigationServer3D.map_get_path(map, inside, other.global_position, true)
	check(way.size() > 1 and way[0].distance_to(inside) < 1.0, "the engine's map knows it too: %s" % [way])


func test_a_moved_lot_that_is_made_anew_has_the_ground_that_it_leaves_now() -> void:
	var door: PCGEntrance = _first(&"pcg_entrances")
	var lot: PCGLot = door.get_parent()
	var inside: Vector3 = door.global_basis.z * 2.5 # a house takes the front 15 m of 20
	for node: Node in get_tree().get_nodes_in_group(&"pcg_lots"):
		if _city.is_ancestor_of(node) and (node as PCGLot).type == "park":
			lot.global_position = (node as PCGLot).global_position
	inside += lot.global_position
	await _wait_for_navigation()
	check_equal(_city.find_path(inside, inside + Vector3(1, 0, 0)).size(), 0, "a house stands there")
	for type: PCGLotType in _city.lot_types:
		type.rules = CityForTests.make_rules('@StartRule\nLot --> zone("%s") Lawn.' % type.type)
	check(_city.regenerate_lot(lot.lot_id), "it is a lawn now: %s" % [_city.get_diagnostics()])
	await _wait_for_navigation()
	check(_city.find_path(inside, inside + Vector3(1, 0, 0)).size() > 1, "on which people walk")


func test_what_was_taken_off_a_lot_stays_when_the_lot_is_made_anew() -> void:
	_city.lot_types[3].rules = CityForTests.make_rules(BENCHES)
	check(_city.generate_now(), "a city with benches: %s" % [_city.get_diagnostics()])
	var kinds: Array[String] = ["PCGEntrance", "PCGZone", "PCGObject"]
	for kind: String in kinds:
		var node: Node3D = _city.find_children("*", kind, true, false)[0]
		var lot: PCGLot = node.get_parent()
		node.reparent(_city)
		await _settle()
		var count: int = _city.find_children("*", kind, true, false).size()
		check(_city.regenerate_lot(lot.lot_id), "it is made anew: %s" % [_city.get_diagnostics()])
		check_equal(_city.find_children("*", kind, true, false).size(), count + 1, "%s: that which was taken off, and a new one" % kind)
		var made: Dictionary = _city.get_statistics()
		var doors: int = made["entrances"].values().reduce(func(sum: int, of_type: int) -> int: return sum + of_type, 0)
		check_equal([doors, made["zones"], made["objects"]], kinds.map(func(one: String) -> int: return _city.find_children("*", one, true, false).size()),
				"each node has its record")
	var building: int = (_city.find_children("*", "PCGEntrance", false, false)[0] as PCGEntrance).building_id
	check(is_finite(_city.get_distance(building, (building + 1) % _city.get_building_count())), "people get to the door that was taken off")


func test_a_monument_is_an_object_of_the_city_and_stands_in_the_way() -> void:
	var objects: int = _city.get_statistics()["objects"]
	var park: PCGLot = null
	for node: Node in get_tree().get_nodes_in_group(&"pcg_lots"):
		if _city.is_ancestor_of(node) and (node as PCGLot).type == "park":
			park = node
	var spot: Vector3 = park.global_position
	var door: PCGEntrance = _first(&"pcg_entrances")
	var monument := Node3D.new()
	var object := PCGObject.new()
	object.type = "monument"
	object.footprint = Vector2(6, 6)
	object.places = [Transform3D(Basis(), Vector3(0, 0, 4))]
	monument.add_child(object)
	add_child(monument) # beside the city, as an ordinary scene
	monument.global_position = spot
	await _wait_for_navigation()
	check_equal(_city.get_statistics()["objects"], objects + 1, "one object more")
	check(object.object_id >= 0 and not object.is_in_group(&"pcg_without_city"), "it belongs to the city")
	check_equal(_city.find_path(spot, door.global_position).size(), 0, "nobody walks through it")
	check(_city.find_path(spot + Vector3(0, 0, 4), door.global_position).size() > 1, "but to it")
	monument.free()
	await _wait_for_navigation()
	check_equal(_city.get_statistics()["objects"], objects, "one object less")
	check(_city.find_path(spot, door.global_position).size() > 1, "people walk there again")
	var far := PCGObject.new()
	far.type = "bench"
	far.position = Vector3(5000, 0, 0)
	add_child(far)
	await _settle()
	check(far.is_in_group(&"pcg_without_city"), "out of the city it belongs to none")


func test_zones_and_types_follow_their_nodes() -> void:
	var zones: int = _city.get_statistics()["zones"]
	var zone: PCGZone = _first(&"pcg_zones")
	var copy: PCGZone = zone.duplicate()
	zone.get_parent().add_child(copy)
	await _settle()
	check_equal(_city.get_statistics()["zones"], zones + 1, "a copy is one more")
	check(copy.zone_id != zone.zone_id, "with a number of its own")
	copy.queue_free()
	await _settle()
	check_equal(_city.get_statistics()["zones"], zones, "and goes again")
	var door: PCGEntrance = _first(&"pcg_entrances")
	var before: Dictionary = _city.get_statistics()["entrances"]
	var old: String = door.type
	door.type = "castle"
	await _settle()
	var after: Dictionary = _city.get_statistics()["entrances"]
	check_equal(after["castle"], 1, "its type is what the node says")
	check_equal(after.get(old, 0), int(before[old]) - 1, "and no longer the old one")


func test_a_zone_knows_whether_people_get_to_it() -> void:
	var zone: PCGZone = _first(&"pcg_zones")
	check(zone.reachable, "as generated they do")
	var home: Vector3 = zone.global_position
	for place: Vector3 in [Vector3(0, 60, 0), Vector3(5000, 0, 0), Vector3(NAN, 0, 0)]:
		zone.position += place
		await _settle()
		check(not zone.reachable, "not at %s" % place)
		zone.global_position = home
		await _settle()
		check(zone.reachable, "but where it was")
	var small := PCGZone.new()
	small.type = "cellar"
	small.polygon = PackedVector3Array([Vector3(-1, 0, 1), Vector3(1, 0, 1), Vector3(1, 0, -1), Vector3(-1, 0, -1)])
	var door: PCGEntrance = _first(&"pcg_entrances")
	_city.add_child(small)
	small.global_position = (door.get_parent() as PCGLot).global_position + door.global_basis.z * 2.5 # a house takes the front 15 m of 20
	await _settle()
	check(not small.reachable, "a cellar has no ground")
	door.get_parent().free()
	await _wait_for_navigation()
	check(small.reachable, "until the house is gone")


# People who sit on benches all day, some at each bench.
func _people_on_benches() -> CitizenManager:
	_city.lot_types[3].rules = CityForTests.make_rules(BENCHES)
	check(_city.generate_now(), "a city with benches: %s" % [_city.get_diagnostics()])
	var citizens: CitizenManager = CityForTests.make_citizens(_city, 12)
	citizens.rules = CityForTests.make_rules(SITTERS, PCGRuleSet.DIALECT_AGENDA)
	citizens.check_promises = true
	citizens.jump_to(0, 7.5 * HOUR)
	add_child(citizens)
	check(citizens.generate_population() and citizens.start(), "people: %s" % [citizens.get_diagnostics()])
	return citizens


func _seated(citizens: CitizenManager) -> Dictionary:
	var result := {}
	for id: int in citizens.get_persons_outside():
		var person: Dictionary = citizens.get_person(id)
		if person["state"] == "at-place" and person["place"]["kind"] == "object":
			result[int(person["place"]["id"])] = person["position"]
	return result


func _benches() -> Array:
	return get_tree().get_nodes_in_group(&"pcg_objects").filter(
			func(node: Node) -> bool: return _city.is_ancestor_of(node) and (node as PCGObject).type == "bench")


func _live(citizens: CitizenManager, minutes: int) -> void:
	for minute: int in minutes:
		citizens.advance(60.0)
		if minute % 15 == 0:
			await get_tree().process_frame


func test_people_use_the_moved_and_the_new_bench_and_not_the_deleted_one() -> void:
	var citizens: CitizenManager = _people_on_benches()
	await _live(citizens, 120)
	check(not _seated(citizens).is_empty(), "somebody sits: %s" % [_seated(citizens)])
	var kept: PCGObject = _benches()[0]
	for bench: PCGObject in _benches().slice(1):
		bench.queue_free()
	await _settle()
	await _live(citizens, 120)
	check_equal(_seated(citizens).keys(), [kept.object_id], "only the bench that is left is sat on")
	kept.global_position += Vector3(2, 0, 0)
	await _settle()
	await _live(citizens, 60)
	var seat: Vector3 = _seated(citizens).get(kept.object_id, Vector3.INF)
	check_near(seat.distance_to(kept.global_position), 0.0, 2.0, "where it stands now")
	var copy: PCGObject = kept.duplicate()
	kept.get_parent().add_child(copy)
	copy.global_position += Vector3(-5, 0, 0)
	await _settle()
	await _live(citizens, 240)
	check(copy.object_id >= 0 and copy.object_id != kept.object_id, "the copy is a bench of its own")
	check(_seated(citizens).has(copy.object_id), "which is sat on: %s" % [_seated(citizens)])
	kept.free()
	await _settle()
	await _live(citizens, 120)
	check_equal(_seated(citizens).keys(), [copy.object_id], "and is the only one in the end")
	for count: int in citizens.get_broken_promises().values():
		check_equal(count, 0, "a promise: %s" % [citizens.get_broken_promise_examples()])


func test_people_leave_a_lot_that_is_deleted_and_live_on() -> void:
	var citizens: CitizenManager = _people_on_benches()
	await _live(citizens, 15)
	var home: int = citizens.get_person(0)["home"]
	check(citizens.get_persons_inside(home).size() > 0, "they are at home")
	for node: Node in get_tree().get_nodes_in_group(&"pcg_entrances"):
		if _city.is_ancestor_of(node) and (node as PCGEntrance).building_id == home:
			node.get_parent().queue_free()
	await _wait_for_navigation()
	await _live(citizens, 60)
	check(citizens.is_running(), "life goes on")
	check_equal(citizens.get_persons_inside(home).size(), 0, "nobody is in a house that is gone")
	for count: int in citizens.get_broken_promises().values():
		check_equal(count, 0, "a promise: %s" % [citizens.get_broken_promise_examples()])


func test_what_is_done_by_hand_while_a_city_is_made_holds() -> void:
	await _settle() # the first generation has been told
	var done: Array[String] = []
	var moved: Array[PCGEntrance] = []
	_city.generation_progressed.connect(func(stage: String, fraction: float) -> void:
		if stage in done or stage == "lots" or (stage == "scene" and fraction < 0.5):
			return
		var door: PCGEntrance = _first(&"pcg_entrances")
		if not door: # streets stand first
			return
		done.append(stage)
		if stage == "navigation": # its ground is handed over to be baked
			moved.append(door)
			door.global_position += Vector3(0.5, 0, 0)
		else:
			door.get_parent().free())
	check(_city.generate(), "it is made anew")
	check_equal(await _city.city_generated, true, "it is there: %s" % [_city.get_diagnostics()])
	await _wait_for_navigation()
	check_equal(done, ["scene", "navigation", "distances"] as Array[String], "in each stage something was done")
	var doors: Array = get_tree().get_nodes_in_group(&"pcg_entrances").filter(func(node: Node) -> bool: return _city.is_ancestor_of(node))
	var counts: Dictionary = _city.get_statistics()["entrances"]
	check_equal(counts.values().reduce(func(sum: int, count: int) -> int: return sum + count, 0), doors.size(), "the model has the doors that stand there")
	var last: PCGEntrance = doors.back()
	if is_instance_valid(moved[0]): # it may have stood on the lot that was deleted last
		check(_city.get_building(moved[0].building_id)["position"].distance_to(moved[0].global_position) < 0.01, "the moved one where it is")
	for door: PCGEntrance in doors:
		check(is_finite(_city.get_distance(door.building_id, last.building_id)), "all are reached")
