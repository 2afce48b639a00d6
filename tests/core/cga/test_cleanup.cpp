#include "core/cga/cleanup.h"

#include <doctest/doctest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "core/cga/measure.h"
#include "core/cga/primitives.h"

using namespace pcg;
using namespace pcg::cga;

namespace {

Shape body(const Geometry *geometry, Arena &arena) {
	Shape shape;
	shape.pivot = arena.make(Frame());
	shape.size = glm::dvec3(2.0, 3.0, 4.0);
	fit_to_scope(shape, geometry);
	return shape;
}

} // namespace

TEST_CASE("a box shaded softly has the mean of three faces at each corner; below 90 degrees its edges are hard") {
	Arena arena;
	Shape shape = body(make_primitive(PrimitiveKind::PlainCube, 0, 0, arena), arena);
	soften_normals(shape, 180.0, arena);
	REQUIRE(shape.geometry->corners != nullptr);
	for (uint32_t i = 0; i < shape.geometry->point_count; ++i) {
		const glm::dvec3 outwards = glm::sign(shape.geometry->points[i] - glm::dvec3(1.0, 1.5, 2.0)) / std::sqrt(3.0);
		CHECK(glm::distance(shape.geometry->corners->normals[i], outwards) < 1e-9);
	}
	soften_normals(shape, 30.0, arena);
	for (uint32_t f = 0; f < shape.geometry->face_count; ++f) {
		const uint32_t first = shape.geometry->first_point(shape.geometry->faces[f].first_loop);
		CHECK(glm::distance(shape.geometry->corners->normals[first], face_normal(*shape.geometry, shape.geometry->faces[f])) < 1e-9);
	}
	soften_normals(shape, 0.0, arena);
	CHECK(shape.geometry->corners->normals == nullptr);
}

TEST_CASE("with 30 degrees the sides of a cylinder are round and its ends are not") {
	Arena arena;
	Shape shape = body(make_primitive(PrimitiveKind::Cylinder, 16, 0, arena), arena);
	soften_normals(shape, 30.0, arena);
	size_t level = 0;
	for (uint32_t i = 0; i < shape.geometry->point_count; ++i) {
		const glm::dvec3 normal = shape.geometry->corners->normals[i];
		level += std::abs(normal.y) < 1e-9;
		CHECK((std::abs(normal.y) < 1e-9 || std::abs(std::abs(normal.y) - 1.0) < 1e-9));
	}
	CHECK(level == 64); // the corners of 16 sides
}

TEST_CASE("reducing leaves as many vertices as it says and a closed surface closed") {
	for (const double share : { 0.1, 0.3, 0.6 }) {
		Arena arena;
		GeometryBuilder builder;
		Shape shape = body(make_primitive(PrimitiveKind::Sphere, 20, 12, arena), arena);
		const double before = volume(shape);
		reduce(shape, share, builder, arena);
		CHECK(boundary_length(shape) == 0.0);
		CHECK(volume(shape) > 0.7 * before);
		CHECK(volume(shape) < 1.05 * before);
	}
}

TEST_CASE("cleaning survives what is empty, flat or gone") {
	Arena arena;
	GeometryBuilder builder;
	Shape nothing;
	nothing.pivot = arena.make(Frame());
	clean_up(nothing, { true, true, true, 1.0 }, builder, arena);
	CHECK(nothing.geometry == nullptr);
	Shape small = body(make_primitive(PrimitiveKind::PlainCube, 0, 0, arena), arena);
	small.geometry_scale = glm::dvec3(1e-3);
	clean_up(small, { true, true, true, 1.0 }, builder, arena);
	CHECK(small.geometry == nullptr); // a millimetre is no place for eight vertices that are a metre apart
}
