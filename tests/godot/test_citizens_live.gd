extends "res://tests/godot/living_suite.gd"
## What a game does to people while they live: entries, quests, newcomers; and scripts that do it at the wrong moment.

## Rules that call the game in the middle of a step.
const CALLING := """@StartRule
Household --> members { true: delayedRule(9h + rand(0, 1h), 11h, Call) }
Call --> wait(60) case testCall(): wait(60) else: wait(30)
"""
## One adult leads the children to school.
const LED := """@StartRule
Household -->
	members { true: stayInside(0h, 24h, home) }
	members { age < 18: goToBuilding(8h, 10h, findNearestBuilding("school", home)) }
	case count(age < 18) > 0: members { chooseMember(age >= 18): accompany(8h + 1, age < 18) }
"""


func _leaves_school_at_noon(child: int) -> bool:
	return _citizens.get_agenda(child).any(func(entry: Dictionary) -> bool: return entry["end"] == 12.0 * HOUR)


func test_people_take_over_new_rules_between_two_days_without_a_new_beginning() -> void:
	_begin(12.0)
	var child: int = _citizens.find_persons(func(person: Dictionary) -> bool: return person["age"] < 18)[0]
	var restarts := [0]
	_citizens.simulation_started.connect(func() -> void: restarts[0] += 1)
	var renewals: Array[String] = []
	_citizens.agendas_renewed.connect(func() -> void: renewals.append(_citizens.get_clock_text()))
	_citizens.rules.source = CityForTests.WEEKDAY.replace("8h, 16h", "8h, 12h")
	check(_citizens.renew_agendas(), "they shall take over other rules")
	_citizens.advance(11.9 * HOUR)
	check(not _leaves_school_at_noon(child), "but not today")
	_citizens.advance(HOUR)
	check(_leaves_school_at_noon(child), "from the next day on")
	check_equal(renewals, ["00:00"] as Array[String], "once")
	_citizens.advance(11.6 * HOUR)
	check_equal(_citizens.get_person(child)["place"]["id"], _citizens.get_person(child)["home"], "who is home by half past twelve, or on the way")
	_citizens.rules.source = "@StartRule\nHousehold --> nonsense(\n"
	expect_message("nonsense")
	check(not _citizens.renew_agendas(), "rules with errors are not taken over")
	check(_leaves_school_at_noon(child), "all stays")
	_citizens.rules.source = CityForTests.WEEKDAY
	check(_citizens.renew_agendas(true), "at once")
	check(not _leaves_school_at_noon(child), "the old rules again")
	_citizens.advance(24.0 * HOUR)
	check_equal(restarts[0], 0, "life was not begun anew")
	check_equal(_citizens.get_broken_promises().values().max(), 0, "no promise is broken: %s" % [_citizens.get_broken_promise_examples()])


func test_persons_are_found_by_what_they_are_and_do() -> void:
	_begin(12.0)
	var inside: PackedInt32Array = _citizens.find_persons(func(person: Dictionary) -> bool: return person["state"] == "inside")
	check_equal(inside.size() + _citizens.get_persons_outside().size(), int(_citizens.get_statistics()["persons"]), "inside or outside")
	expect_message("has to give true or false")
	check(_citizens.find_persons(func(_person: Dictionary) -> int: return 1).is_empty(), "not with a number")


