@tool
extends "res://addons/pcg/editor/gizmos/gizmo_plugin.gd"
## A zone's prism. Handles at its corners move them, the one in the middle sets the height.

const LEAST_HEIGHT := 0.1 ## metres


func _get_gizmo_name() -> String:
	return "PCGZone"


func _has_gizmo(node: Node3D) -> bool:
	return node is PCGZone


func _redraw(gizmo: EditorNode3DGizmo) -> void:
	gizmo.clear()
	var zone: PCGZone = gizmo.get_node_3d() as PCGZone
	if zone.polygon.size() < 3:
		return
	var lines := PackedVector3Array()
	var top := Vector3(0.0, zone.height, 0.0)
	for index: int in zone.polygon.size():
		var from: Vector3 = zone.polygon[index]
		var to: Vector3 = zone.polygon[(index + 1) % zone.polygon.size()]
		lines.append_array([from, to, from + top, to + top, from, from + top])
	gizmo.add_lines(lines, lines_material(color_of(zone.type)))
	gizmo.add_collision_segments(lines)
	var handles: PackedVector3Array = zone.polygon.duplicate()
	handles.append(_middle(zone) + top)
	gizmo.add_handles(handles, get_material("handles", gizmo), PackedInt32Array(range(handles.size())))


static func _middle(zone: PCGZone) -> Vector3:
	var sum := Vector3.ZERO
	for corner: Vector3 in zone.polygon:
		sum += corner
	return sum / zone.polygon.size()


static func _is_height(zone: PCGZone, id: int) -> bool:
	return id == zone.polygon.size()


func _get_handle_name(gizmo: EditorNode3DGizmo, id: int, _secondary: bool) -> String:
	return "height" if _is_height(gizmo.get_node_3d() as PCGZone, id) else "corner %d" % id


func _get_handle_value(gizmo: EditorNode3DGizmo, id: int, _secondary: bool) -> Variant:
	var zone: PCGZone = gizmo.get_node_3d() as PCGZone
	return zone.height if _is_height(zone, id) else zone.polygon[id] # the engine shows it below the viewport


func _set_handle(gizmo: EditorNode3DGizmo, id: int, _secondary: bool, camera: Camera3D, mouse: Vector2) -> void:
	var zone: PCGZone = gizmo.get_node_3d() as PCGZone
	if _is_height(zone, id):
		zone.height = maxf(LEAST_HEIGHT, height_above(zone, camera, mouse, _middle(zone)))
	else:
		var polygon: PackedVector3Array = zone.polygon
		polygon[id] = point_on_level(zone, camera, mouse, polygon[id])
		zone.polygon = polygon
	zone.update_gizmos()


func _commit_handle(gizmo: EditorNode3DGizmo, id: int, _secondary: bool, before: Variant, is_cancelled: bool) -> void:
	var zone: PCGZone = gizmo.get_node_3d() as PCGZone
	if _is_height(zone, id):
		commit_property("Change the zone", zone, &"height", before, is_cancelled)
		return
	var polygon: PackedVector3Array = zone.polygon
	polygon[id] = before
	commit_property("Change the zone", zone, &"polygon", polygon, is_cancelled)
