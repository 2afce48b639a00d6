extends "res://tests/godot/suite.gd"
## The steps of the demo that teach: each makes its city without a message, and its people live.

const FOLDER := "res://demo/steps"
const SECONDS_PER_HOUR := 3600.0


func _open(step: String) -> Node:
	var scene: Node = (load(FOLDER.path_join(step + ".tscn")) as PackedScene).instantiate()
	add_child(scene)
	var city: PCGCity = scene.get("city")
	while city.is_generating():
		await get_tree().process_frame
	await get_tree().process_frame
	return scene


func _open_with_people(step: String) -> CitizenManager:
	var scene: Node = await _open(step)
	var citizens: CitizenManager = scene.get("citizens")
	check((scene.get("city") as PCGCity).get_diagnostics().is_empty(), "%s: %s" % [step, (scene.get("city") as PCGCity).get_diagnostics()])
	check(citizens.get_diagnostics().is_empty(), "%s: %s" % [step, citizens.get_diagnostics()])
	check(citizens.is_running(), "%s: people live" % step)
	citizens.paused = true
	return citizens


func test_every_step_is_there_and_has_its_number() -> void:
	var script: GDScript = load(FOLDER.path_join("step.gd"))
	var scenes: PackedStringArray = script.get_script_constant_map()["SCENES"]
	for index: int in scenes.size():
		var scene: Node = (load(FOLDER.path_join(scenes[index] + ".tscn")) as PackedScene).instantiate()
		check_equal(scene.get("number"), index + 1, scenes[index])
		check(str(scene.get("text")).length() > 50, "%s tells something" % scenes[index])
		scene.free()


func test_one_lot_has_one_house_with_a_door() -> void:
	var city: PCGCity = (await _open("1_one_lot")).get("city")
	check_equal(city.get_statistics()["lots"], 1, "a lot")
	check_equal(city.get_statistics()["entrances"], {"house": 1}, "a door")
	check(city.get_diagnostics().is_empty(), "without a message: %s" % [city.get_diagnostics()])


func test_a_street_has_several_kinds_of_houses() -> void:
	var city: PCGCity = (await _open("2_a_street")).get("city")
	check_equal(city.get_statistics()["lots"], 10, "lots")
	check(city.get_statistics()["entrances"].has("shop"), "with a shop: %s" % [city.get_statistics()["entrances"]])


func test_a_household_goes_to_work() -> void:
	var citizens: CitizenManager = await _open_with_people("3_household")
	citizens.jump_to(0, 12.0 * SECONDS_PER_HOUR)
	check_equal(citizens.get_person(0)["state"], "inside", "at noon")
	check(citizens.get_person(0)["place"]["id"] != citizens.get_person(0)["home"], "but not at home")


func test_children_are_brought_to_school() -> void:
	var citizens: CitizenManager = await _open_with_people("4_school_run")
	var led := 0
	for minute: int in 60:
		citizens.advance(60.0)
		for person: int in citizens.get_persons_outside():
			led += int(int(citizens.get_person(person)["leader"]) >= 0)
	check(led > 0, "somebody walks with an adult before school")


func test_somebody_sits_on_a_bench() -> void:
	var citizens: CitizenManager = await _open_with_people("5_bench")
	var sat := 0
	for minute: int in 150:
		citizens.advance(60.0)
		for person: int in citizens.get_persons_outside():
			sat += int(citizens.get_person(person)["state"] == "at-place")
	check(sat > 0, "on a bench between ten and noon")


func test_the_added_rule_brings_people_into_the_park() -> void:
	var citizens: CitizenManager = await _open_with_people("6_your_own_rule")
	citizens.advance(1.3 * SECONDS_PER_HOUR)
	check(int(citizens.get_statistics()["peak_outside"]) > 0, "after six: %s" % [citizens.get_statistics()])
