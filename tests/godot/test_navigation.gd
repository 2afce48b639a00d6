extends "res://tests/godot/suite.gd"
## Ways of the city compared with those of the engine's own navigation server, on the same polygons.

const CityForTests := preload("res://tests/godot/city_for_tests.gd")
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
