#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include "core/city/ground.h"
#include "core/io/atomic_file.h"
#include "core/io/gltf.h"

using namespace pcg;

namespace {

std::string scratch(const std::string &name) {
	return (std::filesystem::temp_directory_path() / "pcg_test_gltf" / name).string();
}

// Read back by the library's own loader, which checks the file's structure.
tinygltf::Model load(const std::string &path) {
	tinygltf::Model model;
	tinygltf::TinyGLTF loader;
	std::string error, warning;
	const bool is_good = loader.LoadBinaryFromFile(&model, &error, &warning, path);
	CHECK_MESSAGE(is_good, error);
	CHECK(warning.empty());
	return model;
}

void add_square(Mesh &mesh, float size, float height, uint32_t material) {
	MeshFace face;
	face.first_loop = uint32_t(mesh.loop_ends.size());
	face.material = material;
	mesh.positions.insert(mesh.positions.end(), { { 0, height, 0 }, { size, height, 0 }, { size, height, -size }, { 0, height, -size } });
	mesh.loop_ends.push_back(uint32_t(mesh.positions.size()));
	mesh.faces.push_back(face);
}

std::vector<float> floats_of(const tinygltf::Model &model, int accessor_index) {
	const tinygltf::Accessor &accessor = model.accessors[size_t(accessor_index)];
	const tinygltf::BufferView &view = model.bufferViews[size_t(accessor.bufferView)];
	std::vector<float> floats(accessor.count * 3);
	std::memcpy(floats.data(), model.buffers[0].data.data() + view.byteOffset + accessor.byteOffset, floats.size() * sizeof(float));
	return floats;
}

cga::DerivationResult sample_model() {
	cga::DerivationResult model;
	model.materials.resize(2);
	model.materials[0].name = "wall";
	model.materials[0].color = { 1.0f, 0.5f, 0.0f, 1.0f };
	model.materials[1].name = "glass";
	model.materials[1].color = { 0.2f, 0.3f, 0.4f, 0.5f };
	model.materials[1].roughness = 0.1f;
	add_square(model.mesh, 4.0f, 0.0f, 0);
	add_square(model.mesh, 2.0f, 3.0f, 1);
	for (int i = 0; i < 3; ++i) {
		cga::ModelObject bench;
		bench.tag = "bench";
		bench.frame[3] = { float(i), 0.0f, 5.0f, 1.0f };
		add_square(bench.mesh, i == 2 ? 2.0f : 1.0f, 0.5f, 0);
		model.objects.push_back(bench);
	}
	return model;
}

} // namespace

TEST_CASE("a model written as glTF reads back with its triangles, materials and objects") {
	Diagnostics diagnostics;
	REQUIRE(write_glb(sample_model(), "house", scratch("model.glb"), diagnostics));
	CHECK(diagnostics.is_empty());
	const tinygltf::Model model = load(scratch("model.glb"));
	CHECK(model.asset.version == "2.0");
	REQUIRE(model.scenes.size() == 1);
	REQUIRE(model.scenes[0].nodes.size() == 1);
	const tinygltf::Node &house = model.nodes[size_t(model.scenes[0].nodes[0])];
	CHECK(house.name == "house");
	CHECK(house.children.size() == 3);
	const tinygltf::Mesh &mesh = model.meshes[size_t(house.mesh)];
	REQUIRE(mesh.primitives.size() == 2);
	CHECK(model.accessors[size_t(mesh.primitives[0].indices)].count == 6);
	const tinygltf::Accessor &positions = model.accessors[size_t(mesh.primitives[0].attributes.at("POSITION"))];
	CHECK(positions.minValues == std::vector<double>{ 0, 0, -4 });
	CHECK(positions.maxValues == std::vector<double>{ 4, 0, 0 });
	const std::vector<float> normals = floats_of(model, mesh.primitives[0].attributes.at("NORMAL"));
	CHECK(normals[0] == 0.0f);
	CHECK(normals[1] == 1.0f);
	const tinygltf::Material &glass = model.materials[size_t(mesh.primitives[1].material)];
	CHECK(glass.name == "glass");
	CHECK(glass.alphaMode == "BLEND");
	CHECK(glass.pbrMetallicRoughness.roughnessFactor == doctest::Approx(0.1));
	CHECK(glass.pbrMetallicRoughness.baseColorFactor[3] == doctest::Approx(0.5));
	// sRGB 0.5 is 0.214 of the light.
	CHECK(model.materials[0].pbrMetallicRoughness.baseColorFactor[1] == doctest::Approx(0.21404).epsilon(0.001));
}

TEST_CASE("equal objects share one mesh and stand where their frames say") {
	Diagnostics diagnostics;
	REQUIRE(write_glb(sample_model(), "house", scratch("objects.glb"), diagnostics));
	const tinygltf::Model model = load(scratch("objects.glb"));
	const std::vector<int> &children = model.nodes[size_t(model.scenes[0].nodes[0])].children;
	REQUIRE(children.size() == 3);
	const tinygltf::Node &first = model.nodes[size_t(children[0])], &second = model.nodes[size_t(children[1])];
	CHECK(first.mesh == second.mesh);
	CHECK(model.nodes[size_t(children[2])].mesh != first.mesh);
	CHECK(second.matrix[12] == 1.0);
	CHECK(second.matrix[14] == 5.0);
	CHECK(first.extras.Get("type").Get<std::string>() == "bench");
}

