extends "res://tests/godot/living_suite.gd"
## People in a city: they leave, walk, arrive; the clock jumps; what is missing is named.

const ERRANDS := """attr leaves = 8h
const fixed = 1
@StartRule
Household --> members { true: goToBuilding(leaves, leaves + 1h, findBuilding("workplace")) }
"""


func test_persons_have_homes_names_and_agendas() -> void:
	check(_citizens.generate_population(), "there are people: %s" % [_citizens.get_diagnostics()])
	var made: Dictionary = _citizens.get_statistics()
	check(made["persons"] >= 60 and made["households"] > 10, "as many as wanted: %s" % [made])
	var person: Dictionary = _citizens.get_person(0)
	check(person["home"] >= 0 and not str(person["name"]).is_empty(), "the first one: %s" % [person])
	var agenda: Array[Dictionary] = _citizens.get_agenda(0)
	check(not agenda.is_empty(), "has an agenda")
	check_equal(agenda[0]["file"], "rules.pcg", "that says where it comes from")


func test_agents_are_spawned_when_people_leave_and_freed_when_they_arrive() -> void:
	_citizens.check_promises = true
	var counts := {"spawned": 0, "freed": 0, "left": 0, "entered": 0, "tasks": 0}
	_citizens.agent_spawned.connect(func(_person: int) -> void: counts["spawned"] += 1)
	_citizens.agent_freed.connect(func(_person: int) -> void: counts["freed"] += 1)
	_citizens.person_left_building.connect(func(_person: int, _building: int) -> void: counts["left"] += 1)
	_citizens.person_entered_building.connect(func(_person: int, _building: int) -> void: counts["entered"] += 1)
	_citizens.task_started.connect(func(_person: int, _kind: String) -> void: counts["tasks"] += 1)
	_citizens.jump_to(0, 5 * HOUR)
	_begin()
	var view: PCGAgentView = _citizens.get_agent_view()
	var peak := 0
	for minute: int in 15 * 60:
		_citizens.advance(60.0)
		peak = maxi(peak, view.get_agent_count())
		if minute % 60 == 0:
			await get_tree().process_frame
	check(peak > 0, "there was somebody outdoors")
	check(counts["spawned"] > 0 and counts["left"] > 0 and counts["tasks"] > 0, "signals came: %s" % [counts])
	check_equal(counts["spawned"] - counts["freed"], view.get_agent_count(), "bodies are those who have not arrived yet")
	check_equal(_citizens.get_persons_outside().size(), view.get_agent_count(), "everybody outdoors has a body, nobody else")
	for count: int in _citizens.get_broken_promises().values():
		check_equal(count, 0, "a promise: %s" % [_citizens.get_broken_promise_examples()])


func test_an_agent_is_where_its_person_is() -> void:
	_citizens.jump_to(0, 7.5 * HOUR)
	_begin()
	var view: PCGAgentView = _citizens.get_agent_view()
	for minute: int in 60:
		_citizens.advance(30.0)
		for person: int in _citizens.get_persons_outside():
			var place: Vector3 = _citizens.get_person(person)["position"]
			check(view.has_agent(person), "a body")
			check_near(view.get_agent_position(person).distance_to(place), 0.0, 0.05, "at the person's place")


func test_the_clock_runs_by_itself_unless_it_is_paused() -> void:
	_begin()
	_citizens.time_scale = 600.0
	var before: float = _citizens.time
	await get_tree().process_frame
	await get_tree().process_frame
	check_equal(_citizens.time, before, "paused")
	_citizens.paused = false
	for frame: int in 10:
		await get_tree().process_frame
	check(_citizens.time > before, "running")


func test_time_jumps_forwards_and_backwards_give_the_same_world() -> void:
	_begin()
	var jumps: Array[bool] = [false]
	_citizens.time_jumped.connect(func() -> void: jumps[0] = true)
	_citizens.jump_to(0, 12 * HOUR)
	check(jumps[0], "it is told")
	check_equal(_citizens.get_clock_text(), "12:00", "the clock")
	var noon: Array = _where_everybody_is()
	_citizens.jump_to(1, 3 * HOUR)
	check_equal(_citizens.day, 1, "the next day")
	_citizens.jump_to(0, 12 * HOUR)
	check_equal(_where_everybody_is(), noon, "noon is noon")


func _where_everybody_is() -> Array:
	return range(_citizens.get_statistics()["persons"]).map(func(id: int) -> Array:
		var person: Dictionary = _citizens.get_person(id)
		return [person["state"], person["place"]])


