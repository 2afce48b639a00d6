#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include <glm/geometric.hpp>

#include "core/cga/derivation.h"
#include "core/cga/dialect.h"
#include "core/city/free_ground.h"
#include "core/io/file_assets.h"
#include "core/io/rule_loader.h"
#include "core/semantics/city_query.h"

// What is promised of every file in rules/cga: short, without a message on any lot, within its budget of faces, with doors that can be reached.

using namespace pcg;
using namespace pcg::cga;

namespace {

struct ShippedRules {
	const char *name;
	double width, depth; // of a usual lot, metres
	uint64_t budgets[3]; // faces at level of detail 0, 1 and 2, objects included
	std::vector<std::string> entrances; // types that there must be
	std::string zone;
};

std::vector<ShippedRules> all_shipped() {
	return {
		{ "house", 20, 20, { 250, 650, 2300 }, { "house" }, "" },
		{ "row_house", 24, 24, { 400, 1200, 6500 }, { "house" }, "" },
		{ "apartment", 20, 20, { 300, 1800, 7000 }, { "house", "shop" }, "" },
		{ "office_tower", 30, 30, { 700, 2800, 15000 }, { "workplace" }, "" },
		{ "workplace", 20, 20, { 600, 1300, 3500 }, { "workplace" }, "" },
		{ "workshop", 30, 30, { 900, 3000, 8500 }, { "workplace" }, "" },
		{ "supermarket", 50, 56, { 700, 2000, 4500 }, { "shop" }, "" },
		{ "restaurant", 20, 24, { 1000, 1800, 7500 }, { "restaurant" }, "terrace" },
		{ "school", 40, 40, { 600, 2200, 7500 }, { "school" }, "playground" },
		{ "shop", 20, 20, { 250, 500, 3500 }, { "shop" }, "" },
		{ "town_hall", 36, 40, { 1000, 2500, 9000 }, { "town_hall", "workplace" }, "" },
		{ "park", 30, 30, { 900, 1800, 7500 }, {}, "park" },
		{ "plaza", 32, 32, { 1200, 2600, 5500 }, {}, "plaza" },
		{ "bus_stop", 14, 8, { 250, 350, 700 }, {}, "bus_stop" },
		{ "street", 40, 16, { 60, 1200, 3500 }, {}, "" },
	};
}

std::string path_of(const std::string &name) {
	return "rules/cga/" + name + ".cga";
}

std::shared_ptr<const Program> load(const std::string &name) {
	Diagnostics diagnostics;
	auto program = load_program(path_of(name), cga_dialect(), diagnostics);
	INFO(to_text(diagnostics));
	REQUIRE(program != nullptr);
	CHECK(diagnostics.is_empty());
	return program;
}

DerivationResult derive_at(const Program &program, InitialShape shape, int lod) {
	static const FileAssets assets; // pictures
	DeriveOptions options;
	options.assets = &assets;
	shape.attributes.push_back({ "lod", double(lod) });
	return derive(program, shape, options);
}

bool has_entrance(const DerivationResult &model, const std::string &type) {
	return std::ranges::any_of(model.entrances, [&](const ModelEntrance &e) { return e.type == type; });
}

using FreeGround = std::vector<std::vector<glm::vec3>>;

FreeGround ground_of(const DerivationResult &model, double width, double depth) {
	Lot lot;
	const InitialShape shape = InitialShape::rectangle(width, depth);
	for (const glm::dvec3 &corner : shape.faces[0].outline) {
		lot.polygon.push_back(glm::vec3(corner));
	}
	lot.street_widths = { 8, 0, 0, 0 };
	return free_ground(lot, model);
}

bool is_on(const FreeGround &ground, glm::vec3 point) {
	return std::ranges::any_of(ground, [&](const std::vector<glm::vec3> &piece) {
		return contains(Zone{ TypeId::Invalid, piece, 0.0f, LotId(0), false }, point);
	});
}

// Whether ground that is connected with the street lies before the door, within the three metres of a porch.
bool is_reachable(const FreeGround &ground, const ModelEntrance &door) {
	for (float metres = 0.25f; metres <= 3.0f; metres += 0.25f) {
		if (is_on(ground, door.position + door.facing * metres)) {
			return true;
		}
	}
	return false;
}

void check_doors(const DerivationResult &model, const ShippedRules &rules) {
	for (const std::string &type : rules.entrances) {
		CHECK_MESSAGE(has_entrance(model, type), type);
	}
	const FreeGround ground = ground_of(model, rules.width, rules.depth);
	for (const ModelEntrance &door : model.entrances) {
		INFO(door.type << " at " << door.position.x << " " << door.position.z);
		CHECK(std::abs(door.position.y) < 1e-3f);
		CHECK(door.facing.z == doctest::Approx(1.0f)); // to the street, out of a building that lies behind it
		CHECK(door.capacity > 0);
		CHECK(is_reachable(ground, door));
	}
}

// By something higher than half a metre; x and z of a point.
bool is_built_over(const Mesh &mesh, glm::vec2 point) {
	return std::ranges::any_of(mesh.faces, [&](const MeshFace &face) {
		bool is_inside = false;
		float top = 0.0f;
		for (uint32_t i = 0; i < face.loop_count; ++i) {
			const auto loop = mesh.loop(face.first_loop + i);
			for (size_t k = 0; k < loop.size(); ++k) {
				const glm::vec3 a = loop[k], b = loop[(k + 1) % loop.size()];
				top = std::max(top, a.y);
				const bool is_between = (a.z > point.y) != (b.z > point.y);
				is_inside ^= is_between && point.x < a.x + (b.x - a.x) * (point.y - a.z) / (b.z - a.z);
			}
		}
		return is_inside && top > 0.5f;
	});
}

bool is_finite(const Mesh &mesh) {
	return std::ranges::all_of(mesh.positions, [](const glm::vec3 &p) { return std::isfinite(p.x + p.y + p.z); });
}

std::vector<std::vector<glm::dvec3>> odd_lots() {
	return {
		{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, -1 }, { 0, 0, -1 } }, // a square metre
		{ { 0, 0, 0 }, { 4, 0, 0 }, { 4, 0, -4 }, { 0, 0, -4 } },
		{ { 0, 0, 0 }, { 40, 0, 0 }, { 40, 0, -0.5 }, { 0, 0, -0.5 } }, // slivers
		{ { 0, 0, 0 }, { 0.5, 0, 0 }, { 0.5, 0, -40 }, { 0, 0, -40 } },
		{ { 0, 0, 0 }, { 30, 0, 0 }, { 12, 0, -25 } }, // a triangle
		{ { 0, 0, 0 }, { 25, 0, 4 }, { 22, 0, -20 }, { -6, 0, -24 } },
		{ { 0, 0, 0 }, { 30, 0, 0 }, { 30, 0, -12 }, { 12, 0, -12 }, { 12, 0, -30 }, { 0, 0, -30 } }, // an L
		{ { 0, 0, 0 }, { 30, 0, 0 }, { 30, 0, -25 }, { 15, 0, -8 }, { 0, 0, -25 } }, // a notch from behind
		{ { 10, 0, 0 }, { 20, 0, 0 }, { 30, 0, -10 }, { 30, 0, -20 }, { 20, 0, -30 }, { 10, 0, -30 }, { 0, 0, -20 }, { 0, 0, -10 } },
	};
}

} // namespace

