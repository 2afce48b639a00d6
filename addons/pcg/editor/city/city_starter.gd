@tool
extends RefCounted
## A first city: a small layout, the shipped rules, and people whose day is a weekday.

const RULE_FOLDERS: PackedStringArray = ["res://addons/pcg/rules", "res://rules"] # as installed, and in the addon's own project
const LOT_WEIGHTS: Dictionary[String, float] = {"house": 45.0, "row_house": 10.0, "apartment": 12.0, "workplace": 12.0, "shop": 6.0, "school": 4.0,
		"restaurant": 3.0, "park": 8.0}
const LOTS := 80
const PERSONS := 200
const MORNING := 7.5 * 3600.0


## Where the shipped rules lie; empty if they were taken away.
static func find_rules() -> String:
	for folder: String in RULE_FOLDERS:
		if FileAccess.file_exists(folder.path_join("cga/house.cga")):
			return folder
	return ""


static func make_city() -> PCGCity:
	var city := PCGCity.new()
	city.name = "City"
	city.layout = PCGLayout.new()
	city.layout.fit_lots(LOTS)
	var types: Array[PCGLotType] = []
	for type_name: String in LOT_WEIGHTS:
		var path: String = find_rules().path_join("cga/%s.cga" % type_name)
		if FileAccess.file_exists(path):
			var type := PCGLotType.new()
			type.type = type_name
			type.weight = LOT_WEIGHTS[type_name]
			type.rules = load(path)
			types.append(type)
	city.lot_types = types
	var streets: String = find_rules().path_join("cga/street.cga")
	if FileAccess.file_exists(streets):
		city.street_rules = load(streets) # by name, so that exported games bring it along
	return city


static func make_citizens() -> CitizenManager:
	var citizens := CitizenManager.new()
	citizens.name = "Citizens"
	citizens.person_count = PERSONS
	citizens.time = MORNING
	var rules: String = find_rules().path_join("agenda/weekday.pcg")
	if FileAccess.file_exists(rules):
		citizens.rules = load(rules)
	citizens.household_table = PCGHouseholdTable.new()
	citizens.household_table.file = find_rules().path_join("data/households_us_acs2023.csv")
	return citizens


## Adds both to the edited scene in one step; makes a scene where there is none.
static func add_to_scene(undo: EditorUndoRedoManager) -> void:
	var root: Node = EditorInterface.get_edited_scene_root()
	if root == null:
		root = Node3D.new()
		root.name = "World"
		EditorInterface.add_root_node(root)
	var city: PCGCity = make_city()
	var citizens: CitizenManager = make_citizens()
	undo.create_action("Add a city", UndoRedo.MERGE_DISABLE, root)
	for node: Node in [city, citizens]:
		undo.add_do_method(root, &"add_child", node, true)
		undo.add_do_method(node, &"set_owner", root)
		undo.add_do_reference(node)
		undo.add_undo_method(root, &"remove_child", node)
	undo.add_do_property(citizens, &"city", city)
	undo.commit_action()
	EditorInterface.edit_node(city)