func test_a_clock_shows_whole_minutes() -> void:
	check_equal(CitizenManager.format_clock(28700.0), "07:58", "rounded down")
	check_equal(CitizenManager.format_clock(25 * HOUR + 600.0), "25:10", "past midnight")
	check_equal(_citizens.count_persons(), 0, "nobody yet")
	_begin()
	check_equal(_citizens.count_persons(), int(_citizens.get_statistics()["persons"]), "everybody")


func test_a_new_day_is_told() -> void:
	var days: Array[int] = []
	_citizens.day_started.connect(func(day: int) -> void: days.append(day))
	_begin(23.0)
	_citizens.advance(26 * HOUR)
	check_equal(days, [1, 2] as Array[int], "Tuesday and Wednesday")


func test_a_recorded_day_can_be_told_and_written() -> void:
	_citizens.record_lives = true
	_begin()
	_citizens.advance(24 * HOUR)
	var household: int = _citizens.choose_household()
	check(household >= 0, "there is somebody to tell of")
	check(_citizens.tell_day(household, 0).size() > 1, "in several lines")
	for path: String in ["user://heat_of_tests.png", "user://lives_of_tests.csv"]:
		var error: Error = _citizens.save_heat_map(path) if path.ends_with("png") else _citizens.save_lives(path)
		check_equal(error, OK, path)
		check(FileAccess.file_exists(path), "%s is there" % path)
		DirAccess.remove_absolute(path)
	check(Image.new() != null, "pictures can be read")


func test_a_file_that_cannot_be_written_is_one_error_and_leaves_nothing() -> void:
	expect_message("heat.png")
	_citizens.record_lives = true
	_begin()
	_citizens.advance(HOUR)
	check(_citizens.save_heat_map("/proc/nowhere/heat.png") != OK, "it says no")


func test_what_is_missing_is_named_in_one_message() -> void:
	expect_message("CitizenManager has no rules")
	_citizens.rules = null
	check(not _citizens.generate_population(), "no rules")
	expect_message("CitizenManager has no household table")
	_citizens.rules = CityForTests.make_rules(CityForTests.WEEKDAY, PCGRuleSet.DIALECT_AGENDA)
	_citizens.household_table = null
	check(not _citizens.generate_population(), "no households")
	expect_message("Call generate_population() before start()")
	check(not _citizens.start(), "nobody to start with")


func _first_start(person: int = 0) -> float:
	return _citizens.get_agenda(person)[0]["start"]


func test_attributes_of_the_rules_are_set_kept_and_checked() -> void:
	_citizens.rules = CityForTests.make_rules(ERRANDS, PCGRuleSet.DIALECT_AGENDA)
	_citizens.attributes = {"leaves": 10 * HOUR}
	_begin()
	check_equal(_first_start(), 10 * HOUR, "as set")
	var saved: PackedByteArray = _citizens.save_state()
	_citizens.attributes = {}
	check(_citizens.load_state(saved), "a life that was saved with it")
	var people := PCGPopulation.new()
	people.source = "household,person,home,age,gender,speed\n7,1,%d,35,w,1.3\n" % CityForTests.roomiest_home(_citizens)
	check_equal(_first_start(_citizens.add_people(people)[0]), 10 * HOUR, "holds there, also for who comes later")
	check(_citizens.generate_population(), "new agendas")
	check_equal(_first_start(), 8 * HOUR, "take what is set now")
	for wrong: Array in [["leavs", 1.0, "'leavs' is no attribute of the rules"], ["fixed", 2.0, "'fixed' is const"], ["leaves", "soon", "'leaves' is a number in the rules, not text"],
			["leaves", NAN, "which rules cannot reckon with"]]:
		_citizens.attributes = {wrong[0]: wrong[1]}
		expect_message(wrong[2])
		check(not _citizens.generate_population(), "refused: %s" % [wrong])


func test_people_who_were_put_into_a_full_home_live_there_with_a_warning() -> void:
	check(_citizens.generate_population(), "people by chance")
	var home: int = _citizens.get_person(0)["home"]
	var people := PCGPopulation.new()
	people.source = "household,person,home,age,gender,speed,family_name\n" + "".join(range(9).map(func(i: int) -> String: return "1,%d,%d,30,w,1,Nagy\n" % [i, home]))
	_citizens.population = people
	expect_message("9 persons live in building %d, which takes 4" % home)
	check(_citizens.generate_population(), "they live")
	check_equal(_citizens.get_statistics()["persons"], 9, "all of them")
	check(str(_citizens.get_person(8)["name"]).ends_with(" Nagy"), "under their name")


