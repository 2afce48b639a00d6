@tool
extends "res://addons/pcg/editor/gizmos/gizmo_plugin.gd"
## A lot's outline in the colour of its type, and those of its courtyards.


func _get_gizmo_name() -> String:
	return "PCGLot"


func _has_gizmo(node: Node3D) -> bool:
	return node is PCGLot


func _redraw(gizmo: EditorNode3DGizmo) -> void:
	gizmo.clear()
	var lot: PCGLot = gizmo.get_node_3d() as PCGLot
	var lines := PackedVector3Array()
	for loop: PackedVector3Array in [lot.polygon] + Array(lot.holes):
		for index: int in loop.size():
			lines.append_array([loop[index], loop[(index + 1) % loop.size()]])
	if not lines.is_empty():
		gizmo.add_lines(lines, lines_material(color_of(lot.type)))
