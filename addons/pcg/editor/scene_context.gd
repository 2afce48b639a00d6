@tool
extends Node
## What the docks are about: the city and the citizens of the edited scene, and the person that somebody looks at.

const LoadedRules := preload("res://addons/pcg/editor/rules/loaded_rules.gd")
const CityStarter := preload("res://addons/pcg/editor/city/city_starter.gd")

## The city, the citizens or the scene are others than before.
signal changed
signal person_chosen(person: int)

var plugin: EditorPlugin
var city: PCGCity:
	get:
		return instance_from_id(_city_id) as PCGCity if is_instance_id_valid(_city_id) else null
var citizens: CitizenManager:
	get:
		return instance_from_id(_citizens_id) as CitizenManager if is_instance_id_valid(_citizens_id) else null
var person := -1
var viewport: Viewport ## of the editor, that somebody looked into last
var _household_types := PackedStringArray() # by row of the table
var _table: PCGHouseholdTable
var _shipped_streets: PCGRuleSet # of cities that name none
var _city_id := 0
var _citizens_id := 0


func open(of: EditorPlugin) -> void:
	plugin = of
	viewport = EditorInterface.get_editor_viewport_3d(0)
	plugin.scene_changed.connect(_on_scene_changed)
	EditorInterface.get_selection().selection_changed.connect(refresh)
	get_tree().node_added.connect(_on_node_changed)
	get_tree().node_removed.connect(_on_node_changed)
	refresh() # a scene may be open already when the addon is switched on


# The scene's own viewport is not the one that people are seen in.
func _process(_delta: float) -> void:
	var view: PCGAgentView = citizens.get_agent_view() if citizens else null
	if view:
		view.camera = viewport.get_camera_3d()


func get_undo() -> EditorUndoRedoManager:
	return plugin.get_undo_redo()


## The person whose week is shown; -1: nobody.
func choose_person(chosen: int) -> void:
	person = chosen
	person_chosen.emit(person)


func get_cities() -> Array[PCGCity]:
	var found: Array[PCGCity] = []
	for node: Node in _find_all("PCGCity"):
		found.append(node)
	return found


## A building by its number: `type` and `position` of its first entrance; empty if it has none.
func get_building(id: int) -> Dictionary:
	return city.get_building(id) if city and id >= 0 and id < city.get_building_count() else {}


## What people call a building.
func get_building_text(id: int) -> String:
	var building: Dictionary = get_building(id)
	return "%s %d" % [building["type"], id] if not building.is_empty() else "building %d" % id


func has_person() -> bool:
	return citizens != null and citizens.has_person(person)


## Persons that were generated.
func count_persons() -> int:
	return citizens.count_persons() if citizens else 0


## The table's words for the household of a person as CitizenManager.get_person() tells it; empty for one that stands in no table.
func get_household_type(told: Dictionary) -> String:
	if citizens.household_table != _table:
		if _table:
			_table.changed.disconnect(_read_household_types)
		_table = citizens.household_table
		if _table:
			_table.changed.connect(_read_household_types)
		_read_household_types()
	var row: int = told["household_row"]
	return _household_types[row] if row >= 0 and row < _household_types.size() else ""


func _read_household_types() -> void:
	_household_types.clear()
	for row: Dictionary in _table.get_households() if _table else ([] as Array[Dictionary]):
		_household_types.append(row["descriptor"])


## Whoever lives in a city leaves it in time: it is about to be made anew.
func stop_life_in(left_city: PCGCity) -> void:
	for other: CitizenManager in _find_all("CitizenManager"):
		if other.city == left_city:
			other.stop()


func show_city(shown: PCGCity) -> void:
	_city_id = shown.get_instance_id() if shown else 0
	refresh()


## Looks again for what the docks show: what is selected, else what was shown, else the first in the scene.
func refresh() -> void:
	var new_city: PCGCity = _pick("PCGCity", city) as PCGCity
	var new_citizens: CitizenManager = _pick("CitizenManager", citizens) as CitizenManager
	if EditorInterface.get_selection().get_selected_nodes().any(func(node: Node) -> bool: return node is CitizenManager) and new_citizens.city:
		new_city = new_citizens.city
	elif new_citizens and new_citizens.city != new_city:
		for other: CitizenManager in _find_all("CitizenManager"):
			if other.city == new_city:
				new_citizens = other
	var is_new: bool = new_city != city or new_citizens != citizens
	_follow(new_city, new_citizens)
	_city_id = new_city.get_instance_id() if new_city else 0
	_citizens_id = new_citizens.get_instance_id() if new_citizens else 0
	if is_new:
		person = -1
		changed.emit()


# What is generated or cleared changes what can be done with it.
func _follow(new_city: PCGCity, new_citizens: CitizenManager) -> void:
	if new_citizens and not new_citizens.agendas_renewed.is_connected(_on_agendas_renewed):
		new_citizens.agendas_renewed.connect(_on_agendas_renewed)
	for signal_name: StringName in [&"city_generated", &"city_cleared"]:
		if new_city and not new_city.is_connected(signal_name, _on_city_changed):
			new_city.connect(signal_name, _on_city_changed, CONNECT_DEFERRED)


func _on_agendas_renewed() -> void:
	choose_person(person)


func _on_city_changed(_success: bool = true) -> void:
	changed.emit()


func _pick(kind: String, shown: Node) -> Node:
	var root: Node = EditorInterface.get_edited_scene_root()
	if root == null:
		return null
	for selected: Node in EditorInterface.get_selection().get_selected_nodes():
		for node: Node in _self_and_parents(selected, root):
			if node.is_class(kind):
				return node
	if shown and shown.is_inside_tree() and (shown == root or root.is_ancestor_of(shown)):
		return shown
	var found: Array[Node] = _find_all(kind)
	return found[0] if not found.is_empty() else null


static func _self_and_parents(node: Node, root: Node) -> Array[Node]:
	var chain: Array[Node] = []
	while node and node != root.get_parent():
		chain.append(node)
		node = node.get_parent()
	return chain


func _find_all(kind: String) -> Array[Node]:
	var root: Node = EditorInterface.get_edited_scene_root()
	var found: Array[Node] = []
	if root:
		if root.is_class(kind):
			found.append(root)
		found.append_array(root.find_children("*", kind, true, false))
	return found


func _on_scene_changed(_root: Node) -> void:
	_city_id = 0
	_citizens_id = 0
	refresh()
	changed.emit()


func _on_node_changed(node: Node) -> void:
	if node is PCGCity or node is CitizenManager:
		refresh.call_deferred()


## What builds a city's streets: the rules that it names, else those that ship, whether it uses them now or not. Null if there are none.
func get_street_rules(of: PCGCity) -> PCGRuleSet:
	var shipped: String = CityStarter.find_rules().path_join("cga/street.cga")
	if _shipped_streets == null and FileAccess.file_exists(shipped):
		_shipped_streets = load(shipped)
	return of.street_rules if of.street_rules else _shipped_streets


## Nodes of the scene that use a rule file, directly or by import.
func get_users(path: String) -> Array[Node]:
	var users: Array[Node] = []
	for node: Node in _find_all("PCGCity"):
		var city := node as PCGCity
		if city.use_street_rules and _uses(get_street_rules(city), path) or city.lot_types.any(func(type: PCGLotType) -> bool: return type != null and _uses(type.rules, path)):
			users.append(node)
	for node: Node in _find_all("CitizenManager"):
		if _uses((node as CitizenManager).rules, path):
			users.append(node)
	return users


static func _uses(rules: PCGRuleSet, path: String) -> bool:
	return rules != null and LoadedRules.is_made_of(rules, path)
