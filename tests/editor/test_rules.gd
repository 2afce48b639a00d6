@tool
extends "res://tests/editor/editor_suite.gd"
## Rule files in the editor: opened, typed in, broken, mended, saved.

const GOOD := "attr height = 9\n\n@StartRule\nLot -->\n\textrude(height) Mass\n\nMass --> X.\n"
const RulesDock := preload("res://addons/pcg/editor/rules/rules_dock.gd")
const RuleEdit := preload("res://addons/pcg/editor/rules/rule_edit.gd")

var _dock: RulesDock


func before_each() -> void:
	_dock = get_authoring().rules


func after_each() -> void:
	while _dock.get_current():
		_dock.get_current().tag_saved_version()
		_dock.close_current()


func _open(text: String, name: String = "lot.cga") -> RuleEdit:
	_dock.open(write("res://typed/" + name, text))
	await frames(2)
	return _dock.get_current()


func test_editing_the_resource_opens_its_text() -> void:
	var path: String = write("res://typed/lot.cga", GOOD)
	EditorInterface.edit_resource(load(path))
	await frames(3)
	check(_dock.get_current() != null and _dock.get_current().path == path, "its text is open")
	check_equal(_dock.get_current().text, GOOD, "the text")
	check(_dock.get_current().rules.has_errors() == false, "without errors")


func test_an_error_is_marked_a_second_after_the_last_key_and_goes_when_mended() -> void:
	var edit: RuleEdit = await _open(GOOD)
	edit.set_line(4, "\textrud(height) Mass")
	edit.text_changed.emit()
	check(edit.get_messages_at(4).is_empty(), "nothing is marked while somebody types")
	await edit.checked
	check_equal(edit.get_messages_at(4).size(), 1, "a message at the line")
	check(edit.get_line_gutter_icon(4, edit.get_gutter_count() - 1) != null, "an icon in the gutter")
	check(edit.get_tooltip_at(4, 0).contains("extrude"), "hovering tells what to do: %s" % edit.get_tooltip_at(4, 0))
	edit.set_line(4, "\textrude(height) Mass")
	edit.check()
	check(edit.get_messages_at(4).is_empty(), "mended")
	check(edit.get_line_gutter_icon(4, edit.get_gutter_count() - 1) == null, "no icon")


func test_a_file_with_errors_opens_and_its_list_leads_to_the_place() -> void:
	var edit: RuleEdit = await _open("@StartRule\nLot -->\n\textrude(3\n", "broken.cga")
	var shown: Array[Dictionary] = (_dock.get_node("%Problems") as Node).call("get_shown")
	check(not shown.is_empty() and shown[0]["severity"] == "error", "its errors are listed, before warnings: %s" % [shown])
	(_dock.get_node("%Problems") as Node).emit_signal("problem_activated", shown[0])
	check_equal(edit.get_caret_line(), int(shown[0]["line"]) - 1, "the caret stands there")


func test_columns_count_characters() -> void:
	var edit: RuleEdit = await _open("@StartRule\nLot --> /* niños */ extrude(heigth)\n", "foreign.cga")
	var told: Dictionary = edit.rules.get_diagnostics()[0]
	check_equal(int(told["column"]), 29, "behind the remark")
	_dock.open(edit.path, int(told["line"]), int(told["column"]))
	check_equal(edit.get_caret_column(), 28, "the caret stands before the name")


func test_words_have_the_colours_of_what_they_are() -> void:
	var edit: RuleEdit = await _open("@StartRule\nLot --> extrude(floor(scope.sx)) Mass\nMass --> case width > 3 : X. else : NIL // end\nattr width = 3\n")
	var colors: Dictionary[String, String] = {"@StartRule 0 1": "gdscript/annotation_color", "extrude 1 8": "engine_type_color", "floor 1 16": "function_color",
			"scope 1 22": "base_type_color", "Mass 1 33": "user_type_color", "case 2 9": "control_flow_keyword_color", "3 2 22": "number_color",
			"// 2 43": "comment_color", "attr 3 0": "keyword_color"}
	for word: String in colors:
		var line: Dictionary = edit.syntax_highlighter.get_line_syntax_highlighting(word.get_slice(" ", 1).to_int())
		var column: int = word.get_slice(" ", 2).to_int()
		var starts: Array = line.keys().filter(func(start: int) -> bool: return start <= column)
		var color: Color = line[starts.max()]["color"]
		check_equal(color, EditorInterface.get_editor_settings().get_setting("text_editor/theme/highlighting/" + colors[word]), "the colour of %s" % word)


