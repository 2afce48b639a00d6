class_name DemoHeatLayer
extends "res://addons/pcg/heat_plane.gd"
## Where people spent their time since the day began.

const SECONDS_BETWEEN_PICTURES := 1.0

@export var citizens: CitizenManager

var group := "" ## everybody, or one of CitizenManager.get_age_groups()
var _age := INF ## of the picture, in seconds


func _ready() -> void:
	hide()


## "off", "all" or one of the groups.
func choose(choice: String) -> void:
	visible = choice != "off"
	group = "" if choice == "off" or choice == "all" else choice
	_age = INF


func _process(delta: float) -> void:
	_age += delta
	if visible and _age > SECONDS_BETWEEN_PICTURES and citizens.is_running():
		_age = 0.0
		show_heat(citizens, group)
