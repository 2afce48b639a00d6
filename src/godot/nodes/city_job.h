#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/city/city.h"
#include "core/city/city_generator.h"
#include "core/navigation/nav_mesh.h"
#include "core/navigation/reachability.h"
#include "core/ports/path_provider.h"
#include "godot/main_thread.h"

namespace pcg {

// A finished city with its ways. Read-only once it is shared.
struct CityState {
	City city;
	NavMesh ground;
	std::unique_ptr<PathProvider> paths; // on `ground`, between the entrances of `city`
};

struct CityInput {
	LayoutParameters layout;
	RulesByType rules;
	std::vector<std::string> asset_folders; // beside the rule files' own projects
};

// The part of a generation that runs beside the main thread. One call at a time; the flags may be touched by anybody.
class CityJob {
public:
	explicit CityJob(CityInput input) : _input(std::move(input)) {}

	// Layout and lots. Meanwhile the main thread runs what waits for it. False after an error or a cancellation.
	bool grow();
	// Makes the baked regions one walkable ground and learns its distances.
	bool join();

	const std::shared_ptr<MainThread> main = std::make_shared<MainThread>();
	std::atomic<bool> is_cancelled{ false };
	std::atomic<float> progress{ 0.0f };
	bool has_succeeded = false; // of the last call; read after it has ended
	Diagnostics diagnostics;
	std::vector<Reach> reach; // by EntranceId; of join()
	std::vector<NavRegion> regions; // by tile; for join()
	std::shared_ptr<CityState> state;

private:
	CityInput _input;
};

} // namespace pcg
