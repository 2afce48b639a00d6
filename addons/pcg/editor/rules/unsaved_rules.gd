@tool
extends RefCounted
## What was typed into rules and not saved, while the addon is switched off: kept with what the editor remembers of the project.

const SECTION := "pcg"
const KEY := "unsaved_rules"


## Takes texts by path.
static func keep(texts: Dictionary[String, String]) -> void:
	EditorInterface.get_editor_settings().set_project_metadata(SECTION, KEY, texts)


## Gives back what was kept, once.
static func take() -> Dictionary[String, String]:
	var settings: EditorSettings = EditorInterface.get_editor_settings()
	var texts: Dictionary[String, String] = {}
	texts.assign(settings.get_project_metadata(SECTION, KEY, {}))
	if not texts.is_empty():
		settings.set_project_metadata(SECTION, KEY, null)
	return texts
