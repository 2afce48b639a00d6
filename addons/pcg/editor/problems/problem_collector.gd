@tool
extends RefCounted
## Puts the diagnostics of rules, tables, city, navigation and agendas together, each once.

signal problems_changed(diagnostics: Array[Dictionary])

const SceneContext := preload("res://addons/pcg/editor/scene_context.gd")

var _context: SceneContext
var _of_files: Dictionary[String, Array] = {} # diagnostics of rule files that are being edited
var _followed: Dictionary[int, bool] = {} # instance ids of nodes whose signals are connected


func _init(context: SceneContext) -> void:
	_context = context
	_context.changed.connect(collect)
	_context.get_undo().history_changed.connect(collect)
	_context.get_undo().version_changed.connect(collect)


## What an editor says of a file goes before what was loaded of it.
func take_file(path: String, diagnostics: Array[Dictionary]) -> void:
	_of_files[path] = diagnostics
	collect()


func forget_file(path: String) -> void:
	_of_files.erase(path)
	collect()


func collect() -> void:
	var found: Array[Dictionary] = []
	for path: String in _of_files:
		found.append_array(_of_files[path])
	if _context.city:
		_follow(_context.city, &"city_generated")
		for rules: PCGRuleSet in _find_rules(_context.city):
			if not _of_files.has(rules.get_file()):
				_append(found, rules.get_diagnostics(), _context.city)
		_append(found, _context.city.get_diagnostics(), _context.city)
	if _context.citizens:
		_follow(_context.citizens, &"population_generated")
		_append_inputs(found, _context.citizens)
		_append(found, _context.citizens.get_diagnostics(), _context.citizens)
	problems_changed.emit(_without_doubles(found))


# What builds a city's lots and streets.
func _find_rules(city: PCGCity) -> Array[PCGRuleSet]:
	var found: Array[PCGRuleSet] = []
	for type: PCGLotType in city.lot_types:
		if type and type.rules:
			found.append(type.rules)
	if city.use_street_rules and _context.get_street_rules(city):
		found.append(_context.get_street_rules(city))
	return found


func _append_inputs(found: Array[Dictionary], citizens: CitizenManager) -> void:
	if citizens.rules and not _of_files.has(citizens.rules.get_file()):
		_append(found, citizens.rules.get_diagnostics(), citizens)
	for table: PCGTextFile in [citizens.household_table, citizens.population]:
		if table:
			_append(found, table.get_diagnostics(), citizens)


func _follow(node: Node, signal_name: StringName) -> void:
	if not _followed.has(node.get_instance_id()):
		_followed[node.get_instance_id()] = true
		node.connect(signal_name, _collect_later, CONNECT_DEFERRED)


func _collect_later(_success: Variant = null) -> void:
	collect()


static func _append(found: Array[Dictionary], diagnostics: Array[Dictionary], node: Node) -> void:
	for diagnostic: Dictionary in diagnostics:
		diagnostic["node"] = node
		found.append(diagnostic)


# The same message reaches a list through rules and through whoever uses them.
static func _without_doubles(found: Array[Dictionary]) -> Array[Dictionary]:
	var seen: Dictionary[String, bool] = {}
	var told: Array[Dictionary] = []
	for entry: Dictionary in found:
		var key: String = "%s:%d:%d:%s" % [entry["file"], entry["line"], entry["column"], entry["message"]]
		if not seen.has(key):
			seen[key] = true
			told.append(entry)
	return told
