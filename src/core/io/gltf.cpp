#include "core/io/gltf.h"

#include <cmath>
#include <cstring>
#include <map>
#include <sstream>

#include <nlohmann/json.hpp>

// The library's implementation lives in this file alone.
#define TINYGLTF_IMPLEMENTATION
#include "core/io/gltf_library.h"

#include "core/io/atomic_file.h"
#include "core/io/gltf_materials.h"
#include "core/io/utf8.h"

namespace pcg {

namespace {

using Extras = std::map<std::string, tinygltf::Value>;

// Collects nodes, meshes and materials; equal materials become one, and so do equal meshes of which there may be many.
class GlbBuilder {
public:
	static constexpr int no_parent = -1;
	static constexpr int no_mesh = -1;

	GlbBuilder(const FileTree *pictures, Diagnostics &diagnostics) : _materials(_model, pictures, diagnostics) {}

	// The mesh's index, or no_mesh if it has no area.
	int add_mesh(const Mesh &mesh, const std::vector<Material> &materials, const std::string &name) {
		const std::vector<MeshSurface> surfaces = make_surfaces(mesh);
		return surfaces.empty() ? no_mesh : add_surfaces(surfaces, add_materials(surfaces, materials), name);
	}

	// The same, but an equal mesh that was added by this function is used again.
	int add_shared_mesh(const Mesh &mesh, const std::vector<Material> &materials, const std::string &name) {
		const std::vector<MeshSurface> surfaces = make_surfaces(mesh);
		if (surfaces.empty()) {
			return no_mesh;
		}
		const std::vector<int> indices = add_materials(surfaces, materials);
		const auto [place, is_new] = _shared_meshes.emplace(content_of(surfaces, indices), int(_model.meshes.size()));
		return is_new ? add_surfaces(surfaces, indices, name) : place->second;
	}

	// The mesh of a prototype: once for all lots where its materials are the same, and with one copy of its corners whatever its materials.
	int add_prototype(const cga::ModelPrototype &prototype, const std::vector<Material> &materials) {
		Prototype &known = _prototypes[prototype.mesh.get()];
		if (known.surfaces.empty()) {
			for (const MeshSurface &surface : make_surfaces(*prototype.mesh)) {
				known.surfaces.emplace_back(surface.material, add_primitive(surface));
				known.sets = sets_of(surface.uvs.data());
			}
		}
		std::vector<int> indices;
		for (const auto &[material, primitive] : known.surfaces) {
			indices.push_back(_materials.add(materials[prototype.materials[material]], known.sets));
		}
		const auto [place, is_new] = known.meshes.emplace(indices, int(_model.meshes.size()));
		if (is_new) {
			tinygltf::Mesh mesh;
			for (size_t i = 0; i < indices.size(); ++i) {
				mesh.primitives.push_back(known.surfaces[i].second);
				mesh.primitives.back().material = indices[i];
			}
			_model.meshes.push_back(std::move(mesh));
		}
		return place->second;
	}

	int add_node(const std::string &name, int mesh, int parent, Extras extras = {}) {
		tinygltf::Node node;
		node.name = valid_utf8(name);
		node.mesh = mesh;
		if (!extras.empty()) {
			node.extras = tinygltf::Value(std::move(extras));
		}
		const int index = int(_model.nodes.size());
		_model.nodes.push_back(std::move(node));
		(parent == no_parent ? _roots : _model.nodes[size_t(parent)].children).push_back(index);
		return index;
	}

	void place_node(int node, const glm::mat4 &frame) {
		for (int column = 0; column < 4; ++column) {
			for (int row = 0; row < 4; ++row) {
				_model.nodes[size_t(node)].matrix.push_back(double(frame[column][row]));
			}
		}
	}

	bool write(const std::string &path, Diagnostics &diagnostics) {
		finish_buffer();
		tinygltf::Scene scene;
		scene.nodes = _roots;
		_model.scenes.push_back(std::move(scene));
		_model.defaultScene = 0;
		_model.asset.version = "2.0";
		_model.asset.generator = "PCG for Godot";
		std::ostringstream stream;
		tinygltf::TinyGLTF writer;
		if (!writer.WriteGltfSceneToStream(&_model, stream, false, true)) {
			diagnostics.add({ Severity::Error, "cannot-write-file", path, 0, 0, "the model does not fit into a glTF file", "write fewer lots", {} });
			return false;
		}
		return write_file(path, stream.str(), diagnostics);
	}

private:
	struct Prototype {
		std::vector<std::pair<uint32_t, tinygltf::Primitive>> surfaces; // with their material in the prototype's list
		uint32_t sets = 0;
		std::map<std::vector<int>, int> meshes; // by their materials
	};
	enum View { Indices, Positions, Normals, Uvs, ViewCount }; // Uvs last: there may be none

