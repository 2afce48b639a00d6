extends "res://tests/godot/saved_suite.gd"
## Lots with holes: drawn, measured, built around, walked through where there is a gate, saved and edited.

const PATH := "user://courtyards_of_tests.tscn"
const MAP := "user://courtyards_of_tests.geojson"
## Two wings with a gate of 4 m between them, or one without; a door to the street.
const RING := """attr gate = 4
@StartRule
Lot --> case gate > 0 : split(x) { ~1 : Wing(1) | gate : X. | ~1 : Wing(0) } else : Wing(1)
Wing(doors) --> extrude(6) comp(f) { front : Front(doors) | all : Wall. }
Front(doors) --> [ case doors > 0 && convert(z, scope, object, pos, 0, 0, 0) > -1 : t('0.5, 0, 0) entrance("house", 40) else : NIL ] Wall.
"""
const HUT := """@StartRule
Lot --> split(x) { 2 : X. | ~1 : split(z) { 2 : X. | ~1 : Hut | 2 : X. } | 2 : X. }
Hut --> extrude(3) comp(f) { front : Front | all : Wall. }
Front --> entrance("hut", 4) Wall.
"""


## A ring of 60 by 60 m with a courtyard of 30 by 30 m, and in that a lot of 12 by 12 m. Outlines are Path3D, the hole moves with its parent.
func _drawn(gate: float = 4.0) -> PCGCity:
	var city: PCGCity = CityForTests.make_city()
	city.layout.kind = PCGLayout.KIND_FOOTPRINTS
	city.lot_types = [CityForTests.make_type("house", 1, RING), CityForTests.make_type("hut", 0, HUT)] as Array[PCGLotType]
	city.lot_types[0].attributes = {"gate": gate}
	var ring: Path3D = _box("Ring", 60)
	ring.position = Vector3(100, 0, 50)
	var hole: Path3D = _box("Hole", 30)
	hole.position = Vector3(15, 0, 15)
	ring.add_child(hole)
	var hut: Path3D = _box("Hut", 12)
	hut.position = Vector3(124, 0, 74)
	hut.set_meta("lot_type", "hut")
	for drawn: Path3D in [ring, hut]:
		city.add_child(drawn)
	for drawn: Path3D in [ring, hole, hut]:
		drawn.owner = city
	add_child(city)
	return city


func _box(title: String, size: float) -> Path3D:
	var box := Path3D.new()
	box.name = title
	box.curve = Curve3D.new()
	for point: Vector3 in [Vector3(0, 0, 0), Vector3(size, 0, 0), Vector3(size, 0, size), Vector3(0, 0, size), Vector3(0, 0, 0)]:
		box.curve.add_point(point)
	return box


func _lot(city: PCGCity, type: String) -> PCGLot:
	for lot: PCGLot in city.find_children("*", "PCGLot", true, false):
		if lot.type == type:
			return lot
	return null


func _ends_at(city: PCGCity, target: Vector3) -> bool:
	var way: PackedVector3Array = city.find_path(Vector3(96, 0, 46), target)
	return not way.is_empty() and way[-1].distance_to(target) < 1.0


func _wait_for_navigation(city: PCGCity) -> void:
	await _settle()
	for frame: int in 2000:
		if not city.is_updating_navigation():
			return
		await get_tree().process_frame
	check(false, "navigation is ready within 2000 frames")


func test_a_courtyard_with_a_gate_is_walked_through() -> void:
	var city: PCGCity = _drawn()
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	check_equal(city.get_diagnostics().size(), 0, "nothing is wrong with it: %s" % [city.get_diagnostics()])
	var ring: PCGLot = _lot(city, "house")
	check_equal(ring.holes.size(), 1, "it has its hole")
	var low := Vector3(INF, 0, INF)
	var high := Vector3(-INF, 0, -INF)
	for corner: Vector3 in ring.holes[0]:
		low = low.min(ring.to_global(corner))
		high = high.max(ring.to_global(corner))
	check_equal([low, high], [Vector3(115, 0, 65), Vector3(145, 0, 95)], "where it was drawn")
	check_equal(_lot(city, "hut").holes.size(), 0, "the lot within has none")
	check(is_finite(city.get_distance(0, 1)), "people walk from the ring to the hut")
	check(_ends_at(city, Vector3(118, 0, 92)), "and into the courtyard")
	city.free()


func test_a_closed_courtyard_is_no_ground_and_who_lives_there_is_told_of() -> void:
	var city: PCGCity = _drawn(0)
	expect_message("1 of 2 entrances cannot be reached on foot: lot 1 (hut)")
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	check(not _ends_at(city, Vector3(118, 0, 92)), "nobody walks into the courtyard")
	check(_ends_at(city, Vector3(164, 0, 114)), "but around the ring")
	city.free()