TEST_CASE("triangles in the file wind counter-clockwise around their normals") {
	Diagnostics diagnostics;
	REQUIRE(write_glb(sample_model(), "house", scratch("winding.glb"), diagnostics));
	const tinygltf::Model model = load(scratch("winding.glb"));
	const tinygltf::Primitive &primitive = model.meshes[0].primitives[0];
	const std::vector<float> p = floats_of(model, primitive.attributes.at("POSITION"));
	const tinygltf::Accessor &accessor = model.accessors[size_t(primitive.indices)];
	std::vector<uint32_t> indices(accessor.count);
	std::memcpy(indices.data(), model.buffers[0].data.data() + model.bufferViews[size_t(accessor.bufferView)].byteOffset + accessor.byteOffset,
			indices.size() * sizeof(uint32_t));
	for (size_t i = 0; i < indices.size(); i += 3) {
		const float *a = &p[indices[i] * 3], *b = &p[indices[i + 1] * 3], *c = &p[indices[i + 2] * 3];
		CHECK((b[2] - a[2]) * (c[0] - a[0]) - (b[0] - a[0]) * (c[2] - a[2]) > 0.0f); // y of the cross product
	}
}

TEST_CASE("a city has a node for each lot with its number and type") {
	Diagnostics diagnostics;
	City city;
	city.layout = *make_layout(layout_for_lots(4), diagnostics);
	city.lots.resize(4);
	city.lots[2].model = sample_model();
	city.ground.blocks.push_back({ lot_ground(city.layout, city.layout.blocks[0]), {}, {} });
	REQUIRE(write_glb(city, scratch("city.glb"), diagnostics));
	const tinygltf::Model model = load(scratch("city.glb"));
	REQUIRE(model.scenes[0].nodes.size() == 2);
	CHECK(model.nodes[size_t(model.scenes[0].nodes[0])].name == "streets");
	const tinygltf::Node &block = model.nodes[size_t(model.scenes[0].nodes[1])];
	CHECK(block.name == "block 0");
	CHECK(block.mesh >= 0);
	REQUIRE(block.children.size() == 4);
	const tinygltf::Node &lot = model.nodes[size_t(block.children[2])];
	CHECK(lot.name == lot_name(city.layout, LotId(2)));
	CHECK(lot.extras.Get("lot").Get<int>() == 2);
	CHECK(lot.extras.Get("type").Get<std::string>() == city.layout.lots[2].type);
	CHECK(lot.children.size() == 3);
	CHECK(model.nodes[size_t(block.children[0])].mesh == -1);
}

TEST_CASE("a model without any geometry is still a file that opens") {
	Diagnostics diagnostics;
	REQUIRE(write_glb(cga::DerivationResult(), "nothing", scratch("empty.glb"), diagnostics));
	const tinygltf::Model model = load(scratch("empty.glb"));
	CHECK(model.meshes.empty());
	CHECK(model.nodes.size() == 1);
}

TEST_CASE("names that are not valid text do not stop the writing") {
	Diagnostics diagnostics;
	cga::DerivationResult result = sample_model();
	result.objects[0].tag = "b\xFF\xC3nch";
	result.materials[0].name = "\x80";
	REQUIRE(write_glb(result, "caf\xE9", scratch("names.glb"), diagnostics));
	CHECK(load(scratch("names.glb")).nodes.size() == 4);
}

TEST_CASE("a place that cannot be written to is an error, and nothing is left there") {
	Diagnostics diagnostics;
	std::filesystem::create_directories(scratch("folder"));
	CHECK_FALSE(write_glb(sample_model(), "house", scratch("folder"), diagnostics));
	CHECK(diagnostics.error_count() == 1);
}

TEST_CASE("what is inserted many times is one mesh with a node for each place; other materials share its corners") {
	cga::DerivationResult model = sample_model();
	Mesh square;
	add_square(square, 1.0f, 0.0f, 0);
	const auto mesh = std::make_shared<const Mesh>(square);
	model.prototypes = { { mesh, { 0 } }, { mesh, { 1 } } };
	const glm::dmat3 doubled(2.0);
	model.instances = { { 0, -1, doubled, { 7, 0, 0 } }, { 0, -1, doubled, { 9, 0, 0 } }, { 1, 2, glm::dmat3(1.0), { 0, 1, 0 } } };
	Diagnostics diagnostics;
	REQUIRE(write_glb(model, "house", scratch("instances.glb"), diagnostics));
	const tinygltf::Model file = load(scratch("instances.glb"));
	std::vector<const tinygltf::Node *> nodes;
	for (const tinygltf::Node &node : file.nodes) {
		if (node.name == "instance") {
			nodes.push_back(&node);
		}
	}
	REQUIRE(nodes.size() == 3);
	CHECK(file.meshes.size() == 5); // the house, two kinds of benches, the square in two materials
	CHECK(nodes[0]->mesh == nodes[1]->mesh);
	CHECK(nodes[0]->mesh != nodes[2]->mesh);
	CHECK(nodes[1]->matrix == std::vector<double>{ 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 9, 0, 0, 1 });
	const tinygltf::Primitive &first = file.meshes[size_t(nodes[0]->mesh)].primitives[0], &last = file.meshes[size_t(nodes[2]->mesh)].primitives[0];
	CHECK(first.attributes == last.attributes);
	CHECK(file.materials[size_t(first.material)].name == "wall");
	CHECK(file.materials[size_t(last.material)].name == "glass");
	// Below the house and below the third bench.
	const auto is_child = [&](const tinygltf::Node &parent, const tinygltf::Node *child) {
		return std::ranges::any_of(parent.children, [&](int i) { return &file.nodes[size_t(i)] == child; });
	};
	CHECK(is_child(file.nodes[0], nodes[0]));
	CHECK(is_child(file.nodes[3], nodes[2]));
}
