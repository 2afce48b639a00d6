#include <algorithm>
#include <limits>

#include <godot_cpp/core/error_macros.hpp>

#include "core/io/gltf.h"
#include "godot/convert.h"
#include "godot/nodes/pcg_city.h"
#include "godot/ports/engine_tree.h"
#include "godot/report.h"

using namespace godot;

namespace pcg {

Error PCGCity::save_gltf(const String &p_path) const {
	ERR_FAIL_COND_V_MSG(!_state, ERR_UNCONFIGURED, "PCGCity: there is no city yet. Call generate() and wait for city_generated.");
	const auto is_without_faces = [](const LotBuild &lot) { return lot.model.face_count > 0 && lot.model.mesh.faces.empty() && lot.model.instances.empty(); };
	ERR_FAIL_COND_V_MSG(std::ranges::any_of(_state->city.lots, is_without_faces), ERR_UNAVAILABLE,
			"PCGCity: this city came with its scene, which holds the engine's meshes and not what they were made of. Call generate() with its rules first, wait "
			"for city_generated, then save_gltf().");
	const EngineTree pictures;
	return save_to(p_path, [&](const std::string &path, Diagnostics &diagnostics) { write_glb(_state->city, path, diagnostics, &pictures); });
}

TypedArray<Dictionary> PCGCity::get_diagnostics() const { return to_godot(_diagnostics); }

int PCGCity::get_building_count() const { return _state ? int(_state->city.model.buildings().size()) : 0; }

Dictionary PCGCity::get_building(int p_building) const {
	ERR_FAIL_COND_V_MSG(p_building < 0 || p_building >= get_building_count(), Dictionary(), "PCGCity: buildings are numbered from 0 to get_building_count() - 1.");
	Dictionary result;
	const CityModel &model = _state->city.model;
	if (const EntranceId door = model.entrance_of(BuildingId(p_building)); is_valid(door)) {
		result["type"] = to_godot(model.types.name(model.entrance(door).type));
		result["position"] = frame().xform(to_godot(model.entrance(door).position));
	}
	return result;
}

Dictionary PCGCity::get_statistics() const {
	Dictionary result;
	if (!_state) {
		return result;
	}
	const City &city = _state->city;
	int64_t faces = 0, instances = 0;
	for (const LotBuild &lot : city.lots) {
		faces += int64_t(lot.model.face_count);
		instances += int64_t(lot.model.instances.size());
	}
	for (const std::vector<GroundBuild> *builds : { &city.ground.streets, &city.ground.blocks }) {
		for (const GroundBuild &ground : *builds) {
			faces += int64_t(ground.model.face_count);
			instances += int64_t(ground.model.instances.size());
		}
	}
	Dictionary entrances;
	for (const Entrance &entrance : city.model.entrances()) {
		if (entrance.is_removed) {
			continue;
		}
		const String type = to_godot(city.model.types.name(entrance.type));
		entrances[type] = int64_t(entrances.get(type, 0)) + 1;
	}
	result["blocks"] = int64_t(std::ranges::count_if(city.layout.blocks, [&](const CityBlock &block) {
		return !block.lots.empty() || !city.layout.streets.empty(); // without streets they are squares of the map, most of them empty
	}));
	result["lots"] = int64_t(city.layout.lots.size());
	result["faces"] = faces;
	result["instances"] = instances;
	const auto is_there = [](const auto &record) { return !record.is_removed; };
	result["buildings"] = int64_t(std::ranges::count_if(city.model.buildings(), is_there));
	result["entrances"] = entrances;
	result["zones"] = int64_t(std::ranges::count_if(city.model.zones(), is_there));
	result["objects"] = int64_t(std::ranges::count_if(city.model.objects(), is_there));
	result["seconds"] = _seconds;
	result["longest_hold"] = _longest_hold;
	return result;
}

PackedVector3Array PCGCity::find_path(const Vector3 &p_from, const Vector3 &p_to) const {
	ERR_FAIL_COND_V_MSG(!_state, PackedVector3Array(), "PCGCity: there is no city yet. Call generate() and wait for city_generated.");
	const Transform3D inverse = frame().affine_inverse();
	const std::vector<glm::vec3> path = _state->paths->path(from_godot(inverse.xform(p_from)), from_godot(inverse.xform(p_to)));
	PackedVector3Array points;
	for (const glm::vec3 &point : path) {
		points.push_back(frame().xform(to_godot(point)));
	}
	return points;
}

double PCGCity::get_distance(int p_building, int p_other) const {
	constexpr double no_way = std::numeric_limits<double>::infinity(); // 0 would say that the buildings are one
	ERR_FAIL_COND_V_MSG(!_state, no_way, "PCGCity: there is no city yet, so no distances. Call generate() and wait for city_generated.");
	const int count = get_building_count();
	ERR_FAIL_COND_V_MSG(p_building < 0 || p_building >= count || p_other < 0 || p_other >= count, no_way,
			"PCGCity: buildings are numbered from 0 to get_building_count() - 1.");
	return _state->paths->distance(BuildingId(p_building), BuildingId(p_other));
}

int PCGCity::get_nearest_building(const String &p_type, int p_building) const {
	ERR_FAIL_COND_V_MSG(!_state, -1, "PCGCity: there is no city yet, so no buildings. Call generate() and wait for city_generated.");
	ERR_FAIL_COND_V_MSG(p_building < 0 || p_building >= get_building_count(), -1,
			"PCGCity: buildings are numbered from 0 to get_building_count() - 1.");
	const BuildingId nearest = _state->paths->nearest_building(_state->city.model.types.find(from_godot(p_type)), BuildingId(p_building));
	return is_valid(nearest) ? int(index_of(nearest)) : -1;
}

} // namespace pcg
