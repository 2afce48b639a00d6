@tool
extends RefCounted
## The attributes of the rules of a lot type, or of a city's streets, as properties, so that the engine's inspector shows them: annotations become ranges,
## lists, colours and groups. Each shows what the rules say until it is set here, and can be reverted to that. What they draw or compute for each lot is no value but a text,
## as it is written; a value that is put in its place sets the attribute. What else a lot type has beside its weight and rules stands before them.

const OF_LOTS: Dictionary[StringName, Dictionary] = {
	&"lot/type": {"type": TYPE_STRING, "of": &"type"},
	&"lot/weight_map": {"type": TYPE_OBJECT, "hint": PROPERTY_HINT_RESOURCE_TYPE, "hint_string": "Texture2D", "of": &"weight_map", "none": null},
	&"lot/start_rule": {"type": TYPE_STRING, "of": &"start_rule", "none": ""},
} ## how each is shown, what the lot type calls it, and what it is where nothing is set; no attribute of rules has a slash in its name

const NO_GROUP := "General" ## the heading of attributes without a group; without one they would seem to be no part of the rules, between those that have

## A PCGLotType, or the PCGCity whose streets these are; null: nobody, or a city that is gone (steps to undo live longer).
var subject: Object:
	get:
		return subject if is_instance_valid(subject) else null
var rules: PCGRuleSet
var _typed: Dictionary[StringName, String] = {} # texts that somebody is typing, shown in place of the values that they mean so far
var _holder := &"" # the subject's property that has the values that are set
var _entries: Dictionary[StringName, Dictionary] = {} # name to { property, default }


func _init(of: Object, built_by: PCGRuleSet) -> void:
	subject = of
	rules = built_by
	_holder = &"street_attributes" if subject is PCGCity else &"attributes"
	if subject and rules:
		_read(rules.get_attributes())


func _set_values() -> Dictionary:
	return subject.get(_holder)


func is_empty() -> bool:
	return _entries.is_empty()


func _has(name: StringName) -> bool:
	return subject != null and _entries.has(name)


# A group holds for the attributes behind it, until the next one.
func _read(attributes: Array[Dictionary]) -> void:
	var group := NO_GROUP
	var own_file: String = rules.get_file()
	for attribute: Dictionary in attributes:
		if attribute["file"] != own_file and not own_file.is_empty():
			continue
		var annotations: Dictionary = attribute["annotations"]
		group = annotations["Group"][0] if annotations.has("Group") and not annotations["Group"].is_empty() else group
		if attribute["is_constant"] or attribute["is_plain"] or annotations.has("Hidden"):
			continue
		var property: Dictionary = to_property(attribute)
		_entries[StringName(property["name"])] = {"property": property, "group": group, "default": attribute["default"]}


## How the engine's inspector shows an attribute that [method PCGRuleSet.get_attributes] describes.
static func to_property(attribute: Dictionary) -> Dictionary:
	var annotations: Dictionary = attribute["annotations"]
	var property := {"name": attribute["name"], "type": _type_of(attribute), "hint": PROPERTY_HINT_NONE, "hint_string": "",
			"usage": PROPERTY_USAGE_EDITOR}
	var range_arguments: Array = annotations.get("Range", annotations.get("Enum", []))
	if annotations.has("Color"):
		property["type"] = TYPE_COLOR
		property["hint"] = PROPERTY_HINT_COLOR_NO_ALPHA
	elif annotations.has("File"):
		property["hint"] = PROPERTY_HINT_FILE
		property["hint_string"] = ",".join(PackedStringArray(annotations["File"].map(func(end: String) -> String: return "*." + end)))
	elif property["type"] == TYPE_STRING and not range_arguments.is_empty():
		property["hint"] = PROPERTY_HINT_ENUM
		property["hint_string"] = ",".join(PackedStringArray(range_arguments.filter(func(value: String) -> bool: return not value.contains("="))))
	elif property["type"] == TYPE_FLOAT:
		property["hint"] = PROPERTY_HINT_RANGE
		property["hint_string"] = _range_text(range_arguments, annotations)
	return property


# Where the compiler does not know the type without running, what is written tells it.
static func _type_of(attribute: Dictionary) -> Variant.Type:
	match attribute["type"]:
		"true or false":
			return TYPE_BOOL
		"text":
			return TYPE_STRING
		"a number":
			return TYPE_FLOAT
	var allowed: Array = attribute["annotations"].get("Range", [])
	if not allowed.is_empty():
		return TYPE_FLOAT if str(allowed[0]).contains("=") or str(allowed[0]).is_valid_float() else TYPE_STRING
	var default: String = attribute["default"]
	if default.contains("\""):
		return TYPE_STRING
	return TYPE_BOOL if default.contains("true") or default.contains("false") or default.begins_with("p(") else TYPE_FLOAT


