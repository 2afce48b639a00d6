extends "res://tests/godot/suite.gd"
## Bodies of people: scenes near the camera, figures further off; what a game does to a scene, its person gets over.

const CityForTests := preload("res://tests/godot/city_for_tests.gd")
const HOUR := 3600.0
const STEP := 0.1 ## seconds
const FASTEST := 5.0 ## m/s that nobody's body ever exceeds in view: a hurrying adult, aside and round a corner

var _city: PCGCity
var _citizens: CitizenManager
var _view: PCGAgentView
var _camera: Camera3D


func before_each() -> void:
	_city = CityForTests.make_city(90)
	add_child(_city)
	_city.generate_now()
	_citizens = CityForTests.make_citizens(_city, 180)
	_view = PCGAgentView.new()
	_view.agent_distance = 300.0
	_view.agent_limit = 12
	_view.switch_budget = 100
	_citizens.add_child(_view)
	add_child(_citizens)
	_camera = Camera3D.new()
	_camera.position = Vector3(0, 120, 0.1)
	_camera.fov = 120.0
	add_child(_camera)
	_camera.look_at(Vector3.ZERO)
	_camera.make_current()
	_citizens.generate_population()
	_citizens.jump_to(0, 7.6 * HOUR)
	_citizens.start()
	_citizens.advance(10 * 60.0)
	for step: int in 60 * 60: # until there is a crowd
		if _view.get_agent_count() > 25:
			break
		_citizens.advance(1.0)


func _someone(level: String) -> int:
	for person: int in _citizens.get_persons_outside():
		if _view.get_level(person) == level and _citizens.get_person(person)["state"] == "walking":
			return person
	return -1


## Advances and checks that nobody on the way jumps in view.
func _watch(person: int, seconds: float) -> void:
	var last: Vector3 = _view.get_shown_position(person)
	for step: int in roundi(seconds / STEP):
		_citizens.advance(STEP)
		if not _view.has_agent(person):
			return
		var now: Vector3 = _view.get_shown_position(person)
		check(now.distance_to(last) < FASTEST * STEP, "from %s to %s in %s s" % [last, now, STEP])
		last = now


func test_the_view_of_the_scene_is_used() -> void:
	check(_citizens.get_agent_view() == _view, "the one that stands below the manager")
	check(_view.get_agent_count() > 25, "there is a crowd: %d" % _view.get_agent_count())


func test_the_nearest_have_scenes_up_to_the_limit_and_the_others_are_figures() -> void:
	check_equal(_view.get_scene_count(), 12, "scenes")
	var farthest_agent := 0.0
	var nearest_figure := INF
	for person: int in _citizens.get_persons_outside():
		var distance: float = _view.get_shown_position(person).distance_to(_camera.position)
		match _view.get_level(person):
			"agent":
				farthest_agent = maxf(farthest_agent, distance)
				check_near(_view.get_agent_node(person).position.distance_to(_view.get_shown_position(person)), 0.0, 0.001, "the scene is where its person is")
			"figure":
				nearest_figure = minf(nearest_figure, distance)
				check(_view.get_agent_node(person) == null, "a figure has no scene")
	check(farthest_agent < nearest_figure * (1.0 + _view.hysteresis) + 0.01, "%s m and %s m" % [farthest_agent, nearest_figure])


func test_scenes_come_back_from_the_pool() -> void:
	_camera.position.y = 5000.0
	_citizens.advance(STEP)
	check_equal(_view.get_scene_count(), 0, "nobody is near")
	check_equal(_view.get_pool_size(), 12, "all wait")
	check_equal(_someone("figure"), -1, "beyond the distance of figures people are data")
	_camera.position.y = 120.0
	_citizens.advance(STEP)
	check_equal(_view.get_scene_count(), 12, "they are back")
	check_equal(_view.get_pool_size(), 0, "out of the pool")


func test_a_camera_of_its_own_and_one_that_moves_while_the_clock_stands() -> void:
	check(_view.camera == null, "the viewport's is taken")
	var other := Camera3D.new()
	other.position = Vector3(0, 5000, 0)
	add_child(other)
	_view.camera = other
	await get_tree().process_frame
	await get_tree().process_frame
	check_equal(_view.get_scene_count(), 0, "nobody is near that one")
	check_equal(_someone("figure"), -1, "nor in its picture")
	other.free()
	check(_view.camera == null, "it is gone")
	await get_tree().process_frame
	await get_tree().process_frame
	check_equal(_view.get_scene_count(), 12, "the viewport's again")


