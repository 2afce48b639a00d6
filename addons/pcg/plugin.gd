@tool
extends EditorPlugin
## Switches the addon on. No native class is named here: without its library this script must still parse, and say so.

const LibraryCheck := preload("res://addons/pcg/editor/library_check.gd")
const AUTHORING := "res://addons/pcg/editor/authoring.gd" # names native classes, so it is loaded only where they are

var _authoring: Node


func _enter_tree() -> void:
	var problem: String = LibraryCheck.find_problem()
	if problem.is_empty():
		_authoring = (load(AUTHORING) as GDScript).new()
		add_child(_authoring)
		_authoring.call("open", self)
		return
	push_error(problem)
	if DisplayServer.get_name() != "headless":
		_show(problem)


func _exit_tree() -> void:
	if _authoring:
		_authoring.call("close")
		_authoring.queue_free()
		_authoring = null


func _show(problem: String) -> void:
	var dialog := AcceptDialog.new()
	dialog.title = "PCG for Godot"
	dialog.dialog_text = problem
	dialog.dialog_autowrap = true
	dialog.min_size = Vector2i(560, 0)
	dialog.visibility_changed.connect(func() -> void:
		if not dialog.visible:
			dialog.queue_free())
	EditorInterface.popup_dialog_centered(dialog)


## The node that holds what the addon adds to the editor; null without the native library.
func get_authoring() -> Node:
	return _authoring


func _handles(object: Object) -> bool:
	return _authoring != null and object.is_class(&"PCGRuleSet")


func _edit(object: Object) -> void:
	if _authoring and object:
		_authoring.call("edit_rules", object)


func _forward_3d_gui_input(camera: Camera3D, event: InputEvent) -> int:
	return _authoring.call("take_viewport_input", camera, event) if _authoring else AFTER_GUI_INPUT_PASS


func _get_unsaved_status(for_scene: String) -> String:
	return _authoring.call("get_unsaved_status", for_scene) if _authoring else ""


func _save_external_data() -> void:
	if _authoring:
		_authoring.call("save")


# Closing the editor asks about what was not saved; switching the addon off does not.
func _disable_plugin() -> void:
	if _authoring:
		_authoring.call("keep_unsaved")


func _get_window_layout(layout: ConfigFile) -> void:
	if _authoring:
		_authoring.call("keep_layout", layout)


func _set_window_layout(layout: ConfigFile) -> void:
	if _authoring:
		_authoring.call("restore_layout", layout)
