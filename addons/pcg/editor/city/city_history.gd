@tool
extends RefCounted
## Makes generating a step that can be undone. Cities are not kept: the same seed, layout and rules give the same city, so it is enough to remember
## what a city was made of, and to make it again.

const SceneContext := preload("res://addons/pcg/editor/scene_context.gd")
const LOT_TYPE_PROPERTIES: Array[StringName] = [&"type", &"weight", &"rules", &"start_rule", &"attributes"]

var _context: SceneContext
var _made_of: Dictionary[int, Dictionary] = {} # instance id of a city to what it was last made of; empty: it is not there


func _init(context: SceneContext) -> void:
	_context = context


## Generates `city`, with another seed if one is given.
func generate(city: PCGCity, seed: int = city.seed) -> void:
	var before: Dictionary = _made_before(city)
	var seed_before: int = city.seed
	city.seed = seed
	var after: Dictionary = describe(city)
	city.seed = seed_before
	_commit("Generate the city", city, after, before, seed_before)


## Generates some lots anew, by number, with what their types have now.
func generate_lots(city: PCGCity, lots: Array[int]) -> void:
	var undo: EditorUndoRedoManager = _context.get_undo()
	undo.create_action("Generate %s" % ("a lot" if lots.size() == 1 else "%d lots" % lots.size()), UndoRedo.MERGE_DISABLE, city)
	undo.add_do_method(self, &"make_lots", city, lots, describe(city))
	undo.add_undo_method(self, &"make_lots", city, lots, _made_before(city))
	undo.commit_action()


## Gives the lots' types what they were made of, and makes these lots.
func make_lots(city: PCGCity, lots: Array[int], described: Dictionary) -> void:
	_made_of[city.get_instance_id()] = described
	_give_types(described)
	for lot: int in lots:
		city.regenerate_lot(lot)
	_context.changed.emit()


func clear(city: PCGCity) -> void:
	_commit("Clear the city", city, {}, _made_before(city), city.seed)


# A city that came with its scene was made of what it has.
func _made_before(city: PCGCity) -> Dictionary:
	return _made_of.get(city.get_instance_id(), describe(city) if city.is_generated() else {})


func _commit(title: String, city: PCGCity, after: Dictionary, before: Dictionary, seed_before: int) -> void:
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
			var values := {"self": type}
			for property: StringName in LOT_TYPE_PROPERTIES:
				values[property] = type.get(property)
			types.append(values)
	return {"seed": city.seed, "layout": city.layout, "lot_types": city.lot_types.duplicate(), "layout_values": _stored_values(city.layout), "types": types}


static func _stored_values(resource: Resource) -> Dictionary:
	var values: Dictionary = {}
	for property: Dictionary in resource.get_property_list() if resource else ([] as Array[Dictionary]):
		var is_own: bool = not str(property["name"]).begins_with("resource_") and property["name"] != "script"
		if property["usage"] & PROPERTY_USAGE_STORAGE and is_own:
			values[property["name"]] = resource.get(property["name"])
	return values


## Gives a city what it was made of, and makes it; an empty description clears it.
func make(city: PCGCity, described: Dictionary) -> void:
	_made_of[city.get_instance_id()] = described
	_context.stop_life_in(city)
	if city.is_generating():
		city.cancel()
	if described.is_empty():
		city.clear()
		_context.changed.emit()
		return
	city.seed = described["seed"]
	city.layout = described["layout"]
	city.lot_types = described["lot_types"]
	for property: String in described["layout_values"]:
		city.layout.set(property, described["layout_values"][property])
	_give_types(described)
	city.generate()
	_context.changed.emit()


static func _give_types(described: Dictionary) -> void:
	for values: Dictionary in described["types"]:
		for property: StringName in LOT_TYPE_PROPERTIES:
			(values["self"] as PCGLotType).set(property, values[property])
