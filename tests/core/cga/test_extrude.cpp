#include "core/cga/extrude.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/base/random.h"
#include "core/cga/derivation.h"
#include "core/cga/dialect.h"
#include "core/io/rule_loader.h"

using namespace pcg;
using namespace pcg::cga;

namespace {

DerivationResult derived(const std::string &text, const InitialShape &shape) {
	MemorySourceProvider provider;
	provider.add("test.cga", text);
	Diagnostics diagnostics;
	const auto program = load_program("test.cga", cga_dialect(), provider, diagnostics);
	INFO(to_text(diagnostics));
	REQUIRE(program != nullptr);
	return derive(*program, shape);
}

double reported(const DerivationResult &model, const std::string &key) {
	for (const ModelReport &report : model.reports) {
		if (report.key == key) {
			return report.sum;
		}
	}
	return NAN;
}

// A star around the origin: simple, mostly concave.
InitialShape star(Random &random, size_t corners) {
	std::vector<glm::dvec3> outline;
	for (size_t i = 0; i < corners; ++i) {
		const double angle = 6.283185307179586 * double(i) / double(corners), radius = 4.0 + 6.0 * random.uniform();
		outline.push_back({ radius * std::cos(angle), 0.0, -radius * std::sin(angle) });
	}
	return InitialShape::of(outline);
}

// A wing of 10 x 4 and one of 6 x 4 beside it, sheared a little so that nothing is at right angles.
InitialShape wings(Random &random) {
	const double shear = 0.3 * random.uniform() - 0.15;
	const auto at = [&](double x, double depth) { return glm::dvec3(x + shear * depth, 0.0, -depth); };
	return InitialShape::of({ at(0, 0), at(10, 0), at(10, 4), at(4 + random.uniform(), 4), at(4, 10), at(0, 10) });
}

} // namespace

TEST_CASE("the volume of an extrusion is its area times its height, and it is closed") {
	Random random(11);
	for (int i = 0; i < 40; ++i) {
		const double height = 0.5 + 8.0 * random.uniform();
		const DerivationResult model =
				derived("attr h = 1\nLot --> report(\"area\", geometry.area) [ extrude(-h) report(\"down\", geometry.volume) NIL ] extrude(h) report(\"volume\", geometry.volume)",
						[&] {
							InitialShape shape = star(random, size_t(3 + i % 12));
							shape.attributes.push_back({ "h", height });
							return shape;
						}());
		CHECK(reported(model, "volume") == doctest::Approx(reported(model, "area") * height));
		CHECK(reported(model, "down") == doctest::Approx(reported(model, "area") * height));
	}
}

TEST_CASE("neighbours in one plane are raised without a wall between them") {
	InitialShape shape = InitialShape::rectangle(10.0, 10.0);
	shape.faces.push_back({ { { 10, 0, 0 }, { 16, 0, 0 }, { 16, 0, -10 }, { 10, 0, -10 } }, {} });
	const DerivationResult model = derived("Lot --> extrude(3) report(\"volume\", geometry.volume) report(\"open\", geometry.boundaryLength)", shape);
	CHECK(model.mesh.faces.size() == 10); // two bottoms, two tops, six walls
	CHECK(reported(model, "volume") == doctest::Approx(480.0));
	CHECK(reported(model, "open") == 0.0);
}

TEST_CASE("along vertex normals bent faces stay together; each alone they part") {
	InitialShape shape = InitialShape::rectangle(10.0, 10.0);
	shape.faces.push_back({ { { 10, 0, 0 }, { 16, 6, 0 }, { 16, 6, -10 }, { 10, 0, -10 } }, {} });
	CHECK(derived("Lot --> extrude(vertex.normal, 1)", shape).mesh.faces.size() == 10);
	CHECK(derived("Lot --> extrude(1)", shape).mesh.faces.size() == 12);
	CHECK(derived("Lot --> extrude(world.up, 1)", shape).mesh.faces.size() == 10);
}

TEST_CASE("roofs without overhangs are closed over slanted and concave outlines") {
	Random random(5);
	for (int i = 0; i < 25; ++i) {
		const InitialShape shape = i % 2 == 0 ? wings(random) : star(random, size_t(4 + i % 5));
		for (const char *roof : { "roofHip(35)", "roofShed(20)", "roofRidge(byAngle, 30)", "roofPyramid(byHeight, 3)", "taper(4)" }) {
			const DerivationResult model = derived(std::string("Lot --> ") + roof + " report(\"open\", geometry.boundaryLength) report(\"faces\", geometry.nFaces)", shape);
			INFO(roof << " " << i << "\n" << to_text(model.diagnostics));
			CHECK(reported(model, "open") == doctest::Approx(0.0));
			CHECK(reported(model, "faces") > 3.0);
		}
	}
}
