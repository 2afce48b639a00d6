extends Node3D
## A city from above with people in it. Saves a picture and ends when it is started with
##
##     godot --path . demo/showcase.tscn -- --screenshot FILE.png [--hour 7.9] [--view X,Z,YAW,PITCH,DISTANCE]
##
## The picture in the README is --hour 16.01 --view -168,38,42,27,62.

const SECONDS_PER_HOUR := 3600.0
const FRAMES_BEFORE_PICTURE := 8 ## shadows and sky need a few

@export var city: PCGCity
@export var citizens: CitizenManager
@export var camera_rig: DemoCameraRig
@export var sun: DemoSun
@export var panel: DemoClockPanel


func _ready() -> void:
	panel.citizens = citizens
	city.generation_progressed.connect(panel.show_progress)
	citizens.simulation_started.connect(_on_simulation_started)


func _process(_delta: float) -> void:
	sun.show_hour(citizens.time / SECONDS_PER_HOUR)


func _on_simulation_started() -> void:
	panel.show_running()
	var arguments: PackedStringArray = OS.get_cmdline_user_args()
	var screenshot: int = arguments.find("--screenshot")
	if screenshot >= 0 and screenshot + 1 < arguments.size():
		_take_picture(arguments[screenshot + 1], arguments)


func _take_picture(path: String, arguments: PackedStringArray) -> void:
	var hour: int = arguments.find("--hour")
	if hour >= 0:
		# A quarter of an hour is lived rather than jumped over, so that people are on their way.
		citizens.jump_to(citizens.day, (arguments[hour + 1].to_float() - 0.25) * SECONDS_PER_HOUR)
		citizens.advance(0.25 * SECONDS_PER_HOUR)
	var view: int = arguments.find("--view")
	if view >= 0:
		var numbers: PackedFloat64Array = arguments[view + 1].split_floats(",")
		camera_rig.look_from(Vector3(numbers[0], 0.0, numbers[1]), numbers[2], numbers[3], numbers[4])
	citizens.paused = true
	for frame: int in FRAMES_BEFORE_PICTURE:
		await get_tree().process_frame
	await RenderingServer.frame_post_draw
	var error: Error = get_viewport().get_texture().get_image().save_png(path)
	get_tree().quit(0 if error == OK else 1)
