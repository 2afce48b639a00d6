extends "res://tests/godot/suite.gd"
## Ways of the city compared with those of the engine's own navigation server, on the same polygons.

const CityForTests := preload("res://tests/godot/city_for_tests.gd")
const PAIRS := 1000


func _length(points: PackedVector3Array) -> float:
	var sum := 0.0
	for i: int in range(1, points.size()):
		sum += points[i - 1].distance_to(points[i])
	return sum


func _wait_for_map(map: RID, from: Vector3, to: Vector3) -> void:
	for frame: int in 600:
		await get_tree().physics_frame
		if NavigationServer3D.map_get_path(map, from, to, true).size() > 1:
			return


func test_a_thousand_ways_are_as_long_as_those_of_the_engine() -> void:
	var city: PCGCity = CityForTests.make_city(100)
	add_child(city)
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	var doors: Array = city.find_children("*", "PCGEntrance", true, false).map(func(door: PCGEntrance) -> Vector3: return door.global_position)
	var map: RID = city.get_world_3d().navigation_map
	await _wait_for_map(map, doors.front(), doors.back())
	doors = doors.map(func(door: Vector3) -> Vector3: return NavigationServer3D.map_get_closest_point(map, door)) # both begin on the mesh
	var random := RandomNumberGenerator.new()
	random.seed = 7
	var ours := 0.0
	var theirs := 0.0
	var worst := 1.0
	for pair: int in PAIRS:
		var from: Vector3 = doors[random.randi() % doors.size()]
		var to: Vector3 = doors[random.randi() % doors.size()]
		var here: float = _length(city.find_path(from, to))
		var there: float = _length(NavigationServer3D.map_get_path(map, from, to, true))
		ours += here
		theirs += there
		worst = maxf(worst, (here - 0.5) / maxf(there, 1.0))
	check(theirs > 10000.0, "there are ways: %s m" % theirs)
	check_near(ours / theirs, 1.0, 0.015, "all ways together")
	check(worst <= 1.6, "none is much longer: the worst %s times as long" % worst)
