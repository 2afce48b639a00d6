@tool
extends RefCounted
## Draws where people were as colours on the city's ground. The node is not part of the scene: it is never saved.

const HEIGHT := 0.4 ## metres above the city's origin
const COLORS: Array[Color] = [Color(0.15, 0.3, 0.9, 0.35), Color(0.1, 0.8, 0.6, 0.6), Color(0.95, 0.85, 0.2, 0.8), Color(0.95, 0.2, 0.1, 0.9)]

var _node: MeshInstance3D


## `cells`: the cell (of `size` metres, in the city's frame) and how much there was.
func show_cells(city: PCGCity, cells: Dictionary[Vector2i, int], size: float) -> void:
	hide()
	if cells.is_empty():
		return
	var area := Rect2i(cells.keys()[0], Vector2i.ZERO)
	for cell: Vector2i in cells:
		area = area.expand(cell)
	area.size += Vector2i.ONE
	_node = MeshInstance3D.new()
	_node.mesh = _make_plane(Vector2(area.size) * size, _make_material(_paint(cells, area)))
	_node.position = Vector3((area.position.x + area.size.x / 2.0) * size, HEIGHT, (area.position.y + area.size.y / 2.0) * size)
	_node.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	city.add_child(_node, false, Node.INTERNAL_MODE_BACK)


func hide() -> void:
	if is_instance_valid(_node):
		_node.queue_free()
	_node = null


func is_shown() -> bool:
	return is_instance_valid(_node)


# The root of the part of the greatest: a few streets would outshine the rest else.
static func _paint(cells: Dictionary[Vector2i, int], area: Rect2i) -> Image:
	var gradient := Gradient.new()
	gradient.offsets = PackedFloat32Array([0.0, 0.33, 0.66, 1.0])
	gradient.colors = PackedColorArray(COLORS)
	var greatest: float = cells.values().max()
	var image := Image.create_empty(area.size.x, area.size.y, false, Image.FORMAT_RGBA8)
	for cell: Vector2i in cells:
		image.set_pixelv(cell - area.position, gradient.sample(sqrt(cells[cell] / greatest)))
	return image


static func _make_plane(size: Vector2, material: Material) -> PlaneMesh:
	var plane := PlaneMesh.new()
	plane.size = size
	plane.material = material
	return plane


static func _make_material(image: Image) -> StandardMaterial3D:
	var material := StandardMaterial3D.new()
	material.albedo_texture = ImageTexture.create_from_image(image)
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	material.no_depth_test = true
	material.cull_mode = BaseMaterial3D.CULL_DISABLED
	return material
