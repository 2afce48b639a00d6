extends Node3D
## A city with people in it. Click somebody to follow them and read their agenda, drag a bench away, jump through the day.
##
## Saves a picture and ends when it is started with
##
##     godot --path . demo/showcase.tscn -- --screenshot FILE.jpg [--hour 7.5,7.9] [--view X,Z,YAW,PITCH,DISTANCE]
##         [--person ID] [--heat all] [--ui-scale 2]
##
## docs/results.md says how its pictures were taken.

const SECONDS_PER_HOUR := 3600.0
const HOURS_LIVED_BEFORE_PICTURE := 0.25 ## rather than jumped over, so that nobody has just set out
const FOLLOW_DISTANCE := 28.0 ## metres
const SHOULDERS := Vector3(0.0, 1.2, 0.0)
const USUAL_DPI := 96.0

@export var city: PCGCity
@export var citizens: CitizenManager
@export var camera_rig: DemoCameraRig
@export var sun: DemoSun
@export var windows: DemoWindows
@export var heat: DemoHeatLayer
@export var hand: DemoHand
@export var panel: DemoClockPanel
@export var person_panel: DemoPersonPanel
@export var marker: Node3D ## above whoever is followed

var _options := {}


func _ready() -> void:
	_read_options(OS.get_cmdline_user_args())
	RenderingServer.render_loop_enabled = not _options.has("screenshot") # until there is what shall be pictured
	get_window().content_scale_factor = _ui_scale()
	panel.citizens = citizens
	panel.heat_chosen.connect(heat.choose)
	city.generation_progressed.connect(panel.show_progress)
	citizens.simulation_started.connect(_on_simulation_started)
	hand.person_picked.connect(follow_person)
	person_panel.closed.connect(camera_rig.stop_following)
	marker.hide()


func _read_options(arguments: PackedStringArray) -> void:
	for i: int in arguments.size() - 1:
		if arguments[i].begins_with("--"):
			_options[arguments[i].trim_prefix("--")] = arguments[i + 1]


## Of the user's choice, or by how fine the screen is.
func _ui_scale() -> float:
	if _options.has("ui-scale"):
		return clampf(str(_options["ui-scale"]).to_float(), 0.5, 4.0)
	return clampf(snappedf(DisplayServer.screen_get_dpi() / USUAL_DPI, 0.5), 1.0, 3.0)


func _process(_delta: float) -> void:
	var hour: float = citizens.time / SECONDS_PER_HOUR
	sun.show_hour(hour)
	windows.show_hour(hour)
	var place: Variant = find_followed()
	marker.visible = place is Vector3
	if place is Vector3:
		marker.global_position = place


## -1 lets go.
func follow_person(person: int) -> void:
	person_panel.show_person(person)
	if person < 0:
		camera_rig.stop_following()
	else:
		camera_rig.follow(find_followed, FOLLOW_DISTANCE)


## Where the person whose agenda is shown is, or null while nobody is shown or it is indoors.
func find_followed() -> Variant:
	var view: PCGAgentView = citizens.get_agent_view()
	if view == null or not view.has_agent(person_panel.person):
		return null
	return view.global_transform * view.get_shown_position(person_panel.person) + SHOULDERS


func _on_simulation_started() -> void:
	panel.show_running()
	if _options.has("screenshot"):
		_take_pictures()


func _take_pictures() -> void:
	citizens.paused = true
	if _options.has("view"):
		var numbers: PackedFloat64Array = str(_options["view"]).split_floats(",")
		camera_rig.look_from(Vector3(numbers[0], 0.0, numbers[1]), numbers[2], numbers[3], numbers[4])
	if _options.has("person"):
		person_panel.show_person(str(_options["person"]).to_int())
	if _options.has("heat"):
		panel.choose_heat(_options["heat"])
	var hours: PackedFloat64Array = str(_options.get("hour", citizens.time / SECONDS_PER_HOUR)).split_floats(",")
	var path: String = _options["screenshot"]
	var error: Error = OK
	for hour: float in hours:
		citizens.jump_to(citizens.day, (hour - HOURS_LIVED_BEFORE_PICTURE) * SECONDS_PER_HOUR)
		citizens.advance(HOURS_LIVED_BEFORE_PICTURE * SECONDS_PER_HOUR)
		var name_of_hour: String = "" if hours.size() == 1 else citizens.get_clock_text().replace(":", "")
		error = await DemoPicture.take(self, "%s%s.%s" % [path.get_basename(), name_of_hour, path.get_extension()])
	get_tree().quit(0 if error == OK else 1)
