@tool
extends RefCounted
## Which persons a list shows. Every word must fit: a part of the name, the type of household or a type of building in the agenda, "woman", "man",
## "outside", or a comparison such as "age<18", "age>=65", "household=12".

const NUMBER_PATTERN := "^(age|household|home|id)(<=|>=|<|>|=)(\\d+)$"

var _words := PackedStringArray()
var _number := RegEx.create_from_string(NUMBER_PATTERN)


func _init(text: String) -> void:
	_words = text.to_lower().split(" ", false)


## `person` as CitizenManager.get_person() tells it, with `household_type` and `visits`, the types of building in the agenda.
func fits(person: Dictionary) -> bool:
	for word: String in _words:
		if not _fits_word(person, word):
			return false
	return true


func _fits_word(person: Dictionary, word: String) -> bool:
	var comparison: RegExMatch = _number.search(word)
	if comparison:
		return _compare(int(person[comparison.get_string(1)]), comparison.get_string(2), comparison.get_string(3).to_int())
	if word in ["woman", "man"]:
		return person["gender"] == word
	if word == "outside":
		return person.get("state", "inside") != "inside"
	var told: String = "%s %s %s" % [person["name"], person["household_type"], " ".join(person["visits"])]
	return told.to_lower().contains(word)


static func _compare(value: int, operator: String, limit: int) -> bool:
	match operator:
		"<":
			return value < limit
		"<=":
			return value <= limit
		">":
			return value > limit
		">=":
			return value >= limit
	return value == limit
