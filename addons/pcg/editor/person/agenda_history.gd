@tool
extends RefCounted
## Puts entries into agendas in steps that can be undone. What an entry takes from others cannot be put back one by one, so undoing goes back to the whole
## state before, the clock included.

signal agenda_changed

const SceneContext := preload("res://addons/pcg/editor/scene_context.gd")

var _context: SceneContext


func _init(context: SceneContext) -> void:
	_context = context


## Inserts a task as CitizenManager.insert_task() takes it. Life begins for that, standing still, where it had not.
func insert(person: int, task: Dictionary) -> void:
	var citizens: CitizenManager = _context.citizens
	if not citizens.is_running():
		citizens.paused = true
		citizens.start()
	var undo: EditorUndoRedoManager = _context.get_undo()
	undo.create_action("Put an entry into an agenda", UndoRedo.MERGE_DISABLE, citizens)
	undo.add_do_method(self, &"put", citizens, person, task)
	undo.add_undo_method(self, &"go_back", citizens, citizens.save_state())
	undo.commit_action()


func put(citizens: CitizenManager, person: int, task: Dictionary) -> void:
	citizens.insert_task(person, task)
	agenda_changed.emit()


func go_back(citizens: CitizenManager, state: PackedByteArray) -> void:
	citizens.load_state(state)
	agenda_changed.emit()
