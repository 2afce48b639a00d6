#include "core/cga/corner_data.h"

#include <doctest/doctest.h>

#include <vector>

#include <glm/geometric.hpp>

#include "core/cga/clip.h"
#include "core/cga/components.h"
#include "core/cga/extrude.h"

using namespace pcg;
using namespace pcg::cga;

namespace {

// u and v are linear in x and z: whatever is cut out of it must keep that.
glm::dvec2 uv_at(glm::dvec3 point) {
	return { 0.25 * point.x + 1.0, -0.1 * point.z + 0.05 * point.x };
}

const Geometry *textured(const Geometry &geometry, Arena &arena) {
	glm::dvec2 *uvs = arena.allocate<glm::dvec2>(geometry.point_count);
	for (uint32_t i = 0; i < geometry.point_count; ++i) {
		uvs[i] = uv_at(geometry.points[i]);
	}
	return with_uvs(geometry, 0, uvs, arena);
}

// An L looking up, with a square hole.
const Geometry *sample(Arena &arena) {
	GeometryBuilder builder;
	builder.add_loop(std::vector<glm::dvec3>{ { 0, 0, 0 }, { 10, 0, 0 }, { 10, 0, -4 }, { 6, 0, -4 }, { 6, 0, -10 }, { 0, 0, -10 } });
	builder.add_loop(std::vector<glm::dvec3>{ { 1, 0, -1 }, { 1, 0, -3 }, { 3, 0, -3 }, { 3, 0, -1 } });
	builder.end_face();
	return textured(*builder.finish(arena, false), arena);
}

void check_linear(const Geometry &geometry) {
	REQUIRE(geometry.uvs(0) != nullptr);
	for (uint32_t i = 0; i < geometry.point_count; ++i) {
		CHECK(glm::distance(geometry.uvs(0)[i], uv_at(geometry.points[i])) < 1e-9);
	}
}

} // namespace

TEST_CASE("mean value coordinates are exact for linear functions: inside, on edges, on corners, in concave faces with holes") {
	Arena arena;
	const Geometry &geometry = *sample(arena);
	std::vector<double> weights;
	const glm::dvec3 places[] = { { 5, 0, -1 }, { 2, 0, -8 }, { 5, 0, 0 }, { 6, 0, -4 }, { 0, 0, -10 }, { 2, 0, -1 }, { 9.5, 0, -3.9 } };
	for (const glm::dvec3 &place : places) {
		mean_value_weights(geometry, geometry.faces[0], place, weights);
		REQUIRE(weights.size() == 10);
		double sum = 0.0;
		glm::dvec3 mean(0.0);
		for (uint32_t i = 0; i < weights.size(); ++i) {
			sum += weights[i];
			mean += weights[i] * geometry.points[i];
		}
		CHECK(sum == doctest::Approx(1.0));
		CHECK(glm::distance(mean, place) < 1e-9);
	}
}

TEST_CASE("a cut keeps texture coordinates linear; what is not cut keeps them as they are") {
	Arena arena;
	Clipper clipper;
	const Geometry &geometry = *sample(arena);
	for (const Plane &plane : { Plane{ { 1, 0, 0 }, 2.0 }, Plane{ { -1, 0, 0 }, -2.0 }, Plane{ { 0, 0, -1 }, 5.0 }, Plane{ { 0.6, 0, -0.8 }, 6.0 } }) {
		const Geometry *piece = clipper.clip(geometry, plane, arena);
		REQUIRE(piece != nullptr);
		check_linear(*piece);
	}
}

TEST_CASE("caps carry no texture coordinates, the walls beside them do") {
	Arena arena;
	Clipper clipper;
	Shape shape;
	const Frame pivot;
	shape.pivot = &pivot;
	GeometryBuilder builder;
	builder.add_loop(std::vector<glm::dvec3>{ { 0, 0, 0 }, { 4, 0, 0 }, { 4, 0, -4 }, { 0, 0, -4 } });
	builder.end_face();
	set_geometry(shape, textured(*builder.finish(arena, false), arena));
	REQUIRE(extrude(shape, ExtrudeDirection::FaceNormal, 3.0, false, builder, arena));
	const Geometry *half = clipper.clip(*shape.geometry, { { 1, 0, 0 }, 1.0 }, arena);
	REQUIRE(half != nullptr);
	REQUIRE(half->face_count == 6);
	uint32_t without = 0;
	for (uint32_t f = 0; f < half->face_count; ++f) {
		without += !has_uv(half->uvs(0)[half->first_point(half->faces[f].first_loop)]);
	}
	CHECK(without == 1);
}

