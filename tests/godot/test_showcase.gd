extends "res://tests/godot/suite.gd"
## The demo, driven through its own functions: a day of 2,000 people with agents and every promise checked, clicks, drags, the clock, the heat map.

const HOUR := 3600.0
const STEP := 20.0 ## seconds

var _scene: Node3D
var _citizens: CitizenManager
var _view: PCGAgentView


func before_each() -> void:
	_scene = (load("res://demo/showcase.tscn") as PackedScene).instantiate()
	_citizens = _scene.get_node("Citizens")
	_citizens.check_promises = true
	_citizens.paused = true
	add_child(_scene)
	_view = _scene.get_node("Citizens/Agents")
	while not _citizens.is_running():
		await get_tree().process_frame


func after_each() -> void:
	get_window().content_scale_factor = 1.0


## To a quarter of an hour before, and then lived.
func _live_until(hour: float) -> void:
	_citizens.jump_to(0, (hour - 0.25) * HOUR)
	for step: int in 45:
		_citizens.advance(STEP)


func _check_promises() -> void:
	var broken: Dictionary = _citizens.get_broken_promises()
	check(not broken.is_empty(), "promises are checked")
	for promise: String in broken:
		check_equal(broken[promise], 0, "%s: %s" % [promise, _citizens.get_broken_promise_examples()])


func test_a_day_of_two_thousand_people_with_agents_breaks_no_promise() -> void:
	check_equal(_citizens.get_statistics()["persons"], 2000, "people")
	var most := {"scenes": 0, "outdoors": 0}
	var outdoors_at := {}
	(_scene.get_node("CameraRig") as DemoCameraRig).look_from(Vector3(28, 0, -52), 8.0, 42.0, 40.0) # between a school and two parks
	_citizens.jump_to(0, 5 * HOUR)
	for step: int in roundi(19 * HOUR / STEP):
		_citizens.advance(STEP)
		most["scenes"] = maxi(most["scenes"], _view.get_scene_count())
		most["outdoors"] = maxi(most["outdoors"], _view.get_agent_count())
		if step % 90 == 0: # every half hour
			outdoors_at[_citizens.get_clock_text()] = _view.get_agent_count()
			check_equal(_citizens.get_persons_outside().size(), _view.get_agent_count(), "everybody outdoors has a body, nobody else")
			await get_tree().process_frame
	_check_promises()
	check(most["scenes"] > 10, "agents were seen: %s" % [most])
	check(most["outdoors"] > 500, "and the school run: %s" % [most])
	check(outdoors_at["10:00"] > 100, "elders are in the parks in the morning: %s" % [outdoors_at])
	check_equal(outdoors_at["22:00"], 0, "and at night everybody is at home")


func test_a_click_follows_somebody_and_shows_the_agenda() -> void:
	_live_until(7.97)
	var hand: DemoHand = _scene.get_node("Hand")
	var panel: DemoPersonPanel = _scene.get_node("Interface/Person")
	var rig: DemoCameraRig = _scene.get_node("CameraRig")
	var person: int = _citizens.get_persons_outside()[0]
	var there: Vector3 = _view.global_transform * _view.get_shown_position(person) + Vector3(0, 0.85, 0)
	rig.look_from(there, 0.0, 89.0, 40.0)
	_citizens.advance(0.0)
	var camera: Camera3D = get_viewport().get_camera_3d()
	var picked: int = hand.pick(camera.global_position, (there - camera.global_position).normalized())
	check(picked >= 0, "somebody was there")
	check_equal(panel.person, picked, "the panel shows them")
	check(panel.visible, "openly")
	panel.write()
	var who: Dictionary = _citizens.get_person(picked)
	check(panel.describe_now(who).contains("on the way to") or panel.describe_now(who).contains("sits on the bench"), "what they do: %s" % panel.describe_now(who))
	check(panel.describe_agenda(who).contains("weekday.pcg:"), "and why")
	check(_scene.call(&"find_followed") is Vector3, "the camera knows where they are")
	for frame: int in 60:
		await get_tree().process_frame
	var target: Variant = _scene.call(&"find_followed")
	if target is Vector3:
		check(rig.position.distance_to(target) < 20.0, "and follows: %s" % rig.position.distance_to(target))
	check_equal(hand.pick(camera.global_position, Vector3.UP), -1, "a click into the sky")
	check(not panel.visible, "lets go")


