class_name DemoHeatLayer
extends MeshInstance3D
## Where people spent their time since the day began, drawn on the ground.

const SECONDS_BETWEEN_PICTURES := 1.0
const HEIGHT := 0.06 ## metres above the ground

@export var citizens: CitizenManager

var group := "" ## everybody, or "children", "adults", "elders"
var _age := INF ## of the picture, in seconds
var _texture: ImageTexture


func _ready() -> void:
	mesh = PlaneMesh.new()
	var material := StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	material.albedo_color = Color(1.0, 1.0, 1.0, 0.85)
	material.texture_filter = BaseMaterial3D.TEXTURE_FILTER_LINEAR
	material.render_priority = -1
	material_override = material
	cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	hide()


## "off", "all" or one of the groups.
func choose(choice: String) -> void:
	visible = choice != "off"
	group = "" if choice == "off" or choice == "all" else choice
	_age = INF


func _process(delta: float) -> void:
	_age += delta
	if visible and _age > SECONDS_BETWEEN_PICTURES and citizens.is_running():
		_age = 0.0
		draw()


func draw() -> void:
	var image: Image = citizens.get_heat_image(group)
	var area: Rect2 = citizens.get_heat_area()
	if image == null:
		return
	if _texture == null or _texture.get_size() != Vector2(image.get_size()):
		_texture = ImageTexture.create_from_image(image)
		(material_override as StandardMaterial3D).albedo_texture = _texture
	else:
		_texture.update(image)
	(mesh as PlaneMesh).size = area.size
	var middle: Vector2 = area.get_center()
	global_transform = citizens.city.global_transform * Transform3D(Basis(), Vector3(middle.x, HEIGHT, middle.y))
