extends SceneTree
## Runs every test_* method of every tests/godot/test_*.gd, or of those whose "file.method" holds the word given after --.
##
##     godot --headless --path . --script tests/godot/run.gd [-- WORD]
##
## The last line, "godot suite ended: N passed, N failed", is the proof that the run was not cut short.

const FOLDER := "res://tests/godot"
const Suite := preload("res://tests/godot/suite.gd")

var passed := 0
var failed := 0


func _initialize() -> void:
	_run.call_deferred()


func _run() -> void:
	var arguments: PackedStringArray = OS.get_cmdline_user_args()
	var word: String = arguments[0] if arguments.size() > 0 else ""
	for file: String in DirAccess.get_files_at(FOLDER):
		if file.begins_with("test_") and file.ends_with(".gd"):
			await _run_file(file, word)
	await process_frame
	print("godot suite ended: %d passed, %d failed" % [passed, failed])
	quit(0 if failed == 0 else 1)


func _run_file(file: String, word: String) -> void:
	var script: GDScript = load(FOLDER.path_join(file))
	if script == null or not script.can_instantiate():
		_report(file, PackedStringArray(["the file does not compile"]))
		return
	for method: Dictionary in script.get_script_method_list():
		var name: String = "%s.%s" % [file.get_basename(), method["name"]]
		if str(method["name"]).begins_with("test_") and (word.is_empty() or name.containsn(word)):
			await _run_test(script, method["name"], name)


func _run_test(script: GDScript, method: StringName, name: String) -> void:
	var suite: Suite = script.new()
	root.add_child(suite)
	await suite.before_each()
	await suite.call(method)
	await suite.after_each()
	var failures: PackedStringArray = suite.failures
	if suite.checks == 0:
		failures.append("it checked nothing, or stopped at a script error")
	suite.queue_free()
	await process_frame
	_report(name, failures)


func _report(name: String, failures: PackedStringArray) -> void:
	if failures.is_empty():
		passed += 1
		return
	failed += 1
	for failure: String in failures:
		print("FAILED %s: %s" % [name, failure])
