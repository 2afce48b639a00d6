extends "res://tests/godot/suite.gd"
## A small city with people in it, anew for each test, and how to find somebody.

const CityForTests := preload("res://tests/godot/city_for_tests.gd")
const HOUR := 3600.0
## The first adult brings the children to school and fetches them, if it brought them.
const SCHOOL_RUN := """@StartRule
Household -->
	members { true: stayInside(0h, 24h, home) }
	members { age < 18: task("school") { goToBuilding(7h30m, 16h, findNearestBuilding("school", home)) } }
	case count(age < 18) > 0: members { age >= 18: requires("school") { delayedRule(16h, 17h, Park) } }
Park --> goToZone("park") wait(10m)
"""

var _city: PCGCity
var _citizens: CitizenManager


func before_each() -> void:
	_city = CityForTests.make_city()
	add_child(_city)
	_city.generate_now()
	_make_citizens()


func _make_citizens() -> void:
	_citizens = CityForTests.make_citizens(_city)
	_citizens.check_promises = true
	add_child(_citizens)


func _begin(hour: float = 0.0) -> void:
	check(_citizens.generate_population(), "there are people: %s" % [_citizens.get_diagnostics()])
	_citizens.jump_to(0, hour * HOUR)
	check(_citizens.start(), "life begins")


func _check_promises() -> void:
	for count: int in _citizens.get_broken_promises().values():
		check_equal(count, 0, "a promise: %s" % [_citizens.get_broken_promise_examples()])


func _somebody(wanted: Callable) -> int:
	var found: PackedInt32Array = _citizens.find_persons(wanted)
	check(not found.is_empty(), "there is somebody like that")
	return found[0] if not found.is_empty() else 0


func _school() -> int:
	var child: int = _somebody(func(person: Dictionary) -> bool: return person["age"] < 18)
	var home: int = _citizens.get_person(child)["home"]
	return _citizens.get_agenda(child).filter(func(task: Dictionary) -> bool: return task["target"] != home)[0]["target"]


func _adult_with_child() -> int:
	var children: PackedInt32Array = _citizens.find_persons(func(person: Dictionary) -> bool: return person["age"] < 18)
	var household: int = _citizens.get_person(children[0])["household"]
	return _somebody(func(person: Dictionary) -> bool: return person["household"] == household and person["age"] >= 18)
