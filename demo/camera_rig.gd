class_name DemoCameraRig
extends Node3D
## A camera that orbits a point on the ground: right or middle button turns, the wheel comes nearer, WASD or the left button moves.

const TURN_SPEED := 0.006 ## radians a pixel
const MOVE_SPEED := 0.9 ## times the distance, metres a second
const ZOOM_STEP := 1.12

@export_range(5.0, 2000.0) var distance := 180.0
@export_range(-180.0, 180.0) var yaw_degrees := 35.0
@export_range(3.0, 89.0) var pitch_degrees := 32.0
@export var nearest := 6.0
@export var farthest := 1200.0

var _goal_distance := 0.0

@onready var _camera: Camera3D = $Camera3D


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


func _process(delta: float) -> void:
	var way := Vector3.ZERO
	way.x = float(Input.is_physical_key_pressed(KEY_D)) - float(Input.is_physical_key_pressed(KEY_A))
	way.z = float(Input.is_physical_key_pressed(KEY_S)) - float(Input.is_physical_key_pressed(KEY_W))
	if way != Vector3.ZERO:
		position += way.normalized().rotated(Vector3.UP, deg_to_rad(yaw_degrees)) * distance * MOVE_SPEED * delta
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
		var way := Vector3(-motion.relative.x, 0.0, -motion.relative.y) * distance * 0.0014
		position += way.rotated(Vector3.UP, deg_to_rad(yaw_degrees))


func _place() -> void:
	var turn := Basis(Vector3.UP, deg_to_rad(yaw_degrees)) * Basis(Vector3.RIGHT, -deg_to_rad(pitch_degrees))
	_camera.transform = Transform3D(turn, turn * Vector3(0.0, 0.0, distance))
