@tool
extends VBoxContainer
## Makes the people of a city and lists them.

const SceneContext := preload("res://addons/pcg/editor/scene_context.gd")
const PeopleHistory := preload("res://addons/pcg/editor/people/people_history.gd")
const PeopleFilter := preload("res://addons/pcg/editor/people/people_filter.gd")
const LONGEST_LIST := 500 ## rows; who looks for one of ten thousand filters
const LARGEST_PREVIEW := 100_000 ## persons; shares of more are the same

var context: SceneContext
var history: PeopleHistory
var _shown_citizens: CitizenManager

@onready var _inspector := EditorInspector.new()
@onready var _list: Tree = %List
@onready var _filter: LineEdit = %Filter
@onready var _shares: Tree = %Shares


func open(of: SceneContext) -> void:
	context = of
	history = PeopleHistory.new(context)
	context.changed.connect(refresh)
	context.get_undo().history_changed.connect(_show_shares)
	context.get_undo().version_changed.connect(_show_shares)
	_shares.visibility_changed.connect(_show_shares)
	refresh()


func _ready() -> void:
	(%Generate as Button).pressed.connect(generate)
	_filter.text_changed.connect(func(_text: String) -> void: fill_list())
	_list.item_selected.connect(func() -> void: context.choose_person(_list.get_selected().get_metadata(0)))
	_inspector.size_flags_vertical = SIZE_EXPAND_FILL
	_inspector.horizontal_scroll_mode = ScrollContainer.SCROLL_MODE_DISABLED
	(%Settings as Control).add_child(_inspector)
	_title(_list, ["Name", "Age", "Household"])
	_title(_shares, ["Household", "Table", "Drawn"])
	_take_theme()


static func _title(tree: Tree, titles: Array[String]) -> void:
	for column: int in titles.size():
		tree.set_column_title(column, titles[column])
		tree.set_column_title_alignment(column, HORIZONTAL_ALIGNMENT_LEFT)
		tree.set_column_clip_content(column, true)


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_node_ready():
		_take_theme()


func _take_theme() -> void:
	var em: float = 14.0 * EditorInterface.get_editor_scale()
	_filter.right_icon = get_theme_icon("Search", "EditorIcons")
	(%Generate as Button).icon = get_theme_icon("Reload", "EditorIcons")
	_list.set_column_expand(1, false)
	_list.set_column_expand_ratio(2, 4)
	for column: int in 3:
		_list.set_column_custom_minimum_width(column, roundi([7.5, 3.0, 5.0][column] * em))
	for column: int in [1, 2]:
		_shares.set_column_expand(column, false)
		_shares.set_column_custom_minimum_width(column, roundi(5.0 * em))


func refresh() -> void:
	var citizens: CitizenManager = context.citizens
	(%Empty as Control).visible = citizens == null
	(%Content as Control).visible = citizens != null
	if is_instance_valid(_shown_citizens) and _shown_citizens != citizens:
		_shown_citizens.population_generated.disconnect(_show_people)
		_shown_citizens.agendas_renewed.disconnect(_show_people)
		_shown_citizens.tree_exiting.disconnect(_inspector.edit)
		_shown_citizens.tree_entered.disconnect(_inspector.edit)
	if citizens and citizens != _shown_citizens:
		citizens.population_generated.connect(_show_people)
		citizens.agendas_renewed.connect(_show_people)
		citizens.tree_exiting.connect(_inspector.edit.bind(null)) # an inspector must not show what is gone
		citizens.tree_entered.connect(_inspector.edit.bind(citizens))
	_shown_citizens = citizens
	_inspector.edit(citizens)
	if citizens:
		(%Generate as Button).disabled = context.city == null or not context.city.is_generated()
		(%Generate as Button).tooltip_text = "Generate the city first" if (%Generate as Button).disabled else "Draw households from the table, house them and write everybody's week"
		_show_people()


func generate() -> void:
	history.generate(context.citizens)


## Gives people the agendas that their rules write now; who lives goes on from where it is.
func live_on(citizens: CitizenManager) -> void:
	if citizens.has_person(0):
		citizens.renew_agendas(true)
	elif citizens.city and citizens.city.is_generated():
		history.generate(citizens)


