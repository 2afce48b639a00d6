// Help on the extension's classes in the editor.
#pragma once

namespace godot::internal {

// Hands the registered pages to the editor. Only at the editor's initialization level; does nothing where there are none.
void load_doc_data();

} // namespace godot::internal
