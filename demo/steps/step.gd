extends Node3D
## One step of the tour: a small city that shows one thing, a text that says what to look at, and the way to the next step. R makes all anew.
##
##     godot --path . demo/steps/1_one_lot.tscn [-- --screenshot FILE.png]

const COUNT := 6
const SCENES: PackedStringArray = ["1_one_lot", "2_a_street", "3_household", "4_school_run", "5_bench", "6_your_own_rule"]
const SECONDS_PER_HOUR := 3600.0

@export_range(1, COUNT) var number := 1
@export_multiline var text := ""
@export_file("*.cga", "*.pcg") var rule_file := ""
@export var first_hour := 10.0
@export var view := Vector3(35.0, 30.0, 60.0) ## yaw and pitch in degrees, distance in metres
@export var city: PCGCity
@export var citizens: CitizenManager

@onready var _stage: Node3D = $Stage
@onready var _panel: DemoClockPanel = _stage.get_node("%Panel")
@onready var _sun: DemoSun = _stage.get_node("%Sun")


func _ready() -> void:
	(_stage.get_node("%Title") as Label).text = "%d  %s" % [number, SCENES[number - 1].substr(2).capitalize()]
	(_stage.get_node("%Text") as Label).text = text
	(_stage.get_node("%File") as Label).text = rule_file
	(_stage.get_node("%Previous") as Button).disabled = number == 1
	(_stage.get_node("%Next") as Button).disabled = number == COUNT
	(_stage.get_node("%Previous") as Button).pressed.connect(_go_to.bind(number - 1))
	(_stage.get_node("%Next") as Button).pressed.connect(_go_to.bind(number + 1))
	_panel.citizens = citizens
	_panel.visible = citizens != null
	city.generation_progressed.connect(_panel.show_progress)
	(_stage.get_node("CameraRig") as DemoCameraRig).look_from(Vector3.ZERO, view.x, view.y, view.z)
	_sun.show_hour(first_hour)
	begin()


func _process(_delta: float) -> void:
	if citizens and citizens.is_running():
		_sun.show_hour(citizens.time / SECONDS_PER_HOUR)


func _unhandled_key_input(event: InputEvent) -> void:
	var key := event as InputEventKey
	if key.pressed and key.keycode == KEY_R and not city.is_generating():
		_read_rules()
		begin()


# Rules are read from their files again, because somebody edits them.
func _read_rules() -> void:
	for type: PCGLotType in city.lot_types:
		type.rules.reload()
	if citizens:
		citizens.stop()
		citizens.rules.reload()


## Makes the city and its people, and lets them live.
func begin() -> void:
	city.generate()
	if not await city.city_generated:
		_tell_problems(city.get_diagnostics())
		return
	if citizens and citizens.generate_population():
		citizens.jump_to(0, first_hour * SECONDS_PER_HOUR)
		citizens.start()
		_panel.show_running()
	var arguments: PackedStringArray = OS.get_cmdline_user_args()
	if arguments.size() == 2 and arguments[0] == "--screenshot":
		_take_picture(arguments[1])


func _tell_problems(problems: Array[Dictionary]) -> void:
	(_stage.get_node("%Text") as Label).text = "\n".join(problems.map(func(problem: Dictionary) -> String: return "%s:%d: %s" % [problem["file"], problem["line"], problem["message"]]))


func _go_to(other: int) -> void:
	get_tree().change_scene_to_file("res://demo/steps/%s.tscn" % SCENES[other - 1])


func _take_picture(path: String) -> void:
	if citizens:
		citizens.paused = true
	get_tree().quit(0 if await DemoPicture.take(self, path) == OK else 1)
