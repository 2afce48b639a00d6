#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/multi_mesh_instance3d.hpp>
#include <godot_cpp/classes/ref.hpp>

#include "core/cga/derivation.h"
#include "godot/city_materials.h"

namespace pcg {

// Inserted models in the scene: the engine's mesh of a prototype is made once for the whole city, and all places in one lot or object where it stands
// are one node. Prototypes that differ by one colour for all of their surfaces have one mesh, too; places then bring the colour.
class CityInstances {
public:
	explicit CityInstances(CityMaterials &materials) : _materials(materials) {}

	// Nodes for the instances of one of the model's objects, or of the lot itself (-1), moved by `offset`. They belong to the caller.
	std::vector<godot::MultiMeshInstance3D *> make(const cga::DerivationResult &model, int32_t object, godot::Vector3 offset);

private:
	struct Prototype {
		godot::Ref<godot::ArrayMesh> mesh; // null: nothing to draw
		bool is_tinted = false; // its places bring its colour
	};
	using SurfaceLook = std::pair<const CityMaterials::Entry *, std::array<float, 4>>;
	// Stretched places are one group only where they are stretched and turned alike: the engine turns normals rightly by a node's transform, not by
	// that of a place.
	struct Group {
		const Prototype *prototype = nullptr;
		std::array<int64_t, 9> axes = {}; // rounded; 0 where not stretched
		std::vector<const cga::ModelInstance *> places;

		bool is_stretched() const { return axes != std::array<int64_t, 9>(); }
	};

	const Prototype &prototype(const cga::DerivationResult &model, const cga::ModelPrototype &source);
	static Group &group_of(std::vector<Group> &groups, const Prototype &prototype, const cga::ModelInstance &place);
	static godot::MultiMeshInstance3D *make_node(const cga::DerivationResult &model, const Group &group, godot::Vector3 offset);

	CityMaterials &_materials;
	std::map<std::pair<const Mesh *, std::vector<SurfaceLook>>, Prototype> _prototypes; // looked up only
};

} // namespace pcg
