#include <doctest/doctest.h>

#include "core/city/model_merge.h"

using namespace pcg;

namespace {

const auto tree = std::make_shared<Mesh>();

// One triangle, one object with a triangle, one instance on the ground and one on the object.
cga::DerivationResult piece(const std::string &color_name) {
	cga::DerivationResult result;
	result.materials = { { "leaf" }, { color_name } };
	Mesh triangle;
	triangle.positions = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, -1 } };
	triangle.loop_ends = { 3 };
	triangle.faces = { { 0, 1, 1, { 0, 1, 0 } } };
	result.mesh = triangle;
	result.objects = { { "bench", glm::mat4(1.0f), triangle, {}, -1 } };
	result.prototypes = { { tree, { 0 } } };
	result.instances = { { 0, -1 }, { 0, 0 } };
	result.face_count = 4;
	return result;
}

} // namespace

TEST_CASE("merged pieces share equal materials and prototypes, and keep whose instances are whose") {
	ModelMerge merge;
	merge.add(piece("asphalt"));
	merge.add(piece("paving"));
	merge.add(piece("asphalt"));
	const cga::DerivationResult whole = merge.take();
	REQUIRE(whole.materials.size() == 3);
	CHECK(whole.materials[0].name == "leaf");
	CHECK(whole.mesh.faces.size() == 3);
	CHECK(whole.mesh.faces[1].material == 2);
	CHECK(whole.mesh.faces[2].material == 1);
	CHECK(whole.objects.size() == 3);
	CHECK(whole.objects[1].mesh.faces[0].material == 2);
	CHECK(whole.prototypes.size() == 1);
	REQUIRE(whole.instances.size() == 6);
	CHECK(whole.instances[4].object == -1);
	CHECK(whole.instances[5].object == 2);
	CHECK(whole.face_count == 12);
}
