extends SceneTree
## A weekday of a small city in the real engine, many times faster than life:
##
##     godot --headless --path . --script demo/run.gd -- [--lots 300] [--persons 600] [--seed 1]
##         [--rules res://rules/agenda/weekday.pcg] [--households res://rules/data/households_us_acs2023.csv] [--out out]
##
## Prints what was made and how long it took, then the day; writes heatmap.png, persons.csv and city.glb into the folder
## given by --out. The exit status is 1 where the input is wrong or a promise of the simulation was broken.

const LibraryCheck := preload("res://addons/pcg/editor/library_check.gd")


func _initialize() -> void:
	_run.call_deferred()


## No native class is named here: without the library this script must still parse, and say so.
func _run() -> void:
	var problem: String = LibraryCheck.find_problem()
	if not problem.is_empty():
		printerr(problem)
		quit(1)
		return
	var weekday: Node = (load("res://demo/weekday_run.gd") as GDScript).new()
	root.add_child(weekday)
	weekday.call(&"run")
	var is_good: bool = await Signal(weekday, &"ended")
	weekday.queue_free()
	await process_frame
	await process_frame
	quit(0 if is_good else 1)
