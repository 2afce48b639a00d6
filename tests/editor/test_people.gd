@tool
extends "res://tests/editor/editor_suite.gd"
## The dock's pages for people, their days and one person.

const CityForTests := preload("res://tests/godot/city_for_tests.gd")
const PCGDock := preload("res://addons/pcg/editor/pcg_dock.gd")
const PeopleFilter := preload("res://addons/pcg/editor/people/people_filter.gd")
const EIGHT := 8.0 * 3600.0

var _dock: PCGDock
var _city: PCGCity
var _citizens: CitizenManager


func before_each() -> void:
	_dock = get_authoring().dock
	EditorInterface.close_scene()
	var root := Node3D.new()
	EditorInterface.add_root_node(root)
	_city = CityForTests.make_city(20)
	_citizens = CityForTests.make_citizens(_city, 40)
	_citizens.rules = load(write("res://typed/weekday.pcg", CityForTests.WEEKDAY))
	for node: Node in [_city, _citizens]:
		root.add_child(node)
		node.owner = root
	await frames(2)
	_city.generate_now()
	await frames(2)
	_dock.population_tab.generate()
	await frames(2)


func after_each() -> void:
	EditorInterface.close_scene()
	await frames(2)
	while get_authoring().rules.get_current():
		get_authoring().rules.close_current()


func _filtered(text: String) -> Array[int]:
	var filter: LineEdit = _dock.population_tab.get_node("%Filter")
	filter.text = text
	_dock.population_tab.fill_list()
	var listed: Array[int] = _dock.population_tab.get_listed()
	filter.text = ""
	return listed


func test_people_are_listed_and_found_by_what_is_asked() -> void:
	var all: int = _dock.population_tab.count_persons()
	check(all >= 40, "they are drawn")
	check_equal(_filtered("").size(), all, "all are listed")
	var children: Array[int] = _filtered("age<18")
	check(not children.is_empty() and children.size() < all, "children: %d of %d" % [children.size(), all])
	check(children.all(func(person: int) -> bool: return int(_citizens.get_person(person)["age"]) < 18), "and nobody else")
	check_equal(_filtered("age<18").size() + _filtered("age>=18").size(), all, "young and old are all")
	check_equal(_filtered("school"), _filtered("age<18"), "children go to school, and nobody else does")
	check_equal(_filtered("household=0").size(), int(_dock.population_tab.describe(0)["household_type"].contains("children")) * 2 + 2, "one household")
	check_equal(_filtered("no such name").size(), 0, "nobody")


func test_drawn_shares_add_up_to_all_households() -> void:
	var drawn: Dictionary[int, int] = _dock.population_tab.count_drawn()
	var sum: int = drawn.values().reduce(func(total: int, count: int) -> int: return total + count, 0)
	check_equal(sum, _citizens.get_statistics()["households"], "each household counts once")
	var shares: Tree = _dock.population_tab.get_node("%Shares")
	check_equal(shares.get_root().get_child_count(), 3, "a row for each kind of household")
	check(shares.get_root().get_child(0).get_text(1).begins_with("40.0"), "the table's share: %s" % shares.get_root().get_child(0).get_text(1))


func test_a_person_is_inspected_down_to_the_line_of_a_rule() -> void:
	_dock.context.choose_person(_filtered("age<18")[0])
	var told: Label = _dock.person_tab.get_node("%Told")
	check(told.text.contains(_citizens.get_person(_dock.context.person)["name"]), "who: %s" % told.text)
	var entries: Array[Dictionary] = _dock.person_tab.get_entries()
	check(entries.size() >= 3, "the week: %s" % [entries])
	var to_school: int = entries.find_custom(func(entry: Dictionary) -> bool: return entry["kind"] == "goToBuilding")
	_dock.person_tab.open_rule(to_school)
	await frames(2)
	var edit: CodeEdit = get_authoring().rules.get_current()
	check(edit.get_line(edit.get_caret_line()).contains("goToBuilding"), "the line that wrote it: %s" % edit.get_line(edit.get_caret_line()))


func test_the_timeline_puts_entries_where_they_belong() -> void:
	_dock.context.choose_person(0)
	var week: Control = _dock.person_tab.get_node("%Week")
	week.size = Vector2(400, 200)
	var entry := {"start": 6.0 * 3600.0, "end": 30.0 * 3600.0, "days": PackedStringArray(["sun"])}
	var rects: Array[Rect2] = week.call("get_entry_rects", entry)
	check_equal(rects.size(), 2, "what runs past midnight stands on two days")
	check(rects[0].position.y > rects[1].position.y, "and after Sunday comes Monday")
	check_near(rects[0].size.x, 3.0 * rects[1].size.x, 0.5, "18 hours are thrice 6")


func test_the_simulation_runs_in_the_editor() -> void:
	_citizens.jump_to(0, EIGHT - 1800.0)
	_dock.simulation_tab.play_or_pause()
	check(_citizens.is_running() and not _citizens.paused, "it runs")
	var began: float = _citizens.time
	await frames(10)
	check(_citizens.time > began, "the clock goes")
	_dock.simulation_tab.play_or_pause()
	check(_citizens.paused, "and stands")


