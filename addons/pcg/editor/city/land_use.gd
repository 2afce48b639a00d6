@tool
extends VBoxContainer
## What land is used for: a city's types of lots with their weights and rule files, and below them its streets. Every change is a step to undo.

## Somebody chose a type of lot, a PCGLotType, or the streets, which is their PCGCity; null: what was chosen is gone.
signal subject_chosen(subject: Object)

const SceneContext := preload("res://addons/pcg/editor/scene_context.gd")
const FIRST_WEIGHT := 10.0 ## of a type that is added

var context: SceneContext
var _dialog: EditorFileDialog
var _asked_for: Object ## whose rules the dialog asks for; null: a new type's

@onready var _list: Tree = %Types


func _ready() -> void:
	_list.item_selected.connect(_on_chosen)
	_list.item_edited.connect(func() -> void: take_row(_list.get_edited()))
	_list.item_activated.connect(_on_activated)
	(%AddType as Button).pressed.connect(_ask_for_rules.bind(false))
	(%ChooseRules as Button).pressed.connect(_ask_for_rules.bind(true))
	(%RemoveType as Button).pressed.connect(remove_chosen)
	_list.set_column_expand(1, false)
	_list.set_column_expand_ratio(0, 4)
	_list.set_column_expand_ratio(2, 5)
	for column: int in 3:
		_list.set_column_title(column, ["Lots", "Weight", "Rules"][column])
		_list.set_column_title_alignment(column, HORIZONTAL_ALIGNMENT_LEFT)
		_list.set_column_clip_content(column, true)
	_take_theme()


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_node_ready():
		_take_theme()


func _take_theme() -> void:
	_list.set_column_custom_minimum_width(1, roundi(76.0 * EditorInterface.get_editor_scale()))
	(%AddType as Button).icon = get_theme_icon("Add", "EditorIcons")
	(%RemoveType as Button).icon = get_theme_icon("Remove", "EditorIcons")


## The type whose row is selected, or the city if that of the streets is; null: none.
func get_chosen() -> Object:
	var chosen: Variant = _list.get_selected().get_metadata(0) if _list.get_selected() else null
	return chosen if is_instance_valid(chosen) else null


## Shows the types that the city has now; the chosen one stays so.
func refresh() -> void:
	var chosen: Object = get_chosen()
	_list.clear()
	var root: TreeItem = _list.create_item()
	for type: PCGLotType in context.city.lot_types if context.city else ([] as Array[PCGLotType]):
		if type:
			_add_row(root, type)
	if context.city:
		_add_streets(root, context.city)
	for item: TreeItem in root.get_children():
		if item.get_metadata(0) == chosen:
			item.select(0)
	if get_chosen() == null:
		_on_chosen()


func _add_row(root: TreeItem, type: PCGLotType) -> void:
	var item: TreeItem = _list.create_item(root)
	item.set_text(0, type.type)
	item.set_metadata(0, type)
	item.set_cell_mode(1, TreeItem.CELL_MODE_RANGE)
	item.set_range_config(1, 0.0, 1000.0, 0.1)
	item.set_range(1, type.weight)
	item.set_editable(1, true)
	_show_rules(item, type.rules)


# Streets have no weight: they are built by rules or not.
func _add_streets(root: TreeItem, city: PCGCity) -> void:
	var item: TreeItem = _list.create_item(root)
	item.set_text(0, "streets")
	item.set_metadata(0, city)
	item.set_cell_mode(1, TreeItem.CELL_MODE_CHECK)
	item.set_checked(1, city.use_street_rules)
	item.set_tooltip_text(1, "Whether rules build streets and pavements; without them they are plain")
	item.set_editable(1, true)
	_show_rules(item, context.get_street_rules(city))
	if city.street_rules == null:
		item.set_custom_color(2, get_theme_color("font_disabled_color", "Editor"))
		item.set_tooltip_text(2, "The street rules that ship: none are named here.\n" + item.get_tooltip_text(2))


