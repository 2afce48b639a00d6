@tool
extends "res://tests/editor/editor_suite.gd"
## The dock's pages for people, their days and one person.

const CityForTests := preload("res://tests/godot/city_for_tests.gd")
const PCGDock := preload("res://addons/pcg/editor/pcg_dock.gd")
const PeopleFilter := preload("res://addons/pcg/editor/people/people_filter.gd")
const TaskColors := preload("res://addons/pcg/editor/person/task_colors.gd")
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
	var all: int = _dock.context.count_persons()
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
	var shares: Tree = await _show_shares()
	check_equal(shares.get_root().get_child_count(), 3, "a row for each kind of household")
	check(shares.get_root().get_child(0).get_text(1).begins_with("40.0"), "the table's share: %s" % shares.get_root().get_child(0).get_text(1))


func _show_shares() -> Tree:
	(_dock.get_parent() as EditorDock).make_visible()
	_dock.show_page(1)
	(_dock.population_tab.get_node("%Pages") as TabContainer).current_tab = 1
	await frames(2)
	return _dock.population_tab.get_node("%Shares")


func _texts(tree: Tree, column: int) -> Array:
	return tree.get_root().get_children().map(func(item: TreeItem) -> String: return item.get_text(column))


func test_shares_are_a_preview_until_people_are_drawn_by_them() -> void:
	var shares: Tree = await _show_shares()
	check_equal(shares.get_column_title(2), "Drawn", "of those who are there")
	var undo_redo: EditorUndoRedoManager = EditorInterface.get_editor_undo_redo()
	undo_redo.create_action("Set the seed", UndoRedo.MERGE_DISABLE, _citizens)
	undo_redo.add_do_property(_citizens, &"seed", 7)
	undo_redo.add_undo_property(_citizens, &"seed", _citizens.seed)
	undo_redo.commit_action()
	await frames(2)
	check_equal(shares.get_column_title(2), "Preview", "other settings draw others")
	var preview: Array = _texts(shares, 2)
	_dock.population_tab.generate()
	await frames(2)
	check_equal([shares.get_column_title(2), _texts(shares, 2)], ["Drawn", preview], "who are those of the preview")
	await undo(_citizens)
	await undo(_citizens)
	check_equal(shares.get_column_title(2), "Drawn", "undone: those who are there are drawn by the settings again")
	await undo(_citizens)
	check_equal(shares.get_column_title(2), "Preview", "nobody is there: what would be drawn")


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


func test_generating_people_is_one_step_to_undo() -> void:
	var names := func() -> Array: return range(_dock.context.count_persons()).map(func(person: int) -> String: return _citizens.get_person(person)["name"])
	var before: Array = names.call()
	_citizens.person_count = 20
	_citizens.rules = load(write("res://typed/late.pcg", "attr late = 1\n" + CityForTests.WEEKDAY))
	_citizens.attributes = {"late": 2.0}
	_dock.population_tab.generate()
	check(_dock.context.count_persons() < before.size(), "fewer people")
	var after: Array = names.call()
	await undo(_citizens)
	check_equal(names.call(), before, "the same people as before")
	check_equal([_citizens.person_count, _citizens.attributes], [40, {}], "with their settings")
	await undo(_citizens)
	check_equal(_dock.context.count_persons(), 0, "nobody")
	check_equal(_dock.population_tab.get_listed().size(), 0, "and nobody listed")
	await redo(_citizens)
	await redo(_citizens)
	check_equal(names.call(), after, "done again: the same people")
	check_equal([_citizens.person_count, _citizens.attributes], [20, {"late": 2.0}], "with theirs")


func test_the_page_of_a_person_tells_its_looks() -> void:
	_dock.context.choose_person(3)
	var looks: Dictionary = _citizens.get_looks(3)
	for part: String in ["hair", "skin", "clothes"]:
		var shown: ColorRect = _dock.person_tab.get_node("%" + part.capitalize())
		check(shown.color.is_equal_approx((looks[part + "_color"] as Color).linear_to_srgb()), part)


func test_the_week_tells_home_from_other_stays_by_its_colour() -> void:
	_citizens.jump_to(0, 3.0 * 3600.0)
	_citizens.start()
	_dock.context.choose_person(_filtered("school")[0])
	await frames(2)
	_citizens.jump_to(0, 12.0 * 3600.0)
	await frames(2)
	var lived: Array = _dock.person_tab.recorder.spans.map(func(span: Dictionary) -> String: return span["kind"])
	check_equal(lived.slice(-1), ["inside"], "at school at noon: %s" % [lived])
	_citizens.jump_to(0, 23.0 * 3600.0)
	await frames(2)
	check_equal(_dock.person_tab.recorder.spans[-1]["kind"], "home", "at home in the evening")
	check(TaskColors.of("home") != TaskColors.of("inside"), "in two colours")
	var home: int = _citizens.get_person(_dock.context.person)["home"]
	var stay := {"kind": "stayInside", "target": home}
	check(TaskColors.of_entry(stay, home) != TaskColors.of_entry(stay, home + 1), "and so is what is planned")


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
	check(not _citizens.record_lives, "and nothing is recorded any more")
	check_equal(_dock.simulation_tab.survey.trips, _citizens.get_statistics()["trips"], "its ways are known, so that the page does not count them")
	check(_dock.simulation_tab.survey.trips > 0, "there are some")
	var day: PackedByteArray = _citizens.get_heat_image().get_data()
	_citizens.advance(4.0 * 3600.0)
	check_equal(_citizens.get_heat_image().get_data(), day, "what is lived after the survey does not change its picture")
	for hour: int in 24:
		var is_anybody_outdoors: bool = counts.slice(12 * hour, 12 * hour + 11).max() > 0 # the twelfth is the next hour's
		var is_drawn: bool = _citizens.get_heat_image("", hour).get_used_rect().has_area()
		check(is_drawn or not is_anybody_outdoors, "whoever the plot counts between %d and %d h is on the map of that hour" % [hour, hour + 1])
	check(not _citizens.get_heat_image("", 1).get_used_rect().has_area(), "nobody at one in the night")
	_citizens.stop()
	await frames(2)
	check(not _dock.simulation_tab.overlay.is_shown(), "without a record there is no map")