func _show_people() -> void:
	var figures: Dictionary = context.citizens.get_statistics()
	(%Told as Label).text = "%d persons, %d households" % [figures["persons"], figures["households"]]
	fill_list()
	_show_shares()


## One person as the list and its filter see them.
func describe(person: int) -> Dictionary:
	var told: Dictionary = context.citizens.get_person(person)
	told["household_type"] = context.get_household_type(told)
	var visits: Dictionary[String, bool] = {}
	for entry: Dictionary in context.citizens.get_agenda(person):
		if entry["kind"] in ["stayInside", "goToBuilding"]:
			visits[context.get_building(entry["target"]).get("type", "")] = true
	told["visits"] = PackedStringArray(visits.keys())
	return told


func fill_list() -> void:
	_list.clear()
	var root: TreeItem = _list.create_item()
	var filter := PeopleFilter.new(_filter.text)
	var left_out := 0
	var persons: int = context.count_persons()
	for person: int in persons:
		if root.get_child_count() >= LONGEST_LIST and _filter.text.is_empty():
			left_out = persons - LONGEST_LIST
			break
		var told: Dictionary = describe(person)
		if filter.fits(told):
			_add_row(root, told)
	if left_out > 0:
		var item: TreeItem = _list.create_item(root)
		item.set_text(0, "%d more: filter" % left_out)
		item.set_metadata(0, -1)


func _add_row(root: TreeItem, told: Dictionary) -> void:
	var item: TreeItem = _list.create_item(root)
	item.set_text(0, told["name"])
	item.set_text(1, str(told["age"]))
	item.set_text(2, told["household_type"])
	item.set_tooltip_text(0, "Person %d, household %d, home %s" % [told["id"], told["household"], context.get_building_text(told["home"])])
	item.set_tooltip_text(2, told["household_type"])
	item.set_metadata(0, told["id"])


func get_listed() -> Array[int]:
	var listed: Array[int] = []
	for item: TreeItem in _list.get_root().get_children():
		listed.append(item.get_metadata(0))
	return listed


## How often Generate would draw each row of the table, by row.
func preview() -> Dictionary[int, int]:
	var citizens: CitizenManager = context.citizens
	var counts: PackedInt32Array = citizens.household_table.preview_households(mini(citizens.person_count, LARGEST_PREVIEW), citizens.seed)
	var drawn: Dictionary[int, int] = {}
	for row: int in counts.size():
		drawn[row] = counts[row]
	return drawn


## How often each row of the table was drawn, by row.
func count_drawn() -> Dictionary[int, int]:
	var drawn: Dictionary[int, int] = {}
	var seen: Dictionary[int, bool] = {}
	for person: int in context.count_persons():
		var told: Dictionary = context.citizens.get_person(person)
		if not seen.has(told["household"]):
			seen[told["household"]] = true
			drawn[told["household_row"]] = drawn.get(told["household_row"], 0) + 1
	return drawn


## Whether Generate would draw other people than those who are there.
func is_preview() -> bool:
	var citizens: CitizenManager = context.citizens
	return citizens.population == null and citizens.household_table != null and not history.is_made_of_settings(citizens)


# Settings that change, also by undo, change what would be drawn.
func _show_shares() -> void:
	if context.citizens and _shares.is_visible_in_tree():
		_fill_shares()


func _fill_shares() -> void:
	_shares.clear()
	var root: TreeItem = _shares.create_item()
	var citizens: CitizenManager = context.citizens
	_shares.set_column_title(2, "Preview" if is_preview() else "Drawn")
	if citizens.household_table == null:
		return
	var counts: Dictionary[int, int] = preview() if is_preview() else count_drawn()
	var total: int = counts.values().reduce(func(sum: int, count: int) -> int: return sum + count, 0)
	var rows: Array[Dictionary] = citizens.household_table.get_households()
	for row: int in rows.size():
		var item: TreeItem = _shares.create_item(root)
		item.set_text(0, rows[row]["descriptor"])
		item.set_autowrap_mode(0, TextServer.AUTOWRAP_WORD_SMART)
		item.set_text(1, "%.1f %%" % (100.0 * float(rows[row]["share"])))
		item.set_text(2, "%.1f %%" % (100.0 * counts.get(row, 0) / total) if total > 0 else "")
		item.set_tooltip_text(2, "%d households" % counts.get(row, 0))
