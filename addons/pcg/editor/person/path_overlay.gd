@tool
extends "res://addons/pcg/editor/city_overlay.gd"
## Draws a person's ways of one day over the city, coloured by the time of the day.

const TaskColors := preload("res://addons/pcg/editor/person/task_colors.gd")
const HEIGHT := 0.5 ## metres above the ground
const WIDTH := 0.9 ## metres


## `ways`: dictionaries with `points` (of the world) and `hour`.
func show_ways(city: PCGCity, ways: Array[Dictionary]) -> void:
	hide()
	var mesh := ImmediateMesh.new()
	for way: Dictionary in ways:
		_add_ribbon(mesh, way["points"], TaskColors.of_hour(way["hour"]), city.global_transform.affine_inverse())
	if mesh.get_surface_count() == 0:
		return
	var node := MeshInstance3D.new()
	node.mesh = mesh
	node.material_override = _make_material()
	lay(city, node)


static func _add_ribbon(mesh: ImmediateMesh, points: PackedVector3Array, color: Color, to_city: Transform3D) -> void:
	if points.size() < 2:
		return
	mesh.surface_begin(Mesh.PRIMITIVE_TRIANGLES)
	mesh.surface_set_color(color)
	for index: int in points.size() - 1:
		var from: Vector3 = to_city * points[index] + Vector3.UP * HEIGHT
		var to: Vector3 = to_city * points[index + 1] + Vector3.UP * HEIGHT
		var right: Vector3 = (to - from).cross(Vector3.UP).normalized() * WIDTH # so that the way there and the way back lie side by side
		for corner: Vector3 in [from, to, to + right, from, to + right, from + right]:
			mesh.surface_set_color(color)
			mesh.surface_add_vertex(corner)
	mesh.surface_end()


static func _make_material() -> StandardMaterial3D:
	var material := StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.vertex_color_use_as_albedo = true
	material.no_depth_test = true
	material.cull_mode = BaseMaterial3D.CULL_DISABLED
	material.render_priority = 1
	return material
