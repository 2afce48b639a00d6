@tool
extends VBoxContainer
## One person: who, where, the week as a timeline, and for each entry the rule that wrote it.

## The place in a rule file that an entry comes from.
signal place_wanted(path: String, line: int, column: int)

const SceneContext := preload("res://addons/pcg/editor/scene_context.gd")
const WeekTimeline := preload("res://addons/pcg/editor/person/week_timeline.gd")
const TaskColors := preload("res://addons/pcg/editor/person/task_colors.gd")
const PathOverlay := preload("res://addons/pcg/editor/person/path_overlay.gd")
const LifeRecorder := preload("res://addons/pcg/editor/person/life_recorder.gd")
const AgendaHistory := preload("res://addons/pcg/editor/person/agenda_history.gd")
const EntryDialog := preload("res://addons/pcg/editor/person/entry_dialog.gd")
const SECONDS_PER_HOUR := 3600.0
const ADULT_AGE := 18 ## of words: a boy, a man

var context: SceneContext
var overlay := PathOverlay.new()
var recorder := LifeRecorder.new()
var history: AgendaHistory
var _entries: Array[Dictionary] = []
var _day := 0 # that is shown

@onready var _dialog: EntryDialog = %EntryDialog
@onready var _list: Tree = %Entries
@onready var _week: WeekTimeline = %Week
@onready var _household: OptionButton = %Household


func open(of: SceneContext) -> void:
	context = of
	history = AgendaHistory.new(context)
	history.agenda_changed.connect(refresh)
	context.changed.connect(refresh)
	context.person_chosen.connect(func(_person: int) -> void: refresh())
	refresh()


func _ready() -> void:
	for column: int in 3:
		_list.set_column_title(column, ["Time", "What", "Why"][column])
		_list.set_column_title_alignment(column, HORIZONTAL_ALIGNMENT_LEFT)
		_list.set_column_clip_content(column, true)
	_list.item_selected.connect(func() -> void: _week.select(_list.get_selected().get_metadata(0)))
	_list.item_activated.connect(func() -> void: open_rule(_list.get_selected().get_metadata(0)))
	_week.entry_clicked.connect(_on_entry_clicked)
	_household.item_selected.connect(func(index: int) -> void: context.choose_person(_household.get_item_id(index)))
	(%Add as Button).pressed.connect(func() -> void: _dialog.ask(context, {}))
	(%Change as Button).pressed.connect(_change_selected)
	_dialog.entry_made.connect(insert)
	(%Ways as CheckBox).toggled.connect(func(_is_on: bool) -> void: show_ways())
	_take_theme()


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_node_ready():
		_take_theme()


func _take_theme() -> void:
	(%Pick as Button).icon = get_theme_icon("ToolSelect", "EditorIcons")
	for column: int in 3: # a line each in a wide dock, two in a narrow one
		_list.set_column_expand_ratio(column, [1, 2, 5][column])
		_list.set_column_custom_minimum_width(column, roundi([70.0, 90.0, 120.0][column] * EditorInterface.get_editor_scale()))
	_week.custom_minimum_size = Vector2(180.0, 150.0) * EditorInterface.get_editor_scale()
	for swatch: ColorRect in [%Hair, %Skin, %Clothes]:
		swatch.custom_minimum_size = Vector2(28.0, 16.0) * EditorInterface.get_editor_scale()


func _exit_tree() -> void:
	overlay.hide()


func _process(_delta: float) -> void:
	if recorder.note():
		show_ways()
	if is_visible_in_tree() and context and context.has_person():
		if context.citizens.day != _day:
			_show_days()
		_tell_present()


func refresh() -> void:
	var has_person: bool = context.has_person()
	(%Empty as Control).visible = not has_person
	(%Content as Control).visible = has_person
	_household.visible = has_person
	overlay.hide()
	_list.clear()
	_entries = []
	recorder.follow(context.citizens if has_person else null, context.person if has_person else -1)
	if has_person:
		_fill_household()
		_show_looks()
		_show_days()
		_tell_present()


