extends SceneTree
## What a city costs in the engine: generating it with the shipped rules, edits, ways beside those of the engine's navigation server, and a large one.
##
##     godot --headless --path . --script bench/city_bench.gd [-- LOTS]
##
## 300 lots, then LOTS (5,000 by default; 0: none). Prints one JSON object a figure, as the programs of this folder do.

const DemoCity := preload("res://demo/demo_city.gd")
const Figure := preload("res://bench/figure.gd")
const LIMIT_SECONDS := 3.0
const LIMIT_HOLD := 8.0 ## ms
const LIMIT_EDIT := 200.0 ## ms
const LIMIT_FASTER := 20.0 ## times the engine's queries a second
const PAIRS := 1000
const ROUNDS := 5
const NEAR := 5.0 ## metres from a door to ground that the server knows


func _initialize() -> void:
	_run.call_deferred()


func _run() -> void:
	var city: PCGCity = await _generate(300, "300", LIMIT_SECONDS)
	await _edit(city)
	await _walk(city)
	city.free()
	await process_frame
	var arguments: PackedStringArray = OS.get_cmdline_user_args()
	var lots: int = int(arguments[0]) if arguments.size() > 0 else 5000
	if lots > 0:
		var before: int = OS.get_static_memory_usage()
		city = await _generate(lots, str(lots), 0.0)
		Figure.tell("city_memory_%d" % lots, (OS.get_static_memory_usage() - before) / 1e6, "MB in the engine's memory")
		city.free()
		await process_frame
	quit(0)


func _generate(lots: int, name: String, limit: float) -> PCGCity:
	var city: PCGCity = DemoCity.make_city(lots, 1)
	root.add_child(city)
	var begin: int = Time.get_ticks_usec()
	city.generate()
	await city.city_generated
	await process_frame
	Figure.tell("city_generate_%s" % name, (Time.get_ticks_usec() - begin) / 1e6, "s", limit)
	var made: Dictionary = city.get_statistics()
	for stage: String in made["seconds"]:
		Figure.tell("city_generate_%s_%s" % [name, stage], made["seconds"][stage], "s")
	Figure.tell("city_longest_hold_%s" % name, made["longest_hold"] * 1e3, "ms", LIMIT_HOLD)
	return city


# From the deletion of a lot until ways lead over its ground.
func _edit(city: PCGCity) -> void:
	var lot: PCGLot = city.find_children("*", "PCGLot", true, false)[40]
	var begin: int = Time.get_ticks_usec()
	lot.queue_free()
	await city.navigation_updated
	Figure.tell("city_edit", (Time.get_ticks_usec() - begin) / 1e3, "ms", LIMIT_EDIT)


func _walk(city: PCGCity) -> void:
	var doors: Array = city.find_children("*", "PCGEntrance", true, false).map(func(door: PCGEntrance) -> Vector3: return door.global_position)
	var map: RID = city.get_world_3d().navigation_map
	var patience: int = Time.get_ticks_msec() + 60000
	while Time.get_ticks_msec() < patience: # until the server has taken in all regions
		await create_timer(0.1).timeout
		if doors.all(func(door: Vector3) -> bool: return NavigationServer3D.map_get_closest_point(map, door).distance_to(door) < NEAR):
			break
	doors = doors.map(func(door: Vector3) -> Vector3: return NavigationServer3D.map_get_closest_point(map, door))
	var pairs: Array[Vector3] = []
	seed(7)
	for i: int in 2 * PAIRS:
		pairs.append(doors[randi() % doors.size()])
	var server := func(from: Vector3, to: Vector3) -> PackedVector3Array: return NavigationServer3D.map_get_path(map, from, to, true)
	var theirs := INF
	var ours := INF
	for round: int in ROUNDS: # in turns, and the least of each counts: what else the machine does disturbs single rounds
		theirs = minf(theirs, _time(pairs, server))
		ours = minf(ours, _time(pairs, city.find_path))
	Figure.tell("city_path", ours, "us", theirs)
	Figure.tell("city_path_faster", theirs / ours, "times the engine's", LIMIT_FASTER)
	_compare_lengths(city, pairs, server)


# Microseconds of a query, ways asked between each two points.
func _time(pairs: Array[Vector3], find: Callable) -> float:
	var begin: int = Time.get_ticks_usec()
	for i: int in PAIRS:
		find.call(pairs[2 * i], pairs[2 * i + 1])
	return (Time.get_ticks_usec() - begin) / float(PAIRS)


# Of the ways that the server finds: after some thousand polygons it gives up, and tells the way until there.
func _compare_lengths(city: PCGCity, pairs: Array[Vector3], server: Callable) -> void:
	var ours := 0.0
	var theirs := 0.0
	var found := 0
	var longest := 0.0
	for i: int in PAIRS:
		var way: PackedVector3Array = server.call(pairs[2 * i], pairs[2 * i + 1])
		if way.size() > 1 and way[-1].distance_to(pairs[2 * i + 1]) < 0.1:
			var here: float = _length(city.find_path(pairs[2 * i], pairs[2 * i + 1]))
			found += 1
			ours += here
			theirs += _length(way)
			longest = maxf(longest, here / maxf(_length(way), 1.0))
	if found < PAIRS / 2:
		printerr("city_bench: the engine's server finds %d of %d ways" % [found, PAIRS])
		quit(1)
		return
	Figure.tell("city_path_length", ours / found, "m", theirs / found)
	Figure.tell("city_path_longest", longest, "times the engine's way", 1.01)


func _length(points: PackedVector3Array) -> float:
	var sum := 0.0
	for i: int in range(1, points.size()):
		sum += points[i - 1].distance_to(points[i])
	return sum