func test_a_bench_that_is_dragged_away_is_gone_for_those_who_sat_there() -> void:
	_live_until(10.0)
	var hand: DemoHand = _scene.get_node("Hand")
	var sitter := -1
	for person: int in _citizens.get_persons_outside():
		if _citizens.get_person(person)["state"] == "at-place" and _citizens.get_person(person)["place"]["kind"] == "object":
			sitter = person
			break
	check(sitter >= 0, "somebody sits on a bench")
	var seat: Vector3 = _citizens.get_person(sitter)["position"]
	var bench: PCGObject = hand.find_object(seat + Vector3(0, 20, 0), Vector3.DOWN)
	check(bench != null, "it is found")
	check_equal(bench.object_id, _citizens.get_person(sitter)["place"]["id"], "that very bench")
	var before: Vector3 = bench.global_position
	hand.grip(bench)
	hand.carry(before + Vector3(60, 30, 0), Vector3.DOWN)
	hand.put_down()
	check(bench.global_position.distance_to(before) > 50.0, "it stands elsewhere")
	check_near(bench.global_position.y, before.y, 0.001, "on the ground")
	await get_tree().process_frame # the city takes it in
	await get_tree().process_frame
	for step: int in 15 * 60:
		_citizens.advance(1.0)
	var after: Dictionary = _citizens.get_person(sitter)
	check(after["position"].distance_to(seat) > 1.0, "who sat there has got up: %s" % [after])
	_check_promises()


func test_the_panel_sets_speed_and_hour_and_shows_the_heat() -> void:
	var panel: DemoClockPanel = _scene.get_node("Interface/Panel")
	var heat: DemoHeatLayer = _scene.get_node("Heat")
	panel.set_speed(300.0)
	check_equal(_citizens.time_scale, 300.0, "fast")
	check(not _citizens.paused, "and running")
	panel.set_speed(0.0)
	check(_citizens.paused, "paused")
	panel.jump_to_hour(16.0)
	check_equal(_citizens.get_clock_text(), "16:00", "the clock jumps")
	_live_until(8.1)
	var pictures: Dictionary[PackedByteArray, String] = {}
	for choice: String in ["all", "children", "adults", "elders"]:
		heat.choose(choice)
		check(heat.visible and heat.show_heat(_citizens, heat.group), "heat of %s" % choice)
		check(heat.picture.get_used_rect().has_area(), "%s were somewhere" % choice)
		pictures[heat.picture.get_data()] = choice
	check_equal(pictures.size(), 4, "everybody and each group in their own places")
	check(_citizens.get_heat_image("children", 7).get_used_rect().has_area(), "children were outdoors at seven")
	check(not _citizens.get_heat_image("children", 2).get_used_rect().has_area(), "not at two in the night")
	check(_citizens.get_heat_area().has_point(Vector2.ZERO), "over the city")
	heat.choose("off")
	check(not heat.visible, "and away")
	expect_message("heat maps are of \"children\", \"adults\", \"elders\"")
	check(_citizens.get_heat_image("dogs") == null, "of nobody else")
	expect_message("heat maps are of an hour from 0 to 23")
	check(_citizens.get_heat_image("", 24) == null, "of no other hour")


func test_light_follows_the_hour_and_windows_are_lit_at_night() -> void:
	var sun: DemoSun = _scene.get_node("Sun")
	sun.show_hour(12.0)
	var noon: float = sun.light_energy
	sun.show_hour(23.0)
	check(sun.light_energy < 0.5 * noon, "nights are dark")
	check(DemoSun.daylight_at(3.0) == 0.0 and DemoSun.daylight_at(13.0) == 1.0, "and days are bright")
	var windows: DemoWindows = _scene.get_node("Windows")
	check_equal(windows.adopt_panes(), 0, "all panes have been found when the city came")
	windows.show_hour(21.0)
	check(windows.get("_material").get_shader_parameter(&"share_lit") > 0.3, "in the evening windows are lit")
	windows.show_hour(12.0)
	check_equal(windows.get("_material").get_shader_parameter(&"share_lit"), 0.0, "at noon none")
