@tool
extends RefCounted
## Notes when one person is inside and outside, from the moment that somebody looks at them.

const DAY := 86400.0 ## seconds
const LONGEST := 7.0 * DAY ## what is older is on no row of the week any more

var spans: Array[Dictionary] = [] # `start`, `end` (seconds since the first Monday) and `kind`, "home", "inside" (elsewhere) or "outside"
var _person := -1
var _citizens: CitizenManager


func follow(citizens: CitizenManager, person: int) -> void:
	if citizens == _citizens and person == _person:
		return
	if is_instance_valid(_citizens) and _citizens != citizens:
		_citizens.time_jumped.disconnect(_begin_anew)
	if citizens and citizens != _citizens:
		citizens.time_jumped.connect(_begin_anew)
	_citizens = citizens
	_person = person
	spans.clear()


# What lies between two moments that were jumped over was not lived.
func _begin_anew() -> void:
	if not spans.is_empty() and present() < float(spans[-1]["end"]):
		spans.clear()
	spans.append({"start": present(), "end": present(), "kind": _kind()})


func present() -> float:
	return _citizens.day * DAY + _citizens.time


func _kind() -> String:
	var told: Dictionary = _citizens.get_person(_person)
	if told.get("state", "inside") != "inside":
		return "outside"
	return "home" if told.get("place", {}).get("id", -1) == told["home"] else "inside"


## Call as often as changes shall be seen.
func note() -> void:
	if not is_instance_valid(_citizens) or not _citizens.is_running() or not _citizens.has_person(_person):
		return
	var kind: String = _kind()
	if spans.is_empty() or spans[-1]["kind"] != kind:
		spans.append({"start": spans[-1]["end"] if not spans.is_empty() else present(), "end": present(), "kind": kind})
	spans[-1]["end"] = present()
	while present() - float(spans[0]["end"]) > LONGEST:
		spans.remove_at(0)