func test_a_city_with_courtyards_is_saved_and_edited() -> void:
	var city: PCGCity = _drawn()
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	var distance: float = city.get_distance(0, 1)
	var holes: Array[PackedVector3Array] = _lot(city, "house").holes
	_save(city, PATH)
	city.free()
	var again: PCGCity = await _load(PATH)
	check_equal(_lot(again, "house").holes, holes, "with its courtyard")
	check_equal(again.get_distance(0, 1), distance, "and ways")
	_lot(again, "house").global_position += Vector3(200, 0, 0)
	await _wait_for_navigation(again)
	check_equal(_lot(again, "hut").get_overlapping_lots().size(), 0, "nothing overlaps")
	check(_ends_at(again, Vector3(130, 0, 75)), "where the ring stood, the ground before the hut is left")
	_lot(again, "hut").global_position += Vector3(200, 0, 0)
	await _wait_for_navigation(again)
	check_equal(_lot(again, "hut").get_overlapping_lots().size(), 0, "in the courtyard it was moved to it is on no other lot")
	_lot(again, "hut").global_position += Vector3(12, 0, 0)
	await _settle()
	check_equal(_lot(again, "hut").get_overlapping_lots(), [_lot(again, "house")] as Array[PCGLot], "but farther on it is")
	again.free()


func test_a_lot_and_what_stands_in_its_courtyard_are_moved_whichever_was_drawn_first() -> void:
	var city: PCGCity = _drawn()
	city.move_child(city.get_node("Hut"), 0)
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	var distance: float = city.get_distance(0, 1)
	for type: String in ["house", "hut"]:
		_lot(city, type).position += Vector3(2, 0, 1)
	await _wait_for_navigation(city)
	check_near(city.get_distance(0, 1), distance, 0.05, "people walk from the ring to the hut as before")
	city.free()


func test_a_ring_that_is_turned_stands_around_what_stays_in_its_courtyard() -> void:
	var city: PCGCity = _drawn()
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	var ring: PCGLot = _lot(city, "house")
	for turned: Vector3 in [Vector3(0, PI, 0), Vector3(PI, 0, 0), Vector3.ZERO]: # the hut stands in the middle: around, upside down, back
		ring.rotation = turned
		await _wait_for_navigation(city)
		check_equal(_lot(city, "hut").get_overlapping_lots().size(), 0, "nothing overlaps")
		check(is_finite(city.get_distance(0, 1)), "people walk from the ring to the hut, turned by %s" % turned)
		check(_ends_at(city, Vector3(118, 0, 92)), "and into the courtyard")
		check(not _ends_at(city, Vector3(107, 0, 80)), "but not through its wing")
	city.free()


func test_a_ring_that_is_moved_without_what_stood_in_its_courtyard_has_ground_there() -> void:
	var city: PCGCity = _drawn()
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	_lot(city, "hut").free()
	await _wait_for_navigation(city)
	check(_ends_at(city, Vector3(130, 0, 80)), "where the hut stood there is ground")
	_lot(city, "house").position += Vector3(4, 0, 2)
	await _wait_for_navigation(city)
	for place: Vector3 in [Vector3(130, 0, 80), Vector3(134, 0, 82)]:
		check(_ends_at(city, place), "and where it would stand, had it been moved along")
	city.free()


func test_holes_of_a_map_are_courtyards() -> void:
	var file := FileAccess.open(MAP, FileAccess.WRITE)
	file.store_string(JSON.stringify({"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [
			[[200, 200], [260, 200], [260, 260], [200, 260], [200, 200]], [[215, 215], [215, 245], [245, 245], [245, 215], [215, 215]]]}}))
	file.close()
	var city: PCGCity = _drawn()
	for drawn: String in ["Ring", "Hut"]:
		city.get_node(drawn).free()
	city.layout.geojson = MAP
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	check_equal(city.get_diagnostics().size(), 0, "nothing is left out: %s" % [city.get_diagnostics()])
	check_equal(_lot(city, "house").holes.size(), 1, "the hole is there")
	DirAccess.remove_absolute(MAP)
	city.free()


func test_yards_of_blocks_are_squares_with_a_passage() -> void:
	var city: PCGCity = _drawn()
	city.get_node("Hut").free()
	city.layout.kind = PCGLayout.KIND_BLOCKS
	city.lot_types = [CityForTests.make_type("house", 1, CityForTests.HOUSE)] as Array[PCGLotType]
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	check_equal(city.get_diagnostics().size(), 0, "nothing is wrong with it: %s" % [city.get_diagnostics()])
	var yard := Rect2(115, 65, 30, 30)
	for lot: PCGLot in city.find_children("*", "PCGLot", true, false):
		var place: Vector3 = lot.global_position
		check(not yard.has_point(Vector2(place.x, place.z)), "no lot in the yard")
	check(_ends_at(city, Vector3(130, 0, 80)), "people walk into it")
	city.free()


func test_a_hole_that_lies_outside_is_told() -> void:
	var city: PCGCity = _drawn()
	(city.get_node("Ring/Hole") as Path3D).position.x = 50
	expect_message("Ring: a hole in it meets its outline or another hole, or lies outside")
	check(not city.generate_now(), "no city")
	city.free()
