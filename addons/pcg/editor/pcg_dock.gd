@tool
extends VBoxContainer
## The dock: a page each for the city, its people, their days, one person, and all problems. The pages' titles are buttons with little room around their words:
## a row of tabs would not fit into a narrow dock.

const SceneContext := preload("res://addons/pcg/editor/scene_context.gd")
const CityTab := preload("res://addons/pcg/editor/city/city_tab.gd")
const PopulationTab := preload("res://addons/pcg/editor/people/population_tab.gd")
const SimulationTab := preload("res://addons/pcg/editor/simulation/simulation_tab.gd")
const PersonTab := preload("res://addons/pcg/editor/person/person_tab.gd")
const ProblemList := preload("res://addons/pcg/editor/problems/problem_list.gd")
const ProblemCollector := preload("res://addons/pcg/editor/problems/problem_collector.gd")

const WIDTH := 340.0 ## pixels at 100 %, the least
const TITLE_MARGIN := 3.0 ## pixels at 100 %, on each side of a title

## A message or an agenda entry is about a place in a file.
signal place_wanted(path: String, line: int, column: int)

var context: SceneContext
var _collector: ProblemCollector

@onready var pages: TabContainer = %Pages
@onready var city_tab: CityTab = %City
@onready var population_tab: PopulationTab = %Population
@onready var simulation_tab: SimulationTab = %Simulation
@onready var person_tab: PersonTab = %Person
@onready var problems: ProblemList = %Problems


func _ready() -> void:
	var group := ButtonGroup.new()
	for index: int in pages.get_tab_count():
		var button := Button.new()
		button.text = pages.get_tab_title(index)
		button.toggle_mode = true
		button.button_group = group
		button.button_pressed = index == 0
		button.theme_type_variation = &"FlatButton"
		button.pressed.connect(show_page.bind(index))
		%Titles.add_child(button)
	_take_theme()


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_node_ready():
		_take_theme()


func _take_theme() -> void:
	for state: String in ["normal", "hover", "pressed", "hover_pressed", "disabled", "focus"]:
		var narrow: StyleBox = get_theme_stylebox(state, &"FlatButton").duplicate()
		narrow.content_margin_left = TITLE_MARGIN * EditorInterface.get_editor_scale()
		narrow.content_margin_right = narrow.content_margin_left
		for button: Button in %Titles.get_children():
			button.add_theme_stylebox_override(state, narrow)
	for state: String in ["normal", "hover", "pressed", "hover_pressed", "focus"]: # the mark of a problem keeps its colour
		for button: Button in %Titles.get_children():
			button.add_theme_color_override("icon_%s_color" % state, Color.WHITE)


func show_page(index: int) -> void:
	pages.current_tab = index
	(%Titles.get_child(index) as Button).button_pressed = true


func open(of: SceneContext) -> void:
	context = of
	custom_minimum_size.x = WIDTH * EditorInterface.get_editor_scale()
	city_tab.open(context)
	population_tab.open(context)
	simulation_tab.open(context)
	person_tab.open(context)
	person_tab.place_wanted.connect(place_wanted.emit)
	_collector = ProblemCollector.new(context)
	_collector.problems_changed.connect(_on_problems_changed)
	problems.problem_activated.connect(_on_problem_activated)
	_collector.collect()


func take_rule_diagnostics(path: String, diagnostics: Array[Dictionary]) -> void:
	_collector.take_file(path, diagnostics)


func forget_rule_diagnostics(path: String) -> void:
	_collector.forget_file(path)


func _on_problems_changed(diagnostics: Array[Dictionary]) -> void:
	problems.show_diagnostics(diagnostics)
	var title: Button = %Titles.get_child(pages.get_tab_idx_from_control(problems))
	var errors: int = diagnostics.reduce(func(sum: int, entry: Dictionary) -> int: return sum + int(entry["severity"] == "error"), 0)
	title.icon = null if diagnostics.is_empty() else get_theme_icon("StatusError" if errors > 0 else "StatusWarning", "EditorIcons")
	title.tooltip_text = "" if diagnostics.is_empty() else "%d errors, %d warnings" % [errors, diagnostics.size() - errors]


func _on_problem_activated(diagnostic: Dictionary) -> void:
	if not str(diagnostic["file"]).is_empty():
		place_wanted.emit(diagnostic["file"], maxi(int(diagnostic["line"]), 1), maxi(int(diagnostic["column"]), 1))
		return
	var node: Node = diagnostic.get("node")
	if node and node.is_inside_tree():
		EditorInterface.get_selection().clear()
		EditorInterface.get_selection().add_node(node)
		EditorInterface.edit_node(node)
