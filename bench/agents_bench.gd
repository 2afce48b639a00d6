extends SceneTree
## What a frame costs CitizenManager in the engine, with people as full agents: scenes with a NavigationAgent3D that avoids others.
##
##     godot --headless --fixed-fps 60 --path . --script bench/agents_bench.gd [-- PERSONS]
##
## 300 lots, 2,000 persons on a weekday, at four in the afternoon, when school and work end. Everybody outdoors has a scene; the clock runs in real
## time. Prints one JSON object a figure, as the programs of this folder do. What the engine spends on avoidance is told separately, and so is drawing where
## there is a screen (without --headless). Run by tools/run_bench.py, it tells as well how often a frame asks for memory: the plugin itself, and the engine on
## its behalf.

const DemoCity := preload("res://demo/demo_city.gd")
const Figure := preload("res://bench/figure.gd")
const FRAME := 1.0 / 60.0 ## seconds
const BEGIN := 15.0 * 3600.0 + 59.0 * 60.0 + 45.0
const WARM_UP := 1200 ## frames, until all have left and have their scenes
const MEASURED := 1800 ## frames
const DRAWN := 30 ## frames of them, where there is a screen: enough to tell, since what is drawn hardly changes
const PERSONS := 2000 ## or as the first argument says
const LOTS_A_PERSON := 0.15
const ALL := 100000 ## scenes
const LIMIT_AVERAGE := 1.0 ## ms
const LIMIT_PERCENTILE := 4.0 ## ms
const ALL_ALLOCATIONS := "PCG_ALLOCATIONS"
const PLUGIN_ALLOCATIONS := "PCG_PLUGIN_ALLOCATIONS"

var _city: PCGCity
var _citizens: CitizenManager


func _initialize() -> void:
	_run.call_deferred()


func _run() -> void:
	var arguments: PackedStringArray = OS.get_cmdline_user_args()
	_make_world(arguments[0].to_int() if arguments.size() > 0 else PERSONS)
	_city.generate()
	if not await _city.city_generated or not _citizens.generate_population():
		printerr("agents_bench: there is no city to live in")
		quit(1)
		return
	_citizens.jump_to(0, BEGIN)
	_citizens.start()
	await _measure("agents", true)
	_citizens.jump_to(0, BEGIN)
	await _measure("figures", false)
	_listen()
	_citizens.jump_to(0, BEGIN)
	await _measure("heard_figures", false)
	root.get_child(root.get_child_count() - 1).queue_free()
	await process_frame
	quit(0)


func _make_world(persons: int) -> void:
	var world := Node3D.new()
	root.add_child(world)
	_city = DemoCity.make_city(ceili(persons * LOTS_A_PERSON), 1)
	world.add_child(_city)
	_citizens = CitizenManager.new()
	_citizens.city = _city
	_citizens.rules = PCGRuleSet.from_file(DemoCity.RULES)
	_citizens.household_table = PCGHouseholdTable.from_file(DemoCity.HOUSEHOLDS)
	_citizens.person_count = persons
	_citizens.paused = true # this script moves the clock, and takes the time
	var view := PCGAgentView.new()
	view.agent_distance = 2000.0
	view.figure_distance = 2000.0
	view.switch_budget = 50
	_citizens.add_child(view)
	world.add_child(_citizens)
	var camera := Camera3D.new()
	camera.far = 3000.0
	camera.position = Vector3(0, 400, 1)
	world.add_child(camera)
	camera.look_at(Vector3.ZERO)


## Somebody listens to everything that happens.
func _listen() -> void:
	for one: StringName in [&"person_left_building", &"person_entered_building", &"task_started"]:
		_citizens.connect(one, func(_person: int, _what: Variant) -> void: pass)
	for one: StringName in [&"agent_spawned", &"agent_freed"]:
		_citizens.connect(one, func(_person: int) -> void: pass)


## How often this thread asked for memory: `allocations.so` answers, if it is there.
func _count(name: String) -> int:
	return OS.get_environment(name).to_int()


## One frame: milliseconds, how often the plugin asked for memory, and how often the engine did on its behalf.
func _advance() -> Vector3:
	var plugin: int = _count(PLUGIN_ALLOCATIONS)
	var asked: int = -_count(ALL_ALLOCATIONS)
	asked += _count(ALL_ALLOCATIONS) # asking itself
	var all: int = _count(ALL_ALLOCATIONS)
	var begin: int = Time.get_ticks_usec()
	_citizens.advance(FRAME)
	var spent: int = Time.get_ticks_usec() - begin
	all = _count(ALL_ALLOCATIONS) - all - asked
	plugin = _count(PLUGIN_ALLOCATIONS) - plugin
	return Vector3(spent / 1000.0, plugin, all - plugin)


func _tell_frames(what: String, frames: PackedVector3Array) -> void:
	var sum := Vector3.ZERO
	var asking := 0
	var milliseconds := PackedFloat64Array()
	for frame: Vector3 in frames:
		sum += frame
		asking += int(frame.y > 0.0)
		milliseconds.append(frame.x)
	milliseconds.sort()
	Figure.tell("engine_%s_ms_a_frame" % what, sum.x / MEASURED, "ms", LIMIT_AVERAGE)
	Figure.tell("engine_%s_ms_99th_percentile" % what, milliseconds[floori(MEASURED * 0.99)], "ms", LIMIT_PERCENTILE)
	Figure.tell("engine_%s_ms_slowest" % what, milliseconds[MEASURED - 1], "ms")
	if OS.has_environment(ALL_ALLOCATIONS):
		Figure.tell("engine_%s_allocations_a_frame" % what, sum.y / MEASURED, "allocations")
		Figure.tell("engine_%s_frames_with_allocations" % what, 100.0 * asking / MEASURED, "%")
		Figure.tell("engine_%s_engine_allocations_a_frame" % what, sum.z / MEASURED, "allocations")


func _measure(what: String, has_scenes: bool) -> void:
	_citizens.get_agent_view().agent_limit = ALL if has_scenes else 0
	var frames := PackedVector3Array()
	var avoidance := 0.0
	var outside := 0
	var scenes := 0
	var drawing := 0.0
	for frame: int in WARM_UP + MEASURED:
		RenderingServer.render_loop_enabled = frame >= WARM_UP and frame < WARM_UP + DRAWN
		var cost: Vector3 = _advance()
		await process_frame
		if RenderingServer.render_loop_enabled:
			var begin: int = Time.get_ticks_usec()
			RenderingServer.force_draw()
			drawing += float(Time.get_ticks_usec() - begin) / 1000.0
		if frame >= WARM_UP:
			frames.append(cost)
			avoidance += Performance.get_monitor(Performance.TIME_NAVIGATION_PROCESS) * 1000.0
			outside += _citizens.get_agent_view().get_agent_count()
			scenes += _citizens.get_agent_view().get_scene_count()
	_tell_frames(what, frames)
	Figure.tell("engine_%s_outdoors" % what, float(outside) / MEASURED, "persons")
	if DisplayServer.get_name() != "headless":
		Figure.tell("engine_%s_drawing_ms_a_frame" % what, drawing / DRAWN, "ms")
	if has_scenes:
		Figure.tell("engine_%s_scenes" % what, float(scenes) / MEASURED, "scenes")
		Figure.tell("engine_%s_navigation_server_ms_a_frame" % what, avoidance / MEASURED, "ms")
