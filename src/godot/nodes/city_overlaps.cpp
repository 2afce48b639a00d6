#include "godot/nodes/city_overlaps.h"

#include <map>

#include <godot_cpp/core/object.hpp>

#include "core/city/lot_overlaps.h"
#include "godot/nodes/pcg_lot.h"

using namespace godot;

namespace pcg {

void CityOverlaps::mark(const Layout &layout, const std::vector<PlacedLot> &lots) {
	std::vector<Loops2> polygons;
	std::vector<bool> is_moved;
	std::map<LotId, uint32_t> at_home;
	for (uint32_t i = 0; i < lots.size(); ++i) {
		polygons.push_back(outline_of(layout, lots[i]));
		// A copy that stays where it was made lies on the lot that it was copied from.
		is_moved.push_back(!lots[i].is_at_home || !at_home.emplace(lots[i].lot, i).second);
	}
	std::vector<OutlineOverlap> overlaps = find_overlaps(polygons, is_moved);
	for (const LotOverlap &known : layout.overlaps) {
		if (at_home.contains(known.a) && at_home.contains(known.b)) {
			overlaps.push_back({ at_home[known.a], at_home[known.b], double(known.area) });
		}
	}
	std::map<uint64_t, std::vector<PCGLot::Overlap>> by_object;
	for (const uint64_t object : _marked) {
		by_object[object] = {};
	}
	for (const OutlineOverlap &overlap : overlaps) {
		by_object[lots[overlap.a].object].push_back({ lots[overlap.b].object, overlap.area });
		by_object[lots[overlap.b].object].push_back({ lots[overlap.a].object, overlap.area });
	}
	_marked.clear();
	for (auto &[object, of_lot] : by_object) {
		if (!of_lot.empty()) {
			_marked.insert(object);
		}
		if (PCGLot *node = Object::cast_to<PCGLot>(ObjectDB::get_instance(object))) {
			node->set_overlaps(std::move(of_lot));
		}
	}
}

} // namespace pcg
