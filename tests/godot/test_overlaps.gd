extends "res://tests/godot/suite.gd"
## Lots that stand on each other know it, moved there by hand or drawn so.

const CityForTests := preload("res://tests/godot/city_for_tests.gd")


func _settle() -> void:
	await get_tree().process_frame
	await get_tree().process_frame


func test_lots_that_overlap_know_each_other() -> void:
	var city: PCGCity = CityForTests.make_city(20)
	add_child(city)
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	var lots: Array = city.find_children("*", "PCGLot", true, false)
	var one: PCGLot = lots[0]
	var other: PCGLot = lots[1]
	check_equal(one.get_overlapping_lots().size(), 0, "as generated none do")
	var home: Vector3 = one.position
	one.position = other.position
	await _settle()
	check_equal(one.get_overlapping_lots(), [other] as Array[PCGLot], "one that was moved")
	check_equal(other.get_overlapping_lots(), [one] as Array[PCGLot], "and the one below it")
	one.position = home
	await _settle()
	check_equal(one.get_overlapping_lots().size() + other.get_overlapping_lots().size(), 0, "until it is moved back")
	var copy: PCGLot = one.duplicate()
	one.get_parent().add_child(copy)
	await _settle()
	check_equal(copy.get_overlapping_lots(), [one] as Array[PCGLot], "a copy in its place")
	copy.free()
	await _settle()
	check_equal(one.get_overlapping_lots().size(), 0, "which went again")
	while city.is_updating_navigation():
		await get_tree().process_frame


func test_lots_that_were_drawn_over_each_other_know_it() -> void:
	var city: PCGCity = CityForTests.make_city()
	city.layout.kind = PCGLayout.KIND_FOOTPRINTS
	for x: int in [0, 15, 60]:
		var drawn := Polygon2D.new()
		drawn.polygon = PackedVector2Array([Vector2(0, 0), Vector2(20, 0), Vector2(20, 20), Vector2(0, 20)])
		drawn.position = Vector2(x, 300)
		city.add_child(drawn)
	add_child(city)
	expect_message("overlap by 100 square metres")
	city.generate_now()
	await _settle()
	var lots: Array = city.find_children("*", "PCGLot", true, false)
	lots.sort_custom(func(a: PCGLot, b: PCGLot) -> bool: return a.lot_id < b.lot_id)
	check_equal(lots[0].get_overlapping_lots(), [lots[1]] as Array[PCGLot], "the one over the other")
	check_equal(lots[2].get_overlapping_lots().size(), 0, "but not the third")
	var blocks: Dictionary = {}
	for lot: PCGLot in lots:
		blocks[lot.block_id] = true
	check_equal(city.get_statistics()["blocks"], blocks.size(), "squares of the map without a lot are no blocks")
