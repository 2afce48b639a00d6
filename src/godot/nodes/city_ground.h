#pragma once

#include <atomic>
#include <memory>
#include <set>
#include <thread>
#include <vector>

#include "godot/nodes/city_edits.h"
#include "godot/nodes/city_job.h"
#include "godot/ports/tile_baker.h"

namespace pcg {

// Keeps the ground for walking as the city is edited: what changed is baked anew, tile by tile, on the engine's threads, and joined with the rest
// on a thread of its own. Until then ways lead over the ground as it was.
class CityGround {
public:
	// `patches`: what the state's regions are, or will be, baked with.
	CityGround(std::shared_ptr<CityState> state, const BakeSettings &settings, LayeredPatches patches);
	~CityGround();
	CityGround(const CityGround &) = delete;
	CityGround &operator=(const CityGround &) = delete;

	// What edits make of the ground; tiles where that differs from before have to be baked.
	void change(LayeredPatches patches);
	void touch(LotId lot);
	// Of a city that was saved: what had not been baked then, or was changed since.
	void touch_changed(const BakedGround &saved);
	bool is_idle() const { return _dirty.empty() && !_baker && !_joiner.joinable(); }
	// A slice of work on the main thread. True when a new ground has come into force.
	bool go_on();
	// The tiles that the last such ground baked anew.
	struct Baked {
		uint32_t tile = 0;
		godot::Ref<godot::NavigationMesh> mesh;
	};
	const std::vector<Baked> &baked() const { return _baked; }

private:
	void set_patches(LayeredPatches patches);
	void note_stale(); // in the state, for who saves it
	void touch(const std::vector<glm::vec3> &polygon);
	void begin_baking();
	void collect_baked();

	std::shared_ptr<CityState> _state;
	BakeSettings _settings;
	LayeredPatches _patches;
	std::set<uint32_t> _dirty; // tiles
	std::unique_ptr<TileBaker> _baker;
	std::vector<Baked> _baked;
	std::thread _joiner;
	std::atomic<bool> _is_joined{ false };
	NavMesh _joined;
};

} // namespace pcg
