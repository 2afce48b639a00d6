@tool
extends ConfirmationDialog
## Asks for an entry that is put into a person's agenda by hand.

## The entry as CitizenManager.insert_task() wants it.
signal entry_made(task: Dictionary)

const SceneContext := preload("res://addons/pcg/editor/scene_context.gd")
const KINDS: PackedStringArray = ["stayInside", "goToBuilding"]
const KIND_TITLES: PackedStringArray = ["Be inside from the beginning", "Set out at the beginning"]
const SECONDS_PER_HOUR := 3600.0

var _today := 0

@onready var _kind: OptionButton = %Kind
@onready var _place: OptionButton = %Place
@onready var _when: OptionButton = %When


func _ready() -> void:
	for title: String in KIND_TITLES:
		_kind.add_item(title)
	confirmed.connect(func() -> void: entry_made.emit(make_task()))


## Shows the dialog with what `entry` says, as CitizenManager.get_agenda() tells it; an empty one begins at noon.
func ask(context: SceneContext, entry: Dictionary) -> void:
	var home: int = context.citizens.get_person(context.person)["home"]
	fill(context, entry if not entry.is_empty() else {"kind": "goToBuilding", "target": home, "start": 12.0 * SECONDS_PER_HOUR, "end": 13.0 * SECONDS_PER_HOUR})
	popup_centered()


func fill(context: SceneContext, entry: Dictionary) -> void:
	_today = context.citizens.day
	_kind.select(maxi(0, KINDS.find(entry["kind"])))
	_place.clear()
	for building: int in context.city.get_building_count():
		_place.add_item(context.get_building_text(building), building)
	_place.select(_place.get_item_index(int(entry["target"])) if int(entry["target"]) >= 0 else 0)
	(%Start as SpinBox).value = float(entry["start"]) / SECONDS_PER_HOUR
	(%End as SpinBox).value = float(entry["end"]) / SECONDS_PER_HOUR
	_when.clear()
	_when.add_item("on the day that the clock shows")
	_when.add_item("every day")


func make_task() -> Dictionary:
	var task := {"kind": KINDS[_kind.selected], "target": _place.get_selected_id(), "start": (%Start as SpinBox).value * SECONDS_PER_HOUR,
			"end": (%End as SpinBox).value * SECONDS_PER_HOUR}
	if _when.selected == 0:
		task["day"] = _today
	return task
