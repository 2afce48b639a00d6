@tool
extends RefCounted
## One colour for each kind of agenda entry, told apart on light and on dark ground; stays at home are paler.

const COLORS: Dictionary[String, Color] = {
	"stayInside": Color("#5b8dd6"),
	"goToBuilding": Color("#e0a030"),
	"accompany": Color("#c86bb8"),
	"delayedRule": Color("#4fae72"),
	"floatingSlot": Color("#8d8d8d"),
	"home": Color("#a9c3ea"),
	"inside": Color("#5b8dd6"),
	"outside": Color("#e0a030"),
}
const TITLES: Dictionary[String, String] = {
	"stayInside": "At",
	"goToBuilding": "Go to",
	"accompany": "Accompany",
	"delayedRule": "Run a rule",
	"floatingSlot": "Find time for a rule",
}


static func of(kind: String) -> Color:
	return COLORS.get(kind, Color.GRAY)


## The colour of an entry of somebody who lives in building `home`.
static func of_entry(entry: Dictionary, home: int) -> Color:
	return of("home" if entry["kind"] == "stayInside" and entry["target"] == home else entry["kind"])


## A colour for a time of the day, as in the paper's figure of paths: from blue in the morning over yellow to red in the evening.
static func of_hour(hour: float) -> Color:
	return Color.from_hsv(lerpf(0.66, 0.0, clampf((hour - 6.0) / 16.0, 0.0, 1.0)), 0.85, 0.95)
