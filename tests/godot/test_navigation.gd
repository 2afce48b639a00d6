extends "res://tests/godot/suite.gd"
## Ways of the city compared with those of the engine's own navigation server, on the same polygons.

const CityForTests := preload("res://tests/godot/city_for_tests.gd")
const DemoCity := preload("res://demo/demo_city.gd")
const PAIRS := 1000


func _length(points: PackedVector3Array) -> float:
	var sum := 0.0
	for i: int in range(1, points.size()):
		sum += points[i - 1].distance_to(points[i])
	return sum


# Metres that the way leads away from the map, at most.
func _off(map: RID, way: PackedVector3Array) -> float:
	var worst := 0.0
	for i: int in range(1, way.size()):
		var steps: int = ceili(way[i - 1].distance_to(way[i]))
		for step: int in steps:
			var point: Vector3 = way[i - 1].lerp(way[i], float(step) / steps)
			worst = maxf(worst, NavigationServer3D.map_get_closest_point(map, point).distance_to(point))
	return worst


# The engine takes regions into its map one by one, on threads of its own.
func _wait_for_map(city: PCGCity) -> void:
	var map: RID = city.get_world_3d().navigation_map
	var middles: Array = []
	for region: NavigationRegion3D in city.find_children("*", "NavigationRegion3D", true, false):
		if region.navigation_mesh.get_polygon_count() > 0:
			var corners: Array = Array(region.navigation_mesh.get_polygon(0)).map(func(i: int) -> Vector3: return region.navigation_mesh.get_vertices()[i])
			middles.append(region.global_transform * (corners.reduce(func(sum: Vector3, corner: Vector3) -> Vector3: return sum + corner) / corners.size()))
	for frame: int in 3000:
		await get_tree().physics_frame
		if NavigationServer3D.map_get_iteration_id(map) > 0 and middles.all(func(point: Vector3) -> bool: return NavigationServer3D.map_get_closest_point(map, point).distance_to(point) < 0.1):
			return
	check(false, "the map has all regions within 3000 frames")


func test_a_thousand_ways_are_as_long_as_those_of_the_engine() -> void:
	var city: PCGCity = CityForTests.make_city(100)
	add_child(city)
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	var doors: Array = city.find_children("*", "PCGEntrance", true, false).map(func(door: PCGEntrance) -> Vector3: return door.global_position)
	var map: RID = city.get_world_3d().navigation_map
	await _wait_for_map(city)
	doors = doors.map(func(door: Vector3) -> Vector3: return NavigationServer3D.map_get_closest_point(map, door)) # both begin on the mesh
	var random := RandomNumberGenerator.new()
	random.seed = 7
	var ours := 0.0
	var theirs := 0.0
	var worst := 0.0
	var ways := 0
	for pair: int in PAIRS:
		var from: Vector3 = doors[random.randi() % doors.size()]
		var to: Vector3 = doors[random.randi() % doors.size()]
		var their_way: PackedVector3Array = NavigationServer3D.map_get_path(map, from, to, true)
		if their_way.is_empty() or their_way[-1].distance_to(to) > 0.1:
			continue # after some thousand polygons the server gives up, and tells the way until there
		var our_way: PackedVector3Array = city.find_path(from, to)
		var here: float = _length(our_way)
		var there: float = _length(their_way)
		check(here >= from.distance_to(to) - 0.01, "no way is shorter than the straight line: %s m" % here)
		if pair % 20 == 0:
			check(_off(map, our_way) < 0.3, "ways lead over the map: %s m off" % _off(map, our_way))
		ways += 1
		ours += here
		theirs += there
		worst = maxf(worst, (here - 0.05) / maxf(there, 1.0))
	check(ways > PAIRS * 9 / 10, "the server finds ways: %d" % ways)
	check(worst <= 1.01, "none is more than 1 %% longer: the worst %s times as long" % worst)
	check(ours <= theirs and ours > theirs * 0.95, "all ways together are a little shorter: %s and %s m" % [ours, theirs])


