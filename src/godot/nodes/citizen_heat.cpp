#include <godot_cpp/core/error_macros.hpp>

#include "core/io/png.h"
#include "core/sim/heat_map_image.h"
#include "godot/convert.h"
#include "godot/nodes/citizen_manager.h"
#include "godot/nodes/pcg_city.h"
#include "godot/report.h"

using namespace godot;

namespace pcg {

PackedStringArray CitizenManager::get_age_groups() {
	PackedStringArray names;
	for (const std::string_view name : age_group_names) {
		names.push_back(to_godot(name));
	}
	return names;
}

// Nothing, with an error, where none is kept.
std::optional<HeatMap> CitizenManager::find_heat_map(const String &p_group, int p_hour) const {
	ERR_FAIL_COND_V_MSG(!has_recorded_lives(), std::nullopt, no_lives);
	ERR_FAIL_COND_V_MSG(p_hour < -1 || p_hour > 23, std::nullopt, "CitizenManager: heat maps are of an hour from 0 to 23 or, with -1, of the whole time.");
	const int64_t group = get_age_groups().find(p_group);
	ERR_FAIL_COND_V_MSG(group < 0 && !p_group.is_empty(), std::nullopt,
			"CitizenManager: heat maps are of \"children\", \"adults\", \"elders\" or, with an empty text, of everybody; not of \"" + p_group + "\".");
	flush_lives();
	const auto chosen = [](int64_t number) { return number < 0 ? std::nullopt : std::optional<size_t>(size_t(number)); };
	return _life->heat->map(chosen(group), chosen(p_hour));
}

Error CitizenManager::save_heat_map(const String &p_path, const String &p_group) const {
	const std::optional<HeatMap> map = find_heat_map(p_group, -1);
	if (!map) {
		return ERR_UNCONFIGURED;
	}
	const City &city = _life->city->city;
	GroundPlan plan;
	for (const Lot &lot : city.layout.lots) {
		plan.lots.push_back(lot.polygon);
	}
	for (const LotBuild &lot : city.lots) {
		plan.walkable.insert(plan.walkable.end(), lot.free_ground.begin(), lot.free_ground.end());
	}
	return save_to(p_path, [&](const std::string &path, Diagnostics &diagnostics) {
		write_png(path, draw_heat_map(*map, plan, { .pixels_per_cell = 4 }), diagnostics);
	});
}

Ref<Image> CitizenManager::get_heat_image(const String &p_group, int p_hour) const {
	const std::optional<HeatMap> map = find_heat_map(p_group, p_hour);
	if (!map) {
		return {};
	}
	const RgbaImage heat = draw_heat_overlay(*map, { .pixels_per_cell = 2 });
	return Image::create_from_data(int32_t(heat.width), int32_t(heat.height), false, Image::FORMAT_RGBA8, to_bytes(heat.pixels));
}

Rect2 CitizenManager::get_heat_area() const {
	ERR_FAIL_COND_V_MSG(!has_recorded_lives(), Rect2(), no_lives);
	const HeatGrid &grid = _life->heat->grid();
	return Rect2(grid.origin.x, grid.origin.y, float(grid.columns) * grid.cell, float(grid.rows) * grid.cell);
}

} // namespace pcg
