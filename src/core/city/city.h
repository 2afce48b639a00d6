#pragma once

#include <vector>

#include "core/cga/derivation.h"
#include "core/city/ground_patch.h"
#include "core/city/layout.h"
#include "core/geometry/mesh.h"
#include "core/semantics/city_model.h"

// A whole city: where things lie, what they look like and what they mean.
namespace pcg {

// What stands on one lot.
struct LotBuild {
	cga::DerivationResult model; // its diagnostics have been handed on and are empty
	// Records in City::model, one for each in `model` and in the same order. The building is Invalid where there is no entrance.
	BuildingId building = BuildingId::Invalid;
	std::vector<EntranceId> entrances;
	std::vector<ZoneId> zones;
	std::vector<ObjectId> objects;
	// Convex pieces of the lot on which one can walk in from the street: nothing stands on them, nothing encloses them. Other lots may stand on those
	// in its courtyards: see lot_ground().
	std::vector<std::vector<glm::vec3>> free_ground;
};

// What a part of the public ground looks like and what stands on it.
struct GroundBuild {
	cga::DerivationResult model; // all pieces as one, without diagnostics
	std::vector<ZoneId> zones; // records in City::model, as those of a lot
	std::vector<ObjectId> objects;
};

struct PublicGround {
	std::vector<GroundBuild> streets; // by tile: carriageways, crossings, junctions
	std::vector<GroundBuild> blocks; // by BlockId: pavements and what is below the lots
};

// What of the ground for walking has been baked, tile by tile. Ground that is being edited lags behind.
struct BakedGround {
	std::vector<GroundPatch> patches; // as they were when no tile was stale
	std::vector<uint32_t> stale_tiles; // indices in Layout::tiles
};

struct City {
	Layout layout;
	CityModel model;
	std::vector<LotBuild> lots; // by LotId
	PublicGround ground;
	std::vector<GroundPatch> patches; // of the ground for walking
	BakedGround baked; // kept by whoever bakes it, and saved
};

} // namespace pcg