	std::vector<int> add_materials(const std::vector<MeshSurface> &surfaces, const std::vector<Material> &materials) {
		std::vector<int> indices;
		for (const MeshSurface &surface : surfaces) {
			const Material material = surface.material < materials.size() ? materials[surface.material] : Material();
			indices.push_back(_materials.add(material, sets_of(surface.uvs.data())));
		}
		return indices;
	}

	// Everything that makes two meshes equal, as bytes.
	static std::string content_of(const std::vector<MeshSurface> &surfaces, const std::vector<int> &materials) {
		std::string content;
		const auto append = [&content](const auto &list) {
			content.append(reinterpret_cast<const char *>(list.data()), list.size() * sizeof(list[0]));
		};
		append(materials);
		for (const MeshSurface &surface : surfaces) {
			append(surface.positions);
			append(surface.normals);
			append(surface.indices);
			for (const std::vector<glm::vec2> &uvs : surface.uvs) {
				append(std::vector<size_t>{ uvs.size() });
				append(uvs);
			}
		}
		return content;
	}

	int add_surfaces(const std::vector<MeshSurface> &surfaces, const std::vector<int> &materials, const std::string &name) {
		tinygltf::Mesh mesh;
		mesh.name = valid_utf8(name);
		for (size_t i = 0; i < surfaces.size(); ++i) {
			mesh.primitives.push_back(add_primitive(surfaces[i]));
			mesh.primitives.back().material = materials[i];
		}
		_model.meshes.push_back(std::move(mesh));
		return int(_model.meshes.size()) - 1;
	}

	tinygltf::Primitive add_primitive(const MeshSurface &surface) {
		tinygltf::Primitive primitive;
		primitive.mode = TINYGLTF_MODE_TRIANGLES;
		primitive.indices = add_accessor(Indices, surface.indices, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR);
		const int positions = add_accessor(Positions, surface.positions, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3);
		set_bounds(_model.accessors[size_t(positions)], surface.positions);
		primitive.attributes["POSITION"] = positions;
		primitive.attributes["NORMAL"] = add_accessor(Normals, surface.normals, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3);
		add_uvs(primitive, surface);
		return primitive;
	}

	// In the file v runs down the picture.
	void add_uvs(tinygltf::Primitive &primitive, const MeshSurface &surface) {
		const uint32_t sets = sets_of(surface.uvs.data());
		for (size_t set = 0; set < uv_set_count; ++set) {
			if (surface.uvs[set].empty()) {
				continue;
			}
			std::vector<glm::vec2> uvs = surface.uvs[set];
			for (glm::vec2 &uv : uvs) {
				uv.y = 1.0f - uv.y;
			}
			primitive.attributes["TEXCOORD_" + std::to_string(file_set(sets, set))] = add_accessor(Uvs, uvs, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC2);
		}
	}

	template <typename T> int add_accessor(View view, const std::vector<T> &items, int component, int type) {
		tinygltf::Accessor accessor;
		accessor.bufferView = view;
		accessor.byteOffset = _bytes[view].size();
		accessor.componentType = component;
		accessor.type = type;
		accessor.count = items.size();
		const size_t size = items.size() * sizeof(T);
		_bytes[view].resize(accessor.byteOffset + size);
		std::memcpy(_bytes[view].data() + accessor.byteOffset, items.data(), size);
		_model.accessors.push_back(std::move(accessor));
		return int(_model.accessors.size()) - 1;
	}

	static void set_bounds(tinygltf::Accessor &accessor, const std::vector<glm::vec3> &points) {
		glm::vec3 low = points[0], high = points[0];
		for (const glm::vec3 &point : points) {
			for (int i = 0; i < 3; ++i) {
				low[i] = std::fmin(low[i], point[i]);
				high[i] = std::fmax(high[i], point[i]);
			}
		}
		accessor.minValues = { low.x, low.y, low.z };
		accessor.maxValues = { high.x, high.y, high.z };
	}

	// All numbers have four bytes, so the views one behind the other stay aligned; pictures come last. A model without meshes has no buffer.
	void finish_buffer() {
		if (_model.meshes.empty()) {
			return;
		}
		tinygltf::Buffer buffer;
		for (int i = 0; i < (_bytes[Uvs].empty() ? int(Uvs) : int(ViewCount)); ++i) {
			tinygltf::BufferView view;
			view.buffer = 0;
			view.byteOffset = buffer.data.size();
			view.byteLength = _bytes[i].size();
			view.byteStride = i == Indices ? 0 : i == Uvs ? sizeof(glm::vec2) : sizeof(glm::vec3);
			view.target = i == Indices ? TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER : TINYGLTF_TARGET_ARRAY_BUFFER;
			buffer.data.insert(buffer.data.end(), _bytes[i].begin(), _bytes[i].end());
			_bytes[i] = {};
			_model.bufferViews.push_back(std::move(view));
		}
		_materials.finish(buffer);
		_model.buffers.push_back(std::move(buffer));
	}

