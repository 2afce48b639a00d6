@tool
extends MeshInstance3D
## Where people of a [CitizenManager] that records lives were outdoors, drawn on the ground of their city.

const HEIGHT := 0.06 ## metres above the city's origin

var picture: Image ## as it was drawn last
var _texture: ImageTexture


func _init() -> void:
	mesh = PlaneMesh.new()
	var material := StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	material.albedo_color = Color(1.0, 1.0, 1.0, 0.85)
	material.texture_filter = BaseMaterial3D.TEXTURE_FILTER_LINEAR
	material.render_priority = -1
	material_override = material
	cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF


## Group and hour as [method CitizenManager.get_heat_image] takes them. False if no lives are recorded.
func show_heat(citizens: CitizenManager, group: String = "", hour: int = -1) -> bool:
	picture = citizens.get_heat_image(group, hour)
	if picture == null:
		return false
	if _texture == null or _texture.get_size() != Vector2(picture.get_size()):
		_texture = ImageTexture.create_from_image(picture)
		(material_override as StandardMaterial3D).albedo_texture = _texture
	else:
		_texture.update(picture)
	var area: Rect2 = citizens.get_heat_area()
	(mesh as PlaneMesh).size = area.size
	var middle: Vector2 = area.get_center()
	global_transform = citizens.city.global_transform * Transform3D(Basis(), Vector3(middle.x, HEIGHT, middle.y))
	return true
