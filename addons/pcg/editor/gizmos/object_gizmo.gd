@tool
extends "res://addons/pcg/editor/gizmos/gizmo_plugin.gd"
## Where people use an object: a ring for each place with an arrow the way they look. One handle moves a place, the one at the arrow's tip turns it.

const RADIUS := 0.25 ## metres
const ARROW := 0.6
const CORNERS := 12


func _get_gizmo_name() -> String:
	return "PCGObject"


func _has_gizmo(node: Node3D) -> bool:
	return node is PCGObject


func _redraw(gizmo: EditorNode3DGizmo) -> void:
	gizmo.clear()
	var object: PCGObject = gizmo.get_node_3d() as PCGObject
	var lines := PackedVector3Array()
	var handles := PackedVector3Array()
	for place: Transform3D in object.places:
		_add_place(lines, place)
		handles.append_array([place.origin, place * Vector3(0.0, 0.0, ARROW)])
	if lines.is_empty():
		return
	gizmo.add_lines(lines, lines_material(color_of(object.type)))
	gizmo.add_collision_segments(lines)
	gizmo.add_handles(handles, get_material("handles", gizmo), PackedInt32Array(range(handles.size())))


static func _add_place(lines: PackedVector3Array, place: Transform3D) -> void:
	for corner: int in CORNERS:
		for turn: float in [corner, corner + 1]:
			lines.append(place * (Vector3(cos(TAU * turn / CORNERS), 0.0, sin(TAU * turn / CORNERS)) * RADIUS))
	lines.append_array([place.origin, place * Vector3(0.0, 0.0, ARROW)])


func _get_handle_name(_gizmo: EditorNode3DGizmo, id: int, _secondary: bool) -> String:
	return ("place %d" if id % 2 == 0 else "direction of place %d") % (id / 2)


func _get_handle_value(gizmo: EditorNode3DGizmo, id: int, _secondary: bool) -> Variant:
	return (gizmo.get_node_3d() as PCGObject).places[id / 2]


func _set_handle(gizmo: EditorNode3DGizmo, id: int, _secondary: bool, camera: Camera3D, mouse: Vector2) -> void:
	var object: PCGObject = gizmo.get_node_3d() as PCGObject
	var places: Array[Transform3D] = object.places.duplicate()
	var place: Transform3D = places[id / 2]
	var to: Vector3 = point_on_level(object, camera, mouse, place.origin)
	if id % 2 == 0:
		place.origin = to
	elif (to - place.origin).length() > 0.05:
		place.basis = Basis(Vector3.UP, atan2(to.x - place.origin.x, to.z - place.origin.z))
	places[id / 2] = place
	object.places = places
	object.update_gizmos()


func _commit_handle(gizmo: EditorNode3DGizmo, id: int, _secondary: bool, before: Variant, is_cancelled: bool) -> void:
	var places: Array[Transform3D] = (gizmo.get_node_3d() as PCGObject).places.duplicate()
	places[id / 2] = before
	commit_property("Change where the object is used", gizmo.get_node_3d(), &"places", places, is_cancelled)
