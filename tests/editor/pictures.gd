@tool
extends Node
## Takes pictures of the editor with the addon at work, for the documentation and for whoever looks whether all is in its place.
##
##     xvfb-run -a godot --editor --path build/editor_project --rendering-driver opengl3 -- --pictures FOLDER

const Authoring := preload("res://addons/pcg/editor/authoring.gd")

var authoring: Authoring
var folder := ""


func run(of: Authoring, into: String) -> void:
	authoring = of
	folder = into
	await _wait(60)
	await _take_rules()


func _take_rules() -> void:
	authoring.show_place("res://rules/cga/house.cga", 0)
	var edit: CodeEdit = authoring.rules.get_current()
	edit.set_line(2, edit.get_line(2) + "s")
	edit.call("check")
	edit.call("go_to", 12, 8)
	await _wait(30)
	await _save("rules")
	edit.undo()
	edit.tag_saved_version()


func _wait(frames: int) -> void:
	for frame: int in frames:
		await get_tree().process_frame


func _save(picture: String) -> void:
	await RenderingServer.frame_post_draw
	get_tree().root.get_texture().get_image().save_png(folder.path_join(picture + ".png"))
