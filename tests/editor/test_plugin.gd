@tool
extends "res://tests/editor/editor_suite.gd"
## The addon switched off and on while the editor runs.


func test_disabling_takes_everything_away_and_enabling_brings_it_back() -> void:
	for round: int in 2:
		EditorInterface.set_plugin_enabled("pcg", false)
		await frames(5)
		check(get_authoring() == null, "nothing is left of it")
		check_equal(_count_docks(), 0, "and no dock")
		EditorInterface.set_plugin_enabled("pcg", true)
		await frames(5)
		check(get_authoring() != null and get_authoring().dock.is_inside_tree(), "it is back")
		check_equal(_count_docks(), 2, "with its docks")


func _count_docks() -> int:
	return get_tree().root.find_children("*", "EditorDock", true, false).reduce(
			func(sum: int, dock: EditorDock) -> int: return sum + int(dock.layout_key.begins_with("pcg")), 0)


func test_rules_are_a_resource_while_it_is_off() -> void:
	EditorInterface.set_plugin_enabled("pcg", false)
	await frames(3)
	var rules: PCGRuleSet = load(write("res://typed/off.cga", "@StartRule\nLot --> X.\n"))
	EditorInterface.edit_resource(rules)
	await frames(3)
	check_equal(EditorInterface.get_inspector().get_edited_object(), rules, "rules are a resource all the same")
	EditorInterface.set_plugin_enabled("pcg", true)
	await frames(5)
	check(get_authoring().rules.open("res://typed/off.cga"), "and open again")
	get_authoring().rules.close_current()