func test_names_are_offered_and_explained() -> void:
	var edit: RuleEdit = await _open(GOOD)
	var names: Array = edit.words.find_completions("ext", edit.text).map(func(entry: Dictionary) -> String: return entry["name"])
	check(names.has("extrude"), "an operation: %s" % [names])
	names = edit.words.find_completions("Ma", edit.text).map(func(entry: Dictionary) -> String: return entry["name"])
	check(names.has("Mass"), "a rule of the file: %s" % [names])
	check(edit.get_tooltip_at(4, 3).contains("extrude(height)"), "help for an operation: %s" % edit.get_tooltip_at(4, 3))
	check(edit.words.get_help("scope.sx").length() > 10, "help for a dotted name")
	check(edit.words.get_help("@Order").begins_with("@Order(number)\n"), "help for an annotation: %s" % edit.words.get_help("@Order"))
	names = edit.words.find_completions("@", edit.text).map(func(entry: Dictionary) -> String: return entry["name"])
	check(names.has("@Range") and not names.has("extrude"), "annotations, and nothing else: %s" % [names])
	names = edit.words.find_completions("", edit.text).map(func(entry: Dictionary) -> String: return entry["name"])
	check(names.has("extrude") and not names.has("@Range"), "annotations only behind an @")
	check_equal(edit.words.find_definition("Mass", edit.path, edit.text), {"file": edit.path, "line": 7}, "where a rule is")


func test_every_builtin_of_both_languages_has_help() -> void:
	for dialect: PCGRuleSet.Dialect in [PCGRuleSet.DIALECT_CGA, PCGRuleSet.DIALECT_AGENDA]:
		var without: Array = PCGRuleSet.get_builtins(dialect).filter(func(entry: Dictionary) -> bool: return str(entry["help"]).is_empty())
		check_equal(without.size(), 0, "without help: %s" % [without.map(func(entry: Dictionary) -> String: return entry["name"])])
		check(PCGRuleSet.get_builtins(dialect).size() > 40, "a table")


func test_a_completion_is_put_as_the_word_needs_it() -> void:
	var edit: RuleEdit = await _open(GOOD)
	for case: Array in [["extru", "extrude("], ["scope.s", "scope.sx"], ["@Desc", "@Description"], ["Mas", "Mass"]]:
		edit.text = str(case[0])
		edit.set_caret_column(edit.text.length())
		edit.request_code_completion(true)
		var options: Array[Dictionary] = edit.get_code_completion_options()
		check(not options.is_empty() or case[0] == "Mas", "options for %s" % case[0])
		if not options.is_empty():
			edit.confirm_code_completion()
			check(edit.text.begins_with(str(case[1])), "%s becomes %s, not %s" % [case[0], case[1], edit.text])


func test_saving_writes_the_file_and_loaded_rules_follow() -> void:
	var edit: RuleEdit = await _open(GOOD, "saved.cga")
	var loaded: PCGRuleSet = load(edit.path)
	edit.text = GOOD.replace("Mass", "Body")
	check(edit.is_modified(), "it counts as changed")
	check_equal(_dock.get_unsaved_paths(), PackedStringArray([edit.path]), "and is named as unsaved")
	_dock.save_current()
	check(not edit.is_modified(), "then as saved")
	check(FileAccess.get_file_as_string(edit.path).contains("Body"), "the file has the text")
	check(not FileAccess.file_exists(edit.path + ".tmp"), "nothing else is left")
	check(loaded.get_rules().has("Body"), "rules that were loaded have it")


func test_a_new_file_has_no_errors_in_either_language() -> void:
	for path: String in ["res://typed/new.cga", "res://typed/new.pcg"]:
		check_equal(_dock.create(path), OK, "written")
		check(not (load(path) as PCGRuleSet).has_errors(), "%s: %s" % [path, (load(path) as PCGRuleSet).get_diagnostics_text()])


func test_shipped_rules_open_without_a_message() -> void:
	for folder: String in ["res://rules/cga", "res://rules/agenda"]:
		for file: String in DirAccess.get_files_at(folder):
			if file.get_extension() in ["cga", "pcg"]:
				_dock.open(folder.path_join(file))
				check(_dock.get_current().rules.get_diagnostics().is_empty(), "%s: %s" % [file, _dock.get_current().rules.get_diagnostics_text()])
