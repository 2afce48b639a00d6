extends "res://tests/godot/saved_suite.gd"
## Blocks that somebody drew are divided into lots; the city is saved with what was drawn.

const PATH := "user://drawn_blocks_of_tests.tscn"


## An L of 100 by 100 m and, 10 m east of it, a box of 60 by 46 m whose lots are all schools.
func _drawn() -> PCGCity:
	var city: PCGCity = CityForTests.make_city()
	city.layout.kind = PCGLayout.KIND_BLOCKS
	var corner := Polygon2D.new()
	corner.name = "Corner"
	corner.polygon = PackedVector2Array([Vector2(0, 0), Vector2(100, 0), Vector2(100, 100), Vector2(50, 100), Vector2(50, 50), Vector2(0, 50)])
	city.add_child(corner)
	var box := Path3D.new()
	box.name = "Box"
	box.curve = Curve3D.new()
	for point: Vector3 in [Vector3(0, 0, 0), Vector3(60, 0, 0), Vector3(60, 0, 46), Vector3(0, 0, 46), Vector3(0, 0, 0)]:
		box.curve.add_point(point)
	box.position = Vector3(110, 0, 0)
	box.set_meta("lot_type", "school")
	city.add_child(box)
	for drawn: Node in [corner, box]:
		drawn.owner = city
	add_child(city)
	return city


func _lots(city: PCGCity) -> Array:
	var lots: Array = city.find_children("*", "PCGLot", true, false)
	lots.sort_custom(func(a: PCGLot, b: PCGLot) -> bool: return a.lot_id < b.lot_id)
	return lots


func _described(city: PCGCity) -> Array:
	return _lots(city).map(func(lot: PCGLot) -> Array: return [lot.lot_id, lot.type, lot.global_position, lot.polygon])


func _outline(lot: PCGLot) -> PackedVector2Array:
	var points := PackedVector2Array()
	for point: Vector3 in lot.polygon:
		var place: Vector3 = lot.to_global(point)
		points.append(Vector2(place.x, place.z))
	return points


func _area(outline: PackedVector2Array) -> float:
	var sum := 0.0
	for i: int in outline.size():
		sum += outline[i].cross(outline[(i + 1) % outline.size()]) / 2.0
	return absf(sum)


func test_blocks_that_were_drawn_are_divided_into_lots() -> void:
	var city: PCGCity = _drawn()
	city.use_street_rules = true # those that ship
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	check_equal(city.get_diagnostics().size(), 0, "nothing is wrong with it: %s" % [city.get_diagnostics()])
	var areas: Array[float] = [0.0, 0.0] # of the lots in the corner block and in the box
	var border: PackedVector2Array = (city.get_node("Corner") as Polygon2D).polygon
	for lot: PCGLot in _lots(city):
		var is_box: bool = lot.global_position.x > 105
		check(is_box or Geometry2D.is_point_in_polygon(Vector2(lot.global_position.x, lot.global_position.z), border), "it lies in the block")
		check(not is_box or lot.type == "school", "a school")
		areas[int(is_box)] += _area(_outline(lot))
	# Less 3 m of pavement along all sides, inside.
	check_near(areas[0], 94.0 * 44.0 + 44.0 * 50.0, 0.1, "lots in the corner block")
	check_near(areas[1], 54.0 * 40.0, 0.1, "lots in the box")
	check(_distances(city).all(is_finite), "people walk from each door to each, over the street between the blocks")
	city.free()


func test_a_city_of_drawn_blocks_is_saved_and_drawn_on() -> void:
	var city: PCGCity = _drawn()
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	var described: Array = _described(city)
	var distances: Array = _distances(city)
	_save(city, PATH)
	city.free()
	var again: PCGCity = await _load(PATH)
	check_equal(again.layout.kind, PCGLayout.KIND_BLOCKS, "with its kind")
	check_equal(_described(again), described, "its lots")
	check_equal(_distances(again), distances, "and ways")
	check(again.generate_now(), "it generates from what was drawn: %s" % [again.get_diagnostics()])
	check_equal(_described(again), described, "the same lots")
	again.get_node("Box").free()
	check(again.generate_now(), "and without one block: %s" % [again.get_diagnostics()])
	check(_lots(again).size() < described.size() and _lots(again).size() > 0, "fewer lots")
	again.free()


func test_heights_that_are_none_and_points_that_are_nowhere_are_told_by_the_name_of_their_node() -> void:
	var city: PCGCity = _drawn()
	city.lot_types = [CityForTests.make_type("house", 1, CityForTests.HOUSE), CityForTests.make_type("school", 0, CityForTests.SCHOOL)] as Array[PCGLotType]
	var box: Path3D = city.get_node("Box")
	for kind: PCGLayout.Kind in [PCGLayout.KIND_BLOCKS, PCGLayout.KIND_FOOTPRINTS]:
		city.layout.kind = kind
		for height: Variant in [INF, NAN, 1e30, 1e300, -2.0, "tall", [12.0]]:
			box.set_meta("height", height)
			expect_message("Box: its height is none from 0 to 2000 m and is ignored")
			city.generate_now()
			check_equal(city.get_diagnostics().filter(func(one: Dictionary) -> bool: return one["id"] == "bad-height").size(), 1, "told of %s" % [height])
		for height: Variant in [12.5, 12, "12.5", 2000]:
			box.set_meta("height", height)
			city.generate_now()
			check(city.get_diagnostics().all(func(one: Dictionary) -> bool: return one["id"] != "bad-height"), "%s is one" % [height])
		for nowhere: float in [NAN, INF]:
			box.curve.set_point_position(2, Vector3(60, 0, nowhere))
			expect_message("Box: its outline has a corner that is nowhere")
			check(not city.generate_now(), "no city of a path with %s" % nowhere)
			box.curve.set_point_position(2, Vector3(60, 0, 46))
			var corner: Polygon2D = city.get_node("Corner")
			corner.position = Vector2(nowhere, 0)
			expect_message("Corner: its outline has a corner that is nowhere")
			check(not city.generate_now(), "no city of a polygon that is at %s" % nowhere)
			corner.position = Vector2.ZERO
	city.free()


func test_blocks_without_room_and_none_at_all_are_told() -> void:
	var city: PCGCity = _drawn()
	city.layout.pavement_width = 26 # of both nothing is left
	expect_message("no block has room for a lot: Corner; Box")
	check(not city.generate_now(), "no lots")
	city.layout.pavement_width = 3
	city.get_node("Corner").free()
	city.get_node("Box").free()
	expect_message("there are no blocks to lay out")
	check(not city.generate_now(), "nothing is drawn")
	city.free()
