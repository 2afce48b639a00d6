extends RefCounted
## What the demos share: which rules build which lots, and how many of each there are.

const RULES := "res://rules/agenda/weekday.pcg"
const HOUSEHOLDS := "res://rules/data/households_us_acs2023.csv"
const SHOWCASE := "res://demo/showcase.tscn"


static func make_city(lots: int, seed: int) -> PCGCity:
	var city := PCGCity.new()
	city.name = "City"
	city.layout = PCGLayout.new()
	city.layout.fit_lots(lots)
	city.lot_types = make_lot_types()
	city.seed = seed
	return city


## Those of the showcase's city, which stand in its scene for all to edit.
static func make_lot_types() -> Array[PCGLotType]:
	var types: Array[PCGLotType] = []
	var scene: SceneState = (load(SHOWCASE) as PackedScene).get_state()
	for node: int in scene.get_node_count():
		for property: int in scene.get_node_property_count(node):
			if scene.get_node_property_name(node, property) == &"lot_types":
				types.assign(scene.get_node_property_value(node, property))
	return types
