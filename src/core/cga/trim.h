#pragma once

#include <cmath>
#include <vector>

#include "core/cga/clip.h"
#include "core/cga/shape.h"

// Trim planes (CGA reference, section 7.6): through each edge at which a face of comp(f) met another face in an angle, halfway between the two. What
// is inserted there later is cut by them, so that bricks and cornices meet at corners.
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
		// It ends where the edge ends in a corner that points into the face: between these places along the edge it is there.
		glm::dvec3 along{ 0.0 };
		double low = -INFINITY, high = INFINITY;
		bool is_horizontal = false;
		bool is_limited() const { return low > -INFINITY || high < INFINITY; }
	};
	// An edge of a face and the corners before and behind it.
	struct Edge {
		glm::dvec3 before, from, to, behind;
	};

	const std::vector<TrimPlane> &planes(const TrimSource &source, uint32_t face);
	void add_planes(const TrimSource &source, uint32_t face);
	void add_plane(const TrimSource &source, const GeometryFace &face, const GeometryFace &other, const Edge &edge, const glm::dmat3 &pivot);
	static void limit(TrimPlane &plane, const TrimSource &source, const GeometryFace &face, const Edge &edge);
	static TrimPlane in_scope(const TrimPlane &plane, const Frame &frame);
	static const Geometry *cut(const Geometry &geometry, const TrimPlane &plane, Clipper &clipper, Arena &arena);

	uint64_t _last_id = 0;
	// Inserted things come in rows along one face: its planes are kept until another face asks.
	uint64_t _known_id = 0;
	uint32_t _known_face = 0;
	std::vector<TrimPlane> _known;
};

} // namespace pcg::cga
