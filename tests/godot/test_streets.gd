extends "res://tests/godot/suite.gd"
## Streets that are built by rules.

const CityForTests := preload("res://tests/godot/city_for_tests.gd")


func _street_parts(city: PCGCity, type: String) -> Array[Node]:
	return city.get_node("Streets").find_children("*", type, true, false)


func test_streets_are_built_by_the_rules_that_ship() -> void:
	var plain_city: PCGCity = CityForTests.make_city(40)
	add_child(plain_city)
	check(plain_city.generate_now(), "without them, too: %s" % [plain_city.get_diagnostics()])
	var plain: Dictionary = plain_city.get_statistics()
	var city: PCGCity = CityForTests.make_city(40)
	city.use_street_rules = true
	add_child(city)
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	var made: Dictionary = city.get_statistics()
	check(made["instances"] > 50, "trees and lamps are instances: %s" % [made])
	check(city.find_children("*", "MultiMeshInstance3D", true, false).size() > 0, "shown as such")
	for figure: String in ["lots", "blocks", "entrances", "buildings"]:
		check_equal(made[figure], plain[figure], figure)
	check(_street_parts(city, "MeshInstance3D").size() > 0, "there are carriageways")
	for instance: MeshInstance3D in _street_parts(city, "MeshInstance3D"):
		check(instance.mesh.get_surface_count() <= 12, "%s has %d surfaces" % [instance.get_path(), instance.mesh.get_surface_count()])


func test_own_street_rules_with_things_that_mean_something() -> void:
	var city: PCGCity = CityForTests.make_city(12)
	city.use_street_rules = true
	city.street_rules = CityForTests.make_rules(CityForTests.STREETS)
	city.street_attributes = {"stop": "bus stop"}
	add_child(city)
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	var stops: Array = city.find_children("*", "PCGObject", true, false)
	check_equal(city.get_statistics()["objects"], stops.size(), "all objects are the streets'")
	check_equal(stops.size(), 4 * city.get_statistics()["blocks"], "one on each side of each block")
	var stop: PCGObject = stops[0]
	check_equal(stop.type, "stop", "its tag")
	check(stop.get_parent().name.begins_with("Block"), "it stands on the block's pavement")
	stop.free()
	await get_tree().process_frame
	check_equal(city.get_statistics()["objects"], stops.size() - 1, "and is edited like any other")


func test_wrong_street_rules_are_told_and_leave_plain_streets() -> void:
	var city: PCGCity = CityForTests.make_city(12)
	city.use_street_rules = true
	city.street_rules = CityForTests.make_rules("Street --> nonsense(")
	add_child(city)
	expect_message("no rule or operation is called `nonsense`")
	check(not city.generate_now(), "that is told")
	check(city.is_generated(), "but there is a city")
	check(_street_parts(city, "MeshInstance3D").size() > 0, "with streets")
	city.street_rules = CityForTests.make_rules("Street --> Asphalt.\nSidewalk --> Paving.\nCrossing --> White.\n")
	expect_message("the street rules have no rule `Junction`")
	check(city.generate_now(), "a rule that is missing is a warning")
