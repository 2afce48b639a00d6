extends "res://tests/godot/suite.gd"
## Rule files as resources: good ones, wrong ones, none at all.

const FOLDER := "user://rules_of_tests"


func before_each() -> void:
	DirAccess.make_dir_recursive_absolute(FOLDER)


func after_each() -> void:
	for file: String in DirAccess.get_files_at(FOLDER):
		DirAccess.remove_absolute(FOLDER.path_join(file))
	DirAccess.remove_absolute(FOLDER)


func _write(name: String, text: String) -> String:
	var path: String = FOLDER.path_join(name)
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.store_string(text)
	file.close()
	return path


func _first_diagnostic(rules: PCGRuleSet) -> Dictionary:
	return rules.get_diagnostics()[0] if not rules.get_diagnostics().is_empty() else {}


func test_a_cga_file_loads_as_a_resource() -> void:
	var path: String = _write("lot.cga", "attr height = 9\n@StartRule\nLot --> extrude(height) Mass\nMass --> X.\n")
	var rules: PCGRuleSet = load(path)
	check(rules != null, "load() gives a rule set")
	check(not rules.has_errors(), "without errors: %s" % [rules.get_diagnostics()])
	check_equal(rules.get_dialect(), PCGRuleSet.DIALECT_CGA, "the dialect follows from the extension")
	check_equal(rules.get_start_rules(), PackedStringArray(["Lot"]), "the start rule")
	check(rules.get_rules().has("Mass"), "the other rule")
	check_equal(rules.get_attributes()[0]["name"], "height", "the attribute")


func test_attributes_tell_their_defaults_as_written() -> void:
	var rules := PCGRuleSet.new()
	rules.source = "attr height =\n\t9 // metres\nattr isTall = height == 12\nattr width = rand(9.5, // at least\n\t12)\nattr last = -1\n@StartRule\nLot --> X.\n"
	var defaults: Dictionary = {}
	for attribute: Dictionary in rules.get_attributes():
		defaults[attribute["name"]] = attribute["default"]
	check_equal(defaults, {"height": "9", "isTall": "height == 12", "width": "rand(9.5, // at least\n\t12)", "last": "-1"}, "on the next line, with an `=`, over two lines")


func test_words_of_the_grammar_are_told() -> void:
	for word: String in ["attr", "case", "else", "import", "style", "with"]:
		check(PCGRuleSet.get_keywords().has(word), word)
	check(not PCGRuleSet.get_keywords().has("extrude"), "operations are no words of the grammar")


func test_a_pcg_file_is_an_agenda() -> void:
	var path: String = _write("day.pcg", "@StartRule\nHousehold --> members { true: stayInside(0h, 24h, home) }\n")
	var rules: PCGRuleSet = load(path)
	check_equal(rules.get_dialect(), PCGRuleSet.DIALECT_AGENDA, "the dialect follows from the extension")
	check(not rules.has_errors(), "without errors: %s" % [rules.get_diagnostics()])


func test_a_file_with_errors_loads_with_its_list_of_errors() -> void:
	var path: String = _write("wrong.cga", "@StartRule\nLot -->\n  extrude(3\nRoof --> X.\n")
	var rules: PCGRuleSet = load(path)
	check(rules != null and rules.has_errors(), "it loads, and says that it has errors")
	var first: Dictionary = _first_diagnostic(rules)
	check_equal(first.get("severity"), "error", "severity")
	check_equal(first.get("file"), path, "file")
	check(int(first.get("line", 0)) > 0 and int(first.get("column", 0)) > 0, "line and column are there: %s" % [first])


func test_an_unknown_name_in_an_agenda_has_line_column_and_a_suggestion() -> void:
	var path: String = _write("typo.pcg", "@StartRule\nHousehold --> members { true: stayInsid(0h, 24h, home) }\n")
	var first: Dictionary = _first_diagnostic(PCGRuleSet.from_file(path))
	check_equal(first.get("line"), 2, "line")
	check_equal(first.get("column"), 31, "column")
	check(str(first.get("message", "") + first.get("hint", "")).contains("stayInside"), "the nearest name is told: %s" % [first])


func test_a_missing_or_empty_or_binary_file_is_one_error_each() -> void:
	var paths: Array[String] = [FOLDER.path_join("none.cga"), _write("empty.cga", ""), FOLDER]
	for path: String in paths:
		var rules: PCGRuleSet = PCGRuleSet.from_file(path)
		check(rules.has_errors(), "%s is refused" % path)
		check_equal(rules.get_diagnostics().size(), 1, "%s gives one message" % path)


func test_rules_may_stand_in_the_resource_itself() -> void:
	var rules := PCGRuleSet.new()
	rules.source = "@StartRule\nLot --> X.\n"
	check(not rules.has_errors(), "compiles: %s" % [rules.get_diagnostics()])
	check_equal(rules.get_start_rules(), PackedStringArray(["Lot"]), "the start rule")


func test_a_reloaded_file_shows_its_new_text() -> void:
	var path: String = _write("again.cga", "@StartRule\nLot --> X.\n")
	var rules: PCGRuleSet = PCGRuleSet.from_file(path)
	_write("again.cga", "@StartRule\nHouse --> X.\n")
	rules.reload()
	check_equal(rules.get_start_rules(), PackedStringArray(["House"]), "the new start rule")


