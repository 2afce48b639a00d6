@tool
extends RefCounted
## Makes generating people a step that can be undone. They are not kept: the same settings give the same people, so it is enough to remember those.

## What [method CitizenManager.generate_population] reads.
const SETTINGS: Array[StringName] = [&"rules", &"start_rule", &"attributes", &"household_table", &"population", &"person_count", &"home_type", &"seed"]
const SceneContext := preload("res://addons/pcg/editor/scene_context.gd")

var _context: SceneContext
var _made_of: Dictionary[int, Dictionary] = {} # instance id of citizens to the settings that they were made with; empty: nobody is there


func _init(context: SceneContext) -> void:
	_context = context


func generate(citizens: CitizenManager) -> void:
	var undo: EditorUndoRedoManager = _context.get_undo()
	var after: Dictionary = describe(citizens)
	var before: Dictionary = _made_of.get(citizens.get_instance_id(), after) if citizens.has_person(0) else {}
	undo.create_action("Generate people", UndoRedo.MERGE_DISABLE, citizens)
	undo.add_do_method(self, &"make", citizens, after)
	undo.add_undo_method(self, &"make", citizens, before)
	undo.commit_action()


static func describe(citizens: CitizenManager) -> Dictionary:
	var settings: Dictionary = {}
	for property: StringName in SETTINGS:
		settings[property] = citizens.get(property)
	return settings


## Whether people are there, and what they were made of has not changed since.
func is_made_of_settings(citizens: CitizenManager) -> bool:
	return citizens.has_person(0) and _made_of.get(citizens.get_instance_id(), describe(citizens)) == describe(citizens)


## Gives citizens these settings, and makes their people; none: lets everybody go.
func make(citizens: CitizenManager, settings: Dictionary) -> void:
	_made_of[citizens.get_instance_id()] = settings
	for property: StringName in settings:
		citizens.set(property, settings[property])
	if settings.is_empty():
		citizens.clear_population()
	else:
		citizens.generate_population()
	_context.changed.emit()
