class_name DemoHand
extends Node
## What the mouse does to the city: a click picks a person, a drag that begins on a bench (or whatever people use) carries it away.

signal person_picked(person: int) ## -1: nobody was there

const CLICK_SLOP := 6.0 ## pixels that a click may wander
const GRIP_RADIUS := 1.2 ## metres around the middle of an object
const GRIP_SHARE := 0.012 ## of the distance, where that is more
const LIFT := 0.4 ## metres that a carried object hangs in the air

@export var city: PCGCity
@export var citizens: CitizenManager

var held: PCGObject ## what is being carried
var _height := 0.0 ## of what is held, before it was lifted
var _pressed_at := Vector2.INF ## where the left button went down; infinite while it is up


func _unhandled_input(event: InputEvent) -> void:
	var camera: Camera3D = get_viewport().get_camera_3d()
	var button := event as InputEventMouseButton
	if button != null and button.button_index == MOUSE_BUTTON_LEFT:
		if button.pressed:
			_pressed_at = button.position
			grip(find_object(camera.project_ray_origin(button.position), camera.project_ray_normal(button.position)))
		else:
			_let_go(camera, button.position)
		if held != null:
			get_viewport().set_input_as_handled()
	var motion := event as InputEventMouseMotion
	if motion != null and held != null:
		var origin: Vector3 = camera.project_ray_origin(motion.position)
		carry(origin, camera.project_ray_normal(motion.position))
		get_viewport().set_input_as_handled()


func _let_go(camera: Camera3D, point: Vector2) -> void:
	var is_click: bool = _pressed_at.distance_to(point) <= CLICK_SLOP
	_pressed_at = Vector2.INF
	if held != null:
		put_down()
	elif is_click:
		pick(camera.project_ray_origin(point), camera.project_ray_normal(point))


## Tells whom a ray meets first.
func pick(origin: Vector3, direction: Vector3) -> int:
	var view: PCGAgentView = citizens.get_agent_view()
	var person: int = view.pick_person(origin, direction) if view != null else -1
	person_picked.emit(person)
	return person


## The object nearest to the eye that a ray passes, or null.
func find_object(origin: Vector3, direction: Vector3) -> PCGObject:
	var best: PCGObject = null
	var nearest := INF
	for node: Node in get_tree().get_nodes_in_group(&"pcg_objects"):
		var object := node as PCGObject
		if object == null or not city.is_ancestor_of(object):
			continue
		var middle: Vector3 = _middle_of(object) - origin
		var along: float = middle.dot(direction)
		var radius: float = maxf(GRIP_RADIUS, along * GRIP_SHARE)
		if along > 0.0 and along < nearest and middle.length_squared() - along * along < radius * radius:
			nearest = along
			best = object
	return best


## Objects stand where their rules put their scope; people use their places.
func _middle_of(object: PCGObject) -> Vector3:
	var sum := Vector3.ZERO
	for place: Transform3D in object.places:
		sum += place.origin
	return object.global_transform * (sum / maxi(1, object.places.size())) + Vector3(0.0, 0.3, 0.0)


func grip(object: PCGObject) -> void:
	held = object
	if held != null:
		_height = held.global_position.y


## Moves what is held to where a ray meets the ground.
func carry(origin: Vector3, direction: Vector3) -> void:
	var ground: Variant = Plane(Vector3.UP, 0.0).intersects_ray(origin, direction)
	if held == null or not ground is Vector3:
		return
	var middle: Vector3 = _middle_of(held)
	var step: Vector3 = ground - middle
	held.global_position = Vector3(held.global_position.x + step.x, _height + LIFT, held.global_position.z + step.z)


func put_down() -> void:
	held.global_position.y = _height
	held = null
