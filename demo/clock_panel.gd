class_name DemoClockPanel
extends PanelContainer
## Clock, speed and a few figures of a CitizenManager.

const DAYS := ["Monday", "Tuesday", "Wednesday", "Thursday", "Friday", "Saturday", "Sunday"]
const SPEEDS := { "II": 0.0, "1x": 1.0, "10x": 10.0, "60x": 60.0, "300x": 300.0 }
const STAGES := { "lots": "Lots are built", "scene": "The scene is filled", "navigation": "Ways are baked",
		"distances": "Distances are learnt" }

var citizens: CitizenManager

@onready var _clock: Label = %Clock
@onready var _figures: Label = %Figures
@onready var _speeds: HBoxContainer = %Speeds
@onready var _time: HSlider = %Time


func _ready() -> void:
	var group := ButtonGroup.new()
	for text: String in SPEEDS:
		var button := Button.new()
		button.text = text
		button.toggle_mode = true
		button.button_group = group
		button.focus_mode = Control.FOCUS_NONE
		button.size_flags_horizontal = Control.SIZE_EXPAND_FILL
		button.pressed.connect(_set_speed.bind(SPEEDS[text]))
		button.button_pressed = text == "10x"
		_speeds.add_child(button)
	_time.drag_ended.connect(_jump)
	_time.focus_mode = Control.FOCUS_NONE


func _process(_delta: float) -> void:
	if citizens == null or not citizens.is_running():
		return
	_clock.text = "%s %s" % [DAYS[posmod(citizens.day, 7)], citizens.get_clock_text()]
	_figures.text = "%d of %d people are outdoors" % [citizens.get_agent_view().get_agent_count(), citizens.get_statistics()["persons"]]
	if not _time.has_focus() and not Input.is_mouse_button_pressed(MOUSE_BUTTON_LEFT):
		_time.set_value_no_signal(citizens.time / 3600.0)


func show_progress(stage: String, fraction: float) -> void:
	_figures.text = "%s: %d %%" % [STAGES.get(stage, stage), roundi(fraction * 100.0)]


func show_running() -> void:
	citizens.time_scale = 10.0


func _set_speed(speed: float) -> void:
	citizens.paused = speed == 0.0
	if speed > 0.0:
		citizens.time_scale = speed


func _jump(is_changed: bool) -> void:
	if is_changed and citizens.is_running():
		citizens.jump_to(citizens.day, _time.value * 3600.0)
