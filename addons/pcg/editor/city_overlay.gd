@tool
extends RefCounted
## Something that is drawn over a city while somebody looks. The node is not part of the scene: it is never saved.

var _node: MeshInstance3D


## Adds `node` to the city, in place of what was shown before.
func lay(city: PCGCity, node: MeshInstance3D) -> void:
	hide()
	_node = node
	_node.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	city.add_child(_node, false, Node.INTERNAL_MODE_BACK)


func hide() -> void:
	if is_instance_valid(_node):
		_node.queue_free()
	_node = null


func is_shown() -> bool:
	return is_instance_valid(_node)
