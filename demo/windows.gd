class_name DemoWindows
extends Node
## Lights windows in the evening: the material of panes is swapped for a shader that lights each with its own chance by the hour. No lamp is needed.

const PANE_ROUGHNESS := 0.15 ## what the plugin makes of glass (CityMaterials)

@export var city: PCGCity

var _material := ShaderMaterial.new()


func _ready() -> void:
	_material.shader = preload("res://demo/windows.gdshader")
	city.city_generated.connect(func(_is_good: bool) -> void: adopt_panes())


## Swaps the material of all panes of the city.
func adopt_panes() -> int:
	var count := 0
	for node: Node in city.find_children("*", "MeshInstance3D", true, false):
		var mesh := (node as MeshInstance3D).mesh as ArrayMesh
		for surface: int in mesh.get_surface_count() if mesh != null else 0:
			if _is_pane(mesh.surface_get_material(surface) as StandardMaterial3D):
				mesh.surface_set_material(surface, _material)
				count += 1
	return count


func _is_pane(material: StandardMaterial3D) -> bool:
	return material != null and absf(material.roughness - PANE_ROUGHNESS) < 0.01 and material.albedo_texture == null \
			and material.transparency == BaseMaterial3D.TRANSPARENCY_DISABLED


## `hour` of the day, 0 to 24: dark by day, most lit at nine in the evening, few after midnight.
func show_hour(hour: float) -> void:
	var share: float = smoothstep(16.5, 20.5, hour) - 0.85 * smoothstep(21.5, 24.0, hour)
	if hour < 9.0:
		share = 0.15 * smoothstep(4.0, 0.0, hour) + 0.45 * smoothstep(5.0, 6.5, hour) * smoothstep(8.0, 7.0, hour)
	_material.set_shader_parameter(&"share_lit", share * 0.45)
	_material.set_shader_parameter(&"strength", 1.0 - 0.75 * DemoSun.daylight_at(hour))
