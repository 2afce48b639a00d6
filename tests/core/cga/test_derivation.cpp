#include "core/cga/derivation.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

#include <glm/geometric.hpp>

#include "core/cga/dialect.h"
#include "core/io/rule_loader.h"
#include "core/sim/dialect.h"

using namespace pcg;
using namespace pcg::cga;

namespace {

std::shared_ptr<const Program> compiled(const std::string &text) {
	MemorySourceProvider provider;
	provider.add("test.cga", text);
	Diagnostics diagnostics;
	auto program = load_program("test.cga", cga_dialect(), provider, diagnostics);
	INFO(to_text(diagnostics));
	REQUIRE(program != nullptr);
	return program;
}

std::shared_ptr<const Program> shipped(const std::string &path) {
	Diagnostics diagnostics;
	auto program = load_program(path, cga_dialect(), diagnostics);
	INFO(to_text(diagnostics));
	REQUIRE(program != nullptr);
	return program;
}

bool is_same(const Mesh &a, const Mesh &b) {
	return a.positions == b.positions && a.loop_ends == b.loop_ends && a.faces.size() == b.faces.size();
}

} // namespace

TEST_CASE("the paper's building comes out as the paper means it") {
	const auto program = shipped("rules/paper/building.cga");
	const DerivationResult model = derive(*program, InitialShape::rectangle(20.0, 12.0));
	CHECK(model.diagnostics.is_empty());

	REQUIRE(model.entrances.size() == 1); // in the middle of the shop's front, at the street
	CHECK(model.entrances[0].type == "shop");
	CHECK(glm::distance(model.entrances[0].position, { 4.0f, 0.0f, 0.0f }) < 1e-4f);
	CHECK(glm::distance(model.entrances[0].facing, { 0.0f, 0.0f, 1.0f }) < 1e-6f);

	REQUIRE(model.zones.size() == 1); // the lot beside the 8 m of the shop
	CHECK(model.zones[0].type == "park");
	CHECK(model.zones[0].polygon.size() == 4);
	CHECK(model.zones[0].height == doctest::Approx(3.0));

	REQUIRE(model.objects.size() == 3); // { ~2 | ~2 }* over 12 m
	for (const ModelObject &bench : model.objects) {
		CHECK(bench.tag == "bench");
		CHECK(bench.mesh.faces.size() == 6);
		CHECK(bench.places.size() == 3);
		CHECK(bench.frame[3].x == doctest::Approx(19.8)); // 0.4 m at the lot's far end
	}

	// The door lies 0.2 m behind the facade, and nothing stands in its opening.
	int doors = 0;
	for (const MeshFace &face : model.mesh.faces) {
		glm::dvec3 middle(0.0);
		for (const glm::vec3 &corner : model.mesh.loop(face.first_loop)) {
			middle += glm::dvec3(corner) / 4.0;
		}
		const bool is_in_opening = std::abs(middle.x - 4.0) < 0.1 && std::abs(middle.y - 1.0) < 0.1 && face.normal.z > 0.9f;
		if (is_in_opening) {
			++doors;
			CHECK(middle.z == doctest::Approx(-0.2));
			CHECK(model.materials[face.material].color.r == doctest::Approx(0.2f));
		}
	}
	CHECK(doors == 1);
}

TEST_CASE("equal seeds give equal models, other seeds others, in any thread and any order") {
	const auto program = shipped("rules/cga/house.cga");
	const DerivationResult first = derive(*program, InitialShape::rectangle(20.0, 20.0, 5));
	Deriver deriver(*program);
	const DerivationResult other = deriver.derive(InitialShape::rectangle(20.0, 20.0, 6));
	const DerivationResult again = deriver.derive(InitialShape::rectangle(20.0, 20.0, 5));
	CHECK(is_same(first.mesh, again.mesh));
	CHECK_FALSE(is_same(first.mesh, other.mesh));
	DerivationResult threaded;
	std::thread([&] { threaded = derive(*program, InitialShape::rectangle(20.0, 20.0, 5)); }).join();
	CHECK(is_same(first.mesh, threaded.mesh));
}

TEST_CASE("a lot far from the origin has the same model, moved") {
	const auto program = compiled("Lot --> extrude(3) comp(f) { front : split(x) { { ~1 : A. }* } | all : B. }");
	const DerivationResult here = derive(*program, InitialShape::rectangle(10.0, 10.0));
	InitialShape far_lot = InitialShape::rectangle(10.0, 10.0);
	for (glm::dvec3 &point : far_lot.faces[0].outline) {
		point += glm::dvec3(4096.0, 0.0, -8192.0);
	}
	const DerivationResult there = derive(*program, far_lot);
	REQUIRE(here.mesh.positions.size() == there.mesh.positions.size());
	for (size_t i = 0; i < here.mesh.positions.size(); ++i) {
		CHECK(glm::distance(here.mesh.positions[i] + glm::vec3(4096.0f, 0.0f, -8192.0f), there.mesh.positions[i]) < 2e-3f);
	}
}