func test_an_entry_for_one_day_is_seen_lived_and_saved() -> void:
	_begin(9.0)
	var person: int = _somebody(func(one: Dictionary) -> bool: return one["state"] == "inside" and one["age"] >= 65)
	var home: int = _citizens.get_person(person)["home"]
	var usual: Array[Dictionary] = _citizens.get_agenda(person)
	var school: int = _school()
	var task := {"kind": "goToBuilding", "start": 9 * HOUR, "end": 10 * HOUR, "target": school, "day": 0}
	check(_citizens.insert_task(person, task), "it is inserted")
	check_equal(_citizens.get_agenda(person), usual, "the week is as it was")
	var today: Array = _citizens.get_agenda(person, 0).filter(func(one: Dictionary) -> bool: return one["start"] == 9 * HOUR)
	check_equal(today.size(), 1, "today it is there")
	check_equal(today[0]["target"], school, "with its goal")
	check_equal(_citizens.get_agenda(person, 7).size(), _citizens.get_agenda(person, 14).size(), "other Mondays are alike")
	check_equal(_citizens.get_person(person)["place"]["id"], school, "it sets out at once")
	var saved: PackedByteArray = _citizens.save_state()
	_citizens.advance(30 * 60.0)
	check(_citizens.get_persons_inside(school).has(person), "and arrives")
	check(_citizens.load_state(saved), "the state before")
	check_equal(_citizens.get_agenda(person, 0).filter(func(one: Dictionary) -> bool: return one["start"] == 9 * HOUR).size(), 1, "it is saved")
	_citizens.advance(90 * 60.0)
	check(not _citizens.get_persons_inside(school).has(person), "it is over")
	check(home >= 0, "there is a home")
	_check_promises()


func test_what_required_a_lost_entry_is_dropped_and_told() -> void:
	_citizens.rules = CityForTests.make_rules(SCHOOL_RUN, PCGRuleSet.DIALECT_AGENDA)
	_begin(6.0)
	var told: Array[Array] = []
	_citizens.task_dropped.connect(func(person: int, task: Dictionary, reason: String, required: String) -> void:
		told.append([person, task["kind"], task["day"], reason, required]))
	var adult: int = _adult_with_child()
	var household: int = _citizens.get_person(adult)["household"]
	var before: int = _citizens.get_agenda(adult, 1).size()
	for child: int in _citizens.find_persons(func(one: Dictionary) -> bool: return one["household"] == household and one["age"] < 18):
		var ill := {"kind": "stayInside", "start": 0, "end": 24 * HOUR, "target": _citizens.get_person(child)["home"], "day": 1}
		check(_citizens.insert_task(child, ill), "a child is ill on Tuesday")
	check(told.has([adult, "delayedRule", 1, "lost", "school"]), "nobody goes to the park: %s" % [told])
	check_equal(_citizens.get_agenda(adult, 1).size(), before - 1, "on that Tuesday")
	check_equal(_citizens.get_agenda(adult, 8).size(), before, "only")


func test_children_whose_leader_is_called_away_go_alone_and_that_is_told() -> void:
	_citizens.rules = CityForTests.make_rules(LED, PCGRuleSet.DIALECT_AGENDA)
	_begin(6.0)
	var told: Array[Array] = []
	_citizens.task_dropped.connect(func(person: int, task: Dictionary, reason: String, _required: String) -> void:
		told.append([person, task["kind"], task.get("day"), reason]))
	var child: int = _somebody(func(one: Dictionary) -> bool: return one["age"] < 18)
	var walk: Dictionary = _citizens.get_agenda(child, 1).filter(func(task: Dictionary) -> bool: return task["kind"] == "accompany")[0]
	var adult: int = walk["leader"]
	check(walk["joiners"].has(child), "they walk together")
	var away := {"kind": "stayInside", "start": 7 * HOUR, "end": 11 * HOUR, "target": _citizens.get_person(adult)["home"], "day": 1}
	check(_citizens.insert_task(adult, away), "the adult stays at home on Tuesday")
	check(told.has([child, "accompany", 1, "leaderless"]), "told: %s" % [told])
	var at_eight := func(day: int) -> Dictionary: return _citizens.get_agenda(child, day).filter(
			func(task: Dictionary) -> bool: return task["start"] == 8 * HOUR)[0]
	var alone: Dictionary = at_eight.call(1)
	check_equal(alone["kind"], "goToBuilding", "alone on Tuesday")
	check_equal(at_eight.call(8)["kind"], "accompany", "and never again")
	_citizens.advance(27.5 * HOUR)
	check_equal(_citizens.get_person(child)["place"]["id"], alone["target"], "and gets there")
	_check_promises()