# As they are seen: the engine lights colours that are linear.
func _show_looks() -> void:
	var looks: Dictionary = context.citizens.get_looks(context.person)
	(%Hair as ColorRect).color = (looks["hair_color"] as Color).linear_to_srgb()
	(%Skin as ColorRect).color = (looks["skin_color"] as Color).linear_to_srgb()
	(%Clothes as ColorRect).color = (looks["clothes_color"] as Color).linear_to_srgb()


# The week around the day that the clock shows, and that day's ways.
func _show_days() -> void:
	_day = context.citizens.day
	_fill_entries()
	show_ways()


func _fill_household() -> void:
	_household.clear()
	var household: int = context.citizens.get_person(context.person)["household"]
	# Members stand one behind the other.
	var member: int = context.person
	while member > 0 and context.citizens.get_person(member - 1)["household"] == household:
		member -= 1
	while context.citizens.has_person(member) and context.citizens.get_person(member)["household"] == household:
		var told: Dictionary = context.citizens.get_person(member)
		_household.add_item("%s, %d" % [told["name"], told["age"]], member)
		if member == context.person:
			_household.select(_household.item_count - 1)
		member += 1


# Of the clock's week, day by day, because some entries hold on one day only. What is the same on several days is one entry.
func _collect_entries() -> Array[Dictionary]:
	var days: Dictionary[Dictionary, PackedStringArray] = {} # entry without its days to those on which it holds
	for weekday: int in 7:
		for entry: Dictionary in context.citizens.get_agenda(context.person, _day - posmod(_day, 7) + weekday):
			entry.erase("days")
			days[entry] = days.get(entry, PackedStringArray()) + PackedStringArray([WeekTimeline.DAYS[weekday]])
	var collected: Array[Dictionary] = []
	for entry: Dictionary in days:
		collected.append(entry.merged({"days": days[entry]}))
	collected.sort_custom(func(one: Dictionary, other: Dictionary) -> bool: return one["start"] < other["start"])
	return collected


func _fill_entries() -> void:
	_list.clear()
	_entries = _collect_entries()
	var home: int = context.citizens.get_person(context.person)["home"]
	var root: TreeItem = _list.create_item()
	for index: int in _entries.size():
		var entry: Dictionary = _entries[index]
		entry["told"] = "%s %s\n%s, %s\n%s:%d" % [TaskColors.TITLES.get(entry["kind"], entry["kind"]), get_target_text(entry), get_time_text(entry),
				get_days_text(entry), entry.get("file", ""), entry.get("line", 0)]
		var item: TreeItem = _list.create_item(root)
		item.set_text(0, get_time_text(entry))
		item.set_text(1, ("%s %s" % [TaskColors.TITLES.get(entry["kind"], entry["kind"]), get_target_text(entry)]).strip_edges() + _some_days_text(entry))
		item.set_custom_color(0, TaskColors.of_entry(entry, home).lerp(get_theme_color("font_color", "Editor"), 0.5)) # to be read on light ground, too
		item.set_text(2, "%s line %d" % [entry.get("rule", ""), entry.get("line", 0)])
		for column: int in 3:
			item.set_autowrap_mode(column, TextServer.AUTOWRAP_WORD_SMART)
			item.set_tooltip_text(column, "%s\nDouble-click to open the rule." % entry["told"])
		item.set_metadata(0, index)
	_week.show_week(_entries, home)


func get_target_text(entry: Dictionary) -> String:
	if int(entry["target"]) < 0 or entry["kind"] not in ["stayInside", "goToBuilding"]:
		return ""
	var home: int = context.citizens.get_person(context.person)["home"]
	return "home" if entry["target"] == home else context.get_building_text(entry["target"])


static func get_time_text(entry: Dictionary) -> String:
	return "%s - %s" % [CitizenManager.format_clock(entry["start"]), CitizenManager.format_clock(entry["end"])]


static func get_days_text(entry: Dictionary) -> String:
	var days: PackedStringArray = entry["days"]
	if days.size() == 7:
		return "daily"
	return "mon-fri" if days == PackedStringArray(["mon", "tue", "wed", "thu", "fri"]) else " ".join(days)


static func _some_days_text(entry: Dictionary) -> String:
	return "" if get_days_text(entry) == "daily" else ", " + get_days_text(entry)


func get_entries() -> Array[Dictionary]:
	return _entries


