@tool
extends VBoxContainer
## Layout, land use, rules and seed of a city; generates it, and tells what came of it.

const SceneContext := preload("res://addons/pcg/editor/scene_context.gd")
const CityHistory := preload("res://addons/pcg/editor/city/city_history.gd")
const CityStarter := preload("res://addons/pcg/editor/city/city_starter.gd")
const LandUse := preload("res://addons/pcg/editor/city/land_use.gd")
const RuleAttributes := preload("res://addons/pcg/editor/city/rule_attributes.gd")
const HIGHEST_SEED := 999_999
const FIGURE_TITLES: Dictionary[String, String] = {"seconds": "Time"} # where the name of a city's figure does not tell

var context: SceneContext
var history: CityHistory
@onready var _layout_inspector := EditorInspector.new()
@onready var _attribute_inspector := EditorInspector.new()
@onready var _city_inspector := EditorInspector.new()
# Inspectors do not keep what they show, and refer to it once more when they show something else.
var _attributes: RuleAttributes
var _layout: PCGLayout
var _shown_city: PCGCity
var _shown_land_use: Array = []

@onready var _seed: SpinBox = %Seed
@onready var _land_use: LandUse = %LandUse
@onready var _cities: OptionButton = %Cities


func open(of: SceneContext) -> void:
	context = of
	history = CityHistory.new(context)
	_land_use.context = context
	context.changed.connect(refresh)
	context.get_undo().history_changed.connect(_on_step, CONNECT_DEFERRED)
	context.get_undo().version_changed.connect(_on_step, CONNECT_DEFERRED)
	refresh()


func _ready() -> void:
	(%Create as Button).pressed.connect(create_city)
	(%Generate as Button).pressed.connect(generate)
	(%Selected as Button).pressed.connect(generate_selected)
	(%Clear as Button).pressed.connect(func() -> void: history.clear(context.city))
	(%Cancel as Button).pressed.connect(func() -> void: context.city.cancel())
	(%Dice as Button).pressed.connect(throw_dice)
	_seed.value_changed.connect(_on_seed_changed)
	_cities.item_selected.connect(func(index: int) -> void: context.show_city(context.get_cities()[index]))
	_land_use.subject_chosen.connect(show_attributes)
	_add_inspector(%Layout, _layout_inspector)
	_add_inspector(%Attributes, _attribute_inspector)
	_add_inspector(%Settings, _city_inspector)
	_take_theme()


static func _add_inspector(holder: Control, inspector: EditorInspector) -> void:
	inspector.size_flags_vertical = SIZE_EXPAND_FILL
	inspector.horizontal_scroll_mode = ScrollContainer.SCROLL_MODE_DISABLED
	holder.add_child(inspector)


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_node_ready():
		_take_theme()


func _take_theme() -> void:
	var figures: Tree = %Statistics
	figures.set_column_expand(1, false)
	figures.set_column_custom_minimum_width(1, roundi(70.0 * EditorInterface.get_editor_scale()))
	(%Dice as Button).icon = get_theme_icon("RandomNumberGenerator", "EditorIcons")
	(%Generate as Button).icon = get_theme_icon("Reload", "EditorIcons")
	(%Clear as Button).icon = get_theme_icon("Clear", "EditorIcons")


## Shows the context's city as it is now.
func refresh() -> void:
	_follow(context.city)
	var city: PCGCity = context.city
	(%Empty as Control).visible = city == null
	(%Content as Control).visible = city != null
	_attribute_inspector.edit(null)
	_city_inspector.edit(city)
	_show_layout(city.layout if city else null)
	if city == null:
		return
	_cities.clear()
	for other: PCGCity in context.get_cities():
		_cities.add_item(other.name)
		if other == city:
			_cities.select(_cities.item_count - 1)
	_cities.visible = _cities.item_count > 1
	_seed.set_value_no_signal(city.seed)
	show_land_use()
	show_statistics()
	_show_progress(city.is_generating())


# An inspector must not show what is gone.
func _let_go() -> void:
	_city_inspector.edit(null)
	if _attributes and _attributes.subject is PCGCity:
		show_attributes(null)


func _show_layout(layout: PCGLayout) -> void:
	_layout = layout
	_layout_inspector.edit(layout)
	_layout_inspector.visible = layout != null
	(%LayoutText as Label).visible = layout == null


## Shows types of lots, streets and what their rules have now, as after rules were saved.
func show_land_use() -> void:
	var shown: Object = _attributes.subject if _attributes else null
	_shown_land_use = _describe_land_use()
	_land_use.refresh()
	if shown == null or shown != context.city and not shown in context.city.lot_types:
		show_attributes(null)
	elif _land_use.get_chosen() != shown:
		show_attributes(shown)


# What decides which rows and which attributes there are.
func _describe_land_use() -> Array:
	var described: Array = [context.city, context.city.street_rules, context.city.use_street_rules]
	for type: PCGLotType in context.city.lot_types:
		described.append([type, type.type, type.weight, type.rules] if type else null)
	return described


# Settings change here, in the engine's own inspector, and where a step is undone.
func _on_step() -> void:
	if context.city == null:
		return
	_seed.set_value_no_signal(context.city.seed)
	if context.city.layout != _layout:
		_show_layout(context.city.layout)
	var typing: Control = get_viewport().gui_get_focus_owner()
	if typing and _attribute_inspector.is_ancestor_of(typing): # each letter is a step
		if not typing.focus_exited.is_connected(_on_step):
			typing.focus_exited.connect(_on_step, CONNECT_ONE_SHOT | CONNECT_DEFERRED)
	elif _describe_land_use() != _shown_land_use:
		show_land_use()
	elif _attributes:
		_attributes.end_typing()


