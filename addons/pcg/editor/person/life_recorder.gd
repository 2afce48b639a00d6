@tool
extends RefCounted
## Notes when one person is inside and outside, and where outdoors it stays, from the moment that somebody looks at them.

const DAY := 86400.0 ## seconds
const LONGEST := 7.0 * DAY ## what is older is on no row of the week any more
const SAME_PLACE := 1.0 ## metres

var spans: Array[Dictionary] = [] # `start`, `end` (seconds since the first Monday) and `kind`, "home", "inside" (elsewhere) or "outside"
var stops: Array[Dictionary] = [] # places outdoors that were reached: `time` (seconds since the first Monday) and `position`
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
	stops.clear()


# What lies between two moments that were jumped over was not lived.
func _begin_anew() -> void:
	if not spans.is_empty() and present() < float(spans[-1]["end"]):
		spans.clear()
		stops.clear()
	spans.append({"start": present(), "end": present(), "kind": _kind()})


func present() -> float:
	return _citizens.day * DAY + _citizens.time


func _kind() -> String:
	var told: Dictionary = _citizens.get_person(_person)
	if told.get("state", "inside") != "inside":
		return "outside"
	return "home" if told.get("place", {}).get("id", -1) == told["home"] else "inside"


## Call as often as changes shall be seen. Returns whether another place outdoors was reached.
func note() -> bool:
	if not is_instance_valid(_citizens) or not _citizens.is_running() or not _citizens.has_person(_person):
		return false
	var kind: String = _kind()
	if spans.is_empty() or spans[-1]["kind"] != kind:
		spans.append({"start": spans[-1]["end"] if not spans.is_empty() else present(), "end": present(), "kind": kind})
	spans[-1]["end"] = present()
	var is_new: bool = _note_stop(_citizens.get_person(_person))
	while present() - float(spans[0]["end"]) > LONGEST:
		spans.remove_at(0)
	while not stops.is_empty() and present() - float(stops[0]["time"]) > LONGEST:
		stops.remove_at(0)
	return is_new


func _note_stop(told: Dictionary) -> bool:
	if told["state"] not in ["at-place", "waiting"] or told["place"].get("kind", "") == "building":
		return false
	var is_known: bool = not stops.is_empty() and float(stops[-1]["time"]) >= float(spans[-1]["start"]) \
			and (stops[-1]["position"] as Vector3).distance_to(told["position"]) < SAME_PLACE
	if not is_known:
		stops.append({"time": present(), "position": told["position"]})
	return not is_known