TEST_CASE("the top of an extrusion has the face's coordinates, the walls those of their edge") {
	Arena arena;
	Shape shape;
	const Frame pivot;
	shape.pivot = &pivot;
	shape.geometry = sample(arena);
	GeometryBuilder builder;
	for (const double height : { 3.0, -3.0 }) {
		Shape solid = shape;
		refit(solid);
		const glm::dvec3 shift = solid.position;
		REQUIRE(extrude(solid, ExtrudeDirection::FaceNormal, height, true, builder, arena));
		const Geometry &geometry = *solid.geometry;
		for (uint32_t i = 0; i < geometry.point_count; ++i) {
			const glm::dvec3 point = solid.to_scope(geometry.points[i]) + solid.position;
			CHECK(glm::distance(geometry.uvs(0)[i], uv_at({ point.x, shift.y, point.z })) < 1e-9);
		}
	}
}

TEST_CASE("turning the scope and turning faces around keep each corner's coordinates") {
	Arena arena;
	Shape shape;
	const Frame pivot;
	shape.pivot = &pivot;
	shape.geometry = sample(arena);
	refit(shape);
	GeometryBuilder builder;
	reverse_normals(shape, builder, arena);
	check_linear(*shape.geometry);
	turn_scope(shape, rotation_from_euler({ 10.0, 20.0, 30.0 }), builder, arena);
	const Frame frame = shape.frame();
	for (uint32_t i = 0; i < shape.geometry->point_count; ++i) {
		const glm::dvec3 point = frame.to_parent(shape.to_scope(shape.geometry->points[i]));
		CHECK(glm::distance(shape.geometry->uvs(0)[i], uv_at(point)) < 1e-9);
	}
}

TEST_CASE("points that melt together melt with what they carry") {
	Arena arena;
	const Geometry &source = *sample(arena);
	GeometryBuilder builder;
	builder.begin(source);
	builder.add_corner(source.points[0], 0);
	builder.add_corner(source.points[0], 0);
	builder.add_corner(source.points[1], 1);
	builder.add_between({ 10, 0, -2 }, 1, 2, 0.5);
	builder.add_inside({ 5, 0, -0.5 }, 0);
	builder.add_corner(source.points[0], 0);
	CHECK(builder.end_loop());
	builder.end_face();
	builder.add_quad({ 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 });
	const Geometry *result = builder.finish(arena, false);
	REQUIRE(result->point_count == 8);
	for (uint32_t i = 0; i < 4; ++i) {
		CHECK(glm::distance(result->uvs(0)[i], uv_at(result->points[i])) < 1e-9);
	}
	for (uint32_t i = 4; i < 8; ++i) {
		CHECK(!has_uv(result->uvs(0)[i]));
	}
}

TEST_CASE("a face that becomes a shape takes its corners' normals along, turned into its own axes") {
	Arena arena;
	Shape shape;
	const Frame pivot;
	shape.pivot = &pivot;
	Geometry geometry = *sample(arena);
	CornerData corners;
	const std::vector<glm::dvec3> normals(geometry.point_count, glm::normalize(glm::dvec3(1.0, 2.0, 0.0)));
	corners.normals = normals.data();
	geometry.corners = &corners;
	shape.geometry = &geometry;
	refit(shape);
	GeometryBuilder builder;
	const uint32_t face = 0;
	const glm::dvec3 normal = face_normal(geometry, geometry.faces[face]);
	const Shape child = face_shape(shape, shape.frame(), *baked(shape, arena), { &face, 1 }, normal, false, builder, arena);
	REQUIRE(child.geometry->corners != nullptr);
	REQUIRE(child.geometry->corners->normals != nullptr);
	const glm::dvec3 world = child.frame().axes * child.geometry->corners->normals[3];
	CHECK(glm::distance(world, normals[0]) < 1e-9);
}
