@tool
extends ScrollContainer
## Runs the simulation in the editor's own viewport: clock, speed, jumps, a plot of a day and a heat map.

const SceneContext := preload("res://addons/pcg/editor/scene_context.gd")
const DaySurvey := preload("res://addons/pcg/editor/simulation/day_survey.gd")
const DayPlot := preload("res://addons/pcg/editor/simulation/day_plot.gd")
const CityOverlay := preload("res://addons/pcg/editor/city_overlay.gd")
const HeatPlane := preload("res://addons/pcg/heat_plane.gd")
const DAYS: PackedStringArray = ["Monday", "Tuesday", "Wednesday", "Thursday", "Friday", "Saturday", "Sunday"]
const SPEEDS: Array[float] = [1.0, 10.0, 60.0, 300.0, 1800.0]
const SECONDS_PER_HOUR := 3600.0

var context: SceneContext
var survey := DaySurvey.new()
var overlay := CityOverlay.new()

@onready var _hour: HSlider = %Hour
@onready var _day: OptionButton = %Day
@onready var _speed: OptionButton = %Speed
@onready var _plot: DayPlot = %Plot


func open(of: SceneContext) -> void:
	context = of
	context.changed.connect(_on_context_changed)
	_on_context_changed()


func _ready() -> void:
	for day: String in DAYS:
		_day.add_item(day)
	for speed: float in SPEEDS:
		_speed.add_item("%d x" % speed)
	(%HeatHour as OptionButton).add_item("all day")
	for hour: int in 24:
		(%HeatHour as OptionButton).add_item("%d h - %d h" % [hour, hour + 1])
	(%HeatAge as OptionButton).add_item("everybody")
	for group: String in CitizenManager.get_age_groups():
		(%HeatAge as OptionButton).add_item(group)
	(%Play as Button).pressed.connect(play_or_pause)
	(%Stop as Button).pressed.connect(func() -> void: context.citizens.stop())
	(%Survey as Button).pressed.connect(start_survey)
	(%Heat as CheckBox).toggled.connect(func(_is_on: bool) -> void: show_heat())
	for button: OptionButton in [%HeatHour, %HeatAge]:
		button.item_selected.connect(func(_index: int) -> void: show_heat())
	_speed.item_selected.connect(func(index: int) -> void: context.citizens.time_scale = SPEEDS[index])
	_day.item_selected.connect(func(_index: int) -> void: _jump())
	_hour.drag_ended.connect(func(_is_changed: bool) -> void: _jump())
	survey.progressed.connect(func(part: float) -> void: (%Survey as Button).text = "Survey the day .. %d %%" % roundi(100.0 * part))
	survey.ended.connect(_on_survey_ended)
	_take_theme()


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_node_ready():
		_take_theme()


func _take_theme() -> void:
	_plot.custom_minimum_size.y = 120.0 * EditorInterface.get_editor_scale()
	(%Stop as Button).icon = get_theme_icon("Stop", "EditorIcons")


func _on_context_changed() -> void:
	if is_node_ready():
		overlay.hide()
		_plot.show_day(PackedInt32Array())
		_begin_to_count()
		if context.citizens and not context.citizens.simulation_started.is_connected(_begin_to_count):
			context.citizens.simulation_started.connect(_begin_to_count)
		(%Heat as CheckBox).set_pressed_no_signal(false)
		_show_state()


func _exit_tree() -> void:
	overlay.hide()


func _process(_delta: float) -> void:
	survey.go_on()
	if overlay.is_shown() and not _has_heat():
		overlay.hide()
	if is_visible_in_tree() and context:
		_show_state()


func has_people() -> bool:
	return context.citizens != null and context.citizens.has_person(0)


func _show_state() -> void:
	(%Content as Control).visible = has_people()
	(%Empty as Control).visible = not has_people()
	if not has_people():
		return
	var citizens: CitizenManager = context.citizens
	(%Clock as Label).text = "%s %s" % [DAYS[posmod(citizens.day, 7)], citizens.get_clock_text()]
	(%Figures as Label).text = _tell_figures(citizens.get_statistics())
	var is_living: bool = citizens.is_running() and not citizens.paused
	(%Play as Button).text = "Pause" if is_living else "Play"
	(%Play as Button).icon = get_theme_icon("Pause" if is_living else "Play", "EditorIcons")
	(%Stop as Button).disabled = not citizens.is_running()
	(%Survey as Button).disabled = survey.is_running
	(%Heat as CheckBox).disabled = not _has_heat()
	(%Heat as CheckBox).button_pressed = (%Heat as CheckBox).button_pressed and _has_heat()
	_day.select(posmod(citizens.day, 7))
	_speed.select(SPEEDS.find(citizens.time_scale))
	_plot.show_hour(citizens.time / SECONDS_PER_HOUR)
	if not _hour.has_focus() or not Input.is_mouse_button_pressed(MOUSE_BUTTON_LEFT):
		_hour.set_value_no_signal(citizens.time / SECONDS_PER_HOUR)


# Days that were surveyed are not lived.
func _tell_figures(figures: Dictionary) -> String:
	var trips: int = maxi(0, int(figures.get("trips", 0)) - survey.trips)
	return "%d of %d outdoors, %d %s walked" % [figures.get("outside", 0), figures["persons"], trips, "way" if trips == 1 else "ways"]


func _begin_to_count() -> void:
	survey.trips = 0


func play_or_pause() -> void:
	var citizens: CitizenManager = context.citizens
	if not citizens.is_running():
		citizens.paused = false
		citizens.start()
	else:
		citizens.paused = not citizens.paused


func _jump() -> void:
	var citizens: CitizenManager = context.citizens
	citizens.jump_to(citizens.day - posmod(citizens.day, 7) + _day.selected, _hour.value * SECONDS_PER_HOUR)


## Lives through the day that the clock shows; the plot and the heat map are made of it.
func start_survey() -> void:
	var citizens: CitizenManager = context.citizens
	if citizens.is_running() or citizens.start():
		survey.start(citizens, citizens.day)


func _on_survey_ended() -> void:
	(%Survey as Button).text = "Survey the day"
	_plot.show_day(survey.counts)
	show_heat()


func _has_heat() -> bool:
	return context.citizens != null and context.citizens.has_recorded_lives() and not survey.is_running


func show_heat() -> void:
	overlay.hide()
	if (%Heat as CheckBox).button_pressed and _has_heat():
		var age: OptionButton = %HeatAge
		var plane := HeatPlane.new()
		overlay.lay(context.citizens.city, plane)
		plane.show_heat(context.citizens, age.get_item_text(age.selected) if age.selected > 0 else "", (%HeatHour as OptionButton).selected - 1)
