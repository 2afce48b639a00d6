#include "core/geometry/wavefront.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace pcg {

namespace {

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

constexpr double parallel_sine = 1e-9; // below it two edges count as parallel
constexpr double onward_sine = 1e-7; // below it one goes on where the other ends
constexpr double never = std::numeric_limits<double>::infinity();

} // namespace

Wavefront::Wavefront(const Loops2 &loops, std::span<const double> speeds, bool with_walls) : _with_walls(with_walls) {
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
	for (uint32_t v = 0, count = uint32_t(_vertices.size()); v < count; ++v) {
		_active.push_back(v);
		settle(v);
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
		const double speed = speeds.empty() ? 1.0 : speeds[source];
		_edges.push_back({ direction, normal, glm::dot(normal, a), speed, source, speed > 0.0 || _with_walls ? source : no_source });
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

bool Wavefront::needs_step(const Vertex &vertex) const {
	const Edge &before = _edges[vertex.before_edge], &after = _edges[vertex.after_edge];
	return before.speed != after.speed && std::abs(cross(before.direction, after.direction)) < onward_sine && glm::dot(before.direction, after.direction) > 0.0;
}

// Between collinear edges of different speed the front opens a step at right angles that itself stands still. Gives the corner behind it.
uint32_t Wavefront::add_step(uint32_t vertex) {
	const Vertex corner = _vertices[vertex];
	const Edge before = _edges[corner.before_edge];
	const glm::dvec2 direction = _edges[corner.after_edge].speed > before.speed ? before.normal : -before.normal;
	const glm::dvec2 normal(-direction.y, direction.x);
	const uint32_t step = uint32_t(_edges.size()), behind = uint32_t(_vertices.size());
	const uint32_t face = _with_walls ? 2 * _edge_count + _step_count++ : no_source;
	_edges.push_back({ direction, normal, glm::dot(normal, corner.position), 0.0, no_source, face });
	_vertices.push_back({ step, corner.after_edge, 0, 0, corner.birth, corner.position, glm::dvec2(0.0), true });
	_vertices[vertex].after_edge = step;
	link(vertex, behind);
	set_velocity(_vertices[vertex]);
	set_velocity(_vertices[behind]);
	_active.push_back(behind);
	return behind;
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

void Wavefront::add_vertex(uint32_t previous, uint32_t before_edge, uint32_t after_edge, uint32_t next, uint32_t node) {
	const uint32_t vertex = uint32_t(_vertices.size());
	_vertices.push_back({ before_edge, after_edge, vertex, vertex, node, _nodes[node].position, glm::dvec2(0.0), true });
	_active.push_back(vertex);
	link(previous, vertex);
	link(vertex, next);
	settle(vertex);
}

// How a linked vertex moves; where its sides lie in one line and move at different speeds a second vertex is put behind it.
void Wavefront::settle(uint32_t vertex) {
	set_velocity(_vertices[vertex]);
	if (needs_step(_vertices[vertex])) {
		const uint32_t next = _vertices[vertex].next;
		link(add_step(vertex), next);
	}
}

void Wavefront::link(uint32_t a, uint32_t b) {
	_vertices[a].next = b;
	_vertices[b].previous = a;
}

void Wavefront::set_velocity(Vertex &vertex) const {
	const Edge &before = _edges[vertex.before_edge], &after = _edges[vertex.after_edge];
	const double sine = cross(before.direction, after.direction), cosine = glm::dot(before.direction, after.direction);
	const bool is_needle = std::abs(sine) < 0.01 && cosine < 0.0; // the sum of its normals has few digits left
	if (std::abs(sine) < parallel_sine && cosine < 0.0) {
		vertex.velocity = glm::dvec2(0.0); // a fold; it closes at once
	} else if (before.speed == after.speed && !is_needle) {
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
	return std::abs(cross(a, b)) < onward_sine && glm::dot(a, b) < 0.0;
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
	_first_node_now = step > 0.0 ? uint32_t(_nodes.size()) : _first_node_now;
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
	return true;
}

bool Wavefront::has_work_left() {
	const auto reflex = std::count_if(_active.begin(), _active.end(), [this](uint32_t v) { return is_reflex(_vertices[v]); });
	_tests_left -= double(_active.size()) * double(reflex + 1);
	return _tests_left > 0.0;
}

void Wavefront::end_vertex(uint32_t vertex, uint32_t node) {
	Vertex &ended = _vertices[vertex];
	add_border(ended.before_edge, ended.birth, node);
	add_border(ended.after_edge, node, ended.birth);
	ended.is_active = false;
}

void Wavefront::add_border(uint32_t edge, uint32_t from, uint32_t to) {
	if (from != to && _edges[edge].face != no_source) {
		_borders.push_back({ _edges[edge].face, from, to });
	}
}

void Wavefront::set_speeds(std::span<const double> speeds) {
	SmallVector<bool, 8> is_changing;
	for (const Edge &edge : _edges) {
		is_changing.push_back(edge.source != no_source && edge.speed != speeds[edge.source]);
	}
	SmallVector<uint32_t, 8> corners;
	for (const uint32_t v : _active) {
		Vertex &vertex = _vertices[v];
		if (is_changing[vertex.before_edge] || is_changing[vertex.after_edge]) {
			const uint32_t node = add_node(vertex.position);
			add_border(vertex.before_edge, vertex.birth, node);
			add_border(vertex.after_edge, node, vertex.birth);
			vertex.birth = node;
			corners.push_back(v);
		}
	}
	const auto add_sides = [&](bool is_begun) {
		for (const uint32_t v : corners) {
			const uint32_t edge = _vertices[v].after_edge, from = _vertices[v].birth, to = _vertices[_vertices[v].next].birth;
			if (is_changing[edge]) {
				is_begun ? add_border(edge, from, to) : add_border(edge, to, from);
			}
		}
	};
	add_sides(false);
	for (uint32_t e = 0; e < is_changing.size(); ++e) {
		if (is_changing[e]) {
			_edges[e].offset += (_edges[e].speed - speeds[_edges[e].source]) * _time;
			_edges[e].speed = speeds[_edges[e].source];
			_edges[e].face += _edge_count;
		}
	}
	add_sides(true);
	for (const uint32_t v : corners) {
		settle(v);
	}
	_changes_left = 8 * _vertices.size() + 64;
}

glm::dvec2 Wavefront::in_face(uint32_t face, uint32_t node) const {
	const bool is_wall = _with_walls && (face < _edge_count || face >= 2 * _edge_count);
	if (!is_wall) {
		return _nodes[node].position;
	}
	const auto edge = std::ranges::find_if(_edges, [&](const Edge &e) { return face < _edge_count ? e.source == face : e.face == face; });
	return { glm::dot(edge->direction, _nodes[node].position), _nodes[node].time };
}

void Wavefront::finish() {
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
			if (final_node[v] != final_node[_vertices[v].next]) { // a step that begins right now has no length
				front.points.push_back(_nodes[final_node[v]].position);
				front.edges.push_back(edge.source);
			}
		}
		if (front.points.size() > 2) {
			_fronts.push_back(std::move(front));
		}
	}
}

} // namespace pcg