func test_ways_of_a_day_lie_on_the_map() -> void:
	_dock.context.choose_person(_filtered("school")[0])
	(_dock.person_tab.get_node("%Ways") as CheckBox).button_pressed = true
	var ways: Array[Dictionary] = _dock.person_tab.find_ways()
	check_equal(ways.size(), 2, "to school and back: %s" % [ways.map(func(way: Dictionary) -> float: return way["hour"])])
	check(_dock.person_tab.overlay.is_shown(), "they are drawn")
	check(ways[0]["points"].size() > 1, "along the streets")
	(_dock.person_tab.get_node("%Ways") as CheckBox).button_pressed = false
	check(not _dock.person_tab.overlay.is_shown(), "and gone")


func test_the_way_to_the_park_is_drawn_once_somebody_is_there() -> void:
	var old: int = _filtered("age>=65")[0]
	_dock.context.choose_person(old)
	(_dock.person_tab.get_node("%Ways") as CheckBox).button_pressed = true
	check(_dock.person_tab.find_ways().is_empty(), "where the rules lead to is not known before")
	_citizens.jump_to(0, 9.99 * 3600.0)
	_citizens.start()
	for minute: int in 80:
		_citizens.advance(60.0)
		await frames(1)
	var ways: Array[Dictionary] = _dock.person_tab.find_ways()
	check(ways.size() > 0, "to the park")
	check(_dock.person_tab.overlay.is_shown(), "they are drawn: %d" % ways.size())
	var home: Vector3 = _city.get_building(_citizens.get_person(old)["home"])["position"]
	check(not ways.is_empty() and home.distance_to(ways[0]["points"][0]) < 1.0, "from home")
	(_dock.person_tab.get_node("%Ways") as CheckBox).button_pressed = false


func test_somebody_is_picked_in_the_viewport() -> void:
	_citizens.jump_to(0, EIGHT - 600.0)
	_citizens.start()
	_citizens.paused = true
	for minute: int in 60:
		if _citizens.get_persons_outside().is_empty():
			_citizens.advance(60.0)
	var person: int = _citizens.get_persons_outside()[0]
	var view: PCGAgentView = _citizens.get_agent_view()
	var at: Vector3 = view.global_transform * view.get_shown_position(person) + Vector3(0.0, 0.85, 0.0)
	var camera: Camera3D = EditorInterface.get_editor_viewport_3d(0).get_camera_3d()
	camera.look_at_from_position(at + Vector3(0.0, 60.0, 80.0), at + Vector3(0.0, 60.0, 160.0))
	await frames(2)
	check_equal(view.get_level(person), "data", "whoever is behind the editor's camera is not drawn")
	camera.look_at_from_position(at + Vector3(0.0, 60.0, 80.0), at)
	await frames(2)
	check_equal(view.get_level(person), "figure", "whoever is before it is, though the clock stands")
	camera.look_at_from_position(at + Vector3(0.0, 2.0, 4.0), at)
	await frames(2)
	check_equal(view.get_level(person), "agent", "and nearby by a scene")
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
	var child: int = _filtered("school")[0]
	var starts := [0]
	_citizens.simulation_started.connect(func() -> void: starts[0] += 1)
	check(not _leaves_at_noon(child), "today is lived by the old rules")
	_citizens.advance(16.0 * 3600.0)
	check(_leaves_at_noon(child), "tomorrow by those that were saved: %s" % [_citizens.get_agenda(child)])
	get_authoring().rules.get_current().text = CityForTests.WEEKDAY
	get_authoring().rules.save_current()
	(get_authoring().rules.get_node("%Regenerate") as Button).pressed.emit()
	await frames(2)
	check_equal([_citizens.day, _citizens.time], [1, 3600.0], "at the same time")
	check(not _leaves_at_noon(child), "at once, if that is wanted")
	check(_citizens.is_running() and starts[0] == 0, "life goes on")


func _leaves_at_noon(person: int) -> bool:
	return _citizens.get_agenda(person).any(func(entry: Dictionary) -> bool: return entry["end"] == 12.0 * 3600.0)


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
	_dock.person_tab.insert(dialog.call("make_task"))
	await frames(2)
	var inserted: Array = _dock.person_tab.get_entries().filter(func(entry: Dictionary) -> bool: return entry["start"] == 13.0 * 3600.0)
	check_equal(inserted.size(), 1, "it stands in the agenda")
	check_equal(inserted[0]["end"], 14.5 * 3600.0, "until half past two")
	check_equal(inserted[0]["days"], PackedStringArray(["mon"]), "on the day that the clock shows")
	await undo(_citizens)
	check_equal(_dock.person_tab.get_entries().size(), before, "and is gone again")
	check(_dock.person_tab.get_entries().all(func(entry: Dictionary) -> bool: return entry["start"] != 13.0 * 3600.0), "altogether")
	await redo(_citizens)
	check(_dock.person_tab.get_entries().any(func(entry: Dictionary) -> bool: return entry["start"] == 13.0 * 3600.0), "and back")