func test_a_survey_counts_who_is_outdoors_and_puts_the_clock_back() -> void:
	_citizens.jump_to(1, EIGHT)
	_dock.simulation_tab.start_survey()
	await _dock.simulation_tab.survey.ended
	var counts: Array = Array(_dock.simulation_tab.survey.counts)
	check_equal(counts.size(), 288, "a step each five minutes")
	check(counts.max() > 0 and counts[12] == 0, "some are outdoors by day, nobody at one in the night")
	check_equal([_citizens.day, _citizens.time], [1, EIGHT], "the clock is where it was")
	(_dock.simulation_tab.get_node("%Heat") as CheckBox).button_pressed = true
	check(_dock.simulation_tab.overlay.is_shown(), "the heat map lies on the ground")
	var cells: Dictionary = _dock.simulation_tab.survey.sum_cells(-1, -1)
	var parts := 0
	for group: int in 3:
		parts += _dock.simulation_tab.survey.sum_cells(-1, group).values().reduce(func(sum: int, n: int) -> int: return sum + n, 0)
	check_equal(parts, cells.values().reduce(func(sum: int, n: int) -> int: return sum + n, 0), "ages add up to all")
	check_equal(parts, counts.reduce(func(sum: int, n: int) -> int: return sum + n, 0), "and to the plot")


func test_ways_of_a_day_lie_on_the_map() -> void:
	_dock.context.choose_person(_filtered("school")[0])
	(_dock.person_tab.get_node("%Ways") as CheckBox).button_pressed = true
	var ways: Array[Dictionary] = _dock.person_tab.find_ways()
	check_equal(ways.size(), 2, "to school and back: %s" % [ways.map(func(way: Dictionary) -> float: return way["hour"])])
	check(_dock.person_tab.overlay.is_shown(), "they are drawn")
	check(ways[0]["points"].size() > 1, "along the streets")
	(_dock.person_tab.get_node("%Ways") as CheckBox).button_pressed = false
	check(not _dock.person_tab.overlay.is_shown(), "and gone")


func test_somebody_is_picked_in_the_viewport() -> void:
	_citizens.jump_to(0, EIGHT - 600.0)
	_citizens.start()
	_citizens.paused = true
	for minute: int in 60:
		if _citizens.get_persons_outside().is_empty():
			_citizens.advance(60.0)
	var person: int = _citizens.get_persons_outside()[0]
	var camera := Camera3D.new()
	EditorInterface.get_edited_scene_root().add_child(camera)
	var at: Vector3 = (_citizens.get_person(person)["position"] as Vector3) + Vector3(0.0, 0.9, 0.0)
	camera.look_at_from_position(at + Vector3(0.0, 5.0, 10.0), at)
	check(_dock.person_tab.pick(camera, camera.unproject_position(at)), "a click on a person")
	check_equal(_dock.context.person, person, "shows that person")
	check(not _dock.person_tab.pick(camera, Vector2(-5000.0, 0.0)), "a click on nobody shows nobody")


func test_people_who_live_take_over_new_rules_where_they_are() -> void:
	_citizens.jump_to(0, EIGHT)
	_citizens.start()
	_citizens.paused = true
	_citizens.advance(3600.0)
	get_authoring().rules.open("res://typed/weekday.pcg")
	get_authoring().rules.get_current().text = CityForTests.WEEKDAY.replace("8h, 16h", "8h, 12h")
	get_authoring().rules.save_current()
	(get_authoring().rules.get_node("%Regenerate") as Button).pressed.emit()
	await frames(2)
	check(_citizens.is_running(), "life goes on")
	check_equal([_citizens.day, _citizens.time], [0, EIGHT + 3600.0], "at the same time")
	var child: int = _filtered("school")[0]
	check(_citizens.get_agenda(child).any(func(entry: Dictionary) -> bool: return entry["end"] == 12.0 * 3600.0), "by the new rules: %s" % [_citizens.get_agenda(child)])


func test_a_city_that_is_made_anew_is_left_without_a_warning() -> void:
	_citizens.start()
	_dock.city_tab.throw_dice()
	while _city.is_generating():
		await get_tree().process_frame
	await frames(2)
	check(not _citizens.is_running(), "nobody lives there any more")
func test_an_entry_is_put_into_an_agenda_and_taken_back() -> void:
	_dock.context.choose_person(_filtered("age>=18")[0])
	var before: int = _dock.person_tab.get_entries().size()
	var dialog: Node = _dock.person_tab.get_node("%EntryDialog")
	var home: int = _citizens.get_person(_dock.context.person)["home"]
	dialog.call("fill", _dock.context, {"kind": "stayInside", "target": home, "start": 13.0 * 3600.0, "end": 14.5 * 3600.0})
	(dialog.get_node("%When") as OptionButton).select(1)
	_dock.person_tab.insert(dialog.call("make_task"))
	await frames(2)
	var inserted: Array = _dock.person_tab.get_entries().filter(func(entry: Dictionary) -> bool: return entry["start"] == 13.0 * 3600.0)
	check_equal(inserted.size(), 1, "it stands in the agenda")
	check_equal(inserted[0]["end"], 14.5 * 3600.0, "until half past two")
	await undo(_citizens)
	check_equal(_dock.person_tab.get_entries().size(), before, "and is gone again")
	check(_dock.person_tab.get_entries().all(func(entry: Dictionary) -> bool: return entry["start"] != 13.0 * 3600.0), "altogether")
	await redo(_citizens)
	check(_dock.person_tab.get_entries().any(func(entry: Dictionary) -> bool: return entry["start"] == 13.0 * 3600.0), "and back")
