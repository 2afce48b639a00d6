#include <algorithm>
#include <cmath>
#include <iterator>
#include <queue>
#include <tuple>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "core/cga/cleanup.h"
#include "core/cga/face_groups.h"

// Takes vertices away one by one, each onto a neighbour, where the surface changes least (quadric error metric, Garland and Heckbert 1997).
namespace pcg::cga {

namespace {

using Corner = IndexedFaces::Corner;
using Face = IndexedFaces::Face;
using Loop = std::vector<Corner>;

// Sum of squared distances to planes.
struct Quadric {
	glm::dmat3 squares{ 0.0 };
	glm::dvec3 linear{ 0.0 };
	double constant = 0.0;

	void add_plane(glm::dvec3 normal, glm::dvec3 point, double weight) {
		const double offset = -glm::dot(normal, point);
		squares += weight * glm::outerProduct(normal, normal);
		linear += weight * offset * normal;
		constant += weight * offset * offset;
	}
	void add(const Quadric &other) {
		squares += other.squares;
		linear += other.linear;
		constant += other.constant;
	}
	double error(glm::dvec3 p) const { return std::max(glm::dot(p, squares * p) + 2.0 * glm::dot(linear, p) + constant, 0.0); }
};

struct Candidate {
	double cost;
	uint32_t from, to;
	uint32_t from_stamp, to_stamp;
	bool operator<(const Candidate &other) const { return std::tie(cost, from, to) > std::tie(other.cost, other.from, other.to); } // cheapest first
};

class Reducer {
public:
	explicit Reducer(IndexedFaces &indexed)
			: _indexed(indexed), _quadrics(indexed.vertices.size()), _faces_of(indexed.vertices.size()), _stamps(indexed.vertices.size(), 0),
			  _sources(indexed.vertices.size(), 0) {
		for (uint32_t f = 0; f < indexed.faces.size(); ++f) {
			note_face(f);
		}
		for (uint32_t vertex = 0; vertex < indexed.vertices.size(); ++vertex) {
			offer(vertex);
		}
	}

	void run(size_t count) {
		while (count > 0 && !_queue.empty()) {
			const Candidate candidate = _queue.top();
			_queue.pop();
			const bool is_fresh = _stamps[candidate.from] == candidate.from_stamp && _stamps[candidate.to] == candidate.to_stamp;
			if (is_fresh && may_collapse(candidate.from, candidate.to)) {
				collapse(candidate.from, candidate.to);
				--count;
			}
		}
	}

private:
	glm::dvec3 at(const Corner &corner) const { return _indexed.vertices[corner.vertex]; }

	void note_face(uint32_t f) {
		const Face &face = _indexed.faces[f];
		const glm::dvec3 normal = normal_of(_indexed, face);
		const double area = area_of(_indexed, face);
		for (const Loop &loop : face.loops) {
			for (size_t i = 0; i < loop.size(); ++i) {
				_quadrics[loop[i].vertex].add_plane(normal, at(loop[i]), area);
				_faces_of[loop[i].vertex].push_back(f);
				_sources[loop[i].vertex] = loop[i].source;
				add_rim(loop[i], loop[(i + 1) % loop.size()], normal);
			}
		}
	}

	// Edges hold their line: the border of a surface, and the bends of a body.
	void add_rim(const Corner &a, const Corner &b, glm::dvec3 normal) {
		const glm::dvec3 side = glm::cross(at(b) - at(a), normal);
		const double length = glm::length(side);
		if (length > 1e-12) {
			_quadrics[a.vertex].add_plane(side / length, at(a), 0.1 * length * length);
			_quadrics[b.vertex].add_plane(side / length, at(a), 0.1 * length * length);
		}
	}

	std::vector<uint32_t> neighbours(uint32_t vertex) const {
		std::vector<uint32_t> result;
		for (const uint32_t f : _faces_of[vertex]) {
			for (const Loop &loop : _indexed.faces[f].loops) {
				for (size_t i = 0; i < loop.size(); ++i) {
					if (loop[i].vertex == vertex) {
						result.push_back(loop[(i + 1) % loop.size()].vertex);
						result.push_back(loop[(i + loop.size() - 1) % loop.size()].vertex);
					}
				}
			}
		}
		std::ranges::sort(result);
		result.erase(std::unique(result.begin(), result.end()), result.end());
		return result;
	}

	void offer(uint32_t vertex) {
		for (const uint32_t other : neighbours(vertex)) {
			push(vertex, other);
			push(other, vertex);
		}
	}
	void push(uint32_t from, uint32_t to) {
		const double length = glm::distance(_indexed.vertices[from], _indexed.vertices[to]);
		_queue.push({ _quadrics[from].error(_indexed.vertices[to]) + 1e-9 * length * length, from, to, _stamps[from], _stamps[to] });
	}

