#include <doctest/doctest.h>

#include <algorithm>

#include "core/cga/derivation.h"
#include "core/cga/dialect.h"
#include "core/io/rule_loader.h"

#include "core/ports/asset_provider.h"

using namespace pcg;

namespace {

// Knows pictures that begin with "glass" (with alpha) and "wall", and one model with a material of its own.
class Pictures : public AssetProvider {
public:
	Pictures() {
		_model.mesh.positions = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
		_model.mesh.loop_ends = { 4 };
		_model.mesh.faces = { { 0, 1, 0, { 0, 0, 1 } } };
		Material oak;
		oak.name = "oak";
		oak.color = { 0.5f, 0.25f, 0.0f, 0.5f };
		oak.roughness = 0.25f;
		oak.maps = { { TextureUse::Color, "oak.png" }, { TextureUse::Normal, "oak_n.png", 2.0f } };
		_model.materials = { oak };
	}
	const Asset *find(std::string_view name, std::string_view) const override { return name == "door.obj" ? &_model : nullptr; }
	std::string locate(std::string_view name, std::string_view) const override {
		++asked;
		return name.starts_with("glass") || name.starts_with("wall") ? "res://pictures/" + std::string(name) : std::string();
	}
	bool has_alpha(std::string_view name, std::string_view) const override { return name.starts_with("glass"); }

	mutable int asked = 0;

private:
	Asset _model;
};

cga::DerivationResult derived(const std::string &rule, const AssetProvider &assets) {
	Diagnostics diagnostics;
	MemorySourceProvider source;
	source.add("test.cga", rule);
	const auto program = load_program("test.cga", cga::cga_dialect(), source, diagnostics);
	REQUIRE(program != nullptr);
	cga::DeriveOptions options;
	options.assets = &assets;
	return cga::derive(*program, cga::InitialShape::rectangle(10.0, 10.0), options);
}

std::string file_of(const Material &material, TextureUse use) {
	return material.map(use) != nullptr ? material.map(use)->file : std::string();
}

} // namespace

TEST_CASE("pictures are asked for once, stand in the material by their path, and fill the opacity map if they have alpha") {
	const Pictures pictures;
	const auto model = derived("Lot --> split(x) { 1 : texture(\"glass.png\") A. }* \n", pictures);
	REQUIRE(model.materials.size() == 1);
	CHECK(pictures.asked == 1);
	CHECK(file_of(model.materials[0], TextureUse::Color) == "res://pictures/glass.png");
	CHECK(file_of(model.materials[0], TextureUse::Opacity) == "res://pictures/glass.png");
	CHECK(file_of(derived("Lot --> texture(\"wall.jpg\")", pictures).materials[0], TextureUse::Opacity).empty());
}

TEST_CASE("a picture that is missing is told once and stays by its name; what rules read is what they set") {
	const Pictures pictures;
	const auto model = derived("Lot --> split(x) { 1 : texture(\"none.png\") print(material.colormap) A. }*", pictures);
	const auto &list = model.diagnostics.list();
	CHECK(std::ranges::count_if(list, [](const Diagnostic &d) { return d.id == "missing-texture"; }) == 1);
	CHECK(file_of(model.materials[0], TextureUse::Color) == "none.png");
	CHECK(model.prints.size() == 10);
	CHECK(model.prints[0] == "none.png");
	CHECK(derived("Lot --> texture(\"wall.jpg\") print(material.colormap)", pictures).prints[0] == "wall.jpg");
	CHECK(derived("Lot --> texture(\"builtin:uvtest.png\")", pictures).diagnostics.is_empty());
}

TEST_CASE("what a rule set itself wins over an asset's material, the rest is the asset's") {
	const Pictures pictures;
	const auto plain = derived("Lot --> i(\"door.obj\")", pictures);
	REQUIRE(plain.materials.size() == 1);
	CHECK(plain.materials[0].name == "oak");
	CHECK(plain.materials[0].color == glm::vec4(0.5f, 0.25f, 0.0f, 0.5f));
	CHECK(plain.materials[0].roughness == 0.25f);
	const auto changed = derived("Lot --> color(1, 0, 0) set(material.metallic, 1) texture(\"wall.jpg\") i(\"door.obj\")", pictures);
	const Material &material = changed.materials[0];
	CHECK(material.color == glm::vec4(1.0f, 0.0f, 0.0f, 0.5f)); // the opacity was not set
	CHECK(material.metallic == 1.0f);
	CHECK(material.roughness == 0.25f);
	CHECK(file_of(material, TextureUse::Color) == "res://pictures/wall.jpg");
	CHECK(file_of(material, TextureUse::Normal) == "oak_n.png");
	CHECK(file_of(derived("Lot --> texture(\"\") i(\"door.obj\")", pictures).materials[0], TextureUse::Color).empty());
}

TEST_CASE("a model's picture that a rule lays out as pictures lie anyhow lies so") {
	const Pictures pictures;
	const Material plain = derived("Lot --> i(\"door.obj\")", pictures).materials[0];
	CHECK(plain.map(TextureUse::Normal)->scale_u == 2.0f);
	const Material changed = derived("Lot --> i(\"door.obj\") set(material.normalmap.su, 1)", pictures).materials[0];
	CHECK(file_of(changed, TextureUse::Normal) == "oak_n.png");
	CHECK(changed.map(TextureUse::Normal)->scale_u == 1.0f);
}
