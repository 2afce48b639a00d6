#include <doctest/doctest.h>

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/cga/dialect.h"
#include "core/cga/instances.h"
#include "core/cga/neighborhood.h"
#include "core/io/rule_loader.h"
#include "core/ports/asset_provider.h"

using namespace pcg;
using namespace pcg::cga;

namespace {

// box.obj: 1 x 2 x 3 m from the origin, 6 faces, of which the upper one has the second material, and a face that is only an edge.
// tree.obj: 5,000 triangles.
class Models : public AssetProvider {
public:
	Models() {
		const glm::vec3 p[8] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 3 }, { 0, 0, 3 }, { 0, 2, 0 }, { 1, 2, 0 }, { 1, 2, 3 }, { 0, 2, 3 } };
		add(_box, { p[0], p[1], p[2], p[3] }, 0);
		add(_box, { p[7], p[6], p[5], p[4] }, 1);
		add(_box, { p[3], p[2], p[6], p[7] }, 0);
		add(_box, { p[1], p[0], p[4], p[5] }, 0);
		add(_box, { p[2], p[1], p[5], p[6] }, 0);
		add(_box, { p[0], p[3], p[7], p[4] }, 0);
		add(_box, { p[0], p[1], p[0] }, 0);
		_box.materials.resize(2);
		_box.materials[0].name = "walls";
		_box.materials[1].name = "lid";
		for (int i = 0; i < 5000; ++i) {
			add(_tree, { { float(i % 100), float(i), 0 }, { float(i % 100) + 1, float(i), 0 }, { 0, float(i) + 1, 1 } }, 0);
		}
		_tree.materials.emplace_back();
	}
	const Asset *find(std::string_view name, std::string_view) const override {
		return name == "box.obj" ? &_box : name == "tree.obj" ? &_tree : nullptr;
	}

private:
	static void add(Asset &asset, const std::vector<glm::vec3> &points, uint32_t material) {
		asset.mesh.positions.insert(asset.mesh.positions.end(), points.begin(), points.end());
		asset.mesh.loop_ends.push_back(uint32_t(asset.mesh.positions.size()));
		asset.mesh.faces.push_back({ uint32_t(asset.mesh.loop_ends.size()) - 1, 1, material, { 0, 1, 0 } });
	}

	Asset _box, _tree;
};

const Models models;

std::vector<DerivationResult> derived(const std::string &rule, const std::vector<InitialShape> &lots, unsigned threads = 1) {
	Diagnostics diagnostics;
	MemorySourceProvider source;
	source.add("test.cga", rule);
	const auto program = load_program("test.cga", cga_dialect(), source, diagnostics);
	REQUIRE_MESSAGE(program != nullptr, to_text(diagnostics));
	DeriveOptions options;
	options.assets = &models;
	return derive_all(*program, lots, options, { threads, {}, nullptr });
}

DerivationResult derived(const std::string &rule) { return std::move(derived(rule, { InitialShape::rectangle(100.0, 100.0) })[0]); }

std::pair<glm::vec3, glm::vec3> bounds(const Mesh &mesh) {
	glm::vec3 low(INFINITY), high(-INFINITY);
	for (const glm::vec3 &point : mesh.positions) {
		low = glm::min(low, point);
		high = glm::max(high, point);
	}
	return { low, high };
}

} // namespace

TEST_CASE("a model from a file is an instance: its mesh is the file's, its place and size are the scope's") {
	const DerivationResult model = derived("Lot --> t(10, 0, 5) s(2, 2, 6) i(\"box.obj\")");
	CHECK(model.mesh.is_empty());
	CHECK(model.face_count == 6); // the edge is none
	REQUIRE(model.prototypes.size() == 1);
	REQUIRE(model.instances.size() == 1);
	CHECK(bounds(*model.prototypes[0].mesh) == std::pair(glm::vec3(0, 0, 0), glm::vec3(1, 2, 3)));
	CHECK(model.instances[0].object == -1);
	CHECK(placed(model.instances[0], { 0, 0, 0 }) == glm::vec3(10, 0, -95)); // from the back left corner of the lot, (0, 0, -100)
	REQUIRE(model.materials.size() == 2);
	CHECK(model.materials[model.prototypes[0].materials[0]].name == "walls");
	CHECK(model.materials[model.prototypes[0].materials[1]].name == "lid");
}

TEST_CASE("written out, an instance has the same faces: bounds, area, normals and materials") {
	// Upright in a scope of 2 x 4 x 3 m: area 2 * (2 * 4 + 4 * 3 + 2 * 3) = 52.
	const DerivationResult model = written_out(derived("Lot --> t(10, 0, 5) s(2, 4, 3) i(\"box.obj\")"));
	CHECK(model.instances.empty());
	CHECK(model.mesh.faces.size() == 6);
	CHECK(area(model.mesh) == doctest::Approx(52.0));
	const auto [low, high] = bounds(model.mesh);
	CHECK(high - low == glm::vec3(2, 4, 3));
	const auto is_lid = [&](const MeshFace &face) { return model.materials[face.material].name == "lid"; };
	REQUIRE(std::ranges::count_if(model.mesh.faces, is_lid) == 1);
	CHECK(std::ranges::find_if(model.mesh.faces, is_lid)->normal == glm::vec3(0, 1, 0));
}

