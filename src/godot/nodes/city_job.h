#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/city/city.h"
#include "core/city/city_generator.h"
#include "core/city/footprint_layout.h"
#include "core/io/file_assets.h"
#include "core/navigation/nav_mesh.h"
#include "core/navigation/nav_mesh_paths.h"
#include "core/navigation/reachability.h"
#include "godot/main_thread.h"

namespace pcg {

// A finished city with its ways. Once it is shared only its own PCGCity writes to it, on the main thread.
struct CityState {
	City city;
	std::vector<NavRegion> regions; // by tile: of what `ground` was joined
	NavMesh ground;
	std::unique_ptr<NavMeshPaths> paths; // on `ground`, between the entrances of `city`
};

struct CityInput {
	LayoutParameters layout;
	// Lots or blocks that were drawn or measured, instead of a layout of streets: a file, and what stands in the scene.
	enum class Source { Streets, Lots, Blocks } source = Source::Streets;
	std::string geojson; // a path; empty: none
	std::vector<Footprint> footprints;
	RulesByType rules;
	LotRules streets; // without a program they are plain
	std::vector<std::string> asset_folders; // beside the rule files' own projects
	FreeGroundOptions free_ground;
};

// The part of a generation that runs beside the main thread. One call at a time; the flags may be touched by anybody.
class CityJob {
public:
	explicit CityJob(CityInput input) : _input(std::move(input)) {}
	const CityInput &input() const { return _input; }

	// Layout and lots. Meanwhile the main thread runs what waits for it. False after an error or a cancellation.
	bool grow();
	// Makes the state's regions one walkable ground and learns its distances.
	bool join();
	// Builds lots of `state` anew. Meanwhile as in grow().
	bool grow_again(const std::vector<LotId> &lots);
	// Does `work`, one of the above, on a thread of its own while this one, the main thread, answers what it asks: lots may ask for what only the main
	// thread gives, which so must not build them. Returns when it is done.
	void do_beside(const std::function<void()> &work);

	const std::shared_ptr<MainThread> main = std::make_shared<MainThread>();
	std::atomic<bool> is_cancelled{ false };
	std::atomic<float> progress{ 0.0f };
	bool has_succeeded = false; // of the last call; read after it has ended
	Diagnostics diagnostics;
	std::vector<Reach> entrance_reach, zone_reach; // by EntranceId and ZoneId; of join()
	std::shared_ptr<CityState> state;

private:
	CityOptions options();
	std::optional<Layout> lay_out();

	CityInput _input;
	std::unique_ptr<FileAssets> _assets; // of the running call
};

} // namespace pcg
