#pragma once

#include "core/cga/geometry.h"
#include "core/cga/shape.h"

// Texture coordinates of whole shapes (CGA reference, sections 4.2, 7.5 and 8.3).
namespace pcg::cga {

class Context;

// 0 .. 9, or -1 with a warning.
int uv_set_of(Context &context, const Value &value);

// Of all corners that have coordinates; `is_empty` if none has.
struct UvRange {
	glm::dvec2 low{ 0.0 }, high{ 0.0 };
	bool is_empty = true;

	glm::dvec2 size() const { return high - low; }
	void add(glm::dvec2 uv);
};
UvRange uv_range(const Geometry &geometry, size_t set);
UvRange uv_range(const Geometry &geometry, const GeometryFace &face, const glm::dvec2 *uvs);

// Metres on the surface that one unit of u, and of v, takes on the average: the mean of the stretch of all places, each weighted by the part of
// the texture that it covers. For a street that is its length along the middle. 0 where nothing is laid out.
glm::dvec2 uv_stretch(const Shape &shape, size_t set);

} // namespace pcg::cga
