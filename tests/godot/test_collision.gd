extends "res://tests/godot/suite.gd"
## What bodies of a game's physics find of a city.

const CityForTests := preload("res://tests/godot/city_for_tests.gd")


func test_bodies_stand_on_streets_and_bump_into_buildings_where_wanted() -> void:
	var city: PCGCity = CityForTests.make_city(12)
	city.use_collision = true
	city.collision_layer = 4
	add_child(city)
	check(city.generate_now(), "it generates")
	await get_tree().physics_frame
	await get_tree().physics_frame
	var space: PhysicsDirectSpaceState3D = city.get_world_3d().direct_space_state
	for node: Node in city.find_children("*", "PCGEntrance", true, false):
		var door := node as PCGEntrance
		var outside: Vector3 = door.global_position + door.global_basis.z * 2.0
		var down: Dictionary = space.intersect_ray(PhysicsRayQueryParameters3D.create(outside + Vector3.UP, outside + Vector3.DOWN, 4))
		check(not down.is_empty() and absf(down["position"].y) < 0.3, "ground before %s: %s" % [door.name, down])
		var ahead := PhysicsRayQueryParameters3D.create(outside + Vector3.UP, door.global_position - door.global_basis.z + Vector3.UP, 4)
		check(not space.intersect_ray(ahead).is_empty(), "a wall at %s" % door.name)
		ahead.collision_mask = 1
		check(space.intersect_ray(ahead).is_empty(), "on the layer that was told, and no other")
	city.use_collision = false
	check(city.regenerate_lot(0), "a lot is made anew")
	check_equal(city.find_child("Lot0", true, false).find_children("*", "StaticBody3D", true, false).size(), 0, "bodies where none are wanted")
	check(city.find_children("*", "StaticBody3D", true, false).size() > 10, "and those of the others stay")
