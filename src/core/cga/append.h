#pragma once

#include <span>

#include "core/cga/frames.h"
#include "core/cga/geometry.h"

namespace pcg::cga {

// Geometries one behind the other; nothing is joined.
class Appender {
public:
	// `parts`: all that will be added; nullptr stands for nothing.
	Appender(Arena &arena, std::span<const Geometry *const> parts);

	// `to_target` from the part's coordinates.
	void add(const Geometry &source, const Frame &to_target);
	const Geometry *finish();

private:
	void add_corners(const Geometry &source, const Frame &to_target);
	const glm::dvec2 *uvs(size_t set);
	const glm::dvec3 *normals();

	Arena &_arena;
	Geometry _result;
	glm::dvec3 *_points = nullptr;
	uint32_t *_loop_ends = nullptr;
	GeometryFace *_faces = nullptr;
	CornerData *_corners = nullptr;
	bool _has_corners = false, _is_closed = true;
	uint32_t _point = 0, _loop = 0, _face = 0;
};

} // namespace pcg::cga
