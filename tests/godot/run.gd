extends SceneTree
## Runs the headless tests, or those whose "file.method" holds the word given after --.
##
##     godot --headless --path . --script tests/godot/run.gd [-- WORD]
##
## The last line, "godot suite ended: N passed, N failed", is the proof that the run was not cut short.

const FOLDER := "res://tests/godot"
const Runner := preload("res://tests/godot/runner.gd")


func _initialize() -> void:
	_run.call_deferred()


func _run() -> void:
	var arguments: PackedStringArray = OS.get_cmdline_user_args()
	var runner := Runner.new()
	root.add_child(runner)
	await runner.run(FOLDER, arguments[0] if arguments.size() > 0 else "")
	print("godot suite ended: %d passed, %d failed" % [runner.passed, runner.failed])
	var status: int = 0 if runner.failed == 0 else 1
	runner.queue_free()
	await process_frame
	quit(status)
