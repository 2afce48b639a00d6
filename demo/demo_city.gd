extends RefCounted
## What the demos share: which rules build which lots, and how many of each there are.

const RULES := "res://rules/agenda/weekday.pcg"
const HOUSEHOLDS := "res://rules/data/households_us_acs2023.csv"
## Type of lot: share of the city, rules.
const LOT_TYPES := {
	"house": [43.0, "res://rules/cga/house.cga"],
	"row_house": [9.0, "res://rules/cga/row_house.cga"],
	"apartment": [12.0, "res://rules/cga/apartment.cga"],
	"workplace": [9.0, "res://rules/cga/workplace.cga"],
	"office_tower": [3.0, "res://rules/cga/office_tower.cga"],
	"workshop": [3.0, "res://rules/cga/workshop.cga"],
	"shop": [5.0, "res://rules/cga/shop.cga"],
	"supermarket": [1.0, "res://rules/cga/supermarket.cga"],
	"restaurant": [3.0, "res://rules/cga/restaurant.cga"],
	"school": [4.0, "res://rules/cga/school.cga"],
	"town_hall": [0.3, "res://rules/cga/town_hall.cga"],
	"park": [7.0, "res://rules/cga/park.cga"],
	"plaza": [0.7, "res://rules/cga/plaza.cga"],
}


static func make_city(lots: int, seed: int) -> PCGCity:
	var city := PCGCity.new()
	city.name = "City"
	city.layout = PCGLayout.new()
	city.layout.fit_lots(lots)
	city.lot_types = make_lot_types()
	city.seed = seed
	return city


static func make_lot_types() -> Array[PCGLotType]:
	var types: Array[PCGLotType] = []
	for name: String in LOT_TYPES:
		var type := PCGLotType.new()
		type.type = name
		type.weight = LOT_TYPES[name][0]
		type.rules = PCGRuleSet.from_file(LOT_TYPES[name][1])
		types.append(type)
	return types
