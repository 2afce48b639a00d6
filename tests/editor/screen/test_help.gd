@tool
extends "res://tests/editor/screen/screen_suite.gd"
## The editor's own help: F1, and a page for every class.


func _find_dialog() -> Window:
	var found: Array[Node] = get_tree().root.find_children("*", "EditorHelpSearch", true, false).filter(func(dialog: Window) -> bool: return dialog.visible)
	return found[0] if not found.is_empty() else null


## The page of help that is seen.
func _find_page() -> String:
	for page: Node in EditorInterface.get_script_editor().find_children("*", "EditorHelp", true, false):
		if (page as Control).is_visible_in_tree():
			return (page.find_children("*", "RichTextLabel", true, false)[0] as RichTextLabel).get_parsed_text()
	return ""


func test_every_class_has_its_page() -> void:
	RenderingServer.render_loop_enabled = false
	if not EditorInterface.is_plugin_enabled("pcg"):
		EditorInterface.set_plugin_enabled("pcg", true)
	await frames(5)
	await press(KEY_F1)
	check(await wait_until(func() -> bool: return _find_dialog() != null, 5.0), "F1 asks what to look for")
	if _find_dialog():
		_find_dialog().hide() # unasked: what the engine has found once it does not free when it ends
	await frames(3)
	for kind: String in ClassDB.get_class_list():
		var is_ours: bool = kind.begins_with("PCG") or kind == "CitizenManager"
		if is_ours and (ClassDB.is_parent_class(kind, "Node") or ClassDB.is_parent_class(kind, "Resource")):
			EditorInterface.get_script_editor().goto_help("class_name:" + kind)
			check(await wait_until(func() -> bool: return _find_page().contains(kind), 5.0), "%s has a page" % kind)
			check(not _find_page().contains("There is currently no description"), "%s: nothing is left without a description" % kind)
	EditorInterface.set_main_screen_editor("3D")
