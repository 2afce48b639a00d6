@tool
extends "res://tests/godot/suite.gd"
## What every test of the editor extends: the addon as it stands in the editor, and how to wait.

const Authoring := preload("res://addons/pcg/editor/authoring.gd")


## The addon's part of the editor; null while it is disabled.
func get_authoring() -> Authoring:
	var found: Array[Node] = get_tree().root.find_children("*", "EditorPlugin", true, false)
	for node: Node in found:
		var script: Script = node.get_script()
		if script and script.resource_path == "res://addons/pcg/plugin.gd":
			return node.call("get_authoring")
	return null


func frames(count: int) -> void:
	for frame: int in count:
		await get_tree().process_frame


func write(path: String, text: String) -> String:
	DirAccess.make_dir_recursive_absolute(path.get_base_dir())
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.store_string(text)
	file.close()
	return path


## Does what a user's undo does: scripts cannot ask the engine's manager for it, which also tells of it.
func undo(object: Object) -> void:
	_history_of(object).undo()
	EditorInterface.get_editor_undo_redo().version_changed.emit()
	await frames(2)


func redo(object: Object) -> void:
	_history_of(object).redo()
	EditorInterface.get_editor_undo_redo().version_changed.emit()
	await frames(2)


static func _history_of(object: Object) -> UndoRedo:
	var manager: EditorUndoRedoManager = EditorInterface.get_editor_undo_redo()
	return manager.get_history_undo_redo(manager.get_object_history_id(object))
