@tool
extends "res://tests/editor/editor_suite.gd"
## What the addon's nodes look like in the editor: their icons, and handles in the viewport: dragged, undone.

const ICONS := "res://addons/pcg/icons"
const THEMED: PackedStringArray = ["#e0e0e0", "#fc7f7f"] ## colours of the engine's icons, which it makes dark for a light theme

var _root: Node3D
var _camera: Camera3D


func before_each() -> void:
	EditorInterface.close_scene()
	_root = Node3D.new()
	EditorInterface.add_root_node(_root)
	_camera = Camera3D.new()
	_root.add_child(_camera)
	_camera.look_at_from_position(Vector3(0.0, 20.0, 20.0), Vector3.ZERO)
	await frames(2)


func after_each() -> void:
	EditorInterface.close_scene()
	await frames(2)


func _add(node: Node3D) -> EditorNode3DGizmo:
	_root.add_child(node)
	node.owner = _root
	await frames(2)
	for gizmo: Node3DGizmo in node.get_gizmos():
		var plugin: EditorNode3DGizmoPlugin = (gizmo as EditorNode3DGizmo).get_plugin()
		if plugin in get_authoring().gizmos:
			return gizmo as EditorNode3DGizmo
	return null


func _drag(gizmo: EditorNode3DGizmo, handle: int, to: Vector3) -> void:
	var plugin: EditorNode3DGizmoPlugin = gizmo.get_plugin()
	var before: Variant = plugin._get_handle_value(gizmo, handle, false)
	plugin._set_handle(gizmo, handle, false, _camera, _camera.unproject_position(to))
	plugin._commit_handle(gizmo, handle, false, before, false)


func test_a_corner_and_the_height_of_a_zone_are_dragged_and_undone() -> void:
	var zone := PCGZone.new()
	zone.type = "park"
	zone.polygon = PackedVector3Array([Vector3(-2, 0, -2), Vector3(-2, 0, 2), Vector3(2, 0, 2), Vector3(2, 0, -2)])
	var gizmo: EditorNode3DGizmo = await _add(zone)
	check(gizmo != null, "a zone has a gizmo")
	check_equal(gizmo.get_plugin()._get_handle_value(gizmo, 2, false), Vector3(2, 0, 2), "the engine shows the one corner")
	_drag(gizmo, 2, Vector3(5, 0, 4))
	check(zone.polygon[2].distance_to(Vector3(5, 0, 4)) < 0.1, "the corner follows: %s" % zone.polygon[2])
	await undo(zone)
	check_equal(zone.polygon[2], Vector3(2, 0, 2), "and goes back")
	var height: float = zone.height
	_drag(gizmo, 4, Vector3(0, 6, 0))
	check_near(zone.height, 6.0, 0.1, "the height follows")
	await undo(zone)
	check_near(zone.height, height, 1e-6, "and goes back")


func test_an_entrance_turns_by_its_arrow() -> void:
	var entrance := PCGEntrance.new()
	entrance.type = "house"
	var gizmo: EditorNode3DGizmo = await _add(entrance)
	_drag(gizmo, 0, Vector3(3, 0.1, 0))
	check((entrance.basis.z - Vector3.RIGHT).length() < 0.05, "it faces where the mouse is: %s" % entrance.basis.z)
	await undo(entrance)
	check((entrance.basis.z - Vector3.BACK).length() < 1e-4, "and back")


func test_a_place_of_an_object_moves_and_turns() -> void:
	var bench := PCGObject.new()
	bench.type = "bench"
	bench.places = [Transform3D(Basis(), Vector3(0, 0.5, 0.4))]
	var gizmo: EditorNode3DGizmo = await _add(bench)
	_drag(gizmo, 0, Vector3(1, 0.5, 1))
	check((bench.places[0] as Transform3D).origin.distance_to(Vector3(1, 0.5, 1)) < 0.1, "it moves: %s" % [bench.places])
	_drag(gizmo, 1, Vector3(3, 0.5, 1))
	check(((bench.places[0] as Transform3D).basis.z - Vector3.RIGHT).length() < 0.1, "it turns")
	await undo(bench)
	await undo(bench)
	check_equal((bench.places[0] as Transform3D).origin, Vector3(0, 0.5, 0.4), "and back")


func test_every_class_has_an_icon() -> void:
	for name: String in ClassDB.get_class_list():
		if (name.begins_with("PCG") or name == "CitizenManager") and ClassDB.can_instantiate(name) and not name.ends_with("Loader") \
				and not name.ends_with("Saver") and not name.ends_with("Probe"):
			check(FileAccess.file_exists("res://addons/pcg/icons/%s.svg" % name), "%s has an icon" % name)


func test_icons_are_seen_on_light_and_on_dark_ground() -> void:
	var colors := RegEx.create_from_string("#[0-9a-f]{6}")
	for file: String in DirAccess.get_files_at(ICONS):
		if file.get_extension() == "svg":
			for color: RegExMatch in colors.search_all(FileAccess.get_file_as_string(ICONS.path_join(file))):
				check(color.get_string() in THEMED, "%s: %s changes with the editor's theme" % [file, color.get_string()])
		if file.get_extension() == "import":
			var settings := ConfigFile.new()
			settings.load(ICONS.path_join(file))
			check(settings.get_value("params", "editor/convert_colors_with_editor_theme"), "%s is imported so" % file)