func test_a_bad_population_is_told_before_anybody_uses_it() -> void:
	var people := PCGPopulation.new()
	people.source = "household,person,home,age,gender,speed\n1,1,0,x,w,1\n1,2,0,30,q,1\n"
	check(people.has_errors(), "it has errors")
	check_equal(people.get_diagnostics().map(func(told: Dictionary) -> int: return told["line"]), [2, 3], "one for each bad row")
	_citizens.population = people
	expect_message("'x' is not a value for 'age'")
	check(not _citizens.generate_population(), "nobody lives")
	people.source = "household,person,home,age,gender,speed\n1,1,9999,40,w,1\n"
	check(not people.has_errors(), "which homes there are the city knows")


func test_a_city_without_homes_is_refused() -> void:
	expect_message("home")
	_city.lot_types = [CityForTests.make_type("workplace", 1, CityForTests.WORKPLACE)]
	check(_city.generate_now(), "a city of workplaces")
	check(not _citizens.generate_population(), "nobody can live there")


func test_life_ends_with_the_city_and_begins_again_in_a_new_one() -> void:
	_begin()
	_citizens.advance(9 * HOUR)
	var stops: Array[int] = [0]
	_citizens.simulation_stopped.connect(func() -> void: stops[0] += 1)
	expect_message("its city was cleared, freed or generated anew")
	_city.seed = 5
	_city.generate_now()
	check(not _citizens.is_running(), "the old life is over")
	check_equal(stops[0], 1, "which is told once")
	check_equal(_citizens.get_agent_view().get_agent_count(), 0, "no bodies are left")
	expect_message("nobody in this city yet. Call generate_population()")
	check(not _citizens.start(), "nobody lives in the new city yet")
	_begin()
	_citizens.advance(HOUR)
	check(_citizens.is_running(), "and a new life begins")
	_citizens.stop()
	_city.clear()
	check_equal(stops[0], 2, "whoever stopped before has nothing to be told")


func test_life_ends_when_a_listener_clears_the_city() -> void:
	expect_message("its city was cleared, freed or generated anew")
	_citizens.person_left_building.connect(func(_person: int, _building: int) -> void: _city.clear())
	_begin()
	_citizens.advance(12 * HOUR)
	check(not _citizens.is_running(), "in the middle of a step")


func test_life_ends_when_the_city_is_freed() -> void:
	expect_message("its city was cleared, freed or generated anew")
	_begin()
	_city.free()
	await get_tree().process_frame
	await get_tree().process_frame
	check(not _citizens.is_running(), "it has ended")


func test_with_auto_start_life_goes_on_in_the_new_city_without_a_word() -> void:
	_citizens.queue_free()
	_citizens = CityForTests.make_citizens(_city)
	_citizens.auto_start = true
	add_child(_citizens)
	check(_citizens.is_running(), "it runs as soon as it is there")
	_city.generate()
	check_equal(await _city.city_generated, true, "a new city")
	check(_citizens.is_running(), "it runs again")


func test_auto_start_without_a_city_says_so() -> void:
	expect_message("auto_start waits for a city, and there is none")
	var citizens := CitizenManager.new()
	citizens.auto_start = true
	add_child(citizens)
	check(not citizens.is_running(), "nothing runs")


func test_an_unknown_start_rule_is_one_error() -> void:
	expect_message("the rules have no rule 'Houshold' without parameters to start with")
	_citizens.start_rule = "Houshold"
	check(not _citizens.generate_population(), "it says no")
	var told: Array[Dictionary] = _citizens.get_diagnostics()
	check_equal(told.size(), 1, "with one diagnostic")
	check_equal(told[0]["hint"], "did you mean 'Household'?", "that says what to do")
	check_equal(told[0]["file"], "rules.pcg", "and where")


func test_what_the_city_lacks_is_told_once_with_the_rule_that_asks() -> void:
	_city.lot_types = [CityForTests.make_type("house", 60, CityForTests.HOUSE), CityForTests.make_type("workplace", 40, CityForTests.WORKPLACE)]
	_city.generate_now()
	expect_message("the city has no building of type 'school'")
	_begin()
	expect_message("rules.pcg:11:10: warning: the city has no zone of type 'park'") # after the engine's own WARNING:
	_citizens.advance(24 * HOUR)
	_citizens.advance(24 * HOUR)
	var missing: Array = _citizens.get_diagnostics().filter(func(one: Dictionary) -> bool: return one["id"] == "unknown-type")
	check_equal(missing.size(), 2, "each once: %s" % [missing])
	check_equal(missing[1]["hint"], "add lots whose rules make one: zone(\"park\")", "what to do")
