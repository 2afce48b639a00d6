#include "core/geometry/wavefront.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace pcg {

namespace {

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

constexpr double parallel_sine = 1e-9; // below it two edges count as parallel
constexpr double never = std::numeric_limits<double>::infinity();

} // namespace

Wavefront::Wavefront(const Loops2 &loops, std::span<const double> speeds) {
	glm::dvec2 low(never), high(-never);
	for (const auto &loop : loops) {
		for (const glm::dvec2 &point : loop) {
			low = glm::min(low, point);
			high = glm::max(high, point);
		}
	}
	_tolerance = std::max(1e-12, 1e-9 * glm::length(high - low));
	reserve(loops);
	for (const auto &loop : loops) {
		add_loop(loop, speeds);
	}
	add_steps();
	for (Vertex &vertex : _vertices) {
		set_velocity(vertex);
		_active.push_back(uint32_t(&vertex - _vertices.data()));
	}
	_changes_left = 8 * _vertices.size() + 64;
}

// Repeated points are left out: their edge has no length and no face.
void Wavefront::add_loop(const Loop2 &loop, std::span<const double> speeds) {
	const size_t count = loop.size();
	_edge_count += uint32_t(count);
	const uint32_t first_vertex = uint32_t(_vertices.size());
	for (size_t i = 0; i < count; ++i) {
		const glm::dvec2 a = loop[i], b = loop[(i + 1) % count];
		const double distance = glm::length(b - a);
		if (distance <= _tolerance) {
			continue;
		}
		const glm::dvec2 direction = (b - a) / distance;
		const glm::dvec2 normal(-direction.y, direction.x);
		const uint32_t source = _edge_count - uint32_t(count - i);
		const uint32_t edge = uint32_t(_edges.size());
		_edges.push_back({ direction, normal, glm::dot(normal, a), speeds.empty() ? 1.0 : speeds[source], source });
		_nodes.push_back({ a, 0.0 });
		_vertices.push_back({ edge - 1, edge, 0, 0, uint32_t(_nodes.size()) - 1, a, glm::dvec2(0.0), true });
	}
	const uint32_t end = uint32_t(_vertices.size());
	if (end - first_vertex < 3) {
		_vertices.resize(first_vertex);
		return;
	}
	_vertices[first_vertex].before_edge = _vertices[end - 1].after_edge;
	for (uint32_t v = first_vertex; v < end; ++v) {
		const uint32_t next = v + 1 < end ? v + 1 : first_vertex;
		link(v, next);
		add_border(_vertices[v].after_edge, _vertices[v].birth, _vertices[next].birth);
	}
}

// Between collinear edges of different speed the front opens a step at right angles that itself stands still.
void Wavefront::add_steps() {
	for (uint32_t v = 0, count = uint32_t(_vertices.size()); v < count; ++v) {
		const Edge before = _edges[_vertices[v].before_edge], after = _edges[_vertices[v].after_edge];
		const bool is_straight = std::abs(cross(before.direction, after.direction)) < 1e-7 && glm::dot(before.direction, after.direction) > 0.0;
		if (!is_straight || before.speed == after.speed) {
			continue;
		}
		const glm::dvec2 direction = after.speed > before.speed ? before.normal : -before.normal;
		const glm::dvec2 normal(-direction.y, direction.x);
		const uint32_t step = uint32_t(_edges.size());
		_edges.push_back({ direction, normal, glm::dot(normal, _vertices[v].position), 0.0, no_source });
		const Vertex old = _vertices[v];
		const uint32_t added = uint32_t(_vertices.size());
		_vertices.push_back({ step, old.after_edge, 0, 0, old.birth, old.position, glm::dvec2(0.0), true });
		_vertices[v].after_edge = step;
		link(added, old.next);
		link(v, added);
	}
}

uint32_t Wavefront::add_node(glm::dvec2 position) {
	for (uint32_t node = _first_node_now; node < _nodes.size(); ++node) {
		if (glm::length(_nodes[node].position - position) <= 10.0 * _tolerance) {
			return node;
		}
	}
	_nodes.push_back({ position, _time });
	return uint32_t(_nodes.size()) - 1;
}