TEST_CASE("useless initial shapes give one error and an empty model") {
	const auto program = compiled("Lot --> extrude(3)");
	const double nan = std::numeric_limits<double>::quiet_NaN();
	const std::vector<std::vector<glm::dvec3>> outlines = { {}, { { 0, 0, 0 } }, { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } },
		{ { nan, 0, 0 }, { 1, nan, 0 }, { 2, 0, nan } }, { { 0, 0, 0 }, { 1e300, 0, 0 }, { 0, 0, -1e300 } }, { { 1, 1, 1 }, { 1, 1, 1 }, { 1, 1, 1 } } };
	for (const auto &outline : outlines) {
		const DerivationResult model = derive(*program, InitialShape::of(outline));
		CHECK(model.diagnostics.error_count() == 1);
		CHECK(model.mesh.is_empty());
	}
	CHECK(derive(*program, InitialShape()).diagnostics.has_errors());
}

TEST_CASE("operations survive empty, flat, endless and meaningless sizes") {
	for (const char *text : { "Lot --> s(0, 0, 0) extrude(3) split(x) { 1 : A. }", "Lot --> s(-5, -5, -5) extrude(2) comp(f) { all : A. }",
				 "Lot --> extrude(1e308) split(y) { 1e-300 : A. }*", "Lot --> extrude(-1e-12) comp(f) { front : A. }",
				 "Lot --> extrude(sqrt(-1)) A.", "Lot --> t(1/0, 0, 0) r(1e30, 0, 0) A.", "Lot --> s(1e200, 1e200, 1e200) extrude(1e200) A.",
				 "Lot --> roofGable(0) A.", "Lot --> roofHip(90) A.", "Lot --> roofPyramid(byHeight, -3) taper(0) A.",
				 "Lot --> extrude(3) extrude(2) extrude(-1) split(x) { ~1 : A. }*", "Lot --> comp(v) { all : extrude(2) comp(f) { all : A. } }",
				 "Lot --> comp(e) { all : split(x) { ~1 : roofGable(45) } }", "Lot --> primitiveSphere(-5, 1e9) A.", "Lot --> color(\"nonsense\") A.",
				 "Lot --> split(x) { -3 : A. | ~-1 : B. | '-2 : C. }", "Lot --> set(scope.sx, 0) split(x) { ~1 : A. }" }) {
		const auto program = compiled(text);
		DeriveOptions options;
		options.limits.max_shapes = 10'000;
		options.limits.max_repeats = 1'000;
		INFO(text);
		const DerivationResult model = derive(*program, InitialShape::rectangle(10.0, 10.0), options);
		CHECK(model.face_count <= 100'000);
		for (const glm::vec3 &point : model.mesh.positions) {
			CHECK_FALSE(std::isnan(point.x + point.y + point.z));
		}
		make_surfaces(model.mesh);
	}
}

TEST_CASE("rules that never end are stopped with one error, and what they made until then stays") {
	DeriveOptions options;
	options.limits.max_depth = 1024;
	options.limits.max_shapes = 50'000;
	const auto deep = compiled("Lot --> [ t(0, 1, 0) s(1, 1, 1) primitiveCube() Cube. ] t(0, 1, 0) Lot");
	const DerivationResult tower = derive(*deep, InitialShape::rectangle(10.0, 10.0), options);
	CHECK(tower.diagnostics.error_count() == 1);
	CHECK(tower.mesh.faces.size() > 6000);
	const auto wide = compiled("Lot --> Lot Lot Lot");
	CHECK(derive(*wide, InitialShape::rectangle(10.0, 10.0), options).diagnostics.error_count() == 1);
}

TEST_CASE("rules of the other language are told, not derived") {
	MemorySourceProvider provider;
	provider.add("day.pcg", "@StartRule\nHousehold --> members { true: stayInside(0, 1h, home) }");
	Diagnostics diagnostics;
	const auto program = load_program("day.pcg", pcg_dialect(), provider, diagnostics);
	REQUIRE(program != nullptr);
	const DerivationResult model = derive(*program, InitialShape::rectangle(10.0, 10.0));
	REQUIRE(model.diagnostics.error_count() == 1);
	CHECK(model.diagnostics.list()[0].id == "wrong-dialect");
	CHECK(model.mesh.is_empty());
}

TEST_CASE("a function that calls itself twice ends in time") {
	MemorySourceProvider provider;
	provider.add("a.cga", "f(n) = case n == 0 : 1 else : f(n - 1) + f(n - 1)\nLot --> extrude(f(60))");
	Diagnostics diagnostics;
	const auto program = load_program("a.cga", cga_dialect(), provider, diagnostics);
	REQUIRE(program != nullptr);
	const DerivationResult model = derive(*program, InitialShape::rectangle(10.0, 10.0));
	REQUIRE(model.diagnostics.error_count() == 1);
	CHECK(model.diagnostics.list()[0].id == "step-limit");
}