func _show_rules(item: TreeItem, rules: PCGRuleSet) -> void:
	item.set_text(2, rules.get_file().get_file() if rules else "none")
	item.set_tooltip_text(2, "%s\nDouble-click to edit." % rules.get_file() if rules else "Rules .. chooses a file.")
	if rules and rules.has_errors():
		item.set_icon(2, get_theme_icon("StatusError", "EditorIcons"))


func _on_chosen() -> void:
	var chosen: Object = get_chosen()
	(%ChooseRules as Button).disabled = chosen == null
	(%RemoveType as Button).disabled = chosen == null or chosen is PCGCity and (chosen as PCGCity).street_rules == null
	(%RemoveType as Button).tooltip_text = "Leave the streets to the rules that ship" if chosen is PCGCity else "Remove the selected type of lot"
	subject_chosen.emit(chosen)


## Gives a type the weight that stands in its row, or streets whether rules build them.
func take_row(item: TreeItem) -> void:
	var type: PCGLotType = item.get_metadata(0) as PCGLotType
	if type:
		_commit("Set the weight of %s" % type.type, type, &"weight", item.get_range(1), UndoRedo.MERGE_ENDS)
	else:
		_commit("Set whether rules build streets", context.city, &"use_street_rules", item.is_checked(1))


## The rules of a row: of a type of lot, or of a city's streets.
func get_rules(subject: Object) -> PCGRuleSet:
	return context.get_street_rules(subject as PCGCity) if subject is PCGCity else (subject as PCGLotType).rules if subject else null


func _on_activated() -> void:
	if get_rules(get_chosen()):
		EditorInterface.edit_resource(get_rules(get_chosen()))


func _commit(title: String, object: Object, property: StringName, value: Variant, merge: UndoRedo.MergeMode = UndoRedo.MERGE_DISABLE) -> void:
	var undo: EditorUndoRedoManager = context.get_undo()
	undo.create_action(title, merge, context.city)
	undo.add_do_property(object, property, value)
	undo.add_undo_property(object, property, object.get(property))
	undo.commit_action()


## Adds a type that is called like the file of its rules.
func add_type(rules: PCGRuleSet) -> void:
	var type := PCGLotType.new()
	type.type = rules.get_file().get_file().get_basename()
	type.weight = FIRST_WEIGHT
	type.rules = rules
	_commit("Add lots of type %s" % type.type, context.city, &"lot_types", context.city.lot_types + ([type] as Array[PCGLotType]))


## Removes a type; streets are left to the rules that ship.
func remove_chosen() -> void:
	var chosen: PCGLotType = get_chosen() as PCGLotType
	if chosen == null:
		_commit("Take back the rules of the streets", context.city, &"street_rules", null)
		return
	_commit("Remove lots of type %s" % chosen.type, context.city, &"lot_types",
			context.city.lot_types.filter(func(type: PCGLotType) -> bool: return type != chosen))


## Gives a type or the streets other rules; attributes that were set stay, and hold where the new rules have them.
func give_rules(subject: Object, rules: PCGRuleSet) -> void:
	if subject is PCGCity:
		_commit("Set the rules of the streets", subject, &"street_rules", rules)
	else:
		_commit("Set the rules of %s" % (subject as PCGLotType).type, subject, &"rules", rules)


func _ask_for_rules(is_for_chosen: bool) -> void:
	_asked_for = get_chosen() if is_for_chosen else null
	if _dialog == null:
		_dialog = EditorFileDialog.new()
		_dialog.file_mode = EditorFileDialog.FILE_MODE_OPEN_FILE
		_dialog.access = EditorFileDialog.ACCESS_RESOURCES
		_dialog.add_filter("*.cga", "Rules that build lots")
		_dialog.file_selected.connect(_on_file_selected)
		add_child(_dialog)
	_dialog.popup_file_dialog()


func _on_file_selected(path: String) -> void:
	if _asked_for:
		give_rules(_asked_for, load(path))
	else:
		add_type(load(path))