uint32_t Wavefront::add_vertex(uint32_t before_edge, uint32_t after_edge, uint32_t node) {
	const uint32_t vertex = uint32_t(_vertices.size());
	_vertices.push_back({ before_edge, after_edge, vertex, vertex, node, _nodes[node].position, glm::dvec2(0.0), true });
	set_velocity(_vertices.back());
	_active.push_back(vertex);
	return vertex;
}

void Wavefront::link(uint32_t a, uint32_t b) {
	_vertices[a].next = b;
	_vertices[b].previous = a;
}

void Wavefront::set_velocity(Vertex &vertex) const {
	const Edge &before = _edges[vertex.before_edge], &after = _edges[vertex.after_edge];
	const double sine = cross(before.direction, after.direction), cosine = glm::dot(before.direction, after.direction);
	if (std::abs(sine) < parallel_sine && cosine < 0.0) {
		vertex.velocity = glm::dvec2(0.0); // a fold; it closes at once
	} else if (before.speed == after.speed) {
		vertex.velocity = before.speed * (before.normal + after.normal) / (1.0 + cosine);
	} else if (std::abs(sine) < parallel_sine) {
		vertex.velocity = before.normal * std::min(before.speed, after.speed);
	} else {
		// On both lines for all times: before.normal . v = before.speed, after.normal . v = after.speed.
		const double along = (after.speed - before.speed * cosine) / -sine;
		vertex.velocity = before.speed * before.normal + along * before.direction;
	}
}

bool Wavefront::is_reflex(const Vertex &vertex) const {
	return cross(_edges[vertex.before_edge].direction, _edges[vertex.after_edge].direction) < -parallel_sine;
}

bool Wavefront::is_spike(const Vertex &vertex) const {
	const glm::dvec2 a = _edges[vertex.before_edge].direction, b = _edges[vertex.after_edge].direction;
	return std::abs(cross(a, b)) < 1e-7 && glm::dot(a, b) < 0.0;
}

// Of the side of the front that begins at `vertex`.
double Wavefront::length(uint32_t vertex) const {
	const Vertex &a = _vertices[vertex], &b = _vertices[a.next];
	return glm::dot(b.position - a.position, _edges[a.after_edge].direction);
}

double Wavefront::length_rate(uint32_t vertex) const {
	const Vertex &a = _vertices[vertex], &b = _vertices[a.next];
	return glm::dot(b.velocity - a.velocity, _edges[a.after_edge].direction);
}

// How far the vertex still is from the moving line of the edge; positive on its inner side.
double Wavefront::gap(const Vertex &vertex, const Edge &edge) const {
	return glm::dot(edge.normal, vertex.position) - (edge.offset + edge.speed * _time);
}

double Wavefront::next_event(double limit) const {
	double earliest = limit;
	for (uint32_t v : _active) {
		const double rate = length_rate(v);
		if (rate < -1e-12) {
			earliest = std::min(earliest, _time + std::max(0.0, length(v)) / -rate);
		}
		if (is_reflex(_vertices[v])) {
			earliest = next_split(_vertices[v], earliest);
		}
	}
	return earliest;
}

double Wavefront::next_split(const Vertex &vertex, double limit) const {
	for (uint32_t v : _active) {
		const Vertex &start = _vertices[v], &end = _vertices[start.next];
		if (start.after_edge == vertex.before_edge || start.after_edge == vertex.after_edge) {
			continue;
		}
		const Edge &edge = _edges[start.after_edge];
		const double distance = gap(vertex, edge), rate = glm::dot(edge.normal, vertex.velocity) - edge.speed;
		if (rate > -1e-12 || distance < -_tolerance) {
			continue;
		}
		const double wait = std::max(0.0, distance) / -rate;
		if (_time + wait >= limit) {
			continue;
		}
		const glm::dvec2 hit = vertex.position + vertex.velocity * wait;
		const double from_start = glm::dot(hit - (start.position + start.velocity * wait), edge.direction);
		const double to_end = glm::dot(end.position + end.velocity * wait - hit, edge.direction);
		if (from_start >= -_tolerance && to_end >= -_tolerance) {
			limit = _time + wait;
		}
	}
	return limit;
}

void Wavefront::advance(double time) {
	const double step = time - _time;
	for (uint32_t v : _active) {
		_vertices[v].position += _vertices[v].velocity * step;
	}
	_time = time;
	_first_node_now = uint32_t(_nodes.size());
}