func test_entries_that_cannot_be_are_refused_with_what_is_wrong() -> void:
	_begin(9.0)
	var good := {"kind": "goToBuilding", "start": 10 * HOUR, "end": 11 * HOUR, "target": 0}
	var wrong := {
		"there is no key 'strat'; did you mean 'start'?": {"strat": 5},
		"there is no kind 'goToBulding'; did you mean 'goToBuilding'?": {"kind": "goToBulding"},
		"`start` and `end` have to be seconds": {"end": "noon"},
		"it has to end after it starts": {"end": 9 * HOUR},
		"is no building of the city": {"target": 100000},
		"there is no day 'monday'": {"days": ["monday"]},
		"`day` has to be a whole number": {"day": 0.5},
		"the time of the task is over": {"day": -3},
		"there is no 'Prak'; did you mean 'Park'?": {"kind": "delayedRule", "delayed_rule": "Prak"},
		"walks together are made by rules only": {"kind": "accompany"},
		"`start` has to be within a week": {"start": NAN},
	}
	for message: String in wrong:
		expect_message(message)
		check(not _citizens.insert_task(0, good.merged(wrong[message], true)), message)
	check(_citizens.insert_task(0, good), "the good one")
	expect_message("there is no such person")
	check(not _citizens.insert_task(-1, good), "nobody")


func test_the_game_takes_somebody_over_and_gives_it_back() -> void:
	_begin(9.0)
	check(_citizens.take_over(3), "the game has it")
	check(not _citizens.take_over(3), "once")
	check_equal(_citizens.get_person(3)["presence"], "taken", "it is told")
	check(not _citizens.get_agent_view().has_agent(3), "the game shows it")
	var there: Vector3 = _citizens.get_person(3)["position"] + Vector3(2, 0, 1)
	check(_citizens.place_taken(3, there), "the game moves it")
	check_near(there.distance_to(_citizens.get_person(3)["position"]), 0.0, 0.01, "there it is")
	_citizens.advance(HOUR)
	check_near(there.distance_to(_citizens.get_person(3)["position"]), 0.0, 0.01, "it stays there")
	check(_citizens.release(3), "given back")
	check(not _citizens.release(3), "once")
	check(not _citizens.place_taken(3, there), "and the game's no more")
	_citizens.advance(3 * HOUR)
	check_equal(_citizens.get_person(3)["presence"], "living", "it lives on")
	expect_message("place_taken() takes a finite position")
	check(not _citizens.place_taken(3, Vector3(NAN, 0, 0)), "not nowhere")
	_check_promises()


func test_who_is_given_back_where_nobody_can_walk_finds_its_way() -> void:
	_begin(10.0)
	for off: Vector3 in [Vector3(0, 5, 0), Vector3(0, -3, 0), Vector3(6, 0, 6), Vector3(-7, 2, -7)]:
		_citizens.jump_to(0, 10 * HOUR)
		var at: Vector3 = _citizens.get_person(3)["position"] + off
		check(_citizens.take_over(3), "the game has it")
		check(_citizens.place_taken(3, at), "and puts it elsewhere")
		check(_citizens.release(3), "gives it back")
		check_equal(_citizens.get_person(3)["state"], "walking", "it sets out")
		check_near(_citizens.get_person(3)["position"].distance_to(at), 0.0, 0.001, "from where it is")
		for i: int in 60:
			_citizens.advance(30.0)
		check_equal(_citizens.get_person(3)["state"], "inside", "it is where it should be")
	_check_promises()


