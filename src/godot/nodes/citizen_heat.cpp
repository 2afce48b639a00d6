#include <godot_cpp/classes/project_settings.hpp>
#include <godot_cpp/core/error_macros.hpp>

#include "core/io/png.h"
#include "core/sim/heat_map_image.h"
#include "godot/convert.h"
#include "godot/nodes/citizen_manager.h"
#include "godot/nodes/pcg_city.h"
#include "godot/report.h"

using namespace godot;

namespace pcg {

namespace {

constexpr const char *group_names[AgeHeat::group_count] = { "", "children", "adults", "elders" };

} // namespace

AgeHeat::AgeHeat(const CityModel &city, const Population &population) {
	static constexpr float ages[group_count + 1] = { 0.0f, 0.0f, 18.0f, 65.0f, 1000.0f };
	maps.reserve(group_count);
	maps.emplace_back(grid_over(city));
	for (size_t group = 1; group < group_count; ++group) {
		const float from = ages[group], to = ages[group + 1];
		maps.emplace_back(grid_over(city), [&population, from, to](PersonId id) { return population.person(id).age >= from && population.person(id).age < to; });
	}
}

// Null, with an error, where none is kept.
const HeatMap *CitizenManager::find_heat_map(const String &p_group) const {
	ERR_FAIL_COND_V_MSG(!is_running() || !_life->heat, nullptr, "CitizenManager: no lives are recorded. Set record_lives before start().");
	for (size_t group = 0; group < AgeHeat::group_count; ++group) {
		if (p_group == group_names[group]) {
			flush_lives();
			return &_life->heat->maps[group];
		}
	}
	ERR_FAIL_V_MSG(nullptr, "CitizenManager: heat maps are of \"children\", \"adults\", \"elders\" or, with an empty text, of everybody; not of \"" + p_group + "\".");
}

Error CitizenManager::save_heat_map(const String &p_path, const String &p_group) const {
	const HeatMap *map = find_heat_map(p_group);
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
	Diagnostics diagnostics;
	const String path = ProjectSettings::get_singleton()->globalize_path(p_path);
	write_png(from_godot(path), draw_heat_map(*map, plan, { .pixels_per_cell = 4 }), diagnostics);
	report(diagnostics);
	return diagnostics.has_errors() ? ERR_FILE_CANT_WRITE : OK;
}

Ref<Image> CitizenManager::get_heat_image(const String &p_group) const {
	const HeatMap *map = find_heat_map(p_group);
	if (!map) {
		return {};
	}
	const RgbaImage heat = draw_heat_overlay(*map, { .pixels_per_cell = 2 });
	PackedByteArray pixels;
	pixels.resize(int64_t(heat.pixels.size()));
	std::copy(heat.pixels.begin(), heat.pixels.end(), pixels.ptrw());
	return Image::create_from_data(int32_t(heat.width), int32_t(heat.height), false, Image::FORMAT_RGBA8, pixels);
}

Rect2 CitizenManager::get_heat_area() const {
	const HeatMap *map = find_heat_map("");
	if (!map) {
		return {};
	}
	const HeatGrid &grid = map->grid();
	return Rect2(grid.origin.x, grid.origin.y, float(grid.columns) * grid.cell, float(grid.rows) * grid.cell);
}

} // namespace pcg
