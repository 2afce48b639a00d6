extends Node
## Runs every test_* method of every test_*.gd of a folder, or of those whose "file.method" holds a word, and counts.

const Suite := preload("res://tests/godot/suite.gd")

var passed := 0
var failed := 0


func run(folder: String, word: String) -> void:
	for file: String in DirAccess.get_files_at(folder):
		if file.begins_with("test_") and file.ends_with(".gd"):
			await _run_file(folder, file, word)
	await get_tree().process_frame


func _run_file(folder: String, file: String, word: String) -> void:
	var script: GDScript = load(folder.path_join(file))
	if script == null or not script.can_instantiate():
		_report(file, PackedStringArray(["the file does not compile"]))
		return
	for method: Dictionary in script.get_script_method_list():
		var method_name: String = "%s.%s" % [file.get_basename(), method["name"]]
		if str(method["name"]).begins_with("test_") and (word.is_empty() or method_name.containsn(word)):
			await _run_test(script, method["name"], method_name)


func _run_test(script: GDScript, method: StringName, method_name: String) -> void:
	var suite: Suite = script.new()
	get_tree().root.add_child(suite)
	await suite.before_each()
	await suite.call(method)
	await suite.after_each()
	var failures: PackedStringArray = suite.failures
	if suite.checks == 0:
		failures.append("it checked nothing, or stopped at a script error")
	suite.queue_free()
	await get_tree().process_frame
	_report(method_name, failures)


func _report(method_name: String, failures: PackedStringArray) -> void:
	if failures.is_empty():
		passed += 1
		return
	failed += 1
	for failure: String in failures:
		print("FAILED %s: %s" % [method_name, failure])
