@tool
extends EditorPlugin
## Runs the editor's tests once the editor is ready, and closes it. tools/editor_project.py makes the project that has this plugin.
##
##     godot --headless --editor --path build/editor_project -- [WORD]
##
## Where there is a screen, the tests are those that click, press keys and look at it: tests/editor/screen. Those begin with the addon switched off.
##
## The line "editor suite ended: N passed, N failed", or "screen suite ended ..", is the proof that the run was not cut short.

const FOLDER := "res://tests/editor"
const SCREEN_FOLDER := "res://tests/editor/screen"
const CityForTests := preload("res://tests/godot/city_for_tests.gd")
const Runner := preload("res://tests/godot/runner.gd")


func _enter_tree() -> void:
	_run.call_deferred()


func _run() -> void:
	var files: EditorFileSystem = EditorInterface.get_resource_filesystem()
	var arguments: PackedStringArray = OS.get_cmdline_user_args()
	var takes_pictures: bool = arguments.size() == 2 and arguments[0] == "--pictures"
	var is_on_screen: bool = DisplayServer.get_name() != "headless" and not takes_pictures
	while files.is_scanning() or not is_on_screen and not EditorInterface.is_plugin_enabled("pcg"):
		await get_tree().process_frame
	for frame: int in 10: # the editor opens its own windows and layout meanwhile
		await get_tree().process_frame
	if takes_pictures:
		await _take_pictures(arguments[1])
		return
	var runner := Runner.new()
	get_tree().root.add_child(runner)
	await runner.run(SCREEN_FOLDER if is_on_screen else FOLDER, arguments[0] if arguments.size() > 0 else "")
	await _begin_a_city()
	print("%s suite ended: %d passed, %d failed" % ["screen" if is_on_screen else "editor", runner.passed, runner.failed])
	runner.queue_free()
	get_tree().quit(0 if runner.failed == 0 else 1)


# The editor is closed while it generates: whoever does that must not see a crash, nor leave anything behind.
func _begin_a_city() -> void:
	var city: PCGCity = CityForTests.make_city(60)
	EditorInterface.add_root_node(city)
	await get_tree().process_frame
	city.generate()
	await get_tree().process_frame


func _take_pictures(folder: String) -> void:
	var pictures: Node = (load("res://tests/editor/pictures.gd") as GDScript).new()
	add_child(pictures)
	var finder: Node = (load("res://tests/editor/editor_suite.gd") as GDScript).new()
	add_child(finder)
	await pictures.call("run", finder.call("get_authoring"), folder)
	get_tree().quit()
