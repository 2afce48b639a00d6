#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <optional>

#include "core/geometry/shown_material.h"
#include "core/io/file_tree.h"
#include "core/io/gltf.h"
#include "core/io/gltf_library.h"
#include "core/io/gltf_materials.h"
#include "core/io/picture.h"

using namespace pcg;

namespace {

using Pixel = std::array<int, 4>;

std::string png_of(Pixel pixel) {
	return encode_png({ { 1, 1 }, { uint8_t(pixel[0]), uint8_t(pixel[1]), uint8_t(pixel[2]), uint8_t(pixel[3]) }, true });
}
// One grey pixel, a quarter of white, without an alpha channel.
std::string grey_png() {
	constexpr unsigned char bytes[] = { 0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00, 0x00, 0x01,
		0x00, 0x00, 0x00, 0x01, 0x08, 0x00, 0x00, 0x00, 0x00, 0x3A, 0x7E, 0x9B, 0x55, 0x00, 0x00, 0x00, 0x0A, 0x49, 0x44, 0x41, 0x54, 0x78, 0x9C, 0x63, 0x70,
		0x00, 0x00, 0x00, 0x42, 0x00, 0x41, 0x29, 0x37, 0xF4, 0xEF, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4E, 0x44, 0xAE, 0x42, 0x60, 0x82 };
	return std::string(reinterpret_cast<const char *>(bytes), sizeof(bytes));
}

const std::string png("\x89PNG\r\n\x1a\n first", 15), jpeg("\xFF\xD8\xFF\xE0 second", 11);

class Pictures : public FileTree {
public:
	bool has_file(const std::string &path) const override { return files.contains(path); }
	bool has_folder(const std::string &) const override { return false; }
	std::vector<Entry> list(const std::string &) const override { return {}; }
	Result<std::string> read(const std::string &path, size_t) const override {
		++reads;
		const auto found = files.find(path);
		return found != files.end() ? Result<std::string>(found->second) : Result<std::string>(Diagnostic{});
	}

	std::map<std::string, std::string> files = { { "brick.png", png }, { "dirt.jpg", jpeg }, { "old.tif", "II*" }, { "grey.png", grey_png() },
		{ "red.png", png_of({ 255, 0, 0, 255 }) } };
	mutable int reads = 0;
};

// One square metre; u, v as x and -z in set 0, twice that in set 2.
Mesh square() {
	Mesh mesh;
	mesh.positions = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, -1 }, { 0, 0, -1 } };
	mesh.loop_ends = { 4 };
	mesh.faces = { { 0, 1, 0, { 0, 1, 0 } } };
	mesh.uvs[0] = { { 0, 0 }, { 1, 0 }, { 1, 0.25 }, { 0, 0.25 } };
	mesh.uvs[2] = { { 0, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 } };
	return mesh;
}

struct Written {
	tinygltf::Model model;
	Diagnostics diagnostics;
	int reads = 0;

	const tinygltf::Material &material() const { return model.materials.at(0); }
};

Written written(const cga::DerivationResult &result) {
	const std::string path = (std::filesystem::temp_directory_path() / "pcg_test_gltf_materials.glb").string();
	Written out;
	Pictures pictures;
	REQUIRE(write_glb(result, "house", path, out.diagnostics, &pictures));
	out.reads = pictures.reads;
	tinygltf::TinyGLTF loader;
	loader.SetImageLoader([](tinygltf::Image *, int, std::string *, std::string *, int, int, const unsigned char *, int, void *) { return true; }, nullptr);
	std::string error, warning;
	const bool is_good = loader.LoadBinaryFromFile(&out.model, &error, &warning, path);
	CHECK_MESSAGE(is_good, error);
	return out;
}

Written written(const Material &material, Mesh mesh = square()) {
	cga::DerivationResult result;
	result.materials = { material };
	result.mesh = std::move(mesh);
	return written(result);
}

std::string picture_of(const tinygltf::Model &model, int texture) {
	const tinygltf::BufferView &view = model.bufferViews.at(size_t(model.images.at(size_t(model.textures.at(size_t(texture)).source)).bufferView));
	const unsigned char *bytes = model.buffers[0].data.data() + view.byteOffset;
	return std::string(bytes, bytes + view.byteLength);
}

Pixel first_pixel(const tinygltf::Model &model, int texture) {
	const std::optional<Picture> picture = decode_picture(picture_of(model, texture));
	REQUIRE(picture.has_value());
	const uint8_t *pixel = picture->pixel({ 0, 0 });
	return { pixel[0], pixel[1], pixel[2], pixel[3] };
}