TEST_CASE("shipped rules: files are short and there are no others") {
	std::vector<std::string> names = { "parts", "grounds", "furniture" };
	for (const ShippedRules &rules : all_shipped()) {
		names.push_back(rules.name);
	}
	for (const std::string &name : names) {
		std::ifstream file(path_of(name));
		REQUIRE(file.good());
		std::string line;
		std::getline(file, line);
		CHECK_MESSAGE(line.starts_with("// "), name);
		int lines = 1;
		while (std::getline(file, line)) {
			++lines;
		}
		CHECK_MESSAGE(lines < 120, name);
		load(name);
	}
}

TEST_CASE("shipped rules: each level of detail keeps its budget, and has the doors and zones") {
	for (const ShippedRules &rules : all_shipped()) {
		const auto program = load(rules.name);
		for (uint64_t seed = 0; seed < 8; ++seed) {
			uint64_t before = 0;
			for (int lod = 0; lod < 3; ++lod) {
				const DerivationResult model = derive_at(*program, InitialShape::rectangle(rules.width, rules.depth, seed), lod);
				INFO(rules.name << " seed " << seed << " lod " << lod << "\n" << to_text(model.diagnostics));
				CHECK(model.diagnostics.is_empty());
				CHECK(model.face_count <= rules.budgets[lod]);
				CHECK(model.face_count > before);
				before = model.face_count;
				check_doors(model, rules);
				const auto is_zone = [&](const ModelZone &zone) { return zone.type == rules.zone; };
				CHECK((rules.zone.empty() || std::ranges::any_of(model.zones, is_zone)));
			}
		}
	}
}