static func _range_text(arguments: Array, annotations: Dictionary) -> String:
	var named := {"min": "", "max": "", "stepsize": ""}
	var order: Array = named.keys()
	for index: int in arguments.size():
		var argument: String = arguments[index]
		var key: String = argument.get_slice("=", 0).strip_edges() if argument.contains("=") else order[mini(index, 2)]
		if named.has(key):
			named[key] = argument.get_slice("=", 1).strip_edges() if argument.contains("=") else argument
	var is_open: bool = str(named["min"]).is_empty() or str(named["max"]).is_empty()
	var text: String = "%s,%s,%s" % [_or(named["min"], "-1000"), _or(named["max"], "1000"), _or(named["stepsize"], "0.01")]
	text += ",or_greater,or_less,hide_slider" if is_open else ""
	if annotations.has("Angle"):
		text += ",suffix:°"
	elif annotations.has("Distance"):
		text += ",suffix:m"
	return text


static func _or(text: String, otherwise: String) -> String:
	return otherwise if text.is_empty() else text


func _get_property_list() -> Array[Dictionary]:
	var list: Array[Dictionary] = []
	for name: StringName in OF_LOTS:
		if subject is PCGLotType:
			list.append(OF_LOTS[name].merged({"name": name, "usage": PROPERTY_USAGE_EDITOR}))
	var group := ""
	for name: StringName in _entries if subject else ({} as Dictionary[StringName, Dictionary]):
		if _entries[name]["group"] != group:
			group = _entries[name]["group"]
			list.append({"name": group, "type": TYPE_NIL, "usage": PROPERTY_USAGE_GROUP, "hint_string": ""})
		list.append(_shown_property(name))
	return list


func _shown_property(name: StringName) -> Dictionary:
	var property: Dictionary = _entries[name]["property"].duplicate()
	if _get(name) is String and property["type"] != TYPE_STRING:
		var suggestions: String = "true,false" if property["type"] == TYPE_BOOL else ""
		property.merge({"type": TYPE_STRING, "hint": PROPERTY_HINT_ENUM_SUGGESTION if not suggestions.is_empty() else PROPERTY_HINT_NONE, "hint_string": suggestions}, true)
	elif property["hint"] == PROPERTY_HINT_ENUM and not _set_values().has(String(name)) and _plain_default(name) == null:
		property["hint"] = PROPERTY_HINT_ENUM_SUGGESTION
	return property


func _get(name: StringName) -> Variant:
	if OF_LOTS.has(name):
		return subject.get(OF_LOTS[name]["of"])
	if not _has(name):
		return null
	if _typed.has(name):
		return _typed[name]
	var value: Variant = _set_values().get(String(name), _plain_default(name))
	if value == null:
		return _entries[name]["default"]
	return Color(str(value)) if _entries[name]["property"]["type"] == TYPE_COLOR else value


func _set(name: StringName, value: Variant) -> bool:
	if OF_LOTS.has(name):
		subject.set(OF_LOTS[name]["of"], value)
		EditorInterface.mark_scene_as_unsaved()
		return true
	if not _has(name):
		return false
	_typed.erase(name)
	if value is String and _entries[name]["property"]["type"] != TYPE_STRING:
		_typed[name] = value
	var attributes: Dictionary = _set_values().duplicate()
	attributes.erase(String(name))
	var written: Variant = _read_value(name, value)
	if written != null and written != _read_value(name, _property_get_revert(name)):
		attributes[String(name)] = written
	subject.set(_holder, attributes)
	EditorInterface.mark_scene_as_unsaved()
	return true


## Shows each attribute by the control for its value. Controls are made anew, so call it while nobody types.
func end_typing() -> void:
	_typed.clear()
	notify_property_list_changed()


func _property_can_revert(name: StringName) -> bool:
	if OF_LOTS.has(name):
		return OF_LOTS[name].has("none") and _get(name) != OF_LOTS[name]["none"]
	return _has(name) and _set_values().has(String(name))


func _property_get_revert(name: StringName) -> Variant:
	if OF_LOTS.has(name):
		return OF_LOTS[name].get("none")
	var default: Variant = _plain_default(name)
	if default == null:
		return _entries[name]["default"]
	return Color(str(default)) if _entries[name]["property"]["type"] == TYPE_COLOR else default


# As rules take it; null for a text that is no such value.
func _read_value(name: StringName, value: Variant) -> Variant:
	if value is Color:
		return "#" + (value as Color).to_html(false)
	return _read_text(name, value) if value is String else value


func _read_text(name: StringName, text: String) -> Variant:
	match _entries[name]["property"]["type"]:
		TYPE_FLOAT:
			return text.to_float() if text.is_valid_float() else null
		TYPE_BOOL:
			return text == "true" if text in ["true", "false"] else null
		TYPE_COLOR:
			return text if Color.html_is_valid(text) else null
	return text


# The value that the rules give, where it is one for all lots; else null.
func _plain_default(name: StringName) -> Variant:
	var text: String = _entries[name]["default"]
	if _entries[name]["property"]["type"] not in [TYPE_STRING, TYPE_COLOR]:
		return _read_text(name, text)
	var inside: String = text.trim_prefix("\"").trim_suffix("\"")
	return _read_text(name, inside) if text == "\"%s\"" % inside and not inside.contains("\"") else null
