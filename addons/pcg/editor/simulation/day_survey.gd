@tool
extends RefCounted
## Lives through a day in steps: counts who is outdoors for a plot, and has lives recorded for a heat map. A piece is done each frame, so that the editor
## stays awake.

signal progressed(fraction: float)
signal ended

const STEP := 300.0 ## seconds of the simulated day
const STEPS_A_DAY := 288
const FRAME_BUDGET := 12_000 ## microseconds

var day := 0
var counts := PackedInt32Array() ## persons outdoors at the end of each step
var trips := 0 ## that people walked while days were surveyed, since their life began
var is_running := false
var _citizens: CitizenManager
var _trips_before := 0
var _before: Array = [] # day, time, paused and record_lives of the simulation before


## Begins to live through `of_day`. The clock stands where it was when ended is told.
func start(citizens: CitizenManager, of_day: int) -> void:
	_citizens = citizens
	_before = [citizens.day, citizens.time, citizens.paused, citizens.record_lives]
	_trips_before = citizens.get_statistics().get("trips", 0)
	day = of_day
	counts.clear()
	is_running = true
	citizens.paused = true
	citizens.jump_to(day, 0.0)
	citizens.record_lives = false
	citizens.record_lives = true # anew


## Call each frame.
func go_on() -> void:
	if not is_running:
		return
	if not is_instance_valid(_citizens) or not _citizens.is_running():
		is_running = false
		if is_instance_valid(_citizens):
			_citizens.record_lives = _before[3]
		ended.emit()
		return
	var began: int = Time.get_ticks_usec()
	while counts.size() < STEPS_A_DAY and Time.get_ticks_usec() - began < FRAME_BUDGET:
		_citizens.advance(STEP)
		counts.append(_citizens.get_persons_outside().size())
	progressed.emit(float(counts.size()) / STEPS_A_DAY)
	if counts.size() == STEPS_A_DAY:
		is_running = false
		trips += int(_citizens.get_statistics()["trips"]) - _trips_before
		_citizens.record_lives = _before[3] # what is off keeps the day
		_citizens.jump_to(_before[0], _before[1])
		_citizens.paused = _before[2]
		ended.emit()
