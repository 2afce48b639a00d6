#include <doctest/doctest.h>

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/base/random.h"
#include "core/cga/measure.h"
#include "core/cga/primitives.h"

using namespace pcg;
using namespace pcg::cga;

namespace {

struct Kind {
	PrimitiveKind kind;
	uint32_t a, b, faces;
	bool is_solid;
};
constexpr Kind kinds[] = { { PrimitiveKind::Quad, 0, 0, 1, false }, { PrimitiveKind::Quad, 1, 0, 1, false }, { PrimitiveKind::Quad, 2, 0, 1, false },
	{ PrimitiveKind::Disk, 16, 0, 1, false }, { PrimitiveKind::Disk, 16, 1, 1, false }, { PrimitiveKind::Disk, 16, 2, 1, false }, { PrimitiveKind::Cube, 0, 0, 6, true },
	{ PrimitiveKind::Sphere, 8, 4, 32, true }, { PrimitiveKind::Cylinder, 16, 0, 18, true }, { PrimitiveKind::Cone, 12, 0, 13, true } };

Shape scope_of(glm::dvec3 size) {
	static const Frame pivot;
	Shape shape;
	shape.pivot = &pivot;
	shape.size = size;
	return shape;
}

} // namespace

TEST_CASE("built-in bodies have their faces, a texture coordinate at each corner, and look outwards") {
	Arena arena;
	for (const Kind &kind : kinds) {
		const Geometry *geometry = make_primitive(kind.kind, kind.a, kind.b, arena);
		CHECK(geometry->face_count == kind.faces);
		CHECK(geometry->is_closed == kind.is_solid);
		REQUIRE(geometry->uvs(0) != nullptr);
		for (uint32_t i = 0; i < geometry->point_count; ++i) {
			const glm::dvec2 uv = geometry->uvs(0)[i];
			CHECK((uv.x > -1e-9 && uv.x < 1.0 + 1e-9 && uv.y > -1e-9 && uv.y < 1.0 + 1e-9));
		}
		for (uint32_t i = 0; kind.is_solid && i < geometry->face_count; ++i) {
			const auto outline = geometry->outline(geometry->faces[i]);
			CHECK(glm::dot(face_normal(*geometry, geometry->faces[i]), 0.5 * (outline[0] + outline[1]) - glm::dvec3(0.5)) > 0.0);
		}
	}
	CHECK(make_primitive(PrimitiveKind::PlainCube, 0, 0, arena)->uvs(0) == nullptr);
	CHECK(make_primitive(PrimitiveKind::Cylinder, 0, 0, arena)->face_count == 5); // three sides at least
}

TEST_CASE("bodies put into a scope fill it, whatever its size and their own") {
	Arena arena;
	Random random(3);
	for (int i = 0; i < 300; ++i) {
		const Kind &kind = kinds[6 + random.index(4)];
		const glm::dvec3 size(random.uniform(0.1, 50.0), random.uniform(0.1, 50.0), random.uniform(0.1, 50.0));
		Shape shape = scope_of(size);
		fit_to_scope(shape, make_primitive(kind.kind, kind.a, kind.b, arena));
		const glm::dvec3 low = shape.to_scope(shape.geometry->low), high = shape.to_scope(shape.geometry->high);
		CHECK(glm::length(low) < 1e-9);
		CHECK(glm::length(high - size) < 1e-9);
		CHECK(shape.size == size);
	}
}

TEST_CASE("scope sizes of 0 keep the proportions of what is inserted") {
	GeometryBuilder builder; // 2 x 4 x 1, its lowest corner at 1 2 3
	builder.add_quad({ 1, 2, 3 }, { 3, 2, 3 }, { 3, 6, 4 }, { 1, 6, 4 });
	Arena arena;
	const Geometry *plate = builder.finish(arena, false);
	Random random(5);
	for (int i = 0; i < 100; ++i) {
		const int axis = int(random.index(3));
		const double length = random.uniform(0.1, 20.0), scale = length / (plate->high - plate->low)[axis];
		glm::dvec3 size(0.0);
		size[axis] = length;
		Shape line = scope_of(size);
		fit_to_scope(line, plate);
		CHECK(glm::length(line.size - scale * glm::dvec3(2, 4, 1)) < 1e-9);
		glm::dvec3 moved = scale * plate->low;
		moved[axis] = 0.0;
		CHECK(glm::length(line.position - moved) < 1e-9);
	}
	Shape point = scope_of(glm::dvec3(0.0));
	fit_to_scope(point, plate);
	CHECK(point.size == glm::dvec3(2, 4, 1));
	CHECK(point.position == glm::dvec3(1, 2, 3));
}

TEST_CASE("flat things in a scope with depth stay flat and take no other size from it") {
	Arena arena;
	Shape shape = scope_of({ 4.0, 3.0, 0.0 });
	fit_to_scope(shape, make_primitive(PrimitiveKind::Quad, 1, 0, arena)); // flat in y, one size unknown: from x alone
	CHECK(shape.size == glm::dvec3(4.0, 3.0, 4.0));
	CHECK(std::abs(surface_area(shape) - 16.0) < 1e-9);
}
