#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

#include "core/base/random.h"
#include "core/io/asset_reader.h"

using namespace pcg;

namespace {

Asset read_obj(const std::string &text, const std::string &library = {}) {
	MemoryTree files;
	files.add("a/model.obj", text);
	if (!library.empty()) {
		files.add("a/model.mtl", library);
	}
	return read_asset(files, "a/model.obj");
}

void append_u32(std::string &bytes, uint32_t value) {
	for (int i = 0; i < 4; ++i) {
		bytes += char(value >> (8 * i));
	}
}

// One triangle in a binary glTF file.
std::string triangle_glb() {
	std::string json = R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
					   R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],)"
					   R"("bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],"buffers":[{"byteLength":44}]})";
	json.resize((json.size() + 3) / 4 * 4, ' ');
	const float points[9] = { 0, 0, 0, 1, 0, 0, 0, 1, 0 };
	const uint16_t indices[4] = { 0, 1, 2, 0 };
	std::string bytes = "glTF";
	append_u32(bytes, 2);
	append_u32(bytes, uint32_t(12 + 8 + json.size() + 8 + 44));
	append_u32(bytes, uint32_t(json.size()));
	bytes += "JSON" + json;
	append_u32(bytes, 44);
	bytes += std::string("BIN\0", 4);
	bytes.append(reinterpret_cast<const char *>(points), 36);
	bytes.append(reinterpret_cast<const char *>(indices), 8);
	return bytes;
}

Asset read_glb(const std::string &bytes) {
	MemoryTree files;
	files.add("model.glb", bytes);
	return read_asset(files, "model.glb");
}

} // namespace

TEST_CASE("polygons, materials and texture coordinates of an OBJ file") {
	const Asset asset = read_obj("mtllib model.mtl\nv 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 0.5\nvt 0 1\nusemtl red brick\nf 1/1 2/2 3/3 4/4\nusemtl none\nf -4 -3 -2\n",
			"newmtl red brick\nKd 1 0.5\nNs 0\nKe 0.1 0.2 0.3\nTr 0.25\nmap_Kd -s 2 3 1 -o 0.5 0 big wall.png\nbump -bm 0.3 ..\\bumps\\b.png\n");
	CHECK(asset.problem.empty());
	REQUIRE(asset.mesh.faces.size() == 2);
	CHECK(asset.mesh.loop(0).size() == 4);
	CHECK(asset.mesh.faces[0].normal == glm::vec3(0, 0, 1));
	REQUIRE(asset.materials.size() == 3);
	const Material &brick = asset.materials[asset.mesh.faces[0].material];
	CHECK(brick.color == glm::vec4(1.0f, 0.5f, 0.5f, 0.75f));
	CHECK(brick.emissive == glm::vec3(0.1f, 0.2f, 0.3f));
	CHECK(brick.roughness == 1.0f);
	REQUIRE(brick.maps.size() == 2);
	CHECK(brick.maps[0] == TextureMap{ .use = TextureUse::Color, .file = "a/big wall.png", .scale_u = 2.0f, .scale_v = 3.0f, .shift_u = 0.5f });
	CHECK(brick.maps[1].use == TextureUse::Bump);
	CHECK(brick.maps[1].file == "bumps/b.png");
	CHECK(asset.materials[asset.mesh.faces[1].material].name == "none");
	CHECK(asset.mesh.uvs[0].empty()); // one face has none, so none of its group has
}

TEST_CASE("groups that lack texture coordinates or normals take none from others") {
	const Asset asset = read_obj("v 0 0 0\nv 2 0 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 1 0.5\nvn 0 0 2\nvn 1 0 1\no a\nf 1/1/1 2/2/1 3/3/2\no b\nf 3 2 1\n");
	REQUIRE(asset.mesh.uvs[0].size() == 6);
	CHECK(asset.mesh.uvs[0][2] == glm::vec2(1.0f, 0.5f));
	CHECK(std::isnan(asset.mesh.uvs[0][3].x));
	REQUIRE(asset.mesh.normals.size() == 6);
	CHECK(asset.mesh.normals[0] == glm::vec3(0, 0, 1));
	CHECK(std::isnan(asset.mesh.normals[5].x));
}

TEST_CASE("what is wrong with an OBJ file is told, and the rest of it is used") {
	CHECK(read_obj("mtllib model.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").problem.find("model.mtl") != std::string::npos);
	const Asset bad_index = read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n");
	CHECK(bad_index.mesh.faces.size() == 1);
	CHECK(bad_index.problem.find("line 5") != std::string::npos);
	const Asset bad_uv = read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/1 3/1\n");
	CHECK(bad_uv.mesh.is_empty());
	CHECK(read_obj("").problem == "there is no face in it");
	CHECK(read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 \\\n3\n").mesh.faces.size() == 1);
	MemoryTree files;
	CHECK_FALSE(read_asset(files, "none.obj").problem.empty());
	CHECK_FALSE(read_asset(files, "model.fbx").problem.empty());
}

TEST_CASE("a model with too many faces is cut off with a word") {
	std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
	for (int i = 0; i < 20; ++i) {
		text += "f 1 2 3\n";
	}
	MemoryTree files;
	files.add("m.obj", text);
	const Asset asset = read_asset(files, "m.obj", { .faces = 7 });
	CHECK(asset.mesh.faces.size() == 7);
	CHECK(asset.problem.find("more than 7 faces") != std::string::npos);
}

TEST_CASE("a binary glTF file gives its triangles") {
	const Asset asset = read_glb(triangle_glb());
	CHECK(asset.problem.empty());
	REQUIRE(asset.mesh.faces.size() == 1);
	CHECK(asset.mesh.faces[0].normal == glm::vec3(0, 0, 1));
	CHECK(asset.mesh.positions[1] == glm::vec3(1, 0, 0));
}

TEST_CASE("a glTF file cut off anywhere, or with any byte changed, is read or refused") {
	const std::string whole = triangle_glb();
	for (size_t length = 0; length < whole.size(); ++length) {
		CHECK_FALSE(read_glb(whole.substr(0, length)).problem.empty());
	}
	Random random(7);
	for (int i = 0; i < 3000; ++i) {
		std::string bytes = whole;
		for (int changes = 0; changes < 3; ++changes) {
			bytes[random.index(bytes.size())] = char(random.index(256));
		}
		const Asset asset = read_glb(bytes);
		CHECK(asset.mesh.faces.size() <= 1);
	}
	for (const char *text : { "{}", "[]", "{", "{\"asset\":{\"version\":\"2.0\"},\"meshes\":[{\"primitives\":[{}]}],\"nodes\":[{\"mesh\":0,\"children\":[0]}]}" }) {
		MemoryTree files;
		files.add("m.gltf", text);
		CHECK_FALSE(read_asset(files, "m.gltf").problem.empty());
	}
}

TEST_CASE("a picture within a glTF file is had by its number; others are files, whatever stands in their name") {
	MemoryTree files;
	files.add("m.gltf", R"({"asset":{"version":"2.0"},"images":[{"uri":"data:image/png;base64,iVBORw=="}]})"); // \x89PNG
	files.add("wall#0.png", "wall");
	const auto read = [&](const std::string &name) {
		const Result<std::string> bytes = read_picture(files, name, 100);
		return bytes ? *bytes : "none";
	};
	CHECK(read("m.gltf#0") == "\x89PNG");
	CHECK(read("wall#0.png") == "wall");
	for (const char *name : { "m.gltf#1", "m.gltf#", "m.gltf#x", "m.gltf#-1", "n.gltf#0", "wall#0", "#" }) {
		CHECK_MESSAGE(read(name) == "none", name);
	}
}