func _follow(city: PCGCity) -> void:
	if is_instance_valid(_shown_city) and _shown_city != city:
		_shown_city.generation_progressed.disconnect(_on_progress)
		_shown_city.city_generated.disconnect(_on_generated)
		_shown_city.city_cleared.disconnect(show_statistics)
		_shown_city.tree_exiting.disconnect(_let_go)
		_shown_city.tree_entered.disconnect(_city_inspector.edit)
	if city and city != _shown_city:
		city.generation_progressed.connect(_on_progress)
		city.city_generated.connect(_on_generated)
		city.city_cleared.connect(show_statistics)
		city.tree_exiting.connect(_let_go)
		city.tree_entered.connect(_city_inspector.edit.bind(city))
	_shown_city = city


## Adds a city with the shipped rules and people to the scene; makes a scene where there is none.
func create_city() -> void:
	CityStarter.add_to_scene(context.get_undo())


func generate() -> void:
	if context.city.is_generating():
		return
	history.generate(context.city)


## A new seed and the city that comes of it, in one step to undo.
func throw_dice() -> void:
	if not context.city.is_generating():
		history.generate(context.city, randi_range(0, HIGHEST_SEED))


## The lots that are selected in the scene, that lie in what is selected (a block), or that something selected belongs to.
func get_selected_lots() -> Array[int]:
	var lots: Array[int] = []
	for node: Node in EditorInterface.get_selection().get_selected_nodes():
		var at: Node = node
		while at and not at is PCGLot:
			at = at.get_parent()
		for lot: PCGLot in [at] if at else node.find_children("*", "PCGLot", true, false):
			if lot.lot_id >= 0 and not lots.has(lot.lot_id):
				lots.append(lot.lot_id)
	return lots


func generate_selected() -> void:
	var lots: Array[int] = get_selected_lots()
	if lots.is_empty():
		EditorInterface.get_editor_toaster().push_toast("PCG: select lots in the scene first.")
		return
	history.generate_lots(context.city, lots)


func _on_seed_changed(value: float) -> void:
	var undo: EditorUndoRedoManager = context.get_undo()
	undo.create_action("Set the city's seed", UndoRedo.MERGE_ENDS, context.city)
	undo.add_do_property(context.city, &"seed", int(value))
	undo.add_undo_property(context.city, &"seed", context.city.seed)
	undo.commit_action()


## Shows the attributes of a lot type's rules, or for a city those of its streets; null shows none.
func show_attributes(subject: Object) -> void:
	var attributes := RuleAttributes.new(subject, _land_use.get_rules(subject))
	_attribute_inspector.visible = subject != null
	var told: Label = %AttributesText
	told.text = "What has an arrow is set here; the rest shows what the rules say." if not attributes.is_empty() else "These rules have no attributes."
	if subject == null:
		told.text = "Choose a type of lot, or the streets, to see the attributes of its rules."
	_attribute_inspector.edit(attributes if subject else null)
	_attributes = attributes


func get_attributes() -> RuleAttributes:
	return _attributes


func show_statistics() -> void:
	var tree: Tree = %Statistics
	tree.clear()
	var root: TreeItem = tree.create_item()
	var figures: Dictionary = context.city.get_statistics() if context.city else {}
	if figures.is_empty():
		tree.create_item(root).set_text(0, "Nothing is generated yet.")
	for figure: String in figures:
		_add_figure(tree, root, figure, figures[figure])
	if not figures.is_empty():
		_add_figure(tree, root, "unreachable entrances", _count_unreachable())


func _add_figure(tree: Tree, parent: TreeItem, figure: String, value: Variant) -> void:
	var item: TreeItem = tree.create_item(parent)
	item.set_text(0, FIGURE_TITLES.get(figure, figure.capitalize()) if parent == tree.get_root() else figure)
	if value is Dictionary:
		var values: Dictionary = value
		for key: String in values:
			_add_figure(tree, item, key, values[key])
	else:
		item.set_text(1, _tell_seconds(value) if value is float else str(value))
		item.set_text_alignment(1, HORIZONTAL_ALIGNMENT_RIGHT)


# All figures of a city that are not whole are times.
static func _tell_seconds(seconds: float) -> String:
	return "%.2f s" % seconds if seconds >= 1.0 else "%.0f ms" % (seconds * 1000.0)


func _count_unreachable() -> int:
	return context.city.find_children("*", "PCGEntrance", true, false).reduce(
			func(sum: int, entrance: PCGEntrance) -> int: return sum + int(not entrance.is_reachable()), 0)


func _show_progress(is_generating: bool) -> void:
	(%Progress as Control).visible = is_generating
	for button: Button in [%Generate, %Dice, %Clear]:
		button.disabled = is_generating
	(%Selected as Button).disabled = is_generating or not context.city.is_generated()


func _on_progress(stage: String, fraction: float) -> void:
	_show_progress(true)
	(%Bar as ProgressBar).value = fraction
	(%Stage as Label).text = stage


func _on_generated(_success: bool) -> void:
	_show_progress(false)
	show_statistics()
