extends RefCounted
## A small city from rules that stand here, so that tests do not depend on the shipped ones.

const HOUSE := """@StartRule
Lot --> split(z) { 5: Yard | ~1: extrude(6) comp(f) { front: Front | all: Wall. } }
Yard --> X.
Front --> entrance("house", 4) Wall.
"""
const WORKPLACE := """@StartRule
Lot --> split(z) { 5: Yard | ~1: extrude(12) comp(f) { front: Front | all: Wall. } }
Yard --> X.
Front --> entrance("workplace", 40) Wall.
"""
const SCHOOL := """@StartRule
Lot --> split(z) { 5: Yard | ~1: extrude(7) comp(f) { front: Front | all: Wall. } }
Yard --> X.
Front --> entrance("school", 100) Wall.
"""
## Its door leads to a yard between walls, further from the street than anybody looks for a way (6 m ahead, 3 m around).
const WALLED_HOUSE := """@StartRule
Lot --> split(x) { 4: Mass | ~1: split(z) { 4: Mass | ~1: Inside | 4: Mass } | 4: Mass }
Inside --> split(z) { 5: extrude(6) comp(f) { front: Front | all: Wall. } | ~1: Yard }
Mass --> extrude(6) Wall.
Yard --> X.
Front --> entrance("house", 4) Wall.
"""
const PARK := """@StartRule
Lot --> zone("park") Lawn.
"""
## A stop on each side of each block.
const STREETS := """attr atCrossing = false
attr stop = ""
Street --> t(0, -0.1, 0) Asphalt.
Crossing --> White.
Junction --> t(0, -0.1, 0) Asphalt.
Sidewalk --> case atCrossing || stop == "" : Paving. else : [ split(x) { ~1 : NIL | 1 : Stop | ~1 : NIL } ] Paving.
@Object("stop")
Stop --> s(1, 2, 1) primitiveCube() Sign.
"""
const WEEKDAY := """@StartRule
Household -->
	members { true: stayInside(0h, 24h, home) }
	members { age < 18: Visit("school", 8h, 16h) | age < 65: Visit("workplace", 8h + rand(-30m, 30m), 16h) | true: Walk }
Visit(type, t0, t1) -->
	set(goal, findNearestBuilding(type, home))
	set(way, getDistanceInTime(home, goal))
	goToBuilding(t0 - way, t1, goal)
	goToBuilding(t1, t1 + way, home)
Walk --> delayedRule(10h, 11h, Park)
Park --> goToZone("park") wait(10m)
"""
const HOUSEHOLDS := "descriptor,count,adults,minors,elders\na couple,40,2,0,0\na couple with two children,40,2,2,0\nan old couple,20,0,0,2\n"


static func make_rules(source: String, dialect: PCGRuleSet.Dialect = PCGRuleSet.DIALECT_CGA) -> PCGRuleSet:
	var rules := PCGRuleSet.new()
	rules.dialect = dialect
	rules.source = source
	return rules


static func make_type(name: String, weight: float, source: String) -> PCGLotType:
	var type := PCGLotType.new()
	type.type = name
	type.weight = weight
	type.rules = make_rules(source)
	return type


static func make_city(lots: int = 40) -> PCGCity:
	var city := PCGCity.new()
	city.layout = PCGLayout.new()
	city.layout.fit_lots(lots)
	city.use_street_rules = false
	city.lot_types = [make_type("house", 60, HOUSE), make_type("workplace", 20, WORKPLACE), make_type("school", 10, SCHOOL),
			make_type("park", 10, PARK)]
	return city


## Of the homes that somebody lives in, one that has most room for others.
static func roomiest_home(citizens: CitizenManager) -> int:
	var living: Dictionary[int, int] = {}
	for person: int in citizens.count_persons():
		var home: int = citizens.get_person(person)["home"]
		living[home] = living.get(home, 0) + 1
	return living.keys().reduce(func(best: int, home: int) -> int: return home if living[home] < living[best] else best)


static func make_citizens(city: PCGCity, persons: int = 60) -> CitizenManager:
	var citizens := CitizenManager.new()
	citizens.city = city
	citizens.rules = make_rules(WEEKDAY, PCGRuleSet.DIALECT_AGENDA)
	citizens.household_table = PCGHouseholdTable.new()
	citizens.household_table.source = HOUSEHOLDS
	citizens.person_count = persons
	citizens.paused = true
	return citizens
