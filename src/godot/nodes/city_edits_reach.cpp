#include <algorithm>

#include <godot_cpp/core/object.hpp>

#include "godot/nodes/city_builder.h"
#include "godot/nodes/city_edits.h"
#include "godot/nodes/pcg_entrance.h"

using namespace godot;

// What the ground says of doors, and lots of each other, told to their nodes.
namespace pcg {

void CityEdits::mark_reach(std::span<const Reach> verdicts) const {
	const std::vector<uint64_t> &nodes = _nodes[size_t(Kind::Entrance)];
	for (size_t i = 0; i < std::min(verdicts.size(), nodes.size()); ++i) {
		PCGEntrance *node = Object::cast_to<PCGEntrance>(ObjectDB::get_instance(nodes[i]));
		const bool is_reachable = verdicts[i] == Reach::Reachable || verdicts[i] == Reach::Removed;
		if (node && node->is_reachable() != is_reachable) {
			node->set_reachable(is_reachable);
		}
	}
}

void CityEdits::mark_overlaps() { _overlaps.mark(_state->city.layout, placed_lots()); }

} // namespace pcg