TEST_CASE("shipped rules: nobody walks in a fountain, and all who look at it stand on free ground") {
	size_t fountains = 0;
	for (const ShippedRules &rules : all_shipped()) {
		const auto program = load(rules.name);
		for (int lod = 0; lod < 3; ++lod) {
			const DerivationResult model = derive_at(*program, InitialShape::rectangle(rules.width, rules.depth), lod);
			const FreeGround ground = ground_of(model, rules.width, rules.depth);
			for (const ModelObject &object : model.objects) {
				if (object.tag != "fountain") {
					continue;
				}
				INFO(rules.name << " lod " << lod);
				++fountains;
				const auto floor = [](glm::vec3 point) { return glm::vec3(point.x, 0.0f, point.z); };
				CHECK_FALSE(is_on(ground, floor(glm::vec3(object.frame[3]))));
				CHECK(object.places.size() == 8);
				for (const ModelPlace &place : object.places) {
					CHECK(is_on(ground, floor(place.position)));
				}
			}
		}
	}
	CHECK(fountains >= 6); // of the park and the plaza
}

TEST_CASE("shipped rules: the place of an object is in the middle of what it looks like, where its gizmo stands") {
	size_t objects = 0;
	for (const ShippedRules &rules : all_shipped()) {
		const auto program = load(rules.name);
		for (uint64_t seed = 0; seed < 8; ++seed) {
			const DerivationResult model = derive_at(*program, InitialShape::rectangle(rules.width, rules.depth, seed), 2);
			for (const ModelObject &object : model.objects) {
				glm::vec3 low(INFINITY), high(-INFINITY);
				for (const glm::vec3 &point : object.mesh.positions) {
					low = glm::min(low, point);
					high = glm::max(high, point);
				}
				const glm::vec3 middle = (low + high) / 2.0f;
				INFO(rules.name << " seed " << seed << " " << object.tag << " " << middle.x << " " << middle.z);
				CHECK(std::hypot(middle.x, middle.z) < 0.5f);
				++objects;
			}
		}
	}
	CHECK(objects > 100);
}

TEST_CASE("shipped rules: lots of other sizes keep their doors") {
	for (ShippedRules rules : all_shipped()) {
		const auto program = load(rules.name);
		for (const auto &[width, depth] : { std::pair(14.0, 25.0), { 12.0, 12.0 }, { 40.0, 30.0 }, { 30.0, 14.0 } }) {
			rules.width = width;
			rules.depth = depth;
			for (uint64_t seed = 0; seed < 4; ++seed) {
				const DerivationResult model = derive_at(*program, InitialShape::rectangle(width, depth, seed), 1);
				INFO(rules.name << " " << width << " x " << depth << " seed " << seed << "\n" << to_text(model.diagnostics));
				CHECK(model.diagnostics.is_empty());
				check_doors(model, rules);
			}
		}
	}
}

