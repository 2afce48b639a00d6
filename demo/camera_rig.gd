class_name DemoCameraRig
extends Node3D
## A camera that orbits a point on the ground: right or middle button turns, the wheel comes nearer, WASD or the left button moves.
## It can follow somebody; moving lets go.

const TURN_SPEED := 0.006 ## radians a pixel
const MOVE_SPEED := 0.9 ## times the distance, metres a second
const ZOOM_STEP := 1.12
const NEAR_SHARE := 0.02 ## of the distance: the nearer the near plane, the coarser the depth, and grounds of nearly one height would flicker
const FOLLOW_RATE := 6.0 ## 1/s
const FOLLOW_PITCH := 40.0 ## degrees at least, so that houses seldom stand in the way

@export_range(5.0, 2000.0) var distance := 180.0
@export_range(-180.0, 180.0) var yaw_degrees := 35.0
@export_range(3.0, 89.0) var pitch_degrees := 32.0
@export var nearest := 4.0
@export var farthest := 1200.0

var _goal_distance := 0.0
var _find_target := Callable() ## returns a Vector3, or null where nobody is to be followed any more

@onready var camera: Camera3D = $Camera3D


func _ready() -> void:
	_goal_distance = distance
	_place()


func look_from(point: Vector3, yaw: float, pitch: float, metres: float) -> void:
	position = point
	yaw_degrees = yaw
	pitch_degrees = pitch
	distance = metres
	_goal_distance = metres
	_place()


## `find_target` is asked each frame where to look; it returns null to end.
func follow(find_target: Callable, metres: float) -> void:
	_find_target = find_target
	_goal_distance = minf(_goal_distance, metres)


func stop_following() -> void:
	_find_target = Callable()


func _process(delta: float) -> void:
	var way := Vector3.ZERO
	way.x = float(Input.is_physical_key_pressed(KEY_D)) - float(Input.is_physical_key_pressed(KEY_A))
	way.z = float(Input.is_physical_key_pressed(KEY_S)) - float(Input.is_physical_key_pressed(KEY_W))
	if way != Vector3.ZERO:
		stop_following()
		position += way.normalized().rotated(Vector3.UP, deg_to_rad(yaw_degrees)) * distance * MOVE_SPEED * delta
	if _find_target.is_valid():
		var target: Variant = _find_target.call()
		if target is Vector3:
			position = position.lerp(target, 1.0 - exp(-FOLLOW_RATE * delta))
			pitch_degrees = lerpf(pitch_degrees, maxf(pitch_degrees, FOLLOW_PITCH), 1.0 - exp(-FOLLOW_RATE * delta))
	distance = lerpf(distance, _goal_distance, 1.0 - exp(-12.0 * delta))
	_place()


func _unhandled_input(event: InputEvent) -> void:
	var motion := event as InputEventMouseMotion
	if motion != null:
		_drag(motion)
	var button := event as InputEventMouseButton
	if button == null or not button.pressed:
		return
	if button.button_index == MOUSE_BUTTON_WHEEL_UP:
		_goal_distance = clampf(_goal_distance / ZOOM_STEP, nearest, farthest)
	elif button.button_index == MOUSE_BUTTON_WHEEL_DOWN:
		_goal_distance = clampf(_goal_distance * ZOOM_STEP, nearest, farthest)


func _drag(motion: InputEventMouseMotion) -> void:
	if motion.button_mask & (MOUSE_BUTTON_MASK_RIGHT | MOUSE_BUTTON_MASK_MIDDLE):
		yaw_degrees = wrapf(yaw_degrees - rad_to_deg(motion.relative.x * TURN_SPEED), -180.0, 180.0)
		pitch_degrees = clampf(pitch_degrees + rad_to_deg(motion.relative.y * TURN_SPEED), 3.0, 89.0)
	elif motion.button_mask & MOUSE_BUTTON_MASK_LEFT:
		stop_following()
		var way := Vector3(-motion.relative.x, 0.0, -motion.relative.y) * distance * 0.0014
		position += way.rotated(Vector3.UP, deg_to_rad(yaw_degrees))


func _place() -> void:
	var turn := Basis(Vector3.UP, deg_to_rad(yaw_degrees)) * Basis(Vector3.RIGHT, -deg_to_rad(pitch_degrees))
	camera.transform = Transform3D(turn, turn * Vector3(0.0, 0.0, distance))
	camera.near = clampf(distance * NEAR_SHARE, 0.05, 10.0)
