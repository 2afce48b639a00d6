@tool
extends RefCounted
## Makes generating a step that can be undone. Cities are not kept: the same seed, layout and rules give the same city, so it is enough to remember
## what a city was made of, and to make it again.

## Of a city, beside its types of lots and its layout; lists and dictionaries are copied.
const SETTINGS: Array[StringName] = [&"seed", &"layout", &"lot_types", &"street_rules", &"street_attributes", &"use_street_rules", &"asset_folders",
		&"agent_height", &"agent_radius", &"agent_max_climb", &"agent_max_slope", &"cell_size", &"use_collision", &"collision_layer", &"collision_mask"]
const SceneContext := preload("res://addons/pcg/editor/scene_context.gd")

var _context: SceneContext
# Instance id of a city to how it was made: a description of the whole, then those of lots that were made anew, with their numbers as `lots`. Empty: it
# is not there.
var _made_of: Dictionary[int, Array] = {}


func _init(context: SceneContext) -> void:
	_context = context


## Generates `city`, with another seed if one is given.
func generate(city: PCGCity, seed: int = city.seed) -> void:
	var before: Array = _made_before(city)
	var seed_before: int = city.seed
	city.seed = seed
	var after: Array = [describe(city)]
	city.seed = seed_before
	_commit("Generate the city", city, after, before, seed_before)


## Generates some lots anew, by number, with what their types have now.
func generate_lots(city: PCGCity, lots: Array[int]) -> void:
	var undo: EditorUndoRedoManager = _context.get_undo()
	var before: Array = _made_before(city)
	var after: Array = before + [describe(city).merged({"lots": lots})]
	undo.create_action("Generate %s" % ("a lot" if lots.size() == 1 else "%d lots" % lots.size()), UndoRedo.MERGE_DISABLE, city)
	undo.add_do_method(self, &"make_lots", city, lots, after)
	undo.add_undo_method(self, &"make_lots", city, lots, before)
	undo.commit_action()


## Makes these lots as `steps` made them last.
func make_lots(city: PCGCity, lots: Array[int], steps: Array) -> void:
	_made_of[city.get_instance_id()] = steps
	for step: int in steps.size():
		_give_types(steps[step])
		for lot: int in lots:
			if _last_step(lot, steps) == step:
				city.regenerate_lot(lot)
	_context.changed.emit()


static func _last_step(lot: int, steps: Array) -> int:
	for step: int in range(steps.size() - 1, 0, -1):
		if lot in steps[step]["lots"]:
			return step
	return 0


func clear(city: PCGCity) -> void:
	_commit("Clear the city", city, [], _made_before(city), city.seed)


# A city that came with its scene was made of what it has.
func _made_before(city: PCGCity) -> Array:
	return _made_of.get(city.get_instance_id(), [describe(city)] if city.is_generated() else [])


func _commit(title: String, city: PCGCity, after: Array, before: Array, seed_before: int) -> void:
	var undo: EditorUndoRedoManager = _context.get_undo()
	undo.create_action(title, UndoRedo.MERGE_DISABLE, city)
	undo.add_do_method(self, &"make", city, after)
	undo.add_undo_method(self, &"make", city, before)
	if before.is_empty():
		undo.add_undo_property(city, &"seed", seed_before)
	undo.commit_action()


## What decides how a city looks: its own properties, those of its layout, and those of its lot types.
static func describe(city: PCGCity) -> Dictionary:
	var types: Array[Dictionary] = []
	for type: PCGLotType in city.lot_types:
		if type:
			types.append({"self": type, "values": _stored_values(type)})
	var settings: Dictionary = {}
	for property: StringName in SETTINGS:
		var value: Variant = city.get(property)
		settings[property] = value.duplicate() if value is Array or value is Dictionary else value
	return {"settings": settings, "layout_values": _stored_values(city.layout), "types": types}


static func _stored_values(resource: Resource) -> Dictionary:
	var values: Dictionary = {}
	for property: Dictionary in resource.get_property_list() if resource else ([] as Array[Dictionary]):
		var is_own: bool = not str(property["name"]).begins_with("resource_") and property["name"] != "script"
		if property["usage"] & PROPERTY_USAGE_STORAGE and is_own:
			values[property["name"]] = resource.get(property["name"])
	return values


## Makes a city by these steps; none clear it.
func make(city: PCGCity, steps: Array) -> void:
	_made_of[city.get_instance_id()] = steps
	_context.stop_life_in(city)
	if city.is_generating():
		city.cancel()
	if steps.is_empty():
		city.clear()
		_context.changed.emit()
		return
	var described: Dictionary = steps[0]
	_give_values(city, described["settings"])
	_give_values(city.layout, described["layout_values"])
	_give_types(described)
	if not city.city_generated.is_connected(_make_later_steps):
		city.city_generated.connect(_make_later_steps.bind(city))
	city.generate()
	_context.changed.emit()


# A generated city is as its first step made it.
func _make_later_steps(is_good: bool, city: PCGCity) -> void:
	var steps: Array = _made_of[city.get_instance_id()]
	var lots: Array[int] = []
	for step: Dictionary in steps.slice(1):
		lots.append_array(step["lots"].filter(func(lot: int) -> bool: return lot not in lots))
	if is_good and not lots.is_empty():
		make_lots(city, lots, steps)


static func _give_types(described: Dictionary) -> void:
	for type: Dictionary in described["types"]:
		_give_values(type["self"], type["values"])


static func _give_values(object: Object, values: Dictionary) -> void:
	for property: StringName in values:
		object.set(property, values[property])
