#include "godot/nodes/city_job.h"

#include <chrono>
#include <thread>

#include "core/city/drawn_blocks.h"
#include "core/city/walkable.h"
#include "core/io/file_assets.h"
#include "core/io/geojson.h"
#include "core/navigation/corner_graph.h"
#include "godot/convert.h"
#include "godot/ports/engine_files.h"
#include "godot/ports/engine_tree.h"
#include "godot/ports/imported_assets.h"

namespace pcg {

CityOptions CityJob::options() {
	_assets = std::make_unique<FileAssets>(_input.asset_folders, std::make_shared<EngineTree>(), std::make_shared<ImportedAssets>(main));
	CityOptions options;
	options.derive.assets = _assets.get();
	options.free_ground = _input.free_ground;
	options.streets = _input.streets;
	options.work.cancel = &is_cancelled;
	options.work.progress = [this](size_t done, size_t total) { progress = float(done) / float(total); };
	return options;
}

std::optional<Layout> CityJob::lay_out() {
	if (_input.source == CityInput::Source::Streets) {
		return make_layout(_input.layout, diagnostics);
	}
	std::vector<Footprint> footprints = _input.footprints;
	if (!_input.geojson.empty()) {
		const Result<std::string> text = read_engine_file(to_godot(std::string_view(_input.geojson)));
		std::optional<std::vector<Footprint>> measured;
		if (text) {
			measured = parse_geojson(*text, _input.geojson, diagnostics);
		} else {
			diagnostics.add(text.diagnostic());
		}
		if (!measured) {
			return std::nullopt;
		}
		footprints.insert(footprints.end(), measured->begin(), measured->end());
	}
	const bool has_blocks = _input.source == CityInput::Source::Blocks;
	if (footprints.empty()) {
		diagnostics.error("no-footprints", std::string("there are no ") + (has_blocks ? "blocks" : "footprints") + " to lay out",
				std::string("name a GeoJSON file in the layout's `geojson`, or draw ") + (has_blocks ? "blocks" : "lots") +
						": Polygon2D or Path3D nodes below the city");
		return std::nullopt;
	}
	return (has_blocks ? layout_of_blocks : layout_of_footprints)(footprints, _input.layout, diagnostics);
}

bool CityJob::grow() {
	std::optional<Layout> layout = lay_out();
	if (!layout) {
		return false;
	}
	std::optional<City> city = generate_city(std::move(*layout), _input.rules, options(), diagnostics);
	if (!city) {
		return false;
	}
	state = std::make_shared<CityState>();
	state->city = std::move(*city);
	return true;
}

bool CityJob::grow_again(const std::vector<LotId> &lots) {
	const CityOptions how = options();
	bool is_good = true;
	for (const LotId lot : lots) {
		is_good = regenerate_lot(state->city, lot, _input.rules, how, diagnostics) && is_good;
	}
	return is_good;
}

void CityJob::do_beside(const std::function<void()> &work) {
	std::atomic<bool> is_done{ false };
	std::thread worker([&] {
		work();
		is_done = true;
	});
	while (!is_done) {
		main->run_waiting();
		std::this_thread::sleep_for(std::chrono::microseconds(100));
	}
	worker.join();
}

bool CityJob::join() {
	state->ground = NavMesh::build(state->regions);
	progress = 0.5f;
	entrance_reach = reach_of_entrances(state->city.model, state->ground);
	zone_reach = reach_of_zones(state->city.model, state->ground);
	report_unreachable(state->city, entrance_reach, diagnostics);
	report_unreachable_zones(state->city, zone_reach, diagnostics);
	if (const size_t count = state->ground.corner_graph().cut_short_count(); count > 0) {
		diagnostics.warning("piled-ground", "too much to look at from " + std::to_string(count) + " corners of the ground: ways there may be longer than they "
						"need be", "see that lots and what stands on them do not overlap; thousands of trees and benches on open ground do it, too");
	}
	state->paths = std::make_unique<NavMeshPaths>(state->city.model, state->ground);
	return !is_cancelled;
}

} // namespace pcg
