#include "core/cga/zone_prism.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

constexpr double flat = 1e-6;

glm::dvec3 raised_size(glm::dvec3 size, double flat_height) {
	for (int axis = 0; axis < 3; ++axis) {
		const bool others_span = std::abs(size[(axis + 1) % 3]) >= flat && std::abs(size[(axis + 2) % 3]) >= flat;
		if (std::abs(size[axis]) < flat && others_span) {
			size[axis] = flat_height;
			return size;
		}
	}
	return size;
}

// The scope axis closest to the vertical.
int upright_axis(const Frame &frame) {
	int up = 0;
	for (int axis = 1; axis < 3; ++axis) {
		up = std::abs(frame.axes[axis].y) > std::abs(frame.axes[up].y) ? axis : up;
	}
	return up;
}

std::vector<glm::dvec3> polygon_of(const Shape &shape, const Frame &frame) {
	std::vector<glm::dvec3> result;
	for (const glm::dvec3 &point : shape.geometry->outline(shape.geometry->faces[0])) {
		result.push_back(frame.to_parent(shape.to_scope(point)));
	}
	return result;
}

} // namespace

ZonePrism zone_prism(const Shape &shape, double flat_height) {
	const Frame frame = shape.frame();
	const int up = upright_axis(frame);
	const int a = (up + 1) % 3, b = (up + 2) % 3;
	const glm::dvec3 size = raised_size(shape.size, flat_height);
	const glm::dvec3 along_a = frame.axes[a] * size[a], along_b = frame.axes[b] * size[b], along_up = frame.axes[up] * size[up];

	ZonePrism prism;
	prism.outline = { frame.origin, frame.origin + along_a, frame.origin + along_a + along_b, frame.origin + along_b };
	double bottom = frame.origin.y, top = bottom;
	for (const glm::dvec3 &corner : prism.outline) {
		bottom = std::min({ bottom, corner.y, corner.y + along_up.y });
		top = std::max({ top, corner.y, corner.y + along_up.y });
	}
	prism.height = top - bottom;
	const bool is_polygon = shape.geometry != nullptr && shape.geometry->face_count == 1 && shape.geometry->point_count >= 3 && std::abs(shape.size[up]) < flat;
	if (is_polygon) {
		prism.outline = polygon_of(shape, frame);
	}
	for (glm::dvec3 &corner : prism.outline) {
		corner.y = bottom;
	}
	if (area_vector(prism.outline).y < 0.0) {
		std::ranges::reverse(prism.outline);
	}
	return prism;
}

} // namespace pcg::cga