TEST_CASE("a thousand trees of 5,000 triangles cost a mesh of 5,000 triangles and a thousand places") {
	const DerivationResult model = derived("Lot --> split(x) { 0.1 : Tree }* Tree --> s(1, 5, 1) i(\"tree.obj\")");
	CHECK(model.face_count == 5'000'000);
	CHECK(model.mesh.positions.empty());
	CHECK(model.instances.size() == 1000);
	REQUIRE(model.prototypes.size() == 1);
	CHECK(model.prototypes[0].mesh->faces.size() == 5000);
}

TEST_CASE("all lots share a prototype's mesh, whatever thread derives them, and looks are kept apart") {
	std::vector<InitialShape> lots;
	for (uint64_t i = 0; i < 16; ++i) {
		lots.push_back(InitialShape::rectangle(10.0, 10.0, i));
	}
	const std::string rule = "Lot --> split(x) { 2 : color(50% : 1 else : 0, 0, 0) i(\"box.obj\") }*";
	const auto one = derived(rule, lots), two = derived(rule, lots, 2);
	for (size_t i = 0; i < lots.size(); ++i) {
		REQUIRE(two[i].instances.size() == 5);
		REQUIRE(one[i].prototypes.size() == two[i].prototypes.size());
		for (size_t k = 0; k < one[i].prototypes.size(); ++k) {
			CHECK(one[i].prototypes[k].mesh == one[0].prototypes[0].mesh);
			CHECK(two[i].prototypes[k].mesh == one[0].prototypes[0].mesh);
			CHECK(one[i].prototypes[k].materials == two[i].prototypes[k].materials);
		}
		for (size_t k = 0; k < 5; ++k) {
			CHECK(one[i].instances[k].prototype == two[i].instances[k].prototype);
			CHECK(one[i].instances[k].origin == two[i].instances[k].origin);
		}
		CHECK(one[i].materials == two[i].materials);
	}
	const auto has_two = [](const DerivationResult &model) { return model.prototypes.size() == 2; };
	CHECK(std::ranges::any_of(one, has_two));
}

TEST_CASE("a model that stands with its z upwards shares the mesh of the one that does not") {
	const DerivationResult model = derived("Lot --> s(0, 0, 0) i(\"box.obj\", zUp) X. ");
	REQUIRE(model.instances.size() == 1);
	CHECK(bounds(*model.prototypes[0].mesh).second == glm::vec3(1, 2, 3));
	const auto [low, high] = bounds(written_out(model).mesh);
	CHECK(high - low == glm::vec3(1, 3, 2));
}

TEST_CASE("what differs from its file is written out: mirrored, cut, split into faces, given coordinates; and built-in bodies") {
	for (const char *rest : { "mirror(true, false, false)", "comp(f) { all : X. }",
				 "setupProjection(0, scope.xy, 1, 1) projectUV(0)" }) {
		const DerivationResult model = derived("Lot --> s(2, 2, 6) i(\"box.obj\") " + std::string(rest));
		INFO(rest);
		CHECK(model.instances.empty());
		CHECK(model.mesh.faces.size() >= 6);
		CHECK(model.face_count == model.mesh.faces.size());
	}
	CHECK(derived("Lot --> s(100, 5000, 1) i(\"tree.obj\") split(y) { ~1 : X. | ~1 : X. }").instances.empty());
	CHECK(derived("Lot --> i(\"box.obj\") split(x) { ~1 : X. | ~1 : X. }").instances.size() == 2); // a cut of a box is the box, scaled
	CHECK(derived("Lot --> primitiveCube()").instances.empty());
	CHECK(derived("Lot --> s(2, 2, 0) i(\"box.obj\")").instances.size() == 1); // 0 follows from the model
}

TEST_CASE("instances belong to their object: they move with its frame, and people stand around what it looks like") {
	// 3 m along z, which is the longer side: floor(3 / 0.6) = 5 places.
	const DerivationResult model = derived("Lot --> t(10, 0, 20) s(1, 2, 3) Bench @Object(\"bench\") Bench --> i(\"box.obj\")");
	REQUIRE(model.objects.size() == 1);
	REQUIRE(model.instances.size() == 1);
	CHECK(model.instances[0].object == 0);
	CHECK(model.objects[0].mesh.is_empty());
	CHECK(model.objects[0].places.size() == 5);
	const auto [low, high] = bounds(written_out(model).objects[0].mesh);
	CHECK(low == glm::vec3(-0.5f, 0.0f, -1.5f)); // around the middle of its floor
	CHECK(high == glm::vec3(0.5f, 2.0f, 1.5f));
}
