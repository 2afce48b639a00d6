@tool
extends Node
## Everything that the addon puts into the editor. plugin.gd adds this node once the native library is known to be there.

const RulesDock := preload("res://addons/pcg/editor/rules/rules_dock.gd")
const RULES_SCENE := preload("res://addons/pcg/editor/rules/rules_dock.tscn")
const LAYOUT_SECTION := "pcg"

var plugin: EditorPlugin
var rules: RulesDock
var _docks: Array[EditorDock] = []


func open(of: EditorPlugin) -> void:
	plugin = of
	rules = RULES_SCENE.instantiate()
	EditorInterface.get_resource_filesystem().filesystem_changed.connect(_take_icons)
	_add_dock(rules, "PCG Rules", "pcg_rules", "PCGRuleSet", EditorDock.DOCK_SLOT_BOTTOM, EditorDock.DOCK_LAYOUT_HORIZONTAL | EditorDock.DOCK_LAYOUT_FLOATING)


func _add_dock(content: Control, title: String, key: String, icon: String, slot: EditorDock.DockSlot, layouts: int) -> void:
	var dock := EditorDock.new()
	dock.title = title
	dock.layout_key = key
	dock.default_slot = slot
	dock.available_layouts = layouts
	dock.set_meta(&"icon", icon)
	dock.add_child(content)
	plugin.add_dock(dock)
	_docks.append(dock)
	_take_icons()


# When the addon is new, its pictures are imported only after it was switched on.
func _take_icons() -> void:
	for dock: EditorDock in _docks:
		var path: String = "res://addons/pcg/icons/%s.svg" % dock.get_meta(&"icon")
		if dock.dock_icon == null and ResourceLoader.exists(path):
			dock.dock_icon = load(path)


func close() -> void:
	EditorInterface.get_resource_filesystem().filesystem_changed.disconnect(_take_icons)
	for dock: EditorDock in _docks:
		plugin.remove_dock(dock)
		dock.queue_free()
	_docks.clear()


## Shows the place that a message or an agenda entry is about.
func show_place(path: String, line: int, column: int = 1) -> void:
	if rules.open(path, line, column):
		(rules.get_parent() as EditorDock).make_visible()


func edit_rules(edited: Object) -> void:
	var path: String = (edited as PCGRuleSet).get_file()
	if not path.is_empty():
		show_place(path, 0)


func get_unsaved_status(for_scene: String) -> String:
	var unsaved: PackedStringArray = rules.get_unsaved_paths()
	return "" if not for_scene.is_empty() or unsaved.is_empty() else "Save changes to %s?" % ", ".join(unsaved)


func save() -> void:
	rules.save_all()


func keep_layout(layout: ConfigFile) -> void:
	layout.set_value(LAYOUT_SECTION, "open_rules", rules.get_open_paths())


func restore_layout(layout: ConfigFile) -> void:
	for path: String in layout.get_value(LAYOUT_SECTION, "open_rules", PackedStringArray()):
		if FileAccess.file_exists(path):
			rules.open(path)
