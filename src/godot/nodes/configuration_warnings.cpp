#include "godot/nodes/configuration_warnings.h"

#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace pcg {

void warn_by(Node *node, const Ref<Resource> &before, const Ref<Resource> &now) {
	const godot::Callable on_change = callable_mp(node, &Node::update_configuration_warnings);
	if (before.is_valid() && before->is_connected("changed", on_change)) {
		before->disconnect("changed", on_change);
	}
	if (now.is_valid() && !now->is_connected("changed", on_change)) {
		now->connect("changed", on_change);
	}
	node->update_configuration_warnings();
}

} // namespace pcg
