#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <godot_cpp/classes/navigation_mesh.hpp>
#include <godot_cpp/classes/navigation_mesh_source_geometry_data3d.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/variant/aabb.hpp>

#include "core/city/city.h"

namespace pcg {

struct BakeSettings {
	float map_cell_size = 0.25f; // metres
	float cell_size = 0.25f; // a whole multiple of it
	float cell_height = 0.25f;
	float agent_radius = 0.25f; // how far from walls people keep; rounded up to whole cells
	float agent_height = 1.75f;
	float agent_max_climb = 0.35f; // rounded down to whole cells
	float agent_max_slope = 45.0f; // degrees
};

// Bakes the walkable ground of a city, a region for each tile of its layout. A bake in one piece fails on a whole city (0 polygons at 960 m), and only
// what changed has to be baked again. Regions meet exactly: each is baked with a border of its neighbours' ground that is cut off afterwards,
// along lines on the grid of cells.
class TileBaker {
public:
	TileBaker(const City &city, BakeSettings settings);

	// Begins a tile; `is_async`: on the engine's threads, finished once is_baking() is false.
	void bake(uint32_t tile, bool is_async);
	bool is_baking(uint32_t tile) const;
	// Of a finished tile. Lowered onto the ground: the engine's baker puts its polygons two cells too high. And a millimetre off the lines of the map's cells:
	// on a line, rounding would decide which cell a corner is in, and the map joins edges by cells. What two tiles share is equal to the last bit, so
	// that it stays together wherever the city is moved and however it is turned.
	godot::Ref<godot::NavigationMesh> finish(uint32_t tile);
	size_t tile_count() const { return _jobs.size(); }

	static constexpr float border = 2.0f; // metres at least: more than an agent's radius

private:
	struct Job {
		godot::Ref<godot::NavigationMesh> mesh;
		godot::Ref<godot::NavigationMeshSourceGeometryData3D> source;
		bool is_finished = false;
	};
	float border_size() const; // a whole number of cells
	godot::AABB snapped(glm::vec3 min, glm::vec3 max) const;
	float snap(float metres) const;

	const City &_city;
	BakeSettings _settings;
	std::vector<Job> _jobs;
};

} // namespace pcg
