#include "core/cga/unite.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "core/base/random.h"
#include "core/cga/junctions.h"
#include "core/cga/scope.h"
#include "core/geometry/polygon.h"

using namespace pcg;
using namespace pcg::cga;

namespace {

constexpr int cells = 6; // along each side of the space for boxes

struct Box {
	glm::ivec3 low, high;
	bool contains(glm::ivec3 cell) const { return glm::all(glm::greaterThanEqual(cell, low)) && glm::all(glm::lessThan(cell, high)); }
};

const Geometry *body(const Box &box, const glm::dmat3 &turn, GeometryBuilder &builder, Arena &arena) {
	const auto at = [&](int x, int y, int z) { return turn * glm::dvec3(x ? box.high.x : box.low.x, y ? box.high.y : box.low.y, z ? box.high.z : box.low.z); };
	builder.clear();
	builder.add_quad(at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1));
	builder.add_quad(at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0));
	builder.add_quad(at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1));
	builder.add_quad(at(1, 0, 0), at(0, 0, 0), at(0, 1, 0), at(1, 1, 0));
	builder.add_quad(at(1, 0, 1), at(1, 0, 0), at(1, 1, 0), at(1, 1, 1));
	builder.add_quad(at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0));
	return builder.finish(arena, true);
}

double volume_of(const std::vector<const Geometry *> &parts) {
	double sum = 0.0;
	for (const Geometry *part : parts) {
		for (uint32_t i = 0; part != nullptr && i < part->loop_count; ++i) {
			sum += glm::dot(part->loop(i)[0], area_vector(part->loop(i))) / 6.0;
		}
	}
	return sum;
}

double area_of(const std::vector<const Geometry *> &parts) {
	double sum = 0.0;
	for (const Geometry *part : parts) {
		for (uint32_t f = 0; part != nullptr && f < part->face_count; ++f) {
			glm::dvec3 vector(0.0);
			for (uint32_t i = 0; i < part->faces[f].loop_count; ++i) {
				vector += area_vector(part->loop(part->faces[f].first_loop + i));
			}
			sum += 0.5 * glm::length(vector);
		}
	}
	return sum;
}

// Cells in any of the boxes, and sides of cells between inside and outside.
std::array<int, 2> count(const std::vector<Box> &boxes) {
	const auto is_inside = [&](glm::ivec3 cell) { return std::ranges::any_of(boxes, [&](const Box &box) { return box.contains(cell); }); };
	std::array<int, 2> result{};
	for (int i = 0; i < cells * cells * cells; ++i) {
		const glm::ivec3 cell(i % cells, i / cells % cells, i / cells / cells);
		if (is_inside(cell)) {
			++result[0];
			for (int axis = 0; axis < 3; ++axis) {
				glm::ivec3 step(0);
				step[axis] = 1;
				result[1] += int(!is_inside(cell + step)) + int(!is_inside(cell - step));
			}
		}
	}
	return result;
}

} // namespace

TEST_CASE("boxes on a grid, many of them with faces in one plane, are united to the volume and the surface of their cells") {
	Arena arena;
	GeometryBuilder builder;
	for (uint64_t seed = 0; seed < 300; ++seed) {
		Random random(seed, 0);
		const glm::dmat3 turn = seed % 2 == 0 ? glm::dmat3(1.0) : rotation_from_euler(glm::dvec3(random.uniform(), random.uniform(), random.uniform()) * 90.0);
		std::vector<Box> boxes;
		std::vector<const Geometry *> parts;
		for (int i = 0; i < 4; ++i) {
			Box box;
			for (int axis = 0; axis < 3; ++axis) {
				box.low[axis] = int(random.uniform() * (cells - 1));
				box.high[axis] = box.low[axis] + 1 + int(random.uniform() * (cells - box.low[axis] - 1));
			}
			boxes.push_back(box);
			parts.push_back(body(box, turn, builder, arena));
		}
		unite(parts, builder, arena);
		const auto [volume, surface] = count(boxes);
		CAPTURE(seed);
		CHECK(volume_of(parts) == doctest::Approx(volume));
		CHECK(area_of(parts) == doctest::Approx(surface));
	}
}

TEST_CASE("a flat part loses what lies inside of a body; of two flat parts in one plane the second loses what both cover") {
	Arena arena;
	GeometryBuilder builder;
	const auto flat = [&](glm::dvec3 low, glm::dvec3 high) {
		builder.clear();
		builder.add_quad(low, { high.x, low.y, low.z }, { high.x, low.y, high.z }, { low.x, low.y, high.z });
		return builder.finish(arena, false);
	};
	std::vector<const Geometry *> parts = { body({ { 0, 0, 0 }, { 2, 2, 2 } }, glm::dmat3(1.0), builder, arena), flat({ -1, 1, -1 }, { 3, 1, 3 }),
		flat({ 2, 1, 0 }, { 5, 1, 2 }) };
	CHECK(unite_cost(parts) == 6.0 + 6.0 + 1.0);
	unite(parts, builder, arena);
	CHECK(area_of({ parts[0] }) == doctest::Approx(24.0));
	CHECK(area_of({ parts[1] }) == doctest::Approx(12.0));
	CHECK(area_of({ parts[2] }) == doctest::Approx(4.0));
	CHECK(can_unite(*parts[0]));
	CHECK(can_unite(*parts[1]));
}

TEST_CASE("a vertex on another face's edge becomes one of its corners") {
	Arena arena;
	GeometryBuilder builder;
	builder.add_quad({ 0, 0, 0 }, { 4, 0, 0 }, { 4, 0, 4 }, { 0, 0, 4 });
	builder.add_quad({ 4, 0, 1 }, { 6, 0, 1 }, { 6, 0, 3 }, { 4, 0, 3 });
	builder.add_quad({ 0, 0, 4 }, { 2, 0, 4 }, { 2, 2, 4 }, { 0, 2, 4 });
	const Geometry *geometry = builder.finish(arena, false);
	const Geometry *joined = with_junctions(*geometry, 0.0, 180.0, builder, arena);
	CHECK(joined->loop(0).size() == 7);
	CHECK(joined->loop(1).size() == 4);
	CHECK(joined->loop(0)[2] == glm::dvec3(4, 0, 1));
	CHECK(with_junctions(*geometry, 0.0, 1.0, builder, arena)->loop(0).size() == 6);
	CHECK(with_junctions(*joined, 0.0, 180.0, builder, arena) == joined);
}
