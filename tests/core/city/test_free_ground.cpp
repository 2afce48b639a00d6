#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/city/cell_grid.h"
#include "core/city/free_ground.h"

using namespace pcg;

namespace {

// 20 x 20 m, front on the x axis, street in front only.
Lot square_lot() {
	Lot lot;
	lot.polygon = { { 0, 0, 0 }, { 20, 0, 0 }, { 20, 0, -20 }, { 0, 0, -20 } };
	lot.street_widths = { 8, 0, 0, 0 };
	return lot;
}

void add_face(Mesh &mesh, std::vector<glm::vec3> corners) {
	MeshFace face;
	face.first_loop = uint32_t(mesh.loop_ends.size());
	mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
	mesh.loop_ends.push_back(uint32_t(mesh.positions.size()));
	mesh.faces.push_back(face);
}

// Four walls from y0 to y1; z counts into the lot.
void add_walls(Mesh &mesh, float x0, float x1, float z0, float z1, float y0, float y1) {
	const std::vector<glm::vec3> plan = { { x0, 0, -z0 }, { x1, 0, -z0 }, { x1, 0, -z1 }, { x0, 0, -z1 } };
	for (size_t i = 0; i < 4; ++i) {
		const glm::vec3 a = plan[i], b = plan[(i + 1) % 4];
		add_face(mesh, { { a.x, y0, a.z }, { b.x, y0, b.z }, { b.x, y1, b.z }, { a.x, y1, a.z } });
	}
}

cga::DerivationResult model_of(Mesh mesh) {
	cga::DerivationResult model;
	model.mesh = std::move(mesh);
	return model;
}

double total_area(const std::vector<std::vector<glm::vec3>> &pieces) {
	double sum = 0.0;
	for (const std::vector<glm::vec3> &piece : pieces) {
		for (size_t i = 0; i < piece.size(); ++i) {
			const glm::vec3 a = piece[i], b = piece[(i + 1) % piece.size()];
			sum += (double(b.x) * a.z - double(a.x) * b.z) / 2.0; // counter-clockwise is positive
		}
	}
	return sum;
}

bool covers(const std::vector<std::vector<glm::vec3>> &pieces, float x, float depth) {
	return std::any_of(pieces.begin(), pieces.end(), [&](const std::vector<glm::vec3> &piece) {
		bool is_inside = true;
		for (size_t i = 0; i < piece.size(); ++i) {
			const glm::vec3 a = piece[i], b = piece[(i + 1) % piece.size()];
			is_inside = is_inside && (b.x - a.x) * (-depth - a.z) - (b.z - a.z) * (x - a.x) <= 0.0f;
		}
		return is_inside;
	});
}

} // namespace

TEST_CASE("an empty lot is free as a whole") {
	const auto pieces = free_ground(square_lot(), cga::DerivationResult());
	REQUIRE(pieces.size() == 1);
	CHECK(total_area(pieces) == doctest::Approx(400.0));
}

TEST_CASE("neither the walls nor the inside of a building can be walked on") {
	Mesh mesh;
	add_walls(mesh, 5, 15, 4, 12, 0, 6);
	const auto pieces = free_ground(square_lot(), model_of(mesh));
	CHECK_FALSE(covers(pieces, 10, 8));
	CHECK(covers(pieces, 10, 2));
	CHECK(covers(pieces, 2, 18));
	CHECK(covers(pieces, 18, 8));
	// A building of 10 x 8 m, and at most one cell of 0.25 m more around it.
	CHECK(total_area(pieces) <= doctest::Approx(320.0));
	CHECK(total_area(pieces) >= 400.0 - 10.5 * 8.5);
}

TEST_CASE("what hangs above heads or lies under feet does not stand in the way") {
	Mesh mesh;
	add_face(mesh, { { 5, 2.5f, -5 }, { 15, 2.5f, -5 }, { 15, 2.5f, -15 }, { 5, 2.5f, -15 } });
	add_face(mesh, { { 5, 0.2f, -5 }, { 15, 0.2f, -5 }, { 15, 0.2f, -15 }, { 5, 0.2f, -15 } });
	CHECK(total_area(free_ground(square_lot(), model_of(mesh))) == doctest::Approx(400.0));
}

TEST_CASE("a table and a low end of a roof stand in the way where they are between knee and head") {
	Mesh table;
	add_face(table, { { 5, 1, -5 }, { 10, 1, -5 }, { 10, 1, -10 }, { 5, 1, -10 } });
	CHECK(total_area(free_ground(square_lot(), model_of(table))) == doctest::Approx(375.0));
	// From the ground at depth 10 to 4 m height at depth 20: below head height up to depth 15, above a step from 10.875 on.
	Mesh roof;
	add_face(roof, { { 0, 0, -10 }, { 20, 0, -10 }, { 20, 4, -20 }, { 0, 4, -20 } });
	const auto pieces = free_ground(square_lot(), model_of(roof));
	CHECK(covers(pieces, 10, 10.5f));
	CHECK_FALSE(covers(pieces, 10, 12));
	// What lies behind cannot be reached from the street.
	CHECK_FALSE(covers(pieces, 10, 18));
}

