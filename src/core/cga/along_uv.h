#pragma once

#include <cstdint>

#include "core/cga/clip.h"
#include "core/cga/geometry.h"

// Bends copies of an asset along texture coordinates (CGA reference: op_insertAlongUV): its x becomes u, its z becomes -v, its y the height. One copy
// lies in each square of 1 x 1 of the coordinates, cut off where the surface ends.
namespace pcg::cga {

struct AlongUv {
	enum class Direction : uint8_t { ScopeY, VertexNormal };

	size_t uv_set = 0;
	double height = 0.0; // metres; below 0: to the other side
	Direction direction = Direction::ScopeY;
	bool keeps_position = false; // y counts from the asset's origin rather than from its lowest point
	uint64_t max_faces = 1'000'000;
};

struct AlongUvResult {
	const Geometry *geometry = nullptr; // nullptr: nothing lies on the surface
	bool is_cut_short = false; // by max_faces
};

// `ground` in scope coordinates; only its triangles and quads take part. Both may lie in the arena.
AlongUvResult insert_along_uv(const Geometry &ground, const Geometry &asset, const AlongUv &settings, Clipper &clipper, Arena &arena);

} // namespace pcg::cga
