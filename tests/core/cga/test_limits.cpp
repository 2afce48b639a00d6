#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "core/cga/derivation.h"
#include "core/cga/dialect.h"
#include "core/io/rule_loader.h"

using namespace pcg;
using namespace pcg::cga;

namespace {

DerivationResult run(const std::string &text, const InitialShape &shape = InitialShape::rectangle(10.0, 10.0), const DeriveOptions &options = {}) {
	MemorySourceProvider provider;
	provider.add("test.cga", text);
	Diagnostics diagnostics;
	const auto program = load_program("test.cga", cga_dialect(), provider, diagnostics);
	REQUIRE_MESSAGE(program != nullptr, to_text(diagnostics));
	return derive(*program, shape, options);
}

bool tells(const DerivationResult &model, std::string_view id) {
	return std::ranges::any_of(model.diagnostics.list(), [&](const Diagnostic &diagnostic) { return diagnostic.id == id; });
}

bool is_finite(const Mesh &mesh) {
	return std::ranges::all_of(mesh.positions, [](const glm::vec3 &p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); });
}

DeriveOptions limited(uint32_t DeriveLimits::*limit, uint32_t value) {
	DeriveOptions options;
	options.limits.*limit = value;
	return options;
}

// Doubles its shapes at each level.
constexpr const char *explosion = "Lot --> A(0)\nA(n) --> A(n + 1) A(n + 1)";

} // namespace

TEST_CASE("each limit ends the derivation with an error, and what was made is handed out") {
	const DerivationResult shapes = run("Lot --> split(x) { 0.1 : X. }*", InitialShape::rectangle(10.0, 10.0), limited(&DeriveLimits::max_shapes, 50));
	CHECK(tells(shapes, "too-many-shapes"));
	CHECK(shapes.shape_count == 50);
	CHECK(shapes.face_count > 20);
	CHECK(tells(run("Lot --> t(1, 0, 0) Lot", InitialShape::rectangle(10.0, 10.0), limited(&DeriveLimits::max_depth, 20)), "too-deep"));
	CHECK(tells(run("Lot --> split(x) { 0.1 : X. }*", InitialShape::rectangle(10.0, 10.0), limited(&DeriveLimits::max_repeats, 10)), "too-many-parts"));
	DeriveOptions faces;
	faces.limits.max_faces = 10;
	const DerivationResult few = run("Lot --> split(x) { 0.1 : A }*\nA --> primitiveSphere() X.", InitialShape::rectangle(10.0, 10.0), faces);
	CHECK(tells(few, "too-many-shapes"));
	CHECK(few.face_count < 1000);
	DeriveOptions steps;
	steps.limits.max_steps = 1000;
	CHECK(tells(run(explosion, InitialShape::rectangle(10.0, 10.0), steps), "step-limit"));
}