std::vector<float> numbers(const tinygltf::Model &model, const std::string &attribute) {
	const tinygltf::Accessor &accessor = model.accessors.at(size_t(model.meshes[0].primitives[0].attributes.at(attribute)));
	std::vector<float> result(accessor.count * 2);
	const tinygltf::BufferView &view = model.bufferViews[size_t(accessor.bufferView)];
	std::memcpy(result.data(), model.buffers[0].data.data() + view.byteOffset + accessor.byteOffset, result.size() * sizeof(float));
	return result;
}

Material with(std::vector<TextureMap> maps) {
	Material material;
	material.maps = std::move(maps);
	return material;
}

} // namespace

TEST_CASE("pictures lie in the file as they are, each once, and coordinates run down the picture") {
	cga::DerivationResult result;
	result.materials = { with({ { TextureUse::Color, "brick.png" }, { TextureUse::Dirt, "dirt.jpg" } }), with({ { TextureUse::Color, "brick.png" } }) };
	result.materials[1].roughness = 0.5f;
	result.mesh = square();
	append(result.mesh, square(), 1);
	const Written out = written(result);
	CHECK(out.diagnostics.is_empty());
	CHECK(out.reads == 2);
	REQUIRE(out.model.images.size() == 2);
	CHECK(out.model.images[0].mimeType == "image/png");
	CHECK(out.model.images[1].mimeType == "image/jpeg");
	CHECK(picture_of(out.model, out.material().pbrMetallicRoughness.baseColorTexture.index) == png);
	CHECK(picture_of(out.model, out.material().occlusionTexture.index) == jpeg); // dirt darkens
	CHECK(out.material().pbrMetallicRoughness.baseColorTexture.texCoord == 0);
	CHECK(out.material().occlusionTexture.texCoord == 1); // set 2 is the second one in the file
	CHECK(numbers(out.model, "TEXCOORD_0") == std::vector<float>{ 0, 1, 1, 1, 1, 0.75f, 0, 0.75f });
	CHECK(numbers(out.model, "TEXCOORD_1") == std::vector<float>{ 0, 1, 2, 1, 2, -1, 0, -1 });
}

TEST_CASE("surfaces without texture coordinates have no pictures, maps without a set of their own use the first") {
	Mesh bare = square();
	bare.uvs = {};
	const Written without = written(with({ { TextureUse::Color, "brick.png" } }), bare);
	CHECK(without.model.images.empty());
	CHECK(without.material().pbrMetallicRoughness.baseColorTexture.index == -1);
	Mesh one = square();
	one.uvs[2].clear();
	CHECK(written(with({ { TextureUse::Color, "brick.png" }, { TextureUse::Dirt, "dirt.jpg" } }), one).material().occlusionTexture.texCoord == 0);
}

TEST_CASE("pictures that are missing or of another kind are told once, and the surface is plain") {
	const Written out = written(with({ { TextureUse::Color, "old.tif" }, { TextureUse::Normal, "none.png" }, { TextureUse::Emissive, "none.png" } }));
	CHECK(out.diagnostics.warning_count() == 2);
	CHECK(out.model.images.empty());
	CHECK(out.material().normalTexture.index == -1);
}

TEST_CASE("a map that is scaled, turned and shifted stays where CGA lays it") {
	TextureMap map = { TextureUse::Color, "brick.png" };
	map.scale_u = 2.0f;
	map.scale_v = 3.0f;
	map.shift_u = 0.25f;
	map.shift_v = 0.5f;
	map.turn = 90.0f;
	const Written out = written(with({ map }));
	REQUIRE(out.model.extensionsUsed == std::vector<std::string>{ "KHR_texture_transform" });
	const tinygltf::Value &transform = out.material().pbrMetallicRoughness.baseColorTexture.extensions.at("KHR_texture_transform");
	const auto number = [&](const char *key, int i) { return transform.Get(key).Get(i).GetNumberAsDouble(); };
	const double turn = transform.Get("rotation").GetNumberAsDouble();
	// By hand: (1, 0.25) is scaled to (2, 0.75), turned to (-0.75, 2), shifted to (-0.5, 2.5); down the picture that is (-0.5, -1.5). The file
	// says the same of (1, 0.75): scaled, turned clockwise as seen with v down, shifted (KHR_texture_transform).
	const double u = 1.0 * number("scale", 0), v = 0.75 * number("scale", 1);
	CHECK(std::cos(turn) * u + std::sin(turn) * v + number("offset", 0) == doctest::Approx(-0.5));
	CHECK(-std::sin(turn) * u + std::cos(turn) * v + number("offset", 1) == doctest::Approx(-1.5));
}