func test_people_come_and_go() -> void:
	_begin(9.0)
	var before: int = _citizens.get_statistics()["persons"]
	var home: int = CityForTests.roomiest_home(_citizens)
	var people := PCGPopulation.new()
	people.source = "household,person,home,age,gender,speed,first_name\n7,1,%d,35,w,1.3,\n7,2,%d,8,m,1.1,\n" % [home, home]
	check_equal(_citizens.add_people(people), PackedInt32Array([before, before + 1]), "two come")
	check_equal(_citizens.get_person(before)["home"], home, "with a home")
	check(not _citizens.get_agenda(before + 1).is_empty(), "and things to do")
	_citizens.advance(24 * HOUR)
	check(_citizens.remove_person(before), "one goes")
	check(not _citizens.remove_person(before), "once")
	check_equal(_citizens.get_person(before)["presence"], "removed", "for good")
	expect_message("the city has no building 9999")
	people.source = "household,person,home,age,gender,speed\n7,1,9999,35,w,1.3\n"
	check(_citizens.add_people(people).is_empty(), "nobody without a home")
	_citizens.advance(24 * HOUR)
	_check_promises()


func test_monitors_stand_in_the_debugger_while_the_node_is_in_the_tree() -> void:
	_begin(8.0)
	_citizens.advance(60.0)
	check_equal(Performance.get_custom_monitor("%s/outside" % _citizens.name), float(_citizens.get_persons_outside().size()), "the same number")
	check(_citizens.get_monitor("milliseconds_per_frame") > 0.0, "it took time")
	expect_message("there is no monitor 'fps'")
	check_equal(_citizens.get_monitor("fps"), 0.0, "not this one")
	var id := "%s/agents" % _citizens.name
	remove_child(_citizens)
	check(not Performance.has_custom_monitor(id), "they go with it")
	add_child(_citizens)
	check(Performance.has_custom_monitor(id), "and come back")


func test_what_rules_call_may_look_but_not_change_anything() -> void:
	var seen: Array[int] = [0]
	var call := func(_person: int) -> bool:
		seen[0] += 1
		if seen[0] == 1:
			_citizens.get_person(0)
			_citizens.stop()
			_citizens.advance(1.0)
			_citizens.jump_to(0, 0)
			_citizens.start()
			_citizens.save_state()
			_citizens.load_state(PackedByteArray())
			_citizens.insert_task(0, {})
			_citizens.take_over(0)
			_citizens.remove_person(0)
			_citizens.generate_population()
			_city.clear()
		return true
	check(PCGRuleSet.add_function("testCall", {}, TYPE_BOOL, call), "the rules may call it")
	_citizens.rules = CityForTests.make_rules(CALLING, PCGRuleSet.DIALECT_AGENDA)
	_begin(9.0)
	for method: String in ["stop", "advance", "jump_to", "start", "save_state", "load_state", "insert_task", "take_over", "remove_person", "generate_population"]:
		expect_message("%s() was called by a function or an operation of the rules" % method)
	expect_message("its city was cleared, freed or generated anew")
	_citizens.advance(2 * HOUR)
	check(seen[0] > 5, "it was called")
	await get_tree().process_frame
	await get_tree().process_frame
	check(not _citizens.is_running(), "the city went, and life ended after the step")


func test_freeing_the_node_in_the_middle_of_a_step_or_a_signal_does_not_crash() -> void:
	var call := func(_person: int) -> bool:
		if is_instance_valid(_citizens):
			_citizens.queue_free()
		return true
	check(PCGRuleSet.add_function("testCall", {}, TYPE_BOOL, call), "the rules may call it")
	_citizens.rules = CityForTests.make_rules(CALLING, PCGRuleSet.DIALECT_AGENDA)
	_begin(9.0)
	_citizens.time_scale = 3600.0
	_citizens.paused = false
	for frame: int in 600:
		if not is_instance_valid(_citizens):
			break
		_citizens.advance(60.0)
		await get_tree().process_frame
	check(not is_instance_valid(_citizens), "a rule's script has freed it")
	_make_citizens()
	_begin(7.0)
	_citizens.person_left_building.connect(func(_person: int, _building: int) -> void: _citizens.queue_free())
	_citizens.advance(HOUR)
	await get_tree().process_frame
	await get_tree().process_frame
	check(not is_instance_valid(_citizens), "a listener has freed it")
	_make_citizens()
	_begin(7.0)
	_citizens.simulation_stopped.connect(_citizens.queue_free)
	_citizens.stop()
	check(_citizens.start(), "it is only queued")
	await get_tree().process_frame