bool Wavefront::run(double max_time) {
	// Each event removes a vertex or a reflex corner; the factor leaves room for events that fall together.
	size_t events_left = 8 * _vertices.size() + 64;
	while (!_active.empty()) {
		const double time = next_event(max_time);
		if (time == never || events_left-- == 0 || !has_work_left()) {
			return false;
		}
		const bool is_last = time >= max_time;
		advance(is_last ? max_time : time);
		if (!clean_up()) {
			return false;
		}
		if (is_last) {
			break;
		}
	}
	collect_fronts();
	return true;
}

bool Wavefront::clean_up() {
	while (collapse_one() || fold_one() || split_one()) {
		remove_dead();
		if (_changes_left-- == 0 || !has_work_left()) {
			return false;
		}
	}
	return true;
}

bool Wavefront::has_work_left() {
	const auto reflex = std::count_if(_active.begin(), _active.end(), [this](uint32_t v) { return is_reflex(_vertices[v]); });
	_tests_left -= double(_active.size()) * double(reflex + 1);
	return _tests_left > 0.0;
}

void Wavefront::remove_dead() {
	erase_if(_active, [this](uint32_t v) { return !_vertices[v].is_active; });
}

void Wavefront::end_vertex(uint32_t vertex, uint32_t node) {
	Vertex &ended = _vertices[vertex];
	add_border(ended.before_edge, ended.birth, node);
	add_border(ended.after_edge, node, ended.birth);
	ended.is_active = false;
}

void Wavefront::add_border(uint32_t edge, uint32_t from, uint32_t to) {
	// A side that stands still sweeps nothing.
	if (from != to && _edges[edge].source != no_source && _edges[edge].speed > 0.0) {
		_borders.push_back({ _edges[edge].source, from, to });
	}
}

bool Wavefront::collapse_one() {
	for (uint32_t v : _active) {
		const uint32_t u = _vertices[v].next;
		// A step between collinear sides begins without length and grows.
		const bool is_growing_step = _edges[_vertices[v].after_edge].source == no_source && length_rate(v) >= 0.0;
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
		const uint32_t merged = add_vertex(_vertices[v].before_edge, _vertices[u].after_edge, node);
		link(before, merged);
		link(merged, after);
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
		const uint32_t merged = before_is_shorter ? add_vertex(ended.before_edge, tip.after_edge, other_node)
												  : add_vertex(tip.before_edge, ended.after_edge, other_node);
		link(before_is_shorter ? ended.previous : tip.previous, merged);
		link(merged, before_is_shorter ? tip.next : ended.next);
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
	const uint32_t first = add_vertex(ended.before_edge, side, node), second = add_vertex(side, ended.after_edge, node);
	link(ended.previous, first);
	link(first, end);
	link(hit, second);
	link(second, ended.next);
}

// Two vertices meet: each goes on with the side behind the other.
void Wavefront::swap_links(uint32_t a, uint32_t b, uint32_t node) {
	const Vertex old_a = _vertices[a], old_b = _vertices[b];
	end_vertex(a, node);
	end_vertex(b, node);
	const uint32_t first = add_vertex(old_a.before_edge, old_b.after_edge, node);
	const uint32_t second = add_vertex(old_b.before_edge, old_a.after_edge, node);
	link(old_a.previous, first);
	link(first, old_b.next);
	link(old_b.previous, second);
	link(second, old_a.next);
}

void Wavefront::collect_fronts() {
	SmallVector<bool, 8> is_done(_vertices.size(), false);
	SmallVector<uint32_t, 8> final_node(_vertices.size());
	for (uint32_t v : _active) {
		final_node[v] = add_node(_vertices[v].position);
		add_border(_vertices[v].before_edge, _vertices[v].birth, final_node[v]);
		add_border(_vertices[v].after_edge, final_node[v], _vertices[v].birth);
	}
	for (uint32_t first : _active) {
		SkeletonFront front;
		for (uint32_t v = first; !is_done[v]; v = _vertices[v].next) {
			is_done[v] = true;
			const Edge &edge = _edges[_vertices[v].after_edge];
			add_border(_vertices[v].after_edge, final_node[_vertices[v].next], final_node[v]);
			front.points.push_back(_nodes[final_node[v]].position);
			front.edges.push_back(edge.source);
		}
		if (front.points.size() > 2) {
			_fronts.push_back(std::move(front));
		}
	}
}

} // namespace pcg
