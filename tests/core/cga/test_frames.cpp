#include "core/cga/frames.h"

#include <doctest/doctest.h>

#include <functional>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/base/random.h"
#include "core/cga/primitives.h"

using namespace pcg;
using namespace pcg::cga;

namespace {

double between(Random &random, double low, double high) { return low + (high - low) * random.uniform(); }

// A cylinder in a scope that is moved, turned and sized at random.
Shape random_shape(Random &random, Arena &arena, bool has_negative_sizes) {
	const auto vector = [&](double low, double high) { return glm::dvec3(between(random, low, high), between(random, low, high), between(random, low, high)); };
	Shape shape;
	shape.pivot = arena.make(Frame{ rotation_from_euler(vector(-180.0, 180.0)), vector(-20.0, 20.0) });
	shape.position = vector(-5.0, 5.0);
	shape.rotation = rotation_from_euler(vector(-180.0, 180.0));
	shape.size = vector(0.5, 9.0);
	fit_to_scope(shape, make_primitive(PrimitiveKind::Cylinder, 5, 0, arena));
	for (int axis = 0; axis < 3 && has_negative_sizes; ++axis) {
		if (random.uniform() < 0.5) {
			mirror_scope(shape, axis);
		}
	}
	return shape;
}

std::vector<glm::dvec3> world_points(const Shape &shape) {
	std::vector<glm::dvec3> points;
	for (uint32_t i = 0; i < shape.geometry->point_count; ++i) {
		points.push_back(shape.frame().to_parent(shape.to_scope(shape.geometry->points[i])));
	}
	return points;
}

void check_frame(const Shape &shape) {
	CHECK(glm::determinant(shape.pivot->axes) == doctest::Approx(1.0));
	CHECK(glm::length(shape.position) == 0.0);
	for (const glm::dvec3 &point : world_points(shape)) { // within the box
		const glm::dvec3 local = shape.frame().to_local(point);
		for (int axis = 0; axis < 3; ++axis) {
			CHECK(local[axis] >= -1e-9);
			CHECK(local[axis] <= shape.size[axis] + 1e-9);
		}
	}
}

void check_moves_nothing(const std::function<void(Shape &, GeometryBuilder &, Arena &)> &operation) {
	Random random(7);
	for (int i = 0; i < 50; ++i) {
		Arena arena;
		GeometryBuilder builder;
		Shape shape = random_shape(random, arena, i % 2 == 1);
		const std::vector<glm::dvec3> before = world_points(shape);
		operation(shape, builder, arena);
		check_frame(shape);
		const std::vector<glm::dvec3> after = world_points(shape);
		REQUIRE(before.size() == after.size());
		for (size_t k = 0; k < before.size(); ++k) {
			CHECK(glm::distance(before[k], after[k]) < 1e-9);
		}
	}
}

} // namespace

TEST_CASE("setPivot moves no vertex, and its axes look into the box from every corner") {
	for (const PivotOrder order : { PivotOrder::Xyz, PivotOrder::Yzx, PivotOrder::Zxy }) {
		for (uint32_t corner = 0; corner < 8; ++corner) {
			check_moves_nothing([&](Shape &shape, GeometryBuilder &builder, Arena &arena) { set_pivot(shape, order, corner, builder, arena); });
		}
	}
}

TEST_CASE("aligning the scope moves no vertex and leaves t and r at zero") {
	check_moves_nothing([](Shape &shape, GeometryBuilder &builder, Arena &arena) { align_scope(shape, glm::dmat3(1.0), builder, arena); });
	using Face = FaceChoice::Kind;
	using Edge = EdgeChoice::Kind;
	for (const Face face : { Face::Index, Face::Lowest, Face::Largest, Face::Any }) {
		for (const Edge edge : { Edge::Index, Edge::Lowest, Edge::Longest, Edge::Auto }) {
			check_moves_nothing([&](Shape &shape, GeometryBuilder &builder, Arena &arena) {
				align_scope_to_geometry(shape, face == Face::Any, { face, 2.0 }, { edge, -1.0 }, builder, arena);
			});
		}
	}
	for (int longer = 0; longer < 3; ++longer) {
		check_moves_nothing([&](Shape &shape, GeometryBuilder &builder, Arena &arena) {
			align_scope_to_rectangle(shape, longer, (longer + 1) % 3, builder, arena);
			CHECK(shape.size[longer] >= shape.size[(longer + 1) % 3] - 1e-9);
		});
	}
}

TEST_CASE("mirroring twice is not mirroring at all") {
	Random random(3);
	for (int i = 0; i < 20; ++i) {
		Arena arena;
		GeometryBuilder builder;
		Shape shape = random_shape(random, arena, i % 2 == 1);
		const std::vector<glm::dvec3> before = world_points(shape);
		const bool axes[3] = { i % 2 == 0, i % 3 == 0, true };
		mirror_geometry(shape, axes, builder, arena);
		mirror_geometry(shape, axes, builder, arena);
		const std::vector<glm::dvec3> after = world_points(shape);
		REQUIRE(before.size() == after.size());
		for (size_t k = 0; k < before.size(); ++k) {
			CHECK(glm::distance(before[k], after[k]) < 1e-9);
		}
	}
}

TEST_CASE("angles of a rotation give that rotation back, also where y is at 90 degrees") {
	for (const glm::dvec3 angles : { glm::dvec3(10, 20, 30), glm::dvec3(40, 90, 25), glm::dvec3(-70, -90, 15), glm::dvec3(0, 90, 0), glm::dvec3(180, 0, 90) }) {
		const glm::dmat3 rotation = rotation_from_euler(angles);
		const glm::dmat3 again = rotation_from_euler(euler_from_rotation(rotation));
		for (int axis = 0; axis < 3; ++axis) {
			CHECK(glm::distance(rotation[axis], again[axis]) < 1e-9);
		}
	}
}
