#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "core/cga/geometry.h"

// Cuts polygons with planes. Concave faces fall into as many pieces as there are, holes stay holes or become part of the outline, and the cuts
// of hollow bodies are capped.
namespace pcg::cga {

struct Plane {
	glm::dvec3 normal{ 0.0, 1.0, 0.0 }; // towards the side that stays
	double offset = 0.0; // normal . p of its points
};

class Clipper {
public:
	enum class Cuts {
		Closed,
		Open
	};

	// What lies on the plane's positive side; nullptr if nothing does. The geometry itself if nothing is cut away. Pieces keep the face's
	// first edge where it survives; where it is cut away, the cut takes its place.
	const Geometry *clip(const Geometry &geometry, const Plane &plane, Arena &arena, Cuts cuts = Cuts::Closed);
	// The same along a line of constant u (axis 0) or v of a set that the geometry has: what lies above `at`, or below. Corners without coordinates
	// are cut away; there are no caps.
	const Geometry *clip_uv(const Geometry &geometry, size_t set, int axis, double at, bool keeps_above, Arena &arena);

private:
	// A run of corners on the positive side, between the point where the outline comes in and the point where it goes out.
	struct Chain {
		uint32_t first = 0, end = 0; // in _chain_points
		double enter = 0.0, leave = 0.0; // where on the cut
		uint32_t next = 0; // chain that goes on where this one leaves
		bool has_first_edge = false; // the face's first edge begins at corner `first_edge`
		uint32_t first_edge = 0;
		bool is_used = false;
	};
	struct Crossing {
		double at;
		uint32_t chain;
		bool is_enter;
	};
	// An end of an edge that lies in the plane with the face above it: a corner of the cut.
	struct FlushCorner {
		double at; // on the cut
		glm::dvec3 point;
		uint32_t corner;
		bool is_kept; // the face gets it as a corner
	};
	struct Segment {
		glm::dvec3 from, to;
		uint32_t number = 0; // in order of the faces that were cut
		bool is_used = false;
	};

	// How far the points of a face, or of all, lie to both sides.
	struct Sides {
		double least = INFINITY, most = -INFINITY;
		uint32_t zeros = 0; // that lie on the plane
		bool are_cut() const { return most > 0.0 && least < 0.0; }
	};

	const Geometry *with_caps_first(const Geometry &geometry, size_t caps, Arena &arena); // `caps`: number of the first
	void measure(const Geometry &geometry, const Plane &plane);
	void measure_uv(const Geometry &geometry, double at, bool keeps_above);
	Sides sides_of(uint32_t first, uint32_t count) const;
	void clip_faces(const Geometry &geometry, const Sides &all);
	void clip_face(const Geometry &geometry, const GeometryFace &face, const Sides &sides);
	bool clip_edge(const Geometry &geometry, const GeometryFace &face);
	bool clip_simple(const Geometry &geometry, const GeometryFace &face);
	void clip_any(const Geometry &geometry, const GeometryFace &face, glm::dvec3 normal);
	double place_on_cut(glm::dvec3 point, const CornerOrigin &origin) const;
	void collect_chains(const Geometry &geometry, uint32_t loop, bool is_outline);
	glm::dvec3 cut_point(const Geometry &geometry, uint32_t a, uint32_t b, CornerOrigin &origin) const;
	void add_chain_point(glm::dvec3 point, CornerOrigin origin);
	void collect_flush_corners(const Geometry &geometry, const GeometryFace &face);
	void unite_flush_corners();
	bool has_neighbor(const Geometry &geometry, glm::dvec3 from, glm::dvec3 to) const;
	void add_cut(const Chain &from, const Chain &to);
	void cancel_opposite_cuts();
	void pair_chains();
	void emit_pieces(const Geometry &geometry, const GeometryFace &face, glm::dvec3 normal);
	void emit_outline(uint32_t chain);
	void add_holes(const Geometry &geometry, const std::vector<glm::dvec3> &outline, glm::dvec3 normal);
	bool add_caps(const Plane &plane);
	void emit_caps(const std::vector<std::vector<glm::dvec3>> &outlines, const std::vector<std::vector<glm::dvec3>> &holes, glm::dvec3 normal);
	bool cap_loop(uint32_t first, std::vector<glm::dvec3> &loop);
	Segment *next_cut(glm::dvec3 at);

	GeometryBuilder _builder;
	std::vector<double> _distances; // of each point of the geometry to the plane
	glm::dvec3 _normal{ 0.0 }; // of the plane
	glm::dvec3 _along{ 0.0 }; // of the cut in the present face
	const glm::dvec2 *_uvs = nullptr; // where the cut is made in the texture, along _uv_axis
	int _uv_axis = 0;
	std::vector<Chain> _chains;
	std::vector<glm::dvec3> _chain_points;
	std::vector<CornerOrigin> _chain_origins; // of the chain points; empty if corners carry nothing
	std::vector<FlushCorner> _flush_corners; // of the present face, in order along the cut
	bool _is_square = false; // the present face, to the plane
	bool _has_flush_edges = false; // some face has an edge in the plane, or a corner
	std::vector<Crossing> _crossings;
	std::vector<uint32_t> _whole_holes; // loops of the face that the cut does not meet
	std::vector<uint32_t> _order; // chains of one outline, or cuts around caps, in order
	std::vector<Segment> _cuts;
	double _margin = 0.0; // ends of cuts that are closer are one point
	std::vector<glm::dvec3> _outline;
	std::vector<CornerOrigin> _outline_origins;
};

} // namespace pcg::cga