TEST_CASE("a closed courtyard is left out, one with a gate is kept") {
	Mesh closed;
	add_walls(closed, 2, 18, 2, 18, 0, 5);
	add_walls(closed, 6, 14, 6, 14, 0, 5);
	CHECK_FALSE(covers(free_ground(square_lot(), model_of(closed)), 10, 10));
	Mesh open = closed;
	// Without the outer and inner front walls, and with walls along the passage between them from x = 9 to 11.
	open.faces.erase(open.faces.begin() + 4);
	open.faces.erase(open.faces.begin());
	add_walls(open, 2, 9, 2, 6, 0, 5);
	add_walls(open, 11, 18, 2, 6, 0, 5);
	const auto pieces = free_ground(square_lot(), model_of(open));
	CHECK(covers(pieces, 10, 10));
	CHECK(covers(pieces, 10, 4));
	CHECK_FALSE(covers(pieces, 5, 4));
}

TEST_CASE("a lot that is built over completely has no free ground") {
	Mesh mesh;
	add_walls(mesh, 0, 20, 0, 20, 0, 5);
	CHECK(free_ground(square_lot(), model_of(mesh)).empty());
}

TEST_CASE("free ground turns with the lot") {
	Lot lot = square_lot();
	std::rotate(lot.polygon.begin(), lot.polygon.begin() + 2, lot.polygon.end());
	Mesh mesh;
	add_walls(mesh, 0, 20, 10, 12, 0, 5); // a wall from side to side
	const auto pieces = free_ground(lot, model_of(mesh));
	// The street now lies at the far side.
	CHECK(covers(pieces, 10, 18));
	CHECK_FALSE(covers(pieces, 10, 5));
	// Odd angles keep the area.
	Lot skew;
	const float c = std::cos(0.7f), s = std::sin(0.7f);
	for (const glm::vec3 &corner : square_lot().polygon) {
		skew.polygon.push_back({ corner.x * c - corner.z * s, 0, corner.x * s + corner.z * c });
	}
	skew.street_widths = { 8, 0, 0, 0 };
	CHECK(total_area(free_ground(skew, cga::DerivationResult())) == doctest::Approx(400.0));
}

TEST_CASE("a triangular lot keeps its outline") {
	Lot lot;
	lot.polygon = { { 0, 0, 0 }, { 20, 0, 0 }, { 0, 0, -20 } };
	lot.street_widths = { 8, 0, 0 };
	const auto pieces = free_ground(lot, cga::DerivationResult());
	CHECK(total_area(pieces) == doctest::Approx(200.0).epsilon(0.01));
	CHECK(pieces.size() == 1); // no steps along the slanted edge
}

TEST_CASE("broken geometry and lots give no ground, not a crash") {
	Mesh mesh;
	add_face(mesh, { { NAN, 1, -5 }, { 1e30f, NAN, -5 }, { -1e30f, 1, INFINITY } });
	add_face(mesh, { { 1, 1, -5 } });
	CHECK(total_area(free_ground(square_lot(), model_of(mesh))) > 0.0);
	Lot flat;
	flat.polygon = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } };
	flat.street_widths = { 1, 1, 1 };
	CHECK(free_ground(flat, model_of(mesh)).empty());
	flat.polygon = { { 0, 0, 0 }, { 20, 0, 0 }, { 10, 0, 0 } };
	CHECK(free_ground(flat, model_of(mesh)).empty());
	CHECK(free_ground(Lot(), model_of(mesh)).empty());
}

TEST_CASE("what is inserted stands in the way where it is placed, unless it belongs to an object") {
	Mesh table; // 1 x 1 m, 1 m high
	add_face(table, { { 0, 1, 0 }, { 1, 1, 0 }, { 1, 1, -1 }, { 0, 1, -1 } });
	cga::DerivationResult model;
	model.prototypes.push_back({ std::make_shared<const Mesh>(table), {} });
	// Five times as wide and deep, from (5, 5) to (10, 10): 25 of the 400 square metres.
	model.instances.push_back({ 0, -1, glm::dmat3({ 5, 0, 0 }, { 0, 1, 0 }, { 0, 0, 5 }), { 5, 0, -5 } });
	const auto pieces = free_ground(square_lot(), model);
	CHECK(total_area(pieces) == doctest::Approx(375.0));
	CHECK_FALSE(covers(pieces, 7, 7));
	CHECK(covers(pieces, 3, 7));
	model.instances[0].origin.y = 1.5; // over all heads
	CHECK(total_area(free_ground(square_lot(), model)) == doctest::Approx(400.0));
	// Turned on its side its top stands upright, 1 m left of where it is put: it takes the one row of cells of 0.25 m that it runs through.
	model.instances[0] = { 0, -1, glm::dmat3({ 0, 1, 0 }, { -1, 0, 0 }, { 0, 0, 1 }), { 10.1, 0.5, -5 } };
	CHECK_FALSE(covers(free_ground(square_lot(), model), 9.1f, 5.5f));
	CHECK(covers(free_ground(square_lot(), model), 9.5f, 5.5f));
	model.instances[0] = { 0, 0, glm::dmat3(1.0), { 5, 0, -5 } };
	CHECK(total_area(free_ground(square_lot(), model)) == doctest::Approx(400.0));
}
