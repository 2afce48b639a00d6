@tool
extends EditorNode3DGizmoPlugin
## What the gizmos of the addon's nodes share: colours by type, points under the mouse, and undo.

var undo: EditorUndoRedoManager
var _materials: Dictionary[Color, StandardMaterial3D] = {}


func _init(manager: EditorUndoRedoManager = null) -> void:
	undo = manager
	create_handle_material("handles")


## One colour for each type, the same in every session.
static func color_of(type: String) -> Color:
	return Color.from_hsv((type.hash() % 997) / 997.0, 0.65, 0.95)


func lines_material(color: Color) -> StandardMaterial3D:
	if not _materials.has(color):
		var material := StandardMaterial3D.new()
		material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
		material.albedo_color = color
		material.no_depth_test = true
		_materials[color] = material
	return _materials[color]


## Where the mouse points on the level plane through `through`, all in the node's frame; `through` if it points past it.
static func point_on_level(node: Node3D, camera: Camera3D, mouse: Vector2, through: Vector3) -> Vector3:
	var frame: Transform3D = node.global_transform
	var plane := Plane((frame.basis * Vector3.UP).normalized(), frame * through)
	var hit: Variant = plane.intersects_ray(camera.project_ray_origin(mouse), camera.project_ray_normal(mouse))
	return frame.affine_inverse() * (hit as Vector3) if hit != null else through


## How high the mouse points above `foot`, in the node's frame.
static func height_above(node: Node3D, camera: Camera3D, mouse: Vector2, foot: Vector3) -> float:
	var frame: Transform3D = node.global_transform
	var at: Vector3 = frame * foot
	var towards: Vector3 = camera.global_position - at
	towards.y = 0.0
	var hit: Variant = Plane(towards.normalized(), at).intersects_ray(camera.project_ray_origin(mouse), camera.project_ray_normal(mouse))
	return (frame.affine_inverse() * (hit as Vector3)).y - foot.y if hit != null else 0.0


## Ends a drag of a handle: the property has its new value already.
func commit_property(title: String, node: Node, property: StringName, before: Variant, is_cancelled: bool) -> void:
	if is_cancelled:
		node.set(property, before)
		return
	undo.create_action(title, UndoRedo.MERGE_DISABLE, node)
	undo.add_do_property(node, property, node.get(property))
	undo.add_undo_property(node, property, before)
	undo.add_do_method(node, &"update_gizmos")
	undo.add_undo_method(node, &"update_gizmos")
	undo.commit_action(false)
	(node as Node3D).update_gizmos()
