#include "core/cga/primitive_uvs.h"

#include <cmath>

namespace pcg::cga {

namespace {

constexpr double tau = 6.283185307179586;

// Around the middle of the unit cube, in turns from +z on; counter-clockwise from above.
double turn_of(glm::dvec3 point) {
	return std::atan2(0.5 - point.z, point.x - 0.5) / tau + 0.25;
}

bool is_on_axis(glm::dvec3 point) {
	return std::abs(point.x - 0.5) < 1e-9 && std::abs(point.z - 0.5) < 1e-9;
}

glm::dvec2 flat_uv(glm::dvec3 point, int axis) {
	return axis == 0 ? glm::dvec2(1.0 - point.z, point.y) : axis == 1 ? glm::dvec2(point.x, 1.0 - point.z) : glm::dvec2(point.x, point.y);
}

void add_side(const Geometry &geometry, uint32_t first, uint32_t count, double start, glm::dvec2 *uvs) {
	glm::dvec3 middle(0.0);
	for (uint32_t i = first; i < first + count; ++i) {
		middle += geometry.points[i] / double(count);
	}
	const double turn = turn_of(middle);
	const double base = turn - start - std::floor(turn - start);
	for (uint32_t i = first; i < first + count; ++i) {
		const double shift = is_on_axis(geometry.points[i]) ? 0.0 : turn_of(geometry.points[i]) - turn;
		uvs[i] = { base + shift - std::round(shift), geometry.points[i].y };
	}
}

// The axis along which the face has no extent; -1: none, or not upright.
int flat_axis(const Geometry &geometry, uint32_t first, uint32_t count) {
	if (geometry.face_count == 1) {
		return geometry.high.x == geometry.low.x ? 0 : geometry.high.z == geometry.low.z ? 2 : 1;
	}
	for (uint32_t i = first + 1; i < first + count; ++i) {
		if (geometry.points[i].y != geometry.points[first].y) {
			return -1;
		}
	}
	return 1;
}

} // namespace

const Geometry *with_face_uvs(const Geometry *geometry, Arena &arena) {
	static constexpr glm::dvec2 corners[4] = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } };
	glm::dvec2 *uvs = arena.allocate<glm::dvec2>(geometry->point_count);
	for (uint32_t i = 0; i < geometry->point_count; ++i) {
		uvs[i] = corners[i % 4];
	}
	return with_uvs(*geometry, 0, uvs, arena);
}

const Geometry *with_round_uvs(const Geometry *geometry, uint32_t sides, Arena &arena) {
	const double start = -0.5 / double(sides); // of the first side, whose middle looks to +z
	glm::dvec2 *uvs = arena.allocate<glm::dvec2>(geometry->point_count);
	for (uint32_t f = 0; f < geometry->face_count; ++f) {
		const uint32_t first = geometry->first_point(geometry->faces[f].first_loop), count = geometry->face_point_count(geometry->faces[f]);
		const int axis = flat_axis(*geometry, first, count);
		if (axis < 0) {
			add_side(*geometry, first, count, start, uvs);
			continue;
		}
		for (uint32_t i = first; i < first + count; ++i) {
			uvs[i] = flat_uv(geometry->points[i], axis);
		}
	}
	return with_uvs(*geometry, 0, uvs, arena);
}

const CornerData *cut_block_corners(const Geometry &block, int axis, double a, double b, Arena &arena) {
	const double middle = 0.5 * (block.low[axis] + block.high[axis]);
	const auto is_high = [&](uint32_t corner) { return block.points[corner][axis] > middle; };
	CornerData *result = arena.make(*block.corners);
	for (size_t set = 0; set < uv_set_count; ++set) {
		const glm::dvec2 *source = block.corners->uvs[set];
		if (source == nullptr) {
			continue;
		}
		glm::dvec2 *uvs = arena.allocate<glm::dvec2>(block.point_count);
		for (uint32_t i = 0; i < block.point_count; ++i) { // four corners for each face
			const uint32_t next = i / 4 * 4 + (i + 1) % 4, previous = i / 4 * 4 + (i + 3) % 4;
			const uint32_t other = is_high(next) != is_high(i) ? next : previous;
			const bool is_end = is_high(other) == is_high(i);
			const double share = is_high(i) ? 1.0 - b : a; // of the way to the other end
			uvs[i] = is_end ? (share > 0.0 ? no_uv() : source[i]) : source[i] + (source[other] - source[i]) * share;
		}
		result->uvs[set] = uvs;
	}
	return result;
}

} // namespace pcg::cga
