extends "res://tests/godot/living_suite.gd"
## What of people lasts: saved games, and populations that are kept.


func test_a_saved_life_goes_on_as_it_would_have() -> void:
	_begin(7.5)
	_citizens.advance(20 * 60.0)
	_citizens.take_over(2)
	_citizens.paused = true
	var path := "user://state_of_tests.pcgstate"
	check_equal(_citizens.save_state_file(path), OK, "saved while paused")
	_citizens.advance(2 * HOUR)
	var later: Array = _where_everybody_is()
	_make_citizens() # nobody lives with this one yet
	check_equal(_citizens.load_state_file(path), OK, "loaded into one that never ran")
	check_equal(_citizens.get_clock_text(), "07:50", "at that time")
	check_equal(_citizens.get_person(2)["presence"], "taken", "with what the game had")
	check_equal(_citizens.get_agent_view().get_agent_count(), _citizens.get_persons_outside().size() - 1, "all others outdoors have bodies")
	_citizens.advance(2 * HOUR)
	check_equal(_where_everybody_is(), later, "the same future")
	DirAccess.remove_absolute(path)
	_check_promises()


func _where_everybody_is() -> Array:
	return range(_citizens.get_statistics()["persons"]).map(func(id: int) -> Array:
		var person: Dictionary = _citizens.get_person(id)
		return [person["state"], person["place"], person["position"]])


func test_states_that_do_not_fit_are_refused_and_life_goes_on() -> void:
	expect_message("nothing runs. Call start() before save_state()")
	check(_citizens.save_state().is_empty(), "nothing to save")
	_begin(8.0)
	var good: PackedByteArray = _citizens.save_state()
	var before: Array = _where_everybody_is()
	var stops: Array[int] = [0]
	_citizens.simulation_stopped.connect(func() -> void: stops[0] += 1)
	var damaged: PackedByteArray = good.duplicate()
	damaged[good.size() / 2] += 1
	expect_message("the saved simulation is damaged")
	check(not _citizens.load_state(damaged), "damaged")
	check(not _citizens.load_state(good.slice(0, 40)), "cut")
	expect_message("this is no saved simulation")
	check(not _citizens.load_state(PackedByteArray()), "nothing")
	var newer: PackedByteArray = good.duplicate()
	newer[8] = 99
	expect_message("it was saved by a newer version (format 99")
	check(not _citizens.load_state(newer), "newer")
	expect_message("no such file.pcgstate")
	check_equal(_citizens.load_state_file("user://no such file.pcgstate"), ERR_FILE_CANT_READ, "not there")
	check_equal(_where_everybody_is(), before, "nothing has changed")
	check_equal(stops[0], 0, "and life went on")
	var other: PCGCity = CityForTests.make_city()
	other.lot_types = [CityForTests.make_type("house", 1, "Lot --> entrance(\"house\", 4)\n")]
	other.seed = 9
	add_child(other)
	other.generate_now()
	_citizens.rules = CityForTests.make_rules(SCHOOL_RUN, PCGRuleSet.DIALECT_AGENDA)
	expect_message("the state was saved with other rules")
	check(not _citizens.load_state(good), "other rules")
	check(_citizens.is_running(), "it still runs")


func test_a_state_of_another_city_is_refused_and_edits_make_no_other_city() -> void:
	_begin(8.0)
	var saved: PackedByteArray = _citizens.save_state()
	_citizens.stop()
	var seed_before: int = _city.seed
	_city.seed = seed_before + 8
	_city.generate_now()
	expect_message("the state was saved in another city")
	check(not _citizens.load_state(saved), "a city of another seed")
	_city.seed = seed_before
	_city.generate_now()
	var lot: PCGLot = _city.find_children("*", "PCGLot", true, false)[3]
	lot.position.x += 1.0
	_city.update_model()
	check(_citizens.load_state(saved), "its own, where a lot was moved")
	_check_promises()


func test_people_who_are_kept_stay_the_same_and_can_be_edited() -> void:
	check(_citizens.generate_population(), "people by chance")
	var people: PCGPopulation = _citizens.keep_population()
	var first: Dictionary = _citizens.get_person(0)
	_citizens.seed = 99
	check(_citizens.generate_population(), "people who were kept")
	first["household_row"] = -1 # no table says who it is
	check_equal(_citizens.get_person(0), first, "the same one")
	people.source = people.source.replace("\n0,0,%d,%s" % [first["home"], people.source.get_slice("\n", 1).get_slice(",", 3)], "\n0,0,%d,77" % first["home"])
	check(_citizens.generate_population(), "edited by hand")
	check_equal(_citizens.get_person(0)["age"], 77, "older now")
	var path := "user://people_of_tests.csv"
	check_equal(people.save_csv(path), OK, "written")
	_citizens.population = PCGPopulation.from_file(path)
	check(_citizens.generate_population(), "read back")
	check_equal(_citizens.get_person(0)["age"], 77, "as it was written")
	check_equal(ResourceSaver.save(people, "user://people_of_tests.tres"), OK, "a resource, too")
	check_equal(ResourceLoader.load("user://people_of_tests.tres").source, people.source, "with the same text")
	for written: String in [path, "user://people_of_tests.tres"]:
		DirAccess.remove_absolute(written)
	expect_message("people_of_tests.csv")
	_citizens.population.reload()
	check(not _citizens.generate_population(), "the file is gone")


func test_a_renewal_that_waits_for_midnight_is_forgotten_when_a_state_is_loaded() -> void:
	_begin(20.0)
	var renewals: Array[int] = [0]
	_citizens.agendas_renewed.connect(func() -> void: renewals[0] += 1)
	check(_citizens.renew_agendas(), "at midnight")
	check(_citizens.load_state(_citizens.save_state()), "but another life begins")
	_citizens.advance(6.0 * HOUR)
	check_equal(renewals[0], 0, "of which nobody asked it")
	check(_citizens.renew_agendas(), "now somebody does")
	_citizens.advance(24.0 * HOUR)
	check_equal(renewals[0], 1, "and it comes")


func test_a_state_is_not_loaded_with_rules_in_which_one_number_is_another() -> void:
	_citizens.rules = CityForTests.make_rules(SCHOOL_RUN, PCGRuleSet.DIALECT_AGENDA)
	_begin(8.0)
	var saved: PackedByteArray = _citizens.save_state()
	_citizens.rules = CityForTests.make_rules(SCHOOL_RUN.replace("wait(10m)", "wait(11m)"), PCGRuleSet.DIALECT_AGENDA)
	expect_message("the state was saved with other rules")
	check(not _citizens.load_state(saved), "ten minutes are not eleven")
	_citizens.rules = CityForTests.make_rules(SCHOOL_RUN, PCGRuleSet.DIALECT_AGENDA)
	check(_citizens.load_state(saved), "but ten are")