func test_days_out_of_range_are_refused() -> void:
	_begin(8.0)
	expect_message("days are -1000000 to 1000000")
	for day: int in [1000001, -1000001, 4294967296]:
		_citizens.jump_to(day, 12.0 * HOUR)
	_citizens.day = 9223372036854775807
	check_equal(_citizens.day, 0, "the day is as it was")
	check_equal(_citizens.get_clock_text(), "08:00", "and the time")
	_citizens.paused = false
	_citizens.jump_to(-1000000, 8.0 * HOUR)
	check_equal(_citizens.day, -1000000, "the first one")
	_citizens.jump_to(1000000, 23.5 * HOUR)
	_citizens.advance(HOUR)
	check_equal(_citizens.day, 1000001, "past the last one")
	check(not _citizens.paused, "the clock runs")
	expect_message("the clock has passed day 1000000")
	_citizens.advance(1.0)
	check(_citizens.paused, "no further")
	check_equal(_citizens.get_clock_text(), "00:30", "it stands")
	_citizens.jump_to(0, 8.0 * HOUR)
	_citizens.advance(60.0)
	check_equal(_citizens.get_clock_text(), "08:01", "and goes on where it was set back")
	_check_promises()


## Where somebody is who walks for a while yet, 10 m further on; nowhere for others.
func _spot_ahead_of(person: int) -> Vector3:
	var told: Dictionary = _citizens.get_person(person)
	if told["state"] != "walking" or (told["arrival"] - _citizens.time) * told["walking_speed"] < 20.0:
		return Vector3.INF
	for node: Node in get_tree().get_nodes_in_group(&"pcg_entrances"):
		if _city.is_ancestor_of(node) and (node as PCGEntrance).building_id == told["place"]["id"]:
			var metres := 0.0
			var way: PackedVector3Array = _city.find_path(told["position"], (node as PCGEntrance).global_position)
			for i: int in range(1, way.size()):
				var step: float = way[i - 1].distance_to(way[i])
				if metres + step > 10.0:
					return way[i - 1].move_toward(way[i], 10.0 - metres)
				metres += step
	return Vector3.INF


func test_people_go_round_what_is_put_in_their_way() -> void:
	_begin(7.4)
	var person := -1
	var spot := Vector3.INF
	for step: int in 500:
		for one: int in _citizens.get_persons_outside():
			if spot == Vector3.INF:
				person = one
				spot = _spot_ahead_of(one)
		if spot != Vector3.INF:
			break
		_citizens.advance(10.0)
	check(spot != Vector3.INF, "somebody has a way before it")
	var saved: PackedByteArray = _citizens.save_state()
	var monument := PCGObject.new()
	monument.type = "monument"
	monument.footprint = Vector2(3, 3)
	monument.position = spot
	_city.add_child(monument)
	for frame: int in 2000:
		await get_tree().process_frame
		if not _city.is_updating_navigation():
			break
	for is_loaded: bool in [false, true]:
		if is_loaded:
			check(_citizens.load_state(saved), "a state from before it was there")
		var nearest := INF
		for step: int in 120:
			_citizens.advance(0.5)
			nearest = minf(nearest, (_citizens.get_person(person)["position"] as Vector3).distance_to(spot))
		check(nearest > 1.5, "loaded: %s, it keeps out of the monument: %.2f m" % [is_loaded, nearest])
		check(nearest < 8.0, "it goes by: %.2f m" % nearest)
		check(_citizens.get_statistics()["events"]["goal-changed"] > 0, "it was led elsewhere")
	_citizens.advance(HOUR)
	_check_promises()
