#include "core/geometry/wavefront.h"

#include <cmath>

#include <glm/geometric.hpp>

// What happens to the front at one moment: sides vanish, fold onto each other, or are hit by inner corners.
namespace pcg {

bool Wavefront::clean_up() {
	while (collapse_one() || fold_one() || split_one()) {
		remove_dead();
		if (_changes_left-- == 0 || !has_work_left()) {
			return false;
		}
	}
	return true;
}

void Wavefront::remove_dead() {
	erase_if(_active, [this](uint32_t v) { return !_vertices[v].is_active; });
}

bool Wavefront::collapse_one() {
	for (uint32_t v : _active) {
		const uint32_t u = _vertices[v].next;
		// A step between collinear sides begins without length and grows.
		const bool is_growing_step = _edges[_vertices[v].after_edge].source == no_source && length_rate(v) > 0.0;
		if (u != v && (length(v) > 4.0 * _tolerance || is_growing_step)) {
			continue;
		}
		const uint32_t node = add_node(_vertices[v].position);
		const uint32_t before = _vertices[v].previous, after = _vertices[u].next;
		end_vertex(v, node);
		if (u == v) {
			return true;
		}
		end_vertex(u, node);
		if (after == v) {
			return true; // the loop had these two only
		}
		add_vertex(before, _vertices[v].before_edge, _vertices[u].after_edge, after, node);
		return true;
	}
	return false;
}

// Two neighbouring sides that lie on each other, back to back, close to a ridge up to the nearer end.
bool Wavefront::fold_one() {
	for (uint32_t v : _active) {
		const Vertex tip = _vertices[v];
		if (!is_spike(tip) || tip.previous == v) {
			continue;
		}
		const double before_length = length(tip.previous), after_length = length(v);
		const bool before_is_shorter = before_length <= after_length;
		const uint32_t other = before_is_shorter ? tip.previous : tip.next;
		const uint32_t node = add_node(tip.position), other_node = add_node(_vertices[other].position);
		end_vertex(v, node);
		add_border(tip.before_edge, node, other_node);
		add_border(tip.after_edge, other_node, node);
		end_vertex(other, other_node);
		const Vertex ended = _vertices[other];
		if (tip.previous == tip.next) {
			return true; // the whole loop closed
		}
		const Vertex &first = before_is_shorter ? ended : tip, &second = before_is_shorter ? tip : ended;
		add_vertex(first.previous, first.before_edge, second.after_edge, second.next, other_node);
		return true;
	}
	return false;
}

bool Wavefront::split_one() {
	for (uint32_t v : _active) {
		if (!is_reflex(_vertices[v])) {
			continue;
		}
		for (uint32_t s : _active) {
			const Vertex &vertex = _vertices[v], &start = _vertices[s];
			if (start.after_edge == vertex.before_edge || start.after_edge == vertex.after_edge || s == v || start.next == v) {
				continue;
			}
			const Edge &edge = _edges[start.after_edge];
			const double rate = glm::dot(edge.normal, vertex.velocity) - edge.speed;
			if (std::abs(gap(vertex, edge)) > 4.0 * _tolerance || rate > -1e-12) {
				continue;
			}
			const double along = glm::dot(vertex.position - start.position, edge.direction);
			if (along < -4.0 * _tolerance || along > length(s) + 4.0 * _tolerance) {
				continue;
			}
			split(v, s, add_node(vertex.position));
			return true;
		}
	}
	return false;
}

// `vertex` has reached the side that begins at `hit`, within it or at one of its ends.
void Wavefront::split(uint32_t vertex, uint32_t hit, uint32_t node) {
	const double near = 10.0 * _tolerance;
	const uint32_t end = _vertices[hit].next;
	const glm::dvec2 position = _vertices[vertex].position;
	if (glm::length(_vertices[hit].position - position) <= near) {
		swap_links(vertex, hit, node);
		return;
	}
	if (glm::length(_vertices[end].position - position) <= near) {
		swap_links(vertex, end, node);
		return;
	}
	const Vertex ended = _vertices[vertex];
	const uint32_t side = _vertices[hit].after_edge;
	end_vertex(vertex, node);
	add_vertex(ended.previous, ended.before_edge, side, end, node);
	add_vertex(hit, side, ended.after_edge, ended.next, node);
}

// Two vertices meet: each goes on with the side behind the other. Where they are neighbours the side between them has no length and ends here.
void Wavefront::swap_links(uint32_t a, uint32_t b, uint32_t node) {
	const Vertex old_a = _vertices[a], old_b = _vertices[b];
	end_vertex(a, node);
	end_vertex(b, node);
	if (old_a.previous != b) {
		add_vertex(old_a.previous, old_a.before_edge, old_b.after_edge, old_b.next, node);
	}
	if (old_b.previous != a) {
		add_vertex(old_b.previous, old_b.before_edge, old_a.after_edge, old_a.next, node);
	}
}

} // namespace pcg