## The clock stands for the engine, and a script advances it: what is shown is a walk, not a walk and a halt by turns.
func test_nobody_halts_between_advances_by_hand() -> void:
	var person: int = _someone("agent")
	var link: PCGAgent = _view.get_agent_node(person).find_children("*", "PCGAgent", true, false)[0]
	for frame: int in 5:
		await get_tree().process_frame
		_citizens.advance(1.0 / 60.0)
	check(link.velocity.length() > 0.0, "it walks, however slow the clock is beside this machine")
	var shown: Vector3 = link.velocity
	await get_tree().process_frame # the nodes of that picture have been processed, those of this one not yet
	check_equal(link.velocity, shown, "and goes on doing so")


func test_switches_are_spread_over_pictures() -> void:
	_view.switch_budget = 3
	_camera.position.y = 5000.0
	_citizens.advance(STEP)
	check_equal(_view.get_scene_count(), 9, "three went")
	_view.switch_budget = 100
	_citizens.advance(STEP)
	_view.switch_budget = 4
	_camera.position.y = 120.0
	_citizens.advance(STEP)
	check_equal(_view.get_scene_count(), 4, "four came")


func test_levels_change_without_a_jump() -> void:
	var person: int = _someone("agent")
	_watch(person, 2.0)
	_view.agent_limit = 0
	_watch(person, 2.0)
	check_equal(_view.get_level(person), "figure", "it lost its scene")
	_view.agent_limit = 12
	_watch(person, 2.0)


func test_a_scene_that_the_game_frees_is_replaced_and_nobody_jumps() -> void:
	var person: int = _someone("agent")
	var before: Vector3 = _view.get_shown_position(person)
	_view.get_agent_node(person).free()
	check_equal(_view.get_level(person), "figure", "at once it is a figure")
	check_equal(_view.get_shown_position(person), before, "at the same place")
	_watch(person, 3.0)
	check_equal(_view.get_level(person), "agent", "and then it has a new scene")
	_view.get_agent_node(person).queue_free()
	await get_tree().process_frame
	await get_tree().process_frame
	_watch(person, 1.0)


func test_whom_the_game_pushes_walks_back_to_its_path() -> void:
	var person: int = _someone("agent")
	var node: Node3D = _view.get_agent_node(person)
	node.position += Vector3(0.8, 0, 0.8)
	var pushed: Vector3 = node.position
	_citizens.advance(STEP)
	check(_view.get_shown_position(person).distance_to(pushed) < FASTEST * STEP, "it starts where it was pushed to")
	_watch(person, 4.0)
	if _view.has_agent(person):
		var off: float = _view.get_shown_position(person).distance_to(_view.get_agent_position(person))
		check(off < 0.5, "it is back, %s m aside at most" % off)


func test_who_is_pushed_into_a_wall_finds_the_way_back() -> void:
	var person: int = _someone("agent")
	_view.get_agent_node(person).position += Vector3(6, 0, -7)
	_citizens.advance(STEP)
	_watch(person, 60.0)
	check(not _view.has_agent(person) or _view.get_shown_position(person).distance_to(_view.get_agent_position(person)) < 0.5, "it is back")


func test_unseen_it_is_put_back_at_once() -> void:
	_view.agent_distance = 6000.0
	_view.figure_distance = 6000.0
	var person: int = _someone("agent")
	_camera.look_at(_camera.position + Vector3.UP, Vector3.BACK)
	_citizens.advance(STEP)
	_view.get_agent_node(person).position += Vector3(9, 0, 9)
	_citizens.advance(STEP)
	_citizens.advance(STEP)
	check(_view.get_shown_position(person).distance_to(_view.get_agent_position(person)) < 0.5, "it is where it belongs")
	check_near(_view.get_agent_node(person).position.distance_to(_view.get_shown_position(person)), 0.0, 0.001, "and so is its scene")