# Rounding must not part what two tiles share.
func test_the_ground_of_a_turned_city_holds_together() -> void:
	for turned: Array in [[37.0, 0.25], [45.0, 0.3], [-121.0, 0.25]]: # degrees, and size of the map's cells
		var map: RID = get_viewport().world_3d.navigation_map
		NavigationServer3D.map_set_cell_size(map, turned[1])
		await get_tree().physics_frame
		await get_tree().physics_frame
		var city: PCGCity = CityForTests.make_city(60)
		city.rotation_degrees.y = turned[0]
		city.position = Vector3(123.4, 0, -56.7)
		add_child(city)
		check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
		var doors: Array = city.find_children("*", "PCGEntrance", true, false).map(func(door: PCGEntrance) -> Vector3: return door.global_position)
		await _wait_for_map(city)
		var reached := 0
		for door: Vector3 in doors:
			var way: PackedVector3Array = NavigationServer3D.map_get_path(map, doors[0], door, true)
			reached += int(not way.is_empty() and way[-1].distance_to(NavigationServer3D.map_get_closest_point(map, door)) < 0.1)
		check_equal(reached, doors.size(), "the engine's ways lead to all doors, turned by %s degrees" % turned[0])
		check(range(city.get_building_count()).all(func(i: int) -> bool: return is_finite(city.get_distance(0, i))), "and so do ours")
		city.free()
		NavigationServer3D.map_set_cell_size(map, 0.25)
		await get_tree().physics_frame


func test_the_nearest_building_is_the_nearest_to_walk_to() -> void:
	var city: PCGCity = CityForTests.make_city(60)
	add_child(city)
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	var by_type: Dictionary[String, Array] = {}
	for building: int in city.get_building_count():
		by_type.get_or_add(city.get_building(building)["type"], []).append(building)
	check(by_type.size() >= 3, "several types: %s" % [by_type.keys()])
	for type: String in by_type:
		for building: int in city.get_building_count():
			var best: float = by_type[type].map(func(other: int) -> float: return city.get_distance(building, other)).min()
			var nearest: int = city.get_nearest_building(type, building)
			check(city.get_distance(building, nearest) <= best * 1.01 + 0.02, "%s for %d: %s m, not %s m" % [type, building, city.get_distance(building, nearest), best])
	check_equal(city.get_nearest_building("lighthouse", 0), -1, "there is none of that type")
	expect_message("buildings are numbered")
	check_equal(city.get_nearest_building("house", -1), -1, "no such building")


# Edges in which more than two polygons meet on the map's cells: of these the engine complains.
func _count_crowded_edges(mesh: NavigationMesh) -> int:
	var polygons: Dictionary[Array, int] = {}
	var vertices: PackedVector3Array = mesh.get_vertices()
	for polygon: int in mesh.get_polygon_count():
		var corners: PackedInt32Array = mesh.get_polygon(polygon)
		for i: int in corners.size():
			var a := Vector3i((vertices[corners[i]] / mesh.cell_size).floor())
			var b := Vector3i((vertices[corners[(i + 1) % corners.size()]] / mesh.cell_size).floor())
			var edge: Array = [a, b] if a < b else [b, a]
			polygons[edge] = polygons.get(edge, 0) + 1
	return polygons.values().filter(func(count: int) -> bool: return count > 2).size()


func test_no_layout_has_edges_in_which_more_than_two_polygons_meet() -> void:
	for kind: PCGLayout.Kind in [PCGLayout.KIND_GRID, PCGLayout.KIND_RADIAL, PCGLayout.KIND_GROWN]:
		for cell: float in [0.0, 0.5]:
			var city: PCGCity = CityForTests.make_city(50)
			city.layout.kind = kind
			city.layout.fit_lots(50)
			city.layout.jitter = 0.15
			city.cell_size = cell
			city.seed = 3 + kind
			add_child(city)
			city.generate_now()
			var regions: Array = city.find_children("*", "NavigationRegion3D", true, false)
			check(regions.size() > 0, "there is ground")
			for region: NavigationRegion3D in regions:
				check_equal(_count_crowded_edges(region.navigation_mesh), 0, "%s of layout %d with cells of %s m" % [region.name, kind, cell])
			city.free()
			await get_tree().process_frame


