@tool
extends "res://addons/pcg/editor/gizmos/gizmo_plugin.gd"
## A door with an arrow the way it faces, its type and capacity beside it. The handle at the arrow's tip turns it. Red: nobody can reach it.

const WIDTH := 1.0 ## metres
const HEIGHT := 2.1
const ARROW := 1.5
const TEXT_SIZE := 0.008 ## metres a pixel of the letters
const TEXT_HEIGHT := 36 ## pixels
const FOR_NOBODY := Color(1.0, 0.15, 0.1)

var _texts: Dictionary[String, TextMesh] = {}


func _get_gizmo_name() -> String:
	return "PCGEntrance"


func _has_gizmo(node: Node3D) -> bool:
	return node is PCGEntrance


func _redraw(gizmo: EditorNode3DGizmo) -> void:
	gizmo.clear()
	var entrance: PCGEntrance = gizmo.get_node_3d() as PCGEntrance
	var color: Color = color_of(entrance.type) if entrance.is_reachable() else FOR_NOBODY
	gizmo.add_lines(_make_lines(), lines_material(color))
	gizmo.add_collision_segments(_make_lines())
	gizmo.add_mesh(_text("%s, %d" % [entrance.type, entrance.capacity]), lines_material(color), Transform3D(Basis(), Vector3(0.0, HEIGHT + 0.15, 0.0)))
	gizmo.add_handles(PackedVector3Array([Vector3(0.0, 0.1, ARROW)]), get_material("handles", gizmo), PackedInt32Array([0]))


static func _make_lines() -> PackedVector3Array:
	var side: float = WIDTH / 2.0
	var tip := Vector3(0.0, 0.1, ARROW)
	return PackedVector3Array([Vector3(-side, 0.0, 0.0), Vector3(-side, HEIGHT, 0.0), Vector3(-side, HEIGHT, 0.0), Vector3(side, HEIGHT, 0.0),
			Vector3(side, HEIGHT, 0.0), Vector3(side, 0.0, 0.0), Vector3(0.0, 0.1, 0.0), tip, tip, tip + Vector3(-0.25, 0.0, -0.35), tip,
			tip + Vector3(0.25, 0.0, -0.35)])


func _text(told: String) -> TextMesh:
	if not _texts.has(told):
		var mesh := TextMesh.new()
		mesh.text = told
		mesh.font_size = TEXT_HEIGHT
		mesh.pixel_size = TEXT_SIZE
		mesh.depth = 0.0
		_texts[told] = mesh
	return _texts[told]


func _get_handle_name(_gizmo: EditorNode3DGizmo, _id: int, _secondary: bool) -> String:
	return "facing"


func _get_handle_value(gizmo: EditorNode3DGizmo, _id: int, _secondary: bool) -> Variant:
	return gizmo.get_node_3d().rotation


func _set_handle(gizmo: EditorNode3DGizmo, _id: int, _secondary: bool, camera: Camera3D, mouse: Vector2) -> void:
	var node: Node3D = gizmo.get_node_3d()
	var to: Vector3 = point_on_level(node, camera, mouse, Vector3(0.0, 0.1, 0.0))
	if Vector2(to.x, to.z).length() > 0.05:
		node.rotate_object_local(Vector3.UP, atan2(to.x, to.z))


func _commit_handle(gizmo: EditorNode3DGizmo, _id: int, _secondary: bool, before: Variant, is_cancelled: bool) -> void:
	commit_property("Turn the entrance", gizmo.get_node_3d(), &"rotation", before, is_cancelled)