func open_rule(index: int) -> void:
	var entry: Dictionary = _entries[index]
	if not str(entry.get("file", "")).is_empty():
		place_wanted.emit(entry["file"], entry["line"], 1)


func _change_selected() -> void:
	var item: TreeItem = _list.get_selected()
	_dialog.ask(context, _entries[item.get_metadata(0)] if item else {})


## Puts an entry, as CitizenManager.insert_task() wants it, into the shown person's agenda; one step to undo.
func insert(task: Dictionary) -> void:
	history.insert(context.person, task)


func _on_entry_clicked(index: int, is_double: bool) -> void:
	_list.get_root().get_child(index).select(0)
	_list.scroll_to_item(_list.get_root().get_child(index))
	if is_double:
		open_rule(index)


func _tell_present() -> void:
	var told: Dictionary = context.citizens.get_person(context.person)
	var present: String = str(told.get("state", "the simulation is stopped"))
	var place: Dictionary = told.get("place", {})
	if place.get("kind", "") == "building":
		present += " %s %s" % ["to" if told["state"] == "walking" else "in", "home" if place["id"] == told["home"] else context.get_building_text(place["id"])]
	elif not str(place.get("kind", "")).is_empty():
		present += " %s %s %d" % ["to" if told["state"] == "walking" else "at", place["type"] if not str(place["type"]).is_empty() else place["kind"], place["id"]]
	var household_type: String = context.get_household_type(told)
	(%Told as Label).text = "%s, a %s of %d\nHousehold %d in %s%s\nWalks %.2f m/s\nNow: %s" % [told["name"], _word_for(told), told["age"], told["household"],
			context.get_building_text(told["home"]), "\n" + household_type if not household_type.is_empty() else "", told["walking_speed"], present]
	_week.show_lived(recorder.spans, context.citizens.day * WeekTimeline.DAY + context.citizens.time if context.citizens.is_running() else -1.0)


static func _word_for(told: Dictionary) -> String:
	if int(told["age"]) < ADULT_AGE:
		return "girl" if told["gender"] == "woman" else "boy"
	return told["gender"]


## The ways of the day that the clock shows: between the buildings that are planned, and the places outdoors where the person was seen. Dictionaries with
## `points` and `hour`.
func find_ways() -> Array[Dictionary]:
	var ways: Array[Dictionary] = []
	var here: Dictionary = context.get_building(context.citizens.get_person(context.person)["home"])
	for stop: Dictionary in _find_stops():
		if not here.is_empty() and stop["position"] != here["position"]:
			ways.append({"points": context.city.find_path(here["position"], stop["position"]), "hour": float(stop["time"]) / SECONDS_PER_HOUR})
		here = stop
	return ways


# Where rules lead people outdoors is known only once they are there.
func _find_stops() -> Array[Dictionary]:
	var stops: Array[Dictionary] = []
	for entry: Dictionary in context.citizens.get_agenda(context.person, context.citizens.day):
		var building: Dictionary = context.get_building(entry["target"]) if entry["kind"] in ["stayInside", "goToBuilding"] else {}
		if not building.is_empty():
			stops.append({"time": float(entry["start"]), "position": building["position"]})
	var midnight: float = context.citizens.day * LifeRecorder.DAY
	for stop: Dictionary in recorder.stops:
		if stop["time"] >= midnight and stop["time"] < midnight + LifeRecorder.DAY:
			stops.append({"time": stop["time"] - midnight, "position": stop["position"]})
	stops.sort_custom(func(one: Dictionary, other: Dictionary) -> bool: return one["time"] < other["time"])
	return stops


func show_ways() -> void:
	overlay.hide()
	if (%Ways as CheckBox).button_pressed and context.has_person() and context.city and context.city.is_generated():
		overlay.show_ways(context.city, find_ways())


func is_picking() -> bool:
	return (%Pick as Button).button_pressed


## Chooses whoever is seen at that point of the 3D viewport. False if nobody is.
func pick(camera: Camera3D, at: Vector2) -> bool:
	var view: PCGAgentView = context.citizens.get_agent_view() if context.citizens else null
	var picked: int = view.pick_person(camera.project_ray_origin(at), camera.project_ray_normal(at)) if view else -1
	if picked >= 0:
		(%Pick as Button).button_pressed = false
		context.choose_person(picked)
	return picked >= 0