# On one of its tiles the engine's baker lays four polygons at one edge.
func test_polygons_that_the_baker_lays_over_others_are_left_out() -> void:
	var city: PCGCity = DemoCity.make_city(240, 15)
	city.layout.kind = PCGLayout.KIND_RADIAL
	city.layout.fit_lots(240)
	city.layout.jitter = 0.15
	add_child(city)
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	for region: NavigationRegion3D in city.find_children("*", "NavigationRegion3D", true, false):
		check_equal(_count_crowded_edges(region.navigation_mesh), 0, region.name)


func test_cells_are_whole_multiples_of_those_of_the_map() -> void:
	var city: PCGCity = CityForTests.make_city(12)
	add_child(city)
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	var fine: int = _count_polygons(city)
	city.cell_size = 0.5
	check(city.generate_now(), "with larger cells: %s" % [city.get_diagnostics()])
	check(_count_polygons(city) != fine, "the ground is baked otherwise: %d polygons, not %d" % [_count_polygons(city), fine])
	for region: NavigationRegion3D in city.find_children("*", "NavigationRegion3D", true, false):
		check_equal(region.navigation_mesh.cell_size, NavigationServer3D.map_get_cell_size(city.get_world_3d().navigation_map), "the map takes it")
	city.cell_size = 0.6
	city.agent_max_climb = 0.1
	expect_message("no whole multiple of the navigation map's")
	check(city.generate_now(), "0.6 m fits no map of 0.25 m, so 0.5 m is taken")
	check_equal(city.get_diagnostics().size(), 2, "which is told: %s" % [city.get_diagnostics()])
	check(str(city.get_diagnostics()).contains("people climb no steps"), "and that steps are lower than a cell")
	expect_message("cell_size is 0.05 m to 1 m")
	city.cell_size = 3.0
	check_equal(city.cell_size, 0.6, "refused")


func _count_polygons(city: PCGCity) -> int:
	return city.find_children("*", "NavigationRegion3D", true, false).reduce(
			func(sum: int, region: NavigationRegion3D) -> int: return sum + region.navigation_mesh.get_polygon_count(), 0)


func test_units_of_settings_are_signs_that_people_read() -> void:
	var city := PCGCity.new()
	var slope: Dictionary = city.get_property_list().filter(func(property: Dictionary) -> bool: return property["name"] == "agent_max_slope")[0]
	check(str(slope["hint_string"]).ends_with("suffix:°"), "degrees: %s" % slope["hint_string"])
	city.free()


func test_the_engine_finds_a_way_between_two_entrances() -> void:
	var city: PCGCity = CityForTests.make_city(40)
	add_child(city)
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	var entrances: Array[Node] = city.find_children("*", "PCGEntrance", true, false)
	var from: Vector3 = (entrances.front() as PCGEntrance).global_position
	var to: Vector3 = (entrances.back() as PCGEntrance).global_position
	var map: RID = city.get_world_3d().navigation_map
	var engine_way := PackedVector3Array()
	var same := 0 # asks in a row that found the same: the map takes cities in and lets go of them over several frames
	for frame: int in 600:
		await get_tree().physics_frame
		if not _is_known_to(map, city, from) or not _is_known_to(map, city, to):
			continue
		var now: PackedVector3Array = NavigationServer3D.map_get_path(map, from, to, true)
		same = same + 1 if now == engine_way and now.size() > 1 and now[-1].distance_to(to) < 2.0 else 0
		engine_way = now
		if same == 10:
			break
	check(engine_way.size() > 1, "the engine's navigation server has a path")
	var way: PackedVector3Array = city.find_path(from, to)
	check(way.size() > 1, "the city has one too")
	check(_length(way) <= 1.01 * _length(engine_way) + 2.0, "no longer: %s and %s m" % [_length(way), _length(engine_way)]) # 2 m: the doorsteps
	check(_length(way) >= from.distance_to(to), "and no shorter than the straight line: %s m" % _length(way))


func _is_known_to(map: RID, city: PCGCity, point: Vector3) -> bool:
	if NavigationServer3D.map_get_iteration_id(map) == 0: # asked before that it complains
		return false
	var owner_rid: RID = NavigationServer3D.map_get_closest_point_owner(map, point)
	return city.find_children("*", "NavigationRegion3D", true, false).any(func(region: NavigationRegion3D) -> bool: return region.get_rid() == owner_rid)
