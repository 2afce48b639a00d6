@tool
extends Node
## What a click in the 3D viewport means: a building stands for its lot, and while somebody picks, the nearest person is chosen.

const PersonTab := preload("res://addons/pcg/editor/person/person_tab.gd")
const CLICK_FRAMES := 3 ## within which the editor tells of the selection that a click made, however long they take

var _person_tab: PersonTab
var _last_click := -CLICK_FRAMES


func open(person_tab: PersonTab) -> void:
	_person_tab = person_tab
	EditorInterface.get_selection().selection_changed.connect(_on_selection_changed)


## What the editor's viewport is told to do with an event.
func take(camera: Camera3D, event: InputEvent) -> int:
	var button: InputEventMouseButton = event as InputEventMouseButton
	if button == null or button.button_index != MOUSE_BUTTON_LEFT:
		return EditorPlugin.AFTER_GUI_INPUT_PASS
	_last_click = Engine.get_process_frames()
	if button.pressed and _person_tab.is_picking() and _person_tab.pick(camera, button.position):
		return EditorPlugin.AFTER_GUI_INPUT_STOP
	return EditorPlugin.AFTER_GUI_INPUT_PASS


# In the scene dock the geometry itself can still be selected.
func _on_selection_changed() -> void:
	var selected: Array[Node] = EditorInterface.get_selection().get_selected_nodes()
	var is_click: bool = Engine.get_process_frames() - _last_click < CLICK_FRAMES
	if is_click and selected.size() == 1 and selected[0] is GeometryInstance3D and selected[0].get_parent() is PCGLot:
		_select.call_deferred(selected[0].get_parent())


func _select(lot: PCGLot) -> void:
	EditorInterface.get_selection().clear()
	EditorInterface.get_selection().add_node(lot)
