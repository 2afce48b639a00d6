#include "core/geometry/mesh.h"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

using namespace pcg;

namespace {

// A square of 10 m with a hole of 4 m, looking up, and a triangle of another material.
Mesh sample() {
	Mesh mesh;
	mesh.positions = { { 0, 0, 0 }, { 10, 0, 0 }, { 10, 0, -10 }, { 0, 0, -10 }, { 3, 0, -3 }, { 3, 0, -7 }, { 7, 0, -7 }, { 7, 0, -3 }, { 0, 0, 0 },
		{ 4, 0, 0 }, { 0, 3, 0 } };
	mesh.loop_ends = { 4, 8, 11 };
	mesh.faces = { { 0, 2, 1, { 0, 1, 0 } }, { 2, 1, 0, { 0, 0, 1 } } };
	return mesh;
}

} // namespace

TEST_CASE("the area of a mesh leaves out holes") {
	CHECK(area(sample()) == doctest::Approx(84.0 + 6.0));
}

TEST_CASE("surfaces come in order of material, with triangles that look like their faces") {
	const auto surfaces = make_surfaces(sample());
	REQUIRE(surfaces.size() == 2);
	CHECK(surfaces[0].material == 0);
	CHECK(surfaces[0].indices.size() == 3);
	CHECK(surfaces[1].indices.size() == 8 * 3); // 8 corners + 2 for the hole - 2
	CHECK(surfaces[1].positions.size() == 8);
	for (const MeshSurface &surface : surfaces) {
		for (size_t i = 0; i < surface.indices.size(); i += 3) {
			const glm::vec3 a = surface.positions[surface.indices[i]];
			const glm::vec3 b = surface.positions[surface.indices[i + 1]];
			const glm::vec3 c = surface.positions[surface.indices[i + 2]];
			CHECK(glm::dot(glm::cross(b - a, c - a), surface.normals[surface.indices[i]]) > 0.0f);
		}
	}
}

TEST_CASE("appending shifts loops and materials") {
	Mesh mesh = sample();
	append(mesh, sample(), 5);
	CHECK(mesh.faces.size() == 4);
	CHECK(mesh.faces[2].material == 6);
	CHECK(mesh.loop(mesh.faces[3].first_loop)[1] == glm::vec3(4, 0, 0));
	CHECK(area(mesh) == doctest::Approx(180.0));
}

TEST_CASE("texture coordinates run beside the corners, through appending and into the surfaces") {
	Mesh mesh = sample();
	Mesh textured = sample();
	for (const glm::vec3 &point : textured.positions) {
		textured.uvs[2].push_back({ point.x, point.z });
	}
	append(mesh, textured);
	append(mesh, sample());
	REQUIRE(mesh.uvs[2].size() == 33);
	CHECK(mesh.uvs[0].empty());
	CHECK(mesh.uvs[2][1] == glm::vec2(0, 0)); // of the first mesh, which has none
	CHECK(mesh.uvs[2][12] == glm::vec2(10, 0));
	CHECK(mesh.uvs[2][32] == glm::vec2(0, 0));
	const auto surfaces = make_surfaces(textured);
	for (const MeshSurface &surface : surfaces) {
		REQUIRE(surface.uvs[2].size() == surface.positions.size());
		for (size_t i = 0; i < surface.positions.size(); ++i) {
			CHECK(surface.uvs[2][i] == glm::vec2(surface.positions[i].x, surface.positions[i].z));
		}
	}
}

TEST_CASE("flat faces keep their normals beside smooth ones") {
	Mesh smooth = sample();
	smooth.normals.assign(smooth.positions.size(), glm::vec3(1, 0, 0));
	Mesh mesh = sample();
	append(mesh, smooth);
	append(mesh, sample());
	REQUIRE(mesh.normals.size() == 33);
	CHECK(mesh.normals[0] == glm::vec3(0, 1, 0));
	CHECK(mesh.normals[10] == glm::vec3(0, 0, 1));
	CHECK(mesh.normals[11] == glm::vec3(1, 0, 0));
	CHECK(mesh.normals[32] == glm::vec3(0, 0, 1));
	CHECK(make_surfaces(smooth)[0].normals[0] == glm::vec3(1, 0, 0));
}
