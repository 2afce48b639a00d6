@tool
extends RefCounted
## The words of one rule language as an editor needs them. Operations, functions, variables and annotations come from the tables that the compiler itself
## uses; rules and attributes from the text and, through its last good compilation, from what it imports.

# Text that somebody is typing compiles seldom, so names that it defines are found by these; what does compile tells them itself.
const RULE_PATTERN := "(?m)^[ \\t]*([A-Za-z_]\\w*)[ \\t]*(\\([^)\\n]*\\))?[ \\t]*(?:=[ \\t\\n]*.*)?--?>"
const VALUE_PATTERN := "(?m)^[ \\t]*(?:(attr|const)[ \\t]+)?([A-Za-z_]\\w*)[ \\t]*(\\([^)\\n]*\\))?[ \\t]*=(?!=)"

var dialect: PCGRuleSet.Dialect
var builtins: Array[Dictionary] = []
var keywords: PackedStringArray = PCGRuleSet.get_keywords()
var _helps: Dictionary[String, PackedStringArray] = {}
var _imported: Array[Dictionary] = [] # definitions, as PCGRuleSet.get_definitions() tells them
var _rule_pattern := RegEx.create_from_string(RULE_PATTERN)
var _value_pattern := RegEx.create_from_string(VALUE_PATTERN)


func _init(of: PCGRuleSet.Dialect) -> void:
	dialect = of
	builtins = PCGRuleSet.get_builtins(dialect)
	for entry: Dictionary in builtins:
		var name: String = entry["name"]
		var lines: PackedStringArray = _helps.get(name, PackedStringArray())
		lines.append("%s\n%s" % [entry["signature"], entry["help"]])
		_helps[name] = lines


## What hovering over `word` tells; empty if the language does not have it.
func get_help(word: String) -> String:
	return "\n\n".join(_helps.get(word, PackedStringArray()))


## Names that the compiled rules define, with those of imported files.
func take_definitions(rules: PCGRuleSet) -> void:
	var found: Array[Dictionary] = rules.get_definitions()
	if not found.is_empty():
		_imported = found


## Rules and values that `text` defines: dictionaries with `kind`, `name`, `signature` and `line` (from 0).
func find_definitions(text: String) -> Array[Dictionary]:
	var found: Array[Dictionary] = []
	for match: RegExMatch in _rule_pattern.search_all(text):
		found.append(_definition("rule", match.get_string(1), match.get_string(2), text, match.get_start(1)))
	for match: RegExMatch in _value_pattern.search_all(text):
		found.append(_definition("attribute", match.get_string(2), match.get_string(3), text, match.get_start(2)))
	return found


static func _definition(kind: String, name: String, parameters: String, text: String, at: int) -> Dictionary:
	return {"kind": kind, "name": name, "signature": name + parameters, "line": text.count("\n", 0, at) if at > 0 else 0}


## Where `word` is defined: `file` and `line` (from 1), or an empty dictionary. What the text says goes before what was compiled.
func find_definition(word: String, path: String, text: String) -> Dictionary:
	for entry: Dictionary in find_definitions(text):
		if entry["name"] == word:
			return {"file": path, "line": int(entry["line"]) + 1}
	for entry: Dictionary in _imported:
		if entry["name"] == word:
			return {"file": entry["file"], "line": entry["line"]}
	return {}


## What may stand where `prefix` is being typed: dictionaries with `kind` and `name`, each name once.
func find_completions(prefix: String, text: String) -> Array[Dictionary]:
	var seen: Dictionary[String, bool] = {}
	var result: Array[Dictionary] = []
	for entry: Dictionary in _candidates(prefix, text):
		var name: String = entry["name"]
		if name != prefix and name.to_lower().begins_with(prefix.to_lower()) and not seen.has(name):
			seen[name] = true
			result.append(entry)
	return result


func _candidates(prefix: String, text: String) -> Array[Dictionary]:
	if prefix.begins_with("@"):
		return builtins.filter(_is_annotation)
	var result: Array[Dictionary] = []
	for keyword: String in keywords:
		result.append({"kind": "keyword", "name": keyword})
	result.append_array(find_definitions(text))
	result.append_array(_imported)
	result.append_array(builtins.filter(func(entry: Dictionary) -> bool: return not _is_annotation(entry)))
	return result


static func _is_annotation(entry: Dictionary) -> bool:
	return entry["kind"] == "annotation"