func test_rules_are_saved_as_a_rule_file() -> void:
	var rules := PCGRuleSet.new()
	rules.source = "@StartRule\nLot --> X.\n"
	var path: String = FOLDER.path_join("saved.cga")
	check_equal(ResourceSaver.get_recognized_extensions(rules).has("cga"), true, "the saver offers the language's extension")
	check_equal(ResourceSaver.save(rules, path), OK, "saved")
	check_equal(FileAccess.get_file_as_string(path), rules.source, "the file is the text")
	check_equal(rules.get_file(), path, "the rules are those of the file now")
	check_equal(Array(DirAccess.get_files_at(FOLDER)).filter(func(file: String) -> bool: return file.contains(".tmp")), [], "nothing else is left")
	check(not PCGRuleSet.from_file(path).has_errors(), "and it loads")
	DirAccess.make_dir_recursive_absolute(FOLDER.path_join("folder.cga"))
	expect_message("this is a folder")
	check_equal(ResourceSaver.save(rules, FOLDER.path_join("folder.cga")), ERR_FILE_CANT_WRITE, "what cannot be written is told")
	check_equal(rules.get_file(), path, "and changes nothing")
	DirAccess.remove_absolute(FOLDER.path_join("folder.cga"))


func test_text_is_compiled_as_though_it_stood_in_its_file() -> void:
	_write("parts.cga", "Part --> X.\n")
	var path: String = _write("whole.cga", "@StartRule\nLot --> X.\n")
	var rules: PCGRuleSet = PCGRuleSet.from_text(path, "import parts : \"parts.cga\"\n@StartRule\nHouse --> parts.Part\n")
	check(not rules.has_errors(), "it sees what lies beside it: %s" % [rules.get_diagnostics_text()])
	check(rules.get_definitions().any(func(entry: Dictionary) -> bool: return entry["name"] == "parts.Part" and str(entry["file"]).ends_with("parts.cga")),
			"where an imported rule is defined: %s" % [rules.get_definitions()])
	check_equal(PCGRuleSet.from_file(path).get_rules(), PackedStringArray(["Lot"]), "the file itself is as it was")


func test_a_household_table_tells_shares_and_refuses_bad_rows() -> void:
	var table: PCGHouseholdTable = PCGHouseholdTable.from_file("res://rules/data/households_us_acs2023.csv")
	check(not table.has_errors(), "the shipped table is good: %s" % [table.get_diagnostics()])
	var sum := 0.0
	for household: Dictionary in table.get_households():
		sum += household["share"]
	check_near(sum, 1.0, 1e-9, "shares add up")
	var preview: PackedInt32Array = table.preview_households(600)
	check_equal(preview.size(), table.get_households().size(), "a preview has a figure for each row")
	check(Array(preview).max() > 40 and preview == table.preview_households(600, 1), "and is the same each time: %s" % [preview])
	check_equal(Array(table.preview_households(-1)).max(), 0, "nobody is nobody")
	var wrong: PCGHouseholdTable = PCGHouseholdTable.from_file(_write("wrong.csv", "descriptor,count\none adult,-5\n"))
	check(wrong.has_errors(), "a negative count is refused")
	check_equal(wrong.get_diagnostics()[0]["line"], 2, "the row is named")
	check(PCGHouseholdTable.from_file(_write("none.csv", "descriptor,count\n")).has_errors(), "no rows are refused")


func test_scripts_add_functions_that_rules_call() -> void:
	check(PCGRuleSet.add_function("luckyFor", {"number": TYPE_FLOAT}, TYPE_BOOL, func(_person: int, number: float) -> bool: return number == 7.0), "added")
	check(PCGRuleSet.add_function("luckyFor", {"number": TYPE_FLOAT}, TYPE_BOOL, func(_person: int, number: float) -> bool: return number == 8.0), "replaced")
	var text := "@StartRule\nHousehold --> members { luckyFor(age): stayInside(0h, 24h, home) }\n"
	var good: PCGRuleSet = load(_write("lucky.pcg", text))
	check(not good.has_errors(), "rules call it: %s" % [good.get_diagnostics()])
	var wrong: PCGRuleSet = load(_write("unlucky.pcg", text.replace("age", '"seven"')))
	check_equal(_first_diagnostic(wrong).get("id"), "type-mismatch", "arguments are checked when a file is compiled")


func test_what_scripts_cannot_add_is_told() -> void:
	var never := func(_person: int) -> bool: return false
	expect_message("the language has 'home' already")
	check(not PCGRuleSet.add_function("home", {}, TYPE_BOOL, never), "a name that is taken")
	expect_message("'nothing' has a result that the agenda language does not know")
	check(not PCGRuleSet.add_function("nothing", {}, TYPE_OBJECT, never), "a result without a meaning")
	expect_message("parameter 'where' of 'nothing' has no type of the agenda language")
	check(not PCGRuleSet.add_operation("nothing", {"where": TYPE_VECTOR3}, never), "a parameter without a meaning")
