class_name DemoClockPanel
extends PanelContainer
## Clock, speed and a few figures of a CitizenManager; hours to jump to, and what the heat map shows.

signal heat_chosen(choice: String)

const DAYS := ["Monday", "Tuesday", "Wednesday", "Thursday", "Friday", "Saturday", "Sunday"]
const SPEEDS := { "II": 0.0, "1x": 1.0, "10x": 10.0, "60x": 60.0, "300x": 300.0 }
const JUMPS := { "7:30": 7.5, "7:58": 7.0 + 58.0 / 60.0, "10:00": 10.0, "16:00": 16.0, "21:00": 21.0 }
const STAGES := { "lots": "Lots are built", "scene": "The scene is filled", "navigation": "Ways are baked",
		"distances": "Distances are learnt" }
const FIRST_SPEED := 10.0
const SECONDS_PER_HOUR := 3600.0

@export var shows_heat := false
@export var hint := "" ## a second line of help

var citizens: CitizenManager

@onready var _clock: Label = %Clock
@onready var _figures: Label = %Figures
@onready var _speeds: HBoxContainer = %Speeds
@onready var _jumps: HBoxContainer = %Jumps
@onready var _time: HSlider = %Time
@onready var _heat: OptionButton = %Heat
@onready var _heat_choices: PackedStringArray = PackedStringArray(["off", "all"]) + CitizenManager.get_age_groups()


func _ready() -> void:
	var group := ButtonGroup.new()
	for text: String in SPEEDS:
		var button: Button = _add_button(_speeds, text, set_speed.bind(SPEEDS[text]))
		button.toggle_mode = true
		button.button_group = group
		button.button_pressed = SPEEDS[text] == FIRST_SPEED
	for text: String in JUMPS:
		_add_button(_jumps, text, jump_to_hour.bind(JUMPS[text]))
	_heat.add_item("No heat map")
	_heat.add_item("Everybody")
	for age_group: String in CitizenManager.get_age_groups():
		_heat.add_item(age_group.capitalize())
	_heat.visible = shows_heat
	if not hint.is_empty():
		(%Hint as Label).text += "\n" + hint
	_heat.item_selected.connect(func(index: int) -> void: heat_chosen.emit(_heat_choices[index]))
	_time.drag_ended.connect(func(is_changed: bool) -> void:
		if is_changed:
			jump_to_hour(_time.value))


func _add_button(row: HBoxContainer, text: String, on_press: Callable) -> Button:
	var button := Button.new()
	button.text = text
	button.focus_mode = Control.FOCUS_NONE
	button.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	button.pressed.connect(on_press)
	row.add_child(button)
	return button


func _process(_delta: float) -> void:
	if citizens == null or not citizens.is_running():
		return
	_clock.text = "%s %s" % [DAYS[posmod(citizens.day, 7)], citizens.get_clock_text()]
	var view: PCGAgentView = citizens.get_agent_view()
	_figures.text = "%d of %d people are outdoors" % [view.get_agent_count() if view != null else 0, citizens.count_persons()]
	if not Input.is_mouse_button_pressed(MOUSE_BUTTON_LEFT):
		_time.set_value_no_signal(citizens.time / SECONDS_PER_HOUR)


func show_progress(stage: String, fraction: float) -> void:
	_figures.text = "%s: %d %%" % [STAGES.get(stage, stage), roundi(fraction * 100.0)]


func show_running() -> void:
	citizens.time_scale = FIRST_SPEED


func set_speed(speed: float) -> void:
	citizens.paused = speed == 0.0
	if speed > 0.0:
		citizens.time_scale = speed


## "off", "all" or one of CitizenManager.get_age_groups(), as if somebody had chosen it.
func choose_heat(choice: String) -> void:
	if _heat_choices.has(choice):
		_heat.select(_heat_choices.find(choice))
		heat_chosen.emit(choice)
	else:
		push_error("There is no heat map of '%s'; there are those of %s." % [choice, ", ".join(_heat_choices)])


func jump_to_hour(hour: float) -> void:
	if citizens.is_running():
		citizens.jump_to(citizens.day, hour * SECONDS_PER_HOUR)
