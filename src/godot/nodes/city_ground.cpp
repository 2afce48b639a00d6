#include "godot/nodes/city_ground.h"

#include <algorithm>

#include "godot/convert.h"

using namespace godot;

namespace pcg {

namespace {

bool is_same(const GroundPatch &a, const GroundPatch &b) { return a.outline == b.outline && a.pieces == b.pieces; }

void add_to(PlanBox &box, const NavRegion &region) {
	for (const glm::vec3 &vertex : region.vertices) {
		box.add(vertex);
	}
}

} // namespace

CityGround::CityGround(std::shared_ptr<CityState> state, const BakeSettings &settings, LayeredPatches patches)
	: _state(std::move(state)), _settings(settings) {
	set_patches(std::move(patches));
	_state->city.baked = { _state->city.patches, {} };
}

void CityGround::touch_changed(const BakedGround &saved) {
	const auto touch_missing = [this](const std::vector<GroundPatch> &from, const std::vector<GroundPatch> &in) {
		for (const GroundPatch &patch : from) {
			if (std::ranges::none_of(in, [&](const GroundPatch &other) { return is_same(patch, other); })) {
				touch(patch.outline);
			}
		}
	};
	const std::vector<GroundPatch> &now = _state->city.patches;
	touch_missing(saved.patches, now);
	touch_missing(now, saved.patches);
	_dirty.insert(saved.stale_tiles.begin(), saved.stale_tiles.end());
	note_stale();
}

// Tiles that are being baked, too.
void CityGround::note_stale() {
	std::set<uint32_t> stale = _dirty;
	for (const Baked &baked : _baked) {
		if (_baker || _joiner.joinable()) {
			stale.insert(baked.tile);
		}
	}
	BakedGround &baked = _state->city.baked;
	baked.stale_tiles.assign(stale.begin(), stale.end());
	if (stale.empty()) {
		baked.patches = _state->city.patches;
	}
}

void CityGround::set_patches(LayeredPatches patches) {
	_patches = std::move(patches);
	_state->city.patches.clear();
	for (const auto &[key, patch] : _patches) {
		_state->city.patches.push_back(patch);
	}
}

void CityGround::change(LayeredPatches patches) {
	for (const auto &[key, patch] : _patches) {
		const auto found = patches.find(key);
		if (found == patches.end() || !is_same(found->second, patch)) {
			touch(patch.outline);
		}
	}
	for (const auto &[key, patch] : patches) {
		const auto found = _patches.find(key);
		if (found == _patches.end() || !is_same(found->second, patch)) {
			touch(patch.outline);
		}
	}
	set_patches(std::move(patches));
}

void CityGround::touch(LotId lot) { touch(_state->city.layout.lot(lot).polygon); }

void CityGround::touch(const std::vector<glm::vec3> &polygon) {
	glm::vec3 low = polygon[0], high = polygon[0];
	for (const glm::vec3 &corner : polygon) {
		low = { std::min(low.x, corner.x), 0.0f, std::min(low.z, corner.z) };
		high = { std::max(high.x, corner.x), 0.0f, std::max(high.z, corner.z) };
	}
	const std::vector<Tile> &tiles = _state->city.layout.tiles;
	for (size_t i = 0; i < tiles.size(); ++i) {
		const float reach = TileBaker::border;
		if (tiles[i].min.x <= high.x + reach && tiles[i].max.x >= low.x - reach && tiles[i].min.z <= high.z + reach && tiles[i].max.z >= low.z - reach) {
			_dirty.insert(uint32_t(i));
		}
	}
	note_stale();
}

bool CityGround::go_on() {
	if (_joiner.joinable()) {
		if (!_is_joined) {
			return false;
		}
		_joiner.join();
		_state->ground = std::move(_joined);
		for (const Baked &baked : _baked) {
			const Tile &tile = _state->city.layout.tiles[baked.tile];
			_state->paths->note_new_ground(tile.min, tile.max);
		}
		_state->paths->prepare();
		note_stale();
		return true;
	}
	if (_baker) {
		collect_baked();
	} else if (!_dirty.empty()) {
		begin_baking();
	}
	return false;
}

void CityGround::begin_baking() {
	_baker = std::make_unique<TileBaker>(_state->city, _settings);
	_baked.clear();
	for (const uint32_t tile : _dirty) {
		_baker->bake(tile, true);
		_baked.push_back({ tile, {} });
	}
	_dirty.clear();
}

void CityGround::collect_baked() {
	if (std::ranges::any_of(_baked, [&](const Baked &baked) { return _baker->is_baking(baked.tile); })) {
		return;
	}
	std::vector<PlanBox> changed;
	for (Baked &baked : _baked) {
		NavRegion &region = _state->regions[baked.tile];
		PlanBox &box = changed.emplace_back();
		add_to(box, region);
		baked.mesh = _baker->finish(baked.tile);
		region = from_godot(baked.mesh);
		add_to(box, region);
	}
	_baker.reset();
	_is_joined = false;
	_joiner = std::thread([this, changed = std::move(changed)] { // ground and regions stay as they are until it has ended
		_joined = NavMesh::rebuild(_state->ground, changed, _state->regions);
		_is_joined = true;
	});
}

// What the engine still bakes is its own to finish: it holds the meshes, too.
CityGround::~CityGround() {
	if (_joiner.joinable()) {
		_joiner.join();
	}
}

} // namespace pcg
