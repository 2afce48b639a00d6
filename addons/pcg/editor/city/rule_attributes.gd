@tool
extends RefCounted
## The attributes of a lot type's rules as properties, so that the engine's inspector shows them: annotations become ranges, lists, colours and
## groups. A property that is not ticked is left to the rules.

signal attribute_changed

var lot_type: PCGLotType
var _entries: Dictionary[StringName, Dictionary] = {} # name to { property, default }


func _init(of: PCGLotType) -> void:
	lot_type = of
	if lot_type and lot_type.rules:
		_read(lot_type.rules.get_attributes())


func is_empty() -> bool:
	return _entries.is_empty()


# A group holds for the attributes behind it, until the next one.
func _read(attributes: Array[Dictionary]) -> void:
	var group := ""
	var own_file: String = lot_type.rules.get_file()
	for attribute: Dictionary in attributes:
		var annotations: Dictionary = attribute["annotations"]
		group = annotations["Group"][0] if annotations.has("Group") and not annotations["Group"].is_empty() else group
		if attribute["is_constant"] or attribute["is_plain"] or annotations.has("Hidden") or attribute["file"] != own_file and not own_file.is_empty():
			continue
		var default: String = _default_text(attribute)
		var property: Dictionary = to_property(attribute, default)
		_entries[StringName(property["name"])] = {"property": property, "group": group, "default": default}


## How the engine's inspector shows an attribute that [method PCGRuleSet.get_attributes] describes, and whose value is written as `default`.
static func to_property(attribute: Dictionary, default: String) -> Dictionary:
	var annotations: Dictionary = attribute["annotations"]
	var property := {"name": attribute["name"], "type": _type_of(attribute, default), "hint": PROPERTY_HINT_NONE, "hint_string": "",
			"usage": PROPERTY_USAGE_EDITOR | PROPERTY_USAGE_CHECKABLE}
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
static func _type_of(attribute: Dictionary, default: String) -> Variant.Type:
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


# What the rules say themselves: the text behind the name's "=".
func _default_text(attribute: Dictionary) -> String:
	var lines: PackedStringArray = lot_type.rules.source.split("\n")
	var line: int = int(attribute["line"]) - 1
	return lines[line].get_slice("=", 1).strip_edges() if line >= 0 and line < lines.size() else ""


## What the rules say themselves about an attribute, as text.
func get_default_text(name: StringName) -> String:
	return _entries[name]["default"] if _entries.has(name) else ""


func _get_property_list() -> Array[Dictionary]:
	var list: Array[Dictionary] = []
	var group := ""
	for name: StringName in _entries:
		if _entries[name]["group"] != group:
			group = _entries[name]["group"]
			list.append({"name": group, "type": TYPE_NIL, "usage": PROPERTY_USAGE_GROUP, "hint_string": ""})
		var property: Dictionary = _entries[name]["property"].duplicate()
		if lot_type.attributes.has(String(name)):
			property["usage"] |= PROPERTY_USAGE_CHECKED
		list.append(property)
	return list


func _get(name: StringName) -> Variant:
	if not _entries.has(name):
		return null
	var value: Variant = lot_type.attributes.get(String(name))
	return Color(str(value)) if value != null and _entries[name]["property"]["type"] == TYPE_COLOR else value


func _set(name: StringName, value: Variant) -> bool:
	if not _entries.has(name):
		return false
	var attributes: Dictionary = lot_type.attributes.duplicate()
	var is_new: bool = not attributes.has(String(name))
	if value == null:
		attributes.erase(String(name))
	else:
		attributes[String(name)] = _first_value(name) if is_new and value == _blank(value) else _to_rules(value)
	lot_type.attributes = attributes
	EditorInterface.mark_scene_as_unsaved()
	if is_new or value == null:
		notify_property_list_changed()
	attribute_changed.emit()
	return true


static func _to_rules(value: Variant) -> Variant:
	return "#" + (value as Color).to_html(false) if value is Color else value


static func _blank(value: Variant) -> Variant:
	return type_convert(null, typeof(value))


# Ticking a property begins with the rules' own value where that is plain, else with the least allowed.
func _first_value(name: StringName) -> Variant:
	var property: Dictionary = _entries[name]["property"]
	var text: String = _entries[name]["default"]
	match property["type"]:
		TYPE_FLOAT:
			return text.to_float() if text.is_valid_float() else maxf(0.0, str(property["hint_string"]).get_slice(",", 0).to_float())
		TYPE_BOOL:
			return text == "true"
		TYPE_COLOR:
			return text.trim_prefix("\"").trim_suffix("\"") if text.begins_with("\"#") else "#ffffff"
	if property["hint"] == PROPERTY_HINT_ENUM:
		return str(property["hint_string"]).get_slice(",", 0)
	return text.trim_prefix("\"").trim_suffix("\"") if text.begins_with("\"") else ""