TEST_CASE("opacity: of the colour, of the colour map's alpha, or of a picture of its own") {
	CHECK(written(with({ { TextureUse::Color, "brick.png" } })).material().alphaMode == "OPAQUE");
	CHECK(written(with({ { TextureUse::Color, "brick.png" }, { TextureUse::Opacity, "brick.png" } })).material().alphaMode == "BLEND");
	const Written apart = written(with({ { TextureUse::Color, "red.png" }, { TextureUse::Opacity, "grey.png" } }));
	CHECK(apart.diagnostics.is_empty());
	CHECK(apart.material().alphaMode == "BLEND");
	CHECK(apart.model.images.size() == 1);
	CHECK(first_pixel(apart.model, apart.material().pbrMetallicRoughness.baseColorTexture.index) == Pixel{ 255, 0, 0, 64 });
	const Written alone = written(with({ { TextureUse::Opacity, "grey.png" } }));
	CHECK(first_pixel(alone.model, alone.material().pbrMetallicRoughness.baseColorTexture.index) == Pixel{ 255, 255, 255, 64 });
}

TEST_CASE("an opacity map that lies otherwise than the colour map, or cannot be read, is left out with a word") {
	TextureMap mask = { TextureUse::Opacity, "grey.png" };
	mask.scale_u = 2.0f;
	const Written other = written(with({ { TextureUse::Color, "red.png" }, mask }));
	CHECK(other.diagnostics.warning_count() == 1);
	CHECK(other.material().alphaMode == "OPAQUE");
	const Written broken = written(with({ { TextureUse::Color, "red.png" }, { TextureUse::Opacity, "dirt.jpg" } }));
	CHECK(broken.diagnostics.warning_count() == 1);
	CHECK(first_pixel(broken.model, broken.material().pbrMetallicRoughness.baseColorTexture.index) == Pixel{ 255, 0, 0, 255 });
}

TEST_CASE("roughness in green and metal in blue, from one picture, from two, or from one of them") {
	Material material = with({ { TextureUse::Emissive, "dirt.jpg" }, { TextureUse::Roughness, "grey.png" } });
	const auto surface = [](const Written &out) { return out.material().pbrMetallicRoughness.metallicRoughnessTexture.index; };
	const Written plain = written(material); // no metal: the picture as it is
	CHECK(picture_of(plain.model, surface(plain)) == grey_png());
	CHECK(plain.material().emissiveFactor == std::vector<double>{ 1, 1, 1 });
	material.metallic = 1.0f;
	const Written metal = written(material);
	CHECK(first_pixel(metal.model, surface(metal)) == Pixel{ 255, 64, 255, 255 });
	CHECK(metal.material().pbrMetallicRoughness.metallicFactor == 1.0);
	material.maps.push_back({ TextureUse::Metallic, "grey.png" });
	CHECK(written(material).model.images.size() == 2);
	material.maps.back().file = "red.png";
	const Written two = written(material);
	CHECK(first_pixel(two.model, surface(two)) == Pixel{ 255, 64, 0, 255 });
	material.maps.erase(material.maps.begin() + 1);
	const Written lone = written(material);
	CHECK(first_pixel(lone.model, surface(lone)) == Pixel{ 255, 255, 0, 255 });
}

TEST_CASE("a specular colour stands for a smoother surface, as its exponent says") {
	Material material;
	material.roughness = 1.0f;
	CHECK(shown_roughness(material) == 1.0f);
	material.specular = glm::vec3(1.0f);
	material.shininess = 30.0f; // (2 / 32) to the power of 1 / 4
	CHECK(shown_roughness(material) == doctest::Approx(0.5));
	material.specular = glm::vec3(0.5f);
	CHECK(shown_roughness(material) == doctest::Approx(0.75));
	material.specular = glm::vec3(1.0f);
	material.reflectivity = 1.0f;
	CHECK(shown_roughness(material) == doctest::Approx(0.05));
	material.roughness = 0.7f; // a rule said so
	CHECK(shown_roughness(material) == 0.7f);
}
