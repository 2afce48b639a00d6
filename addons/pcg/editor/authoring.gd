@tool
extends Node
## Everything that the addon puts into the editor. plugin.gd adds this node once the native library is known to be there.

const RulesDock := preload("res://addons/pcg/editor/rules/rules_dock.gd")
const PCGDock := preload("res://addons/pcg/editor/pcg_dock.gd")
const SceneContext := preload("res://addons/pcg/editor/scene_context.gd")
const LoadedRules := preload("res://addons/pcg/editor/rules/loaded_rules.gd")
const ViewportClicks := preload("res://addons/pcg/editor/viewport_clicks.gd")
const DOCK_SCENE := preload("res://addons/pcg/editor/pcg_dock.tscn")
const RULES_SCENE := preload("res://addons/pcg/editor/rules/rules_dock.tscn")
const GIZMOS: PackedStringArray = ["lot", "entrance", "zone", "object"]
const LAYOUT_SECTION := "pcg"

var plugin: EditorPlugin
var context: SceneContext
var dock: PCGDock
var rules: RulesDock
var clicks := ViewportClicks.new()
var gizmos: Array[EditorNode3DGizmoPlugin] = []
var _docks: Array[EditorDock] = []


func open(of: EditorPlugin) -> void:
	plugin = of
	rules = RULES_SCENE.instantiate()
	context = SceneContext.new()
	add_child(context)
	context.open(plugin)
	plugin.set_input_event_forwarding_always_enabled()
	for gizmo: String in GIZMOS:
		gizmos.append((load("res://addons/pcg/editor/gizmos/%s_gizmo.gd" % gizmo) as GDScript).new(plugin.get_undo_redo()))
		plugin.add_node_3d_gizmo_plugin(gizmos[-1])
	dock = DOCK_SCENE.instantiate()
	rules.count_users = func(path: String) -> int: return context.get_users(path).size()
	EditorInterface.get_resource_filesystem().filesystem_changed.connect(_take_icons)
	EditorInterface.get_resource_filesystem().resources_reload.connect(_on_files_written)
	EditorInterface.get_file_system_dock().files_moved.connect(_on_file_moved)
	EditorInterface.get_file_system_dock().file_removed.connect(rules.follow_removal)
	_add_dock(dock, "PCG", "pcg", "PCGCity", EditorDock.DOCK_SLOT_RIGHT_UL, EditorDock.DOCK_LAYOUT_VERTICAL | EditorDock.DOCK_LAYOUT_FLOATING)
	_add_dock(rules, "PCG Rules", "pcg_rules", "PCGRuleSet", EditorDock.DOCK_SLOT_BOTTOM, EditorDock.DOCK_LAYOUT_HORIZONTAL | EditorDock.DOCK_LAYOUT_FLOATING)
	dock.open(context)
	add_child(clicks)
	clicks.open(dock.person_tab)
	dock.place_wanted.connect(show_place)
	rules.rules_checked.connect(dock.take_rule_diagnostics)
	rules.rules_closed.connect(dock.forget_rule_diagnostics)
	rules.rules_saved.connect(_on_rules_saved)
	rules.regeneration_wanted.connect(_on_regeneration_wanted)
	rules.take_back_unsaved()


func _add_dock(content: Control, title: String, key: String, icon: String, slot: EditorDock.DockSlot, layouts: int) -> void:
	var holder := EditorDock.new()
	holder.title = title
	holder.layout_key = key
	holder.default_slot = slot
	holder.available_layouts = layouts
	holder.set_meta(&"icon", icon)
	holder.add_child(content)
	plugin.add_dock(holder)
	_docks.append(holder)
	_take_icons()


# When the addon is new, its pictures are imported only after it was switched on.
func _take_icons() -> void:
	for holder: EditorDock in _docks:
		var path: String = "res://addons/pcg/icons/%s.svg" % holder.get_meta(&"icon")
		if holder.dock_icon == null and ResourceLoader.exists(path):
			holder.dock_icon = load(path)


func close() -> void:
	EditorInterface.get_resource_filesystem().filesystem_changed.disconnect(_take_icons)
	EditorInterface.get_resource_filesystem().resources_reload.disconnect(_on_files_written)
	EditorInterface.get_file_system_dock().files_moved.disconnect(_on_file_moved)
	EditorInterface.get_file_system_dock().file_removed.disconnect(rules.follow_removal)
	for gizmo: EditorNode3DGizmoPlugin in gizmos:
		plugin.remove_node_3d_gizmo_plugin(gizmo)
	gizmos.clear()
	for holder: EditorDock in _docks:
		plugin.remove_dock(holder)
		holder.free() # at once: what a city tells later must not reach pages whose context is gone
	_docks.clear()


## Shows the place that a message or an agenda entry is about.
func show_place(path: String, line: int, column: int = 1) -> void:
	if rules.open(path, line, column):
		(rules.get_parent() as EditorDock).make_visible()


# Whoever lives takes rules without errors over for the next day, without being asked.
func _on_rules_saved(path: String) -> void:
	if context.city:
		dock.city_tab.show_land_use()
	for citizens: CitizenManager in context.get_users(path).filter(func(node: Node) -> bool: return node is CitizenManager):
		if citizens.is_running() and not citizens.rules.has_errors():
			citizens.renew_agendas()


# Rules that are in memory do not follow their files by themselves.
func _on_files_written(paths: PackedStringArray) -> void:
	for path: String in paths:
		if LoadedRules.is_rule_file(path):
			LoadedRules.renew(path)
			_on_rules_saved(path)


func _on_file_moved(from: String, to: String) -> void:
	if LoadedRules.is_rule_file(to):
		LoadedRules.renew(to)
		rules.follow_move(from, to)


# Whoever uses the rules is made anew at once: cities, else those who live by them.
func _on_regeneration_wanted(path: String) -> void:
	for node: Node in context.get_users(path):
		if node is PCGCity:
			dock.city_tab.history.generate(node as PCGCity)
		else:
			dock.population_tab.live_on(node as CitizenManager)


func take_viewport_input(camera: Camera3D, event: InputEvent) -> int:
	context.viewport = camera.get_viewport()
	return clicks.take(camera, event)


func edit_rules(edited: Object) -> void:
	var path: String = (edited as PCGRuleSet).get_file()
	if not path.is_empty():
		show_place(path, 0)


func get_unsaved_status(for_scene: String) -> String:
	var unsaved: PackedStringArray = rules.get_unsaved_paths()
	return "" if not for_scene.is_empty() or unsaved.is_empty() else "Save changes to %s?" % ", ".join(unsaved)


func save() -> void:
	rules.save_all()


## Call before the addon is switched off.
func keep_unsaved() -> void:
	rules.keep_unsaved()


func keep_layout(layout: ConfigFile) -> void:
	layout.set_value(LAYOUT_SECTION, "open_rules", rules.get_open_paths())


func restore_layout(layout: ConfigFile) -> void:
	for path: String in layout.get_value(LAYOUT_SECTION, "open_rules", PackedStringArray()):
		if FileAccess.file_exists(path):
			rules.open(path)