	tinygltf::Model _model;
	std::vector<int> _roots;
	std::vector<unsigned char> _bytes[ViewCount];
	GltfMaterials _materials;
	std::map<std::string, int> _shared_meshes;
	std::map<const Mesh *, Prototype> _prototypes; // looked up only
};

// One mesh for all places where a prototype stands; `nodes` are those of the objects.
void add_instances(GlbBuilder &builder, const cga::DerivationResult &model, const std::vector<int> &nodes, int lot) {
	std::vector<int> meshes;
	for (const cga::ModelPrototype &prototype : model.prototypes) {
		meshes.push_back(builder.add_prototype(prototype, model.materials));
	}
	for (const cga::ModelInstance &instance : model.instances) {
		glm::mat4 frame(glm::mat3(instance.axes));
		frame[3] = glm::vec4(glm::vec3(instance.origin), 1.0f);
		builder.place_node(builder.add_node("instance", meshes[instance.prototype], instance.object < 0 ? lot : nodes[size_t(instance.object)]), frame);
	}
}

// With all instances.
void add_objects(GlbBuilder &builder, const cga::DerivationResult &model, const std::vector<ObjectId> &ids, int parent) {
	std::vector<int> nodes;
	for (size_t i = 0; i < model.objects.size(); ++i) {
		const cga::ModelObject &object = model.objects[i];
		Extras extras = { { "type", tinygltf::Value(valid_utf8(object.tag)) } };
		if (i < ids.size()) {
			extras.emplace("object", tinygltf::Value(int(index_of(ids[i]))));
		}
		const int mesh = builder.add_shared_mesh(object.mesh, model.materials, object.tag);
		nodes.push_back(builder.add_node(object.tag, mesh, parent, std::move(extras)));
		builder.place_node(nodes.back(), object.frame);
	}
	add_instances(builder, model, nodes, parent);
}

void add_lot(GlbBuilder &builder, const City &city, LotId id, int parent) {
	const LotBuild &lot = city.lots[index_of(id)];
	const std::string name = lot_name(city.layout, id);
	Extras extras = { { "lot", tinygltf::Value(int(index_of(id))) }, { "type", tinygltf::Value(valid_utf8(city.layout.lot(id).type)) } };
	const int mesh = builder.add_mesh(lot.model.mesh, lot.model.materials, name);
	const int node = builder.add_node(name, mesh, parent, std::move(extras));
	add_objects(builder, lot.model, lot.objects, node);
}

// Its node.
int add_ground(GlbBuilder &builder, const GroundBuild &ground, const std::string &name, int parent) {
	const int node = builder.add_node(name, builder.add_mesh(ground.model.mesh, ground.model.materials, name), parent);
	add_objects(builder, ground.model, ground.objects, node);
	return node;
}

} // namespace

bool write_glb(const City &city, const std::string &path, Diagnostics &diagnostics, const FileTree *pictures) {
	GlbBuilder builder(pictures, diagnostics);
	const int streets = builder.add_node("streets", GlbBuilder::no_mesh, GlbBuilder::no_parent);
	for (size_t i = 0; i < city.ground.streets.size(); ++i) {
		add_ground(builder, city.ground.streets[i], "tile " + std::to_string(i), streets);
	}
	for (size_t i = 0; i < city.layout.blocks.size(); ++i) {
		const GroundBuild nothing;
		const int node = add_ground(builder, i < city.ground.blocks.size() ? city.ground.blocks[i] : nothing, "block " + std::to_string(i),
				GlbBuilder::no_parent);
		for (LotId lot : city.layout.blocks[i].lots) {
			add_lot(builder, city, lot, node);
		}
	}
	return builder.write(path, diagnostics);
}

bool write_glb(const cga::DerivationResult &model, const std::string &name, const std::string &path, Diagnostics &diagnostics,
		const FileTree *pictures) {
	GlbBuilder builder(pictures, diagnostics);
	const int node = builder.add_node(name, builder.add_mesh(model.mesh, model.materials, name), GlbBuilder::no_parent);
	add_objects(builder, model, {}, node);
	return builder.write(path, diagnostics);
}

} // namespace pcg
