#pragma once

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>

namespace pcg {

// A node's configuration warnings depend on a resource: the editor asks for them again now, and whenever `now` changes. Either may be null.
void warn_by(godot::Node *node, const godot::Ref<godot::Resource> &before, const godot::Ref<godot::Resource> &now);

} // namespace pcg
