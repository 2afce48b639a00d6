@tool
extends RefCounted
## Colours for rule files, in those of the editor's own code.

const SETTINGS := "text_editor/theme/highlighting/"
const COLORS: Dictionary[String, String] = {"operation": "engine_type_color", "function": "function_color", "variable": "base_type_color",
		"annotation": "gdscript/annotation_color"} ## settings by what PCGRuleSet.get_builtins() calls `kind`


## Makes a highlighter for the words of a language.
static func make(language: Object, defined_rules: PackedStringArray) -> CodeHighlighter:
	var highlighter := CodeHighlighter.new()
	highlighter.number_color = _color("number_color")
	highlighter.symbol_color = _color("symbol_color")
	highlighter.function_color = _color("function_color")
	highlighter.member_variable_color = _color("member_variable_color")
	highlighter.add_color_region("\"", "\"", _color("string_color"))
	highlighter.add_color_region("//", "", _color("comment_color"), true)
	highlighter.add_color_region("#", "", _color("comment_color"), true)
	highlighter.add_color_region("/*", "*/", _color("comment_color"))
	for rule: String in defined_rules:
		highlighter.add_keyword_color(rule, _color("user_type_color"))
	for entry: Dictionary in language.get("builtins"):
		_add_builtin(highlighter, entry)
	for keyword: String in language.get("keywords"):
		highlighter.add_keyword_color(keyword, _color("control_flow_keyword_color" if keyword in ["case", "else"] else "keyword_color"))
	return highlighter


# A dotted name is coloured part by part, because the engine's highlighter knows words only.
static func _add_builtin(highlighter: CodeHighlighter, entry: Dictionary) -> void:
	var color: Color = _color(COLORS[entry["kind"]])
	var parts: PackedStringArray = str(entry["name"]).trim_prefix("@").split(".")
	highlighter.add_keyword_color(parts[0], color)
	for part: String in parts.slice(1):
		highlighter.add_member_keyword_color(part, color)


static func _color(name: String) -> Color:
	var settings: EditorSettings = EditorInterface.get_editor_settings()
	return settings.get_setting(SETTINGS + name) if settings.has_setting(SETTINGS + name) else Color.GRAY
