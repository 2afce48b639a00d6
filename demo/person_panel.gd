class_name DemoPersonPanel
extends PanelContainer
## Who somebody is, what they do now, and their agenda of the day: when, what, where to, and which rule wants it.

signal closed

const SECONDS_BETWEEN_TEXTS := 0.5
const ROOM_BELOW := 32.0 ## pixels to the lower edge of the screen; longer agendas scroll
const LEAST_HEIGHT := 80.0
const WIDTH := 360.0
const LEAST_WIDTH := 240.0 ## on narrow screens, so that it stands beside the clock
const LEFT_PANEL := 340.0
const MARGIN := 16.0
const DAY_SECONDS := 86400.0
const DOING := { "inside": "is inside", "walking": "is on the way to", "waiting": "waits at", "at-place": "is at" }
const NOW_COLOR := "#ffd479"
const DIM_COLOR := "#9fb0b8"

@export var citizens: CitizenManager
@export var city: PCGCity

var person := -1
var _age := INF

@onready var _name: Label = %Name
@onready var _now: Label = %Now
@onready var _agenda: RichTextLabel = %Agenda
@onready var _close: Button = %Close


func _ready() -> void:
	_close.pressed.connect(close)
	hide()


func show_person(id: int) -> void:
	person = id
	visible = id >= 0
	_age = INF


func close() -> void:
	show_person(-1)
	closed.emit()


func _process(delta: float) -> void:
	_age += delta
	if visible and _age > SECONDS_BETWEEN_TEXTS and citizens.is_running():
		_age = 0.0
		write()


func write() -> void:
	var who: Dictionary = citizens.get_person(person)
	_name.text = "%s, %d" % [who["name"], who["age"]]
	_now.text = describe_now(who)
	_agenda.text = describe_agenda(who)
	custom_minimum_size.x = clampf(get_viewport_rect().size.x - LEFT_PANEL - 2.0 * MARGIN, LEAST_WIDTH, WIDTH)
	var room: float = get_viewport_rect().size.y - _agenda.global_position.y - ROOM_BELOW
	_agenda.custom_minimum_size.y = clampf(_agenda.get_content_height(), 0.0, maxf(room, LEAST_HEIGHT))
	reset_size()
	position = Vector2(get_viewport_rect().size.x - size.x - MARGIN, MARGIN)


## A sentence such as "is on the way to school 12, arrives at 07:58".
func describe_now(who: Dictionary) -> String:
	var state: String = who.get("state", "")
	var place: Dictionary = who.get("place", {})
	var doing: String = "sits on" if state == "at-place" and place["kind"] == "object" else DOING.get(state, state)
	var text: String = "%s %s" % [doing, _name_of_place(who, place)]
	if who.has("arrival"):
		text += ", arrives at %s" % CitizenManager.format_clock(fposmod(who["arrival"], DAY_SECONDS))
	if int(who.get("leader", -1)) not in [-1, person]:
		text += ", with %s" % citizens.get_person(who["leader"])["name"]
	return text


## One line for each entry that holds today; the present one stands out.
func describe_agenda(who: Dictionary) -> String:
	var lines := PackedStringArray()
	for entry: Dictionary in citizens.get_agenda(person, citizens.day):
		var is_now: bool = entry["start"] <= citizens.time and citizens.time < entry["end"]
		var line: String = "%s – %s  [b]%s[/b]" % [CitizenManager.format_clock(entry["start"]), CitizenManager.format_clock(entry["end"]), _describe_task(who, entry)]
		if is_now:
			line = "[color=%s]%s[/color]" % [NOW_COLOR, line]
		lines.append(line + "\n[color=%s]    %s, %s:%d[/color]" % [DIM_COLOR, entry.get("rule", ""), str(entry.get("file", "")).get_file(), entry.get("line", 0)])
	return "\n".join(lines)


func _describe_task(who: Dictionary, entry: Dictionary) -> String:
	var kind: String = entry["kind"]
	match kind:
		"delayedRule":
			return "follows %s" % entry["delayed_rule"]
		"accompany":
			var joiners: PackedInt32Array = entry["joiners"]
			return "walks with %s" % citizens.get_person(entry["leader"])["name"] if joiners.has(person) else "walks with %s" % ", ".join(_names(joiners))
		"stayInside":
			return "stays at home" if entry["target"] == who["home"] else "stays in %s" % _name_of_building(who, entry["target"])
		"goToBuilding":
			return "goes home" if entry["target"] == who["home"] else "goes to %s" % _name_of_building(who, entry["target"])
		"floatingSlot":
			return "has time for errands"
	return kind


func _names(persons: PackedInt32Array) -> PackedStringArray:
	var result := PackedStringArray()
	for id: int in persons:
		result.append(str(citizens.get_person(id)["name"]).get_slice(" ", 0))
	return result


func _name_of_place(who: Dictionary, place: Dictionary) -> String:
	match str(place.get("kind", "")):
		"":
			return "the street"
		"person":
			return "somebody"
		"building":
			return _name_of_building(who, place["id"])
	return "the %s" % place["type"]


func _name_of_building(who: Dictionary, id: int) -> String:
	return "home" if id == who["home"] else "%s %d" % [city.get_building(id).get("type", "building"), id]