TEST_CASE("a derivation ends when its time is over") {
	DeriveOptions options;
	options.limits = { UINT32_MAX, UINT32_MAX, 100'000, UINT64_MAX, UINT64_MAX, 0.05 };
	const auto start = std::chrono::steady_clock::now();
	// The second makes no shapes: only calls of functions.
	CHECK(tells(run("Lot --> split(x) { 0.001 : A }*\nA --> split(z) { 0.001 : A }*", InitialShape::rectangle(90.0, 90.0), options), "time-limit"));
	CHECK(tells(run("f(n) = case n < 1 : 1 else : f(n - 1) + f(n - 1)\nLot --> print(f(60))", InitialShape::rectangle(10.0, 10.0), options), "time-limit"));
	CHECK(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < 10.0);
}

TEST_CASE("more materials within inline than faces can name are told") {
	const DerivationResult model = run("Lot --> inline { split(x) { 0.001 : color(rand(1), rand(1), rand(1)) X. }* }", InitialShape::rectangle(66.0, 1.0));
	CHECK(tells(model, "too-many-materials"));
	CHECK(model.face_count == 66000);
	CHECK(model.diagnostics.list().size() == 1);
}

TEST_CASE("a derivation ends when it is cancelled, before and while it runs") {
	std::atomic<bool> cancel{ true };
	DeriveOptions options;
	options.limits.max_steps = UINT64_MAX;
	options.limits.max_shapes = UINT32_MAX;
	options.cancel = &cancel;
	CHECK(tells(run("Lot --> split(x) { 0.01 : X. }*", InitialShape::rectangle(10.0, 10.0), options), "cancelled"));
	cancel = false;
	std::thread canceller([&] {
		std::this_thread::sleep_for(std::chrono::milliseconds(30));
		cancel = true;
	});
	// Eight thousand million parts: minutes, if nobody stops it.
	const DerivationResult model = run("Lot --> split(x) { 0.001 : A }*\nA --> split(z) { 0.001 : NIL }*", InitialShape::rectangle(90.0, 90.0), options);
	canceller.join();
	CHECK(tells(model, "cancelled"));
	CHECK(model.shape_count > 0);
}

TEST_CASE("a million repeats of a millimetre are cut short") {
	const DerivationResult model = run("Lot --> split(x) { 0.001 : X. }*", InitialShape::rectangle(1000.0, 10.0));
	CHECK(tells(model, "too-many-parts"));
	CHECK(model.face_count <= 100'000);
	CHECK(model.face_count > 0);
	CHECK(tells(run("Lot --> split(x) { ~0.000001 : X. }*", InitialShape::rectangle(1000.0, 10.0)), "too-many-parts"));
}

TEST_CASE("lots without a usable outline give a diagnostic and no faces that are not numbers") {
	constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
	const char *rules = "Lot --> extrude(5) comp(f) { side : split(x) { ~1 : X. }* | top : roofHip(30) }";
	const std::vector<std::vector<glm::dvec3>> outlines = {
		{},
		{ { 0, 0, 0 } },
		{ { 0, 0, 0 }, { 1, 0, 0 } },
		{ { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } },
		{ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } },
		{ { 0, 0, 0 }, { nan, 0, 0 }, { 1, 0, -1 } },
		{ { 0, 0, 0 }, { inf, 0, 0 }, { 1, 0, -1 } },
	};
	for (const std::vector<glm::dvec3> &outline : outlines) {
		const DerivationResult model = run(rules, InitialShape::of(outline));
		CHECK_FALSE(model.diagnostics.is_empty());
		CHECK(is_finite(model.mesh));
	}
	CHECK(is_finite(run(rules, InitialShape::of({ { 0, 0, 0 }, { 10, 0, -10 }, { 10, 0, 0 }, { 0, 0, -10 } })).mesh)); // a bow tie
	CHECK(is_finite(run(rules, InitialShape::of({ { 0, 0, 0 }, { 1e-9, 0, 0 }, { 1e-9, 0, -1e-9 }, { 0, 0, -1e-9 } })).mesh));
	CHECK(is_finite(run(rules, InitialShape::rectangle(1e8, 1e-3)).mesh));
}

TEST_CASE("sizes that are zero, negative or no numbers break nothing") {
	for (const char *rules : {
				 "Lot --> s(0, 0, 0) extrude(5) comp(f) { all : split(x) { ~1 : X. }* }",
				 "Lot --> extrude(0) comp(f) { all : X. }",
				 "Lot --> extrude(5) s(-3, '-1, 0 / 0) comp(f) { front : X. | all : split(y) { ~1 : Y. }* }",
				 "Lot --> extrude(1 / 0) s(sqrt(-1), 1, 1) X.",
				 "Lot --> split(x) { -1 : X. | 0 : Y. | ~-1 : Z. | '-0.5 : W. }",
				 "Lot --> split(x) { ~0 : X. }* split(z) { 0 : Y. }*",
				 "Lot --> extrude(3) s('1, 0, '1) roofHip(30) roofGable(0 / 0) primitiveSphere(0, -1, -5) trim() X.",
				 "Lot --> extrude(3) comp(f) { all : s('1, '0, '1) primitiveCube() case inside() : X. else : case touches(all, \"\") : Y. else : Z. }",
				 "Lot --> extrude(3) comp(f) { all : s(0 / 0, '1, -1) t(1 / 0, 0, 0) r(0 / 0, 0, 0) i(\"builtin:cube\") Ask }\nAsk --> case overlaps() : X. else : label(\"a\") Y.",
		 }) {
		const DerivationResult model = run(rules);
		INFO(rules);
		CHECK(is_finite(model.mesh));
		CHECK(model.face_count < 10'000);
	}
}
