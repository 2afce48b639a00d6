@tool
extends EditorPlugin
## Switches the addon on. No native class is named here: without its library this script must still parse, and say so.

const LibraryCheck := preload("res://addons/pcg/editor/library_check.gd")


func _enter_tree() -> void:
	var problem: String = LibraryCheck.find_problem()
	if problem.is_empty():
		return
	push_error(problem)
	if DisplayServer.get_name() != "headless":
		_show(problem)


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
