#include <doctest/doctest.h>

#include <vector>

#include "core/cga/edges.h"
#include "core/cga/primitives.h"

using namespace pcg;
using namespace pcg::cga;

namespace {

// The faces of a body but for one, and some of them twice.
const Geometry *altered(const Geometry &body, uint32_t left_out, uint32_t doubled, Arena &arena) {
	GeometryBuilder builder;
	for (uint32_t f = 0; f < body.face_count; ++f) {
		for (int copies = f == left_out ? 0 : f == doubled ? 2 : 1; copies > 0; --copies) {
			builder.add_face(body, body.faces[f]);
		}
	}
	return builder.finish(arena, false);
}

} // namespace

TEST_CASE("the edges of a body are pairs, those of one that lacks a face or has one twice are not, with few edges and with many") {
	Arena arena;
	constexpr uint32_t none = UINT32_MAX;
	for (const uint32_t sides : { 5u, 8u, 40u, 300u }) {
		const Geometry *body = make_primitive(PrimitiveKind::Cylinder, sides, 0, arena);
		CAPTURE(sides);
		CHECK(has_paired_edges(*body));
		CHECK(has_paired_edges(*altered(*body, none, none, arena)));
		for (const uint32_t face : { 0u, sides / 2, sides + 1 }) {
			CHECK_FALSE(has_paired_edges(*altered(*body, face, none, arena)));
			CHECK_FALSE(has_paired_edges(*altered(*body, none, face, arena)));
		}
	}
}

// Both pairs of sheets that lie on each other are closed, but together each of their edges belongs to four faces.
TEST_CASE("edges that belong to four faces are no pairs") {
	Arena arena;
	GeometryBuilder builder;
	const std::vector<glm::dvec3> up = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, { 1.0, 0.0, 0.0 } }, down = { up[0], up[2], up[1] };
	for (int sheets = 1; sheets <= 4; ++sheets) {
		builder.add_loop(sheets % 2 == 0 ? down : up);
		builder.end_face();
		CHECK(has_paired_edges(*builder.finish(arena, false)) == (sheets == 2));
	}
}

TEST_CASE("edges are told face by face, those without a face once") {
	Arena arena;
	GeometryBuilder builder;
	const std::vector<glm::dvec3> triangle = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 2.0 }, { 2.0, 0.0, 0.0 } };
	builder.add_loop(triangle);
	builder.end_face();
	builder.add_loop({ triangle.data(), 2 }, 2);
	builder.end_face();
	const std::vector<FaceEdge> edges = face_edges(*builder.finish(arena, false));
	REQUIRE(edges.size() == 4);
	for (uint32_t i = 0; i < 4; ++i) {
		CHECK(edges[i].order == i);
		CHECK(edges[i].face == i / 3);
		CHECK(edges[i].corner == i);
		CHECK(edges[i].end_corner == (i < 2 ? i + 1 : i == 2 ? 0 : 4));
		CHECK(edges[i].from == triangle[i % 3]);
		CHECK(edges[i].to == triangle[(i + 1) % 3]);
	}
}
