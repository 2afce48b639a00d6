extends "res://tests/godot/suite.gd"
## Cities that are saved as scenes and loaded again.

const CityForTests := preload("res://tests/godot/city_for_tests.gd")


func _settle() -> void:
	await get_tree().process_frame
	await get_tree().process_frame


func _save(city: PCGCity, path: String) -> void:
	var scene := PackedScene.new()
	check_equal(scene.pack(city), OK, "it is packed")
	check_equal(ResourceSaver.save(scene, path), OK, "it is saved")


## The file goes.
func _load(path: String) -> PCGCity:
	var scene: PackedScene = ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE_DEEP)
	var city: PCGCity = scene.instantiate()
	add_child(city)
	check_equal(await city.city_generated, true, "it is there: %s" % [city.get_diagnostics()])
	await get_tree().process_frame # the signal is still being told
	DirAccess.remove_absolute(path)
	return city


func _distances(city: PCGCity) -> Array:
	return range(city.get_building_count()).map(func(i: int) -> float: return city.get_distance(0, i))
