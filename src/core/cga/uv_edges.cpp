#include "core/cga/uv_edges.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

// Where the normal of the edge a-b points to on the texture.
UvSide facing(glm::dvec2 a, glm::dvec2 b, bool is_mirrored) {
	const glm::dvec2 right(b.y - a.y, a.x - b.x), normal = is_mirrored ? -right : right;
	if (std::abs(normal.x) >= std::abs(normal.y)) {
		return normal.x > 0.0 ? UvSide::Right : UvSide::Left;
	}
	return normal.y > 0.0 ? UvSide::Top : UvSide::Bottom;
}

bool is_at_end(UvSide side, const Geometry &geometry, const glm::dvec2 *uvs, glm::dvec2 a, glm::dvec2 b) {
	const int axis = side == UvSide::UMin || side == UvSide::UMax ? 0 : 1;
	double low = INFINITY, high = -INFINITY;
	for (uint32_t i = 0; i < geometry.point_count; ++i) {
		if (has_uv(uvs[i])) {
			low = std::min(low, uvs[i][axis]);
			high = std::max(high, uvs[i][axis]);
		}
	}
	const double end = side == UvSide::UMin || side == UvSide::VMin ? low : high, margin = 1e-6 * (high - low);
	return std::abs(a[axis] - end) <= margin && std::abs(b[axis] - end) <= margin;
}

} // namespace

UvSide uv_side_of(std::string_view word) {
	static constexpr std::string_view words[] = { "", "uv.left", "uv.right", "uv.bottom", "uv.top", "uv.uMin", "uv.uMax", "uv.vMin", "uv.vMax" };
	const auto found = std::ranges::find(words, word);
	return found == std::end(words) ? UvSide::None : UvSide(found - std::begin(words));
}

bool matches(UvSide side, const Geometry &geometry, const GeometryFace &face, uint32_t from, uint32_t to, size_t set) {
	const glm::dvec2 *uvs = set < uv_set_count ? geometry.uvs(set) : nullptr;
	if (uvs == nullptr || side == UvSide::None || !has_uv(uvs[from]) || !has_uv(uvs[to])) {
		return false;
	}
	if (side >= UvSide::UMin) {
		return is_at_end(side, geometry, uvs, uvs[from], uvs[to]);
	}
	const uint32_t first = geometry.first_point(face.first_loop), end = geometry.loop_ends[face.first_loop];
	return facing(uvs[from], uvs[to], signed_area({ uvs + first, uvs + end }) < 0.0) == side;
}

} // namespace pcg::cga
