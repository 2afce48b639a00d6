#include "core/city/model_merge.h"

#include <algorithm>

namespace pcg {

uint32_t ModelMerge::add_material(const Material &material) {
	const auto [begin, end] = _materials.equal_range(material.name);
	const auto known = std::find_if(begin, end, [&](const auto &entry) { return _whole.materials[entry.second] == material; });
	if (known != end) {
		return known->second;
	}
	_materials.emplace(material.name, uint32_t(_whole.materials.size()));
	_whole.materials.push_back(material);
	return uint32_t(_whole.materials.size() - 1);
}

uint32_t ModelMerge::add_prototype(const cga::ModelPrototype &source, const std::vector<uint32_t> &materials) {
	cga::ModelPrototype prototype{ source.mesh, {} };
	for (const uint32_t material : source.materials) {
		prototype.materials.push_back(materials[material]);
	}
	const auto known = std::ranges::find_if(_whole.prototypes, [&](const cga::ModelPrototype &other) {
		return other.mesh == prototype.mesh && other.materials == prototype.materials;
	});
	if (known != _whole.prototypes.end()) {
		return uint32_t(known - _whole.prototypes.begin());
	}
	_whole.prototypes.push_back(std::move(prototype));
	return uint32_t(_whole.prototypes.size() - 1);
}

void ModelMerge::add(const cga::DerivationResult &piece) {
	std::vector<uint32_t> materials, prototypes;
	for (const Material &material : piece.materials) {
		materials.push_back(add_material(material));
	}
	for (const cga::ModelPrototype &prototype : piece.prototypes) {
		prototypes.push_back(add_prototype(prototype, materials));
	}
	const auto relabel = [&](Mesh &mesh, size_t first_face) {
		for (size_t i = first_face; i < mesh.faces.size(); ++i) {
			mesh.faces[i].material = materials[mesh.faces[i].material];
		}
	};
	const size_t first_face = _whole.mesh.faces.size();
	append(_whole.mesh, piece.mesh);
	relabel(_whole.mesh, first_face);
	const int32_t first_object = int32_t(_whole.objects.size());
	const auto moved = [&](int32_t object) { return object < 0 ? object : object + first_object; };
	for (cga::ModelObject object : piece.objects) {
		relabel(object.mesh, 0);
		object.parent = moved(object.parent);
		_whole.objects.push_back(std::move(object));
	}
	for (cga::ModelInstance instance : piece.instances) {
		instance.prototype = prototypes[instance.prototype];
		instance.object = moved(instance.object);
		_whole.instances.push_back(instance);
	}
	_whole.zones.insert(_whole.zones.end(), piece.zones.begin(), piece.zones.end());
	_whole.entrances.insert(_whole.entrances.end(), piece.entrances.begin(), piece.entrances.end());
	_whole.shape_count += piece.shape_count;
	_whole.leaf_count += piece.leaf_count;
	_whole.face_count += piece.face_count;
}

} // namespace pcg
