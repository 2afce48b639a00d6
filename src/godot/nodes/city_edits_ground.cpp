#include <algorithm>
#include <limits>

#include <godot_cpp/core/object.hpp>

#include "core/city/lot_ground.h"
#include "godot/convert.h"
#include "godot/nodes/city_edits.h"
#include "godot/nodes/pcg_entrance.h"
#include "godot/nodes/pcg_zone.h"

using namespace godot;

// What nodes do to the ground for walking; and what it says of doors, and lots of each other, told to their nodes.
namespace pcg {

namespace {

constexpr int obstacles = std::numeric_limits<int>::max(); // a layer over all lots

template <typename Node> void mark(const std::vector<uint64_t> &nodes, std::span<const Reach> verdicts) {
	for (size_t i = 0; i < std::min(verdicts.size(), nodes.size()); ++i) {
		Node *node = Object::cast_to<Node>(ObjectDB::get_instance(nodes[i]));
		const bool is_reachable = verdicts[i] == Reach::Reachable || verdicts[i] == Reach::Removed;
		if (node && node->is_reachable() != is_reachable) {
			node->set_reachable(is_reachable);
		}
	}
}

} // namespace

LayeredPatches CityEdits::patches() const {
	LayeredPatches result = patches_of_lots(_state->city, placed_lots());
	for (const auto &[object, footprint] : _footprints) {
		result[{ obstacles, object }] = { footprint, {} };
	}
	return result;
}

std::vector<PlacedLot> CityEdits::placed_lots() const {
	std::vector<PlacedLot> lots;
	for (const auto &[object, place] : _lots) {
		const bool is_at_home = place.motion.is_equal_approx(Transform3D());
		lots.push_back({ object, place.lot, is_at_home ? glm::mat4(1.0f) : from_godot(place.motion), is_at_home });
	}
	return lots;
}

void CityEdits::mark_reach(std::span<const Reach> entrances, std::span<const Reach> zones) const {
	mark<PCGEntrance>(_nodes[size_t(Kind::Entrance)], entrances);
	mark<PCGZone>(_nodes[size_t(Kind::Zone)], zones);
}

void CityEdits::mark_overlaps() { _overlaps.mark(_state->city.layout, placed_lots()); }

} // namespace pcg
