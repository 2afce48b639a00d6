extends SceneTree
## Draws the heat maps of docs/results.md: the days of 600 people in a city whose houses stand in the north-west, workplaces in the south-east, and
## shops and schools between them, as in the paper's figure. Headless:
##
##     godot --headless --path . --script tools/results.gd -- FOLDER

const DemoCity := preload("res://demo/demo_city.gd")
const PERSONS := 600
const LOTS := 300
const WIDTH := 400 ## pixels of a map
const GAP := 12 ## pixels between maps
const QUALITY := 0.85
const DAY_SECONDS := 86400.0
const WEEKDAY := "res://rules/agenda/weekday.pcg"
## Shares of lots by quarter: north-west, north-east, south-west, south-east. Parks are everywhere.
const QUARTERS := [
	{"house": 70, "row_house": 14, "apartment": 8, "park": 8},
	{"shop": 30, "supermarket": 6, "restaurant": 8, "school": 14, "house": 34, "park": 8},
	{"shop": 30, "supermarket": 6, "restaurant": 8, "school": 14, "house": 34, "park": 8},
	{"workplace": 64, "office_tower": 14, "workshop": 14, "park": 8},
]
## Picture, then rules and age group of each map in it, from left to right.
const PICTURES := {
	"heat_days": [[WEEKDAY, ""], ["res://rules/agenda/weekend.pcg", ""], ["res://rules/agenda/mixed_week.pcg", ""]],
	"heat_ages": [[WEEKDAY, "children"], [WEEKDAY, "adults"], [WEEKDAY, "elders"]],
	"heat_random": [["res://rules/agenda/random.pcg", ""], [WEEKDAY, ""]],
}
## The weekend's rules hold on any day; mixed_week draws 0.7 and 0.3 on working days. All live a Monday.

var _folder := ""
var _city: PCGCity


func _initialize() -> void:
	_run.call_deferred()


func _run() -> void:
	var arguments: PackedStringArray = OS.get_cmdline_user_args()
	if arguments.size() != 1 or not DirAccess.dir_exists_absolute(arguments[0]):
		printerr("usage: tools/results.gd -- FOLDER (which must be there)")
		quit(1)
		return
	_folder = arguments[0]
	_city = DemoCity.make_city(LOTS, 1)
	_city.layout.districts = _make_districts()
	root.add_child(_city)
	_city.generate()
	var is_good: bool = await _city.city_generated
	for picture: String in PICTURES if is_good else {}:
		var maps: Array[Image] = []
		for map: Array in PICTURES[picture]:
			maps.append(_live(map[0], map[1]))
		is_good = is_good and _side_by_side(maps).save_jpg(_folder.path_join(picture + ".jpg"), QUALITY) == OK
	_city.queue_free()
	await process_frame
	quit(0 if is_good else 1)


func _make_districts() -> Array[PCGDistrict]:
	var districts: Array[PCGDistrict] = []
	for i: int in QUARTERS.size():
		var district := PCGDistrict.new()
		district.area = Rect2(0.5 * (i % 2), 0.5 * floorf(i / 2.0), 0.5, 0.5)
		district.weights = QUARTERS[i]
		districts.append(district)
	return districts


func _live(rules: String, group: String) -> Image:
	var citizens := CitizenManager.new()
	citizens.city = _city
	citizens.rules = PCGRuleSet.from_file(rules)
	citizens.household_table = PCGHouseholdTable.from_file(DemoCity.HOUSEHOLDS)
	citizens.person_count = PERSONS
	citizens.paused = true
	citizens.record_lives = true
	citizens.check_promises = true
	root.add_child(citizens)
	citizens.generate_population()
	citizens.start()
	citizens.advance(DAY_SECONDS)
	var path: String = _folder.path_join("map.tmp.png")
	citizens.save_heat_map(path, group)
	var map: Image = Image.load_from_file(path)
	DirAccess.remove_absolute(path)
	_tell_ground(citizens, group)
	map.resize(WIDTH, roundi(float(WIDTH) * map.get_height() / map.get_width()), Image.INTERPOLATE_LANCZOS)
	var day: Dictionary = citizens.get_statistics()
	print("%s %s: %d trips, at most %d outside at %s, promises broken: %s" % [rules.get_file(), group, day["trips"], day["peak_outside"],
			day["peak_clock"], citizens.get_broken_promises().values()])
	citizens.queue_free()
	return map


## How much ground was entered, and how much of what children entered adults did, too. A pixel of the overlay is a metre wide.
func _tell_ground(citizens: CitizenManager, group: String) -> void:
	var heat: Image = citizens.get_heat_image(group)
	var adults: Image = citizens.get_heat_image("adults")
	var entered := 0
	var shared := 0
	for y: int in heat.get_height():
		for x: int in heat.get_width():
			if heat.get_pixel(x, y).a > 0.0:
				entered += 1
				shared += int(adults.get_pixel(x, y).a > 0.0)
	print("  %d m² were entered, %.1f %% of them by adults" % [entered, 100.0 * shared / maxi(1, entered)])


func _side_by_side(maps: Array[Image]) -> Image:
	var picture: Image = Image.create(maps.size() * (WIDTH + GAP) - GAP, maps[0].get_height(), false, maps[0].get_format())
	picture.fill(Color.WHITE)
	for i: int in maps.size():
		picture.blit_rect(maps[i], Rect2i(Vector2i.ZERO, maps[i].get_size()), Vector2i(i * (WIDTH + GAP), 0))
	return picture