func test_a_scene_of_ones_own_hears_whom_it_shows() -> void:
	var told: Array[Dictionary] = []
	var scene := PackedScene.new()
	var body := CharacterBody3D.new()
	scene.pack(body)
	body.free()
	_view.agent_scene = scene
	check_equal(_view.get_scene_count(), 0, "the old ones are gone")
	_citizens.advance(STEP)
	check_equal(_view.get_scene_count(), 12, "the new ones are there")
	var person: int = _someone("agent")
	var node: Node3D = _view.get_agent_node(person)
	check(node is CharacterBody3D, "of the user's kind")
	var link: PCGAgent = node.get_node("PCGAgent")
	check_equal(link.person, person, "it knows its person")
	check_equal(link.pose, &"walk", "who walks")
	check(link.velocity.length() == 0.0 or link.velocity.is_finite(), "at a speed")
	check_equal(link.looks["name"], _citizens.get_person(person)["name"], "with that name")
	for key: String in ["gender", "age_group", "height", "hair_color", "skin_color", "clothes_color"]:
		check(link.looks.has(key), key)
	link.person_released.connect(func(released: int) -> void: told.append({"released": released}))
	link.person_assigned.connect(func(assigned: int) -> void: told.append({"assigned": assigned}))
	_view.agent_limit = 0
	_citizens.advance(STEP)
	_view.agent_limit = 12
	_citizens.advance(STEP)
	check_equal(told.size(), 2, "%s" % [told])
	check_equal(told[0], {"released": person}, "it was released")
	check_equal(told[1], {"assigned": link.person}, "and shows somebody again")


func test_a_scene_that_moves_itself_is_left_alone_until_it_is_stuck() -> void:
	var person: int = _someone("agent")
	var node: Node3D = _view.get_agent_node(person)
	(node.get_node("PCGAgent") as PCGAgent).moves_itself = true
	_citizens.advance(STEP)
	var here: Vector3 = node.position
	for step: int in 20:
		_citizens.advance(STEP)
	check_equal(node.position, here, "it stays where it is, for nobody moves it")
	_watch(person, 20.0)
	check(not _view.has_agent(person) or node.position != here, "then it is carried")


func test_a_scene_without_a_place_in_space_is_one_error() -> void:
	expect_message("the root of agent_scene is no Node3D")
	var scene := PackedScene.new()
	var root := Node.new()
	scene.pack(root)
	root.free()
	_view.agent_scene = scene
	_citizens.advance(STEP)
	_citizens.advance(STEP)
	check_equal(_view.get_scene_count(), 0, "nobody gets it")
	check(_someone("figure") >= 0, "they are figures instead")


func test_a_view_that_the_game_frees_is_made_anew() -> void:
	_view.free()
	_citizens.advance(60.0)
	check(_citizens.get_agent_view() == null, "life goes on unseen")
	_citizens.stop()
	check(_citizens.start(), "and begins again")
	check(_citizens.get_agent_view() != null, "with a view")


func test_avoidance_of_the_engine_moves_agents_along_their_ways() -> void:
	var walkers: Array = Array(_citizens.get_persons_outside()).filter(func(person: int) -> bool:
		return _view.get_level(person) == "agent" and _citizens.get_person(person)["state"] == "walking")
	var begin := {}
	for person: int in walkers:
		begin[person] = [_view.get_shown_position(person), _view.get_agent_node(person)]
	_citizens.time_scale = 1.0
	_citizens.paused = false
	for step: int in 90: # a second and a half
		await get_tree().physics_frame
	_citizens.paused = true
	var compared := 0
	var steered := 0
	for person: int in walkers:
		if not _view.has_agent(person) or _citizens.get_person(person)["state"] != "walking":
			continue
		var node: Node3D = _view.get_agent_node(person)
		if node == null or node != begin[person][1]:
			continue # it was a figure for a while
		compared += 1
		var steering: NavigationAgent3D = node.get_node("NavigationAgent3D")
		steered += int(NavigationServer3D.agent_get_velocity(steering.get_rid()).length() > 0.3) # others wait for their place to catch up
		var off: float = _view.get_shown_position(person).distance_to(_view.get_agent_position(person))
		check(off < 1.5, "person %d keeps to its way: %s m off" % [person, off])
		check(_view.get_shown_position(person).distance_to(begin[person][0]) > 0.3, "and moves on")
	check(steered * 2 > compared, "the engine steers %d of them" % steered)
	check(compared > 3, "several were looked at: %d" % compared)


func test_a_click_finds_a_person() -> void:
	var person: int = _someone("agent")
	var there: Vector3 = _view.get_shown_position(person) + Vector3(0, 0.85, 0)
	check_equal(_view.pick_person(there + Vector3(0, 3, 0), Vector3.DOWN), person, "from above")
	check_equal(_view.pick_person(there + Vector3(0, 3, 0), Vector3.UP), -1, "not backwards")