	static size_t position(const Loop &loop, uint32_t vertex) {
		return size_t(std::ranges::find(loop, vertex, &Corner::vertex) - loop.begin());
	}

	// Neighbours have two common ones at most, and no face folds over, loses its plane or has holes.
	bool may_collapse(uint32_t from, uint32_t to) const {
		const std::vector<uint32_t> a = neighbours(from), b = neighbours(to);
		std::vector<uint32_t> common;
		std::ranges::set_intersection(a, b, std::back_inserter(common));
		if (common.size() > 2 || !std::ranges::binary_search(a, to) || leaves_nothing(from, to)) {
			return false;
		}
		return std::ranges::all_of(_faces_of[from], [&](uint32_t f) { return stays_sound(_indexed.faces[f], from, to); });
	}

	// Triangles along the edge vanish with it: the last ones of a part stay.
	bool leaves_nothing(uint32_t from, uint32_t to) const {
		const auto vanishes = [&](uint32_t f) {
			const std::vector<Loop> &loops = _indexed.faces[f].loops;
			const auto has = [&](uint32_t vertex) { return position(loops[0], vertex) < loops[0].size(); };
			return loops.size() == 1 && loops[0].size() == 3 && has(from) && has(to);
		};
		return std::ranges::all_of(_faces_of[from], vanishes) && std::ranges::all_of(_faces_of[to], vanishes);
	}

	bool stays_sound(const Face &face, uint32_t from, uint32_t to) const {
		if (face.loops.size() != 1) {
			return false;
		}
		const Loop &loop = face.loops[0];
		const size_t i = position(loop, from), count = loop.size();
		if (position(loop, to) < count) { // its corner goes
			const bool are_beside = loop[(i + 1) % count].vertex == to || loop[(i + count - 1) % count].vertex == to;
			return are_beside;
		}
		const glm::dvec3 before = at(loop[(i + count - 1) % count]), after = at(loop[(i + 1) % count]), old = _indexed.vertices[from];
		const glm::dvec3 normal = normal_of(_indexed, face);
		const glm::dvec3 ear = glm::cross(old - before, after - old), moved = glm::cross(_indexed.vertices[to] - before, after - _indexed.vertices[to]);
		return glm::dot(ear, normal) > 0.0 && glm::dot(moved, ear) > 0.2 * glm::length(moved) * glm::length(ear) && glm::length(moved) > 1e-12;
	}

	void collapse(uint32_t from, uint32_t to) {
		for (const uint32_t f : std::vector<uint32_t>(_faces_of[from])) {
			Loop &loop = _indexed.faces[f].loops[0];
			const size_t i = position(loop, from), count = loop.size();
			if (position(loop, to) < count) {
				loop.erase(loop.begin() + long(i));
			} else if (count == 3) {
				loop[i] = { to, _sources[to] };
				_faces_of[to].push_back(f);
			} else { // the corner is cut off as a triangle, which may bend away
				const Corner before = loop[(i + count - 1) % count], after = loop[(i + 1) % count];
				loop.erase(loop.begin() + long(i));
				Face ear;
				ear.source = _indexed.faces[f].source;
				ear.loops = { { before, { to, _sources[to] }, after } };
				const uint32_t index = uint32_t(_indexed.faces.size());
				for (const Corner &corner : ear.loops[0]) {
					_faces_of[corner.vertex].push_back(index);
				}
				_indexed.faces.push_back(std::move(ear));
			}
			drop_if_gone(f);
		}
		_faces_of[from].clear();
		_quadrics[to].add(_quadrics[from]);
		++_stamps[from];
		++_stamps[to];
		offer(to);
	}

	void drop_if_gone(uint32_t f) {
		if (_indexed.faces[f].loops[0].size() >= 3) {
			return;
		}
		for (const Corner &corner : _indexed.faces[f].loops[0]) {
			std::erase(_faces_of[corner.vertex], f);
		}
		_indexed.faces[f].loops.clear();
	}

	IndexedFaces &_indexed;
	std::vector<Quadric> _quadrics;
	std::vector<std::vector<uint32_t>> _faces_of; // by vertex
	std::vector<uint32_t> _stamps; // candidates made before a change are stale
	std::vector<uint32_t> _sources; // a corner at each vertex
	std::priority_queue<Candidate> _queue;
};

} // namespace

void reduce(Shape &shape, double share, GeometryBuilder &builder, Arena &arena) {
	const Geometry *geometry = baked(shape, arena);
	const double clamped = glm::clamp(share, 0.0, 1.0);
	if (geometry == nullptr || clamped == 0.0) {
		return;
	}
	IndexedFaces indexed = index_faces(*geometry, 0.0);
	const size_t count = size_t(std::floor(clamped * double(indexed.vertices.size()) + 1e-9));
	Reducer(indexed).run(count);
	put_faces(shape, *geometry, indexed, builder, arena);
}

} // namespace pcg::cga
