#pragma once

#include <cstdint>
#include <span>

#include <glm/vec2.hpp>

#include "core/geometry/straight_skeleton.h"

// The moving front behind straight_skeleton(): loops of vertices between moving edges. At each event time the whole front is looked at anew,
// so that events that fall together (every square has four) need no order among themselves.
namespace pcg {

class Wavefront {
public:
	// `with_walls`: all edges begin at speed 0 and what they sweep then are upright faces: time goes up.
	Wavefront(const Loops2 &loops, std::span<const double> speeds, bool with_walls = false);

	// Moves the front to `max_time` or until nothing is left. False if the events did not end.
	bool run(double max_time);
	// New speeds from now on, one for each edge, with walls only. An edge whose speed changes, once at most, goes on with face edge_count() + edge.
	void set_speeds(std::span<const double> speeds);
	// The front as it is becomes `fronts`, and the faces end there.
	void finish();

	// A place and time where vertices of the front began or ended.
	struct Node {
		glm::dvec2 position;
		double time;
	};
	// A piece of the outline of a face, directed so that the face lies to its left.
	struct Border {
		uint32_t face; // an edge, or with walls: edges, edges in motion, steps
		uint32_t from, to; // nodes
	};
	std::span<const Node> nodes() const { return _nodes; }
	std::span<const Border> borders() const { return _borders; }
	SmallVector<SkeletonFront, 1> &fronts() { return _fronts; }
	uint32_t edge_count() const { return _edge_count; }
	uint32_t face_count() const { return _with_walls ? 2 * _edge_count + _step_count : _edge_count; }
	// In the plan, or along a wall and up.
	glm::dvec2 in_face(uint32_t face, uint32_t node) const;

private:
	struct Edge {
		glm::dvec2 direction; // unit
		glm::dvec2 normal; // unit, inwards
		double offset; // normal . p of its line at time 0
		double speed;
		uint32_t source; // input edge; no_source for the step between collinear edges of different speed
		uint32_t face; // no_source: what it sweeps has no area and is not asked for
	};
	struct Vertex {
		uint32_t before_edge, after_edge;
		uint32_t previous, next; // vertices
		uint32_t birth; // node
		glm::dvec2 position; // at _time
		glm::dvec2 velocity;
		bool is_active;
	};
	static constexpr uint32_t no_source = 0xFFFFFFFF;

	// What most outlines need: each corner ends once, and two of them make one.
	void reserve(const Loops2 &loops) {
		size_t corners = 0;
		for (const auto &loop : loops) {
			corners += loop.size();
		}
		_edges.reserve(corners);
		_vertices.reserve(2 * corners);
		_active.reserve(2 * corners);
		_nodes.reserve(3 * corners);
		_borders.reserve(6 * corners);
	}
	void add_loop(const Loop2 &loop, std::span<const double> speeds);
	void settle(uint32_t vertex);
	bool needs_step(const Vertex &vertex) const;
	uint32_t add_step(uint32_t vertex);
	uint32_t add_node(glm::dvec2 position);
	void add_vertex(uint32_t previous, uint32_t before_edge, uint32_t after_edge, uint32_t next, uint32_t node);
	void link(uint32_t a, uint32_t b);
	void set_velocity(Vertex &vertex) const;
	bool is_reflex(const Vertex &vertex) const;
	bool is_spike(const Vertex &vertex) const;
	double length(uint32_t vertex) const;
	double length_rate(uint32_t vertex) const;
	double gap(const Vertex &vertex, const Edge &edge) const;

	double next_event(double limit) const;
	double next_split(const Vertex &vertex, double limit) const;
	void advance(double time);
	bool has_work_left();
	bool clean_up();
	bool collapse_one();
	bool fold_one();
	bool split_one();
	void end_vertex(uint32_t vertex, uint32_t node);
	void add_border(uint32_t edge, uint32_t from, uint32_t to);
	void split(uint32_t vertex, uint32_t hit, uint32_t node);
	void swap_links(uint32_t a, uint32_t b, uint32_t node);
	void remove_dead();
	// With room for outlines of four corners.
	SmallVector<Edge, 4> _edges;
	SmallVector<Vertex, 8> _vertices;
	SmallVector<uint32_t, 8> _active;
	SmallVector<Node, 12> _nodes;
	SmallVector<Border, 32> _borders;
	SmallVector<SkeletonFront, 1> _fronts;
	uint32_t _edge_count = 0;
	uint32_t _step_count = 0;
	bool _with_walls = false;
	uint32_t _first_node_now = 0; // nodes from here on were made at _time
	// An outline that crosses itself makes events without an end: both counters bound what is tried.
	size_t _changes_left = 0;
	double _tests_left = 1.5e9; // of corners against sides: some seconds
	double _time = 0.0;
	double _tolerance = 1e-9; // metres: 1e-9 of the diagonal
};

} // namespace pcg