TEST_CASE("shipped rules: tiny, narrow, slanted and concave lots give a model without a message") {
	for (const ShippedRules &rules : all_shipped()) {
		const auto program = load(rules.name);
		for (const auto &outline : odd_lots()) {
			for (int lod = 0; lod < 3; ++lod) {
				const DerivationResult model = derive_at(*program, InitialShape::of(outline, 7), lod);
				INFO(rules.name << " corners " << outline.size() << " lod " << lod << "\n" << to_text(model.diagnostics));
				CHECK(model.diagnostics.is_empty());
				CHECK(model.face_count > 0);
				CHECK(model.face_count < 60'000);
				CHECK(is_finite(model.mesh));
			}
		}
	}
}

TEST_CASE("shipped rules: a lot that is turned and moved has the same model, turned and moved") {
	const double cosine = std::cos(0.7), sine = std::sin(0.7);
	const auto moved = [&](glm::dvec3 p) { return glm::dvec3(cosine * p.x + sine * p.z + 300.0, p.y, cosine * p.z - sine * p.x - 200.0); };
	for (const ShippedRules &rules : all_shipped()) {
		const auto program = load(rules.name);
		const InitialShape here = InitialShape::rectangle(rules.width, rules.depth, 3);
		InitialShape there = here;
		for (glm::dvec3 &corner : there.faces[0].outline) {
			corner = moved(corner);
		}
		const DerivationResult a = derive_at(*program, here, 2), b = derive_at(*program, there, 2);
		INFO(rules.name);
		REQUIRE(a.mesh.positions.size() == b.mesh.positions.size());
		double worst = 0.0;
		for (size_t i = 0; i < a.mesh.positions.size(); ++i) {
			worst = std::max(worst, glm::distance(moved(a.mesh.positions[i]), glm::dvec3(b.mesh.positions[i])));
		}
		CHECK(worst < 5e-3);
		REQUIRE(a.objects.size() == b.objects.size());
		for (size_t i = 0; i < a.objects.size(); ++i) {
			CHECK(glm::distance(moved(a.objects[i].frame[3]), glm::dvec3(b.objects[i].frame[3])) < 5e-3);
			CHECK(a.objects[i].mesh.faces.size() == b.objects[i].mesh.faces.size());
		}
	}
}

TEST_CASE("shipped rules: rings have their doors and no message, and houses leave the courtyard open") {
	const std::vector<std::string> built_around = { "house", "apartment", "workshop", "shop" };
	for (const ShippedRules &rules : all_shipped()) {
		const auto program = load(rules.name);
		InitialShape ring = InitialShape::rectangle(40, 40, 5);
		ring.faces[0].holes = { { { 12, 0, -12 }, { 28, 0, -12 }, { 28, 0, -28 }, { 12, 0, -28 } } };
		ring.street_widths = { 8, 0, 0, 0 };
		for (int lod = 0; lod < 3; ++lod) {
			const DerivationResult model = derive_at(*program, ring, lod);
			INFO(rules.name << " lod " << lod << "\n" << to_text(model.diagnostics));
			CHECK(model.diagnostics.is_empty());
			CHECK(is_finite(model.mesh));
			CHECK(model.face_count > 0);
			for (const std::string &type : rules.entrances) {
				CHECK_MESSAGE(has_entrance(model, type), type);
			}
			const FreeGround ground = ground_of(model, 40, 40);
			CHECK((model.entrances.empty() || is_reachable(ground, model.entrances[0]))); // others may look into the courtyard
			for (int i = 0; i < 49 && std::ranges::count(built_around, rules.name) > 0; ++i) {
				CHECK_FALSE(is_built_over(model.mesh, { 13.1f + 2.3f * float(i % 7), -13.1f - 2.3f * float(i / 7) }));
			}
		}
	}
}
