extends Node
## The work of demo/run.gd, which sees first whether the addon's library is there.

signal ended(is_good: bool)

const DemoCity := preload("res://demo/demo_city.gd")
const STEP_SECONDS := 60.0 ## of simulated time; promises are checked after each
const STEPS_PER_FRAME := 10 ## the engine draws nothing here, but rests between frames
const DAY_SECONDS := 86400.0
const USAGE := "usage: demo/run.gd -- [--lots N] [--persons N] [--seed N] [--rules FILE.pcg] [--households FILE.csv] [--out FOLDER]"

var _options := {
	"lots": 300,
	"persons": 600,
	"seed": 1,
	"rules": DemoCity.RULES,
	"households": DemoCity.HOUSEHOLDS,
	"out": "out",
}
var _rules: PCGRuleSet
var _households: PCGHouseholdTable
var _city: PCGCity
var _citizens: CitizenManager
var _last_told := 0
var _start_of_stage := 0


func run() -> void:
	await get_tree().process_frame # so that the end is always told after somebody listens
	var is_good: bool = _read_arguments(OS.get_cmdline_user_args()) and _read_files() and await _grow() and _populate() and await _live()
	if is_good:
		is_good = _tell() and _save()
	ended.emit(is_good)


func _read_arguments(arguments: PackedStringArray) -> bool:
	for i: int in range(0, arguments.size(), 2):
		var option: String = arguments[i].trim_prefix("--")
		if not arguments[i].begins_with("--") or not _options.has(option):
			return _refuse("unknown option %s\n%s" % [arguments[i], USAGE])
		if i + 1 >= arguments.size():
			return _refuse("option %s wants a value\n%s" % [arguments[i], USAGE])
		var text: String = arguments[i + 1]
		if _options[option] is int:
			if not text.is_valid_int() or text.to_int() < 0:
				return _refuse("option %s wants a whole number, not \"%s\"" % [arguments[i], text])
			if option != "seed" and text.to_int() < 1:
				return _refuse("option %s wants 1 or more" % arguments[i])
			_options[option] = text.to_int()
		else:
			_options[option] = text
	return true


## Before anything is grown, so that a mistake in a file is told at once.
func _read_files() -> bool:
	_rules = PCGRuleSet.from_file(_options["rules"])
	_households = PCGHouseholdTable.from_file(_options["households"])
	for text: String in [_rules.get_diagnostics_text(), _households.get_diagnostics_text()]:
		if not text.is_empty():
			printerr(text)
	return not (_rules.has_errors() or _households.has_errors())


## One message on standard error, then the end.
func _refuse(message: String) -> bool:
	printerr("demo/run.gd: ", message)
	return false


func _begin_stage() -> void:
	_start_of_stage = Time.get_ticks_usec()


func _seconds() -> float:
	return float(Time.get_ticks_usec() - _start_of_stage) / 1e6


func _grow() -> bool:
	_begin_stage()
	_city = DemoCity.make_city(_options["lots"], _options["seed"])
	_city.generation_progressed.connect(_tell_progress)
	add_child(_city)
	_city.generate()
	if not await _city.city_generated:
		return false
	var made: Dictionary = _city.get_statistics()
	var seconds: Dictionary = made["seconds"]
	print("city: %d lots in %d blocks, %d faces, %d buildings, %d zones, %d objects in %.2f s" % [made["lots"], made["blocks"],
			made["faces"], made["buildings"], made["zones"], made["objects"], _seconds()])
	print("      entrances: %s" % _in_words(made["entrances"]))
	print("      lots derived %.2f s, scene built %.2f s, navigation baked %.2f s, distances prepared %.2f s" % [seconds["lots"],
			seconds["scene"], seconds["navigation"], seconds["distances"]])
	return true


## One line every two seconds, only for what takes longer.
func _tell_progress(stage: String, fraction: float) -> void:
	var now: int = Time.get_ticks_msec()
	if _last_told == 0:
		_last_told = now
	if now - _last_told > 2000:
		_last_told = now
		print("  .. %s: %d %%" % [stage, roundi(fraction * 100.0)])


func _populate() -> bool:
	_begin_stage()
	_citizens = CitizenManager.new()
	_citizens.city = _city
	_citizens.rules = _rules
	_citizens.household_table = _households
	_citizens.person_count = _options["persons"]
	_citizens.seed = _options["seed"]
	_citizens.paused = true # this script moves the clock
	_citizens.record_lives = true
	_citizens.check_promises = true
	add_child(_citizens)
	if not _citizens.generate_population():
		return false
	var made: Dictionary = _citizens.get_statistics()
	print("people: %d persons in %d households, %d agenda entries in %.2f s" % [made["persons"], made["households"],
			made["tasks"], _seconds()])
	return true


func _live() -> bool:
	_begin_stage()
	_last_told = 0
	_citizens.jump_to(0, 0.0)
	if not _citizens.start():
		return false
	var lived := 0.0
	while lived < DAY_SECONDS:
		for step: int in STEPS_PER_FRAME:
			_citizens.advance(STEP_SECONDS)
		lived += STEP_SECONDS * STEPS_PER_FRAME
		_tell_progress("the day", lived / DAY_SECONDS)
		await get_tree().process_frame
	var seconds: float = _seconds()
	print("day: Monday, 24 h in %.2f s, %d times real time" % [seconds, roundi(DAY_SECONDS / seconds)])
	return true


func _tell() -> bool:
	var day: Dictionary = _citizens.get_statistics()
	print("     %d trips; at most %d outside at once, at %s" % [day["trips"], day["peak_outside"], day["peak_clock"]])
	print("     %d of them arrived late: more than a second after a stayInside of the rules was to begin there" % day["late_arrivals"])
	var household: int = _citizens.choose_household()
	if household >= 0:
		print("one household's day:")
		for line: String in _citizens.tell_day(household, 0):
			print("  ", line)
	var broken: Dictionary = _citizens.get_broken_promises()
	print("broken promises: %s" % _in_words(broken))
	var sum := 0
	for count: int in broken.values():
		sum += count
	if sum > 0:
		for example: String in _citizens.get_broken_promise_examples():
			print("  ", example)
		return _refuse("%d promises of the simulation were broken; please report this" % sum)
	return true


func _save() -> bool:
	_begin_stage()
	var folder: String = _options["out"]
	var is_good: bool = _citizens.save_heat_map(folder.path_join("heatmap.png")) == OK \
			and _citizens.save_lives(folder.path_join("persons.csv")) == OK \
			and _city.save_gltf(folder.path_join("city.glb")) == OK
	if is_good:
		print("written in %.2f s: %s/heatmap.png, persons.csv, city.glb" % [_seconds(), folder])
	return is_good


func _in_words(counts: Dictionary) -> String:
	var parts := PackedStringArray()
	for key: String in counts:
		parts.append("%s %d" % [key, counts[key]])
	return ", ".join(parts)
