#pragma once

#include <vector>

#include "core/cga/clip.h"
#include "core/cga/shape.h"

// Trim planes (CGA reference, section 7.6): through each edge that a face of comp(f) shared with another face, halfway between the two. What is
// inserted there later is cut by them, so that bricks and cornices meet at corners.
namespace pcg::cga {

class Trimmer {
public:
	// Before a comp(f) makes its children: what they point to.
	const TrimSource *source_of(const Shape &shape, const Geometry &baked_geometry, bool keeps_axes, Arena &arena);
	// Cuts the geometry by the planes that are switched on; the scope stays. Nothing is left of geometry beyond them. Whether anything was cut away.
	bool trim(Shape &shape, Clipper &clipper, Arena &arena);

private:
	struct TrimPlane {
		Plane plane; // in the derivation's coordinates
		bool is_horizontal = false;
	};

	const std::vector<TrimPlane> &planes(const TrimSource &source, uint32_t face);
	void add_planes(const TrimSource &source, uint32_t face);
	void add_plane(const TrimSource &source, const GeometryFace &face, const GeometryFace &other, glm::dvec3 from, glm::dvec3 to, const glm::dmat3 &pivot);

	uint64_t _last_id = 0;
	// Inserted things come in rows along one face: its planes are kept until another face asks.
	uint64_t _known_id = 0;
	uint32_t _known_face = 0;
	std::vector<TrimPlane> _known;
};

} // namespace pcg::cga
