@tool
extends "res://tests/editor/editor_suite.gd"
## What tests of the dock's page for a city extend: an empty scene, and a small city to put into it.

const CityForTests := preload("res://tests/godot/city_for_tests.gd")
const CityTab := preload("res://addons/pcg/editor/city/city_tab.gd")

var _tab: CityTab
var _root: Node3D


func before_each() -> void:
	_tab = get_authoring().dock.city_tab
	EditorInterface.close_scene()
	_root = Node3D.new()
	_root.name = "World"
	EditorInterface.add_root_node(_root)
	await frames(2)


func after_each() -> void:
	EditorInterface.close_scene()
	await frames(2)


func _add_small_city() -> PCGCity:
	var city: PCGCity = CityForTests.make_city(12)
	_root.add_child(city)
	city.owner = _root
	await frames(2)
	return city


func _generated(city: PCGCity) -> void:
	while city.is_generating():
		await get_tree().process_frame
	await frames(2)
