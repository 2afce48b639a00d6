@tool
extends RefCounted
## Lives through a day in steps and notes who is outdoors where: counts for a plot, cells for a heat map. A piece is done each frame, so that the
## editor stays awake.

signal progressed(fraction: float)
signal ended

const STEP := 300.0 ## seconds of the simulated day
const STEPS_A_DAY := 288
const CELL := 4.0 ## metres
const AGE_LIMITS: Array[int] = [18, 65] ## from here on adults, from here on elders
const AGE_GROUPS: PackedStringArray = ["children", "adults", "elders"]
const FRAME_BUDGET := 12_000 ## microseconds

var day := 0
var counts := PackedInt32Array() ## persons outdoors at the end of each step
var is_running := false
# Key: cell x, cell z, hour, age group; value: steps that persons spent there.
var cells: Dictionary[Vector4i, int] = {}
var _citizens: CitizenManager
var _before: Array = [] # day, time and paused of the simulation before
var _age_groups: Dictionary[int, int] = {} # of persons


## Begins to live through `of_day`. The clock stands where it was when ended is told.
func start(citizens: CitizenManager, of_day: int) -> void:
	_citizens = citizens
	_before = [citizens.day, citizens.time, citizens.paused]
	day = of_day
	counts.clear()
	cells.clear()
	_age_groups.clear()
	is_running = true
	citizens.paused = true
	citizens.jump_to(day, 0.0)


## Call each frame.
func go_on() -> void:
	if not is_running:
		return
	if not is_instance_valid(_citizens) or not _citizens.is_running():
		is_running = false
		ended.emit()
		return
	var began: int = Time.get_ticks_usec()
	while counts.size() < STEPS_A_DAY and Time.get_ticks_usec() - began < FRAME_BUDGET:
		_citizens.advance(STEP)
		_note()
	progressed.emit(float(counts.size()) / STEPS_A_DAY)
	if counts.size() == STEPS_A_DAY:
		is_running = false
		_citizens.jump_to(_before[0], _before[1])
		_citizens.paused = _before[2]
		ended.emit()


func _note() -> void:
	var hour: int = mini(floori(counts.size() * STEP / 3600.0), 23)
	var outside: PackedInt32Array = _citizens.get_persons_outside()
	counts.append(outside.size())
	var to_city: Transform3D = _citizens.city.global_transform.affine_inverse()
	for person: int in outside:
		var told: Dictionary = _citizens.get_person(person)
		var at: Vector3 = to_city * (told["position"] as Vector3) / CELL
		var key := Vector4i(floori(at.x), floori(at.z), hour, _age_group(person, told["age"]))
		cells[key] = cells.get(key, 0) + 1


func _age_group(person: int, age: int) -> int:
	if not _age_groups.has(person):
		_age_groups[person] = AGE_LIMITS.reduce(func(group: int, limit: int) -> int: return group + int(age >= limit), 0)
	return _age_groups[person]


## Steps spent in each cell; hour or group -1: all of them.
func sum_cells(hour: int, group: int) -> Dictionary[Vector2i, int]:
	var sums: Dictionary[Vector2i, int] = {}
	for key: Vector4i in cells:
		if (hour < 0 or key.z == hour) and (group < 0 or key.w == group):
			var cell := Vector2i(key.x, key.y)
			sums[cell] = sums.get(cell, 0) + cells[key]
	return sums
