#include "core/cga/face_groups.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/cga/edges.h"
#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

using Corner = IndexedFaces::Corner;
using Face = IndexedFaces::Face;
using Loop = std::vector<Corner>;

// Finds the first vertex within a distance, in cells of that size.
class VertexFinder {
public:
	VertexFinder(std::vector<glm::dvec3> &vertices, double distance) : _vertices(vertices), _distance(std::max(distance, 1e-7)) {}

	uint32_t find_or_add(glm::dvec3 point) {
		const glm::dvec3 cell = glm::floor(point / _distance);
		uint32_t best = UINT32_MAX;
		for (int i = 0; i < 27; ++i) {
			const auto found = _cells.find(key(cell + glm::dvec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)));
			for (size_t k = 0; found != _cells.end() && k < found->second.size(); ++k) {
				const uint32_t vertex = found->second[k];
				best = vertex < best && glm::distance(_vertices[vertex], point) <= _distance ? vertex : best;
			}
		}
		if (best == UINT32_MAX) {
			best = uint32_t(_vertices.size());
			_vertices.push_back(point);
			_cells[key(cell)].push_back(best);
		}
		return best;
	}

private:
	static std::tuple<int64_t, int64_t, int64_t> key(glm::dvec3 cell) { return { int64_t(cell.x), int64_t(cell.y), int64_t(cell.z) }; }

	std::vector<glm::dvec3> &_vertices;
	double _distance;
	std::map<std::tuple<int64_t, int64_t, int64_t>, std::vector<uint32_t>> _cells;
};

void drop_repeated(Loop &loop) {
	Loop kept;
	for (const Corner &corner : loop) {
		if (kept.empty() || kept.back().vertex != corner.vertex) {
			kept.push_back(corner);
		}
	}
	while (kept.size() > 1 && kept.back().vertex == kept.front().vertex) {
		kept.pop_back();
	}
	loop = std::move(kept);
}

glm::dvec3 area_vector_of(const IndexedFaces &indexed, const Loop &loop) {
	std::vector<glm::dvec3> points;
	for (const Corner &corner : loop) {
		points.push_back(indexed.vertices[corner.vertex]);
	}
	return area_vector(points);
}

struct DirectedEdge {
	Corner from, to;
	uint32_t face = 0;
};
using EdgeKey = std::pair<uint32_t, uint32_t>;

class Joiner {
public:
	Joiner(const Geometry &geometry, IndexedFaces &indexed, double angle)
			: _geometry(geometry), _indexed(indexed), _cosine(std::cos(glm::clamp(angle, 0.0, 90.0) * 0.017453292519943295) - 1e-9) {
		for (uint32_t f = 0; f < indexed.faces.size(); ++f) {
			_normals.push_back(normal_of(indexed, indexed.faces[f]));
			for (const DirectedEdge &edge : edges_of(f)) {
				_edges[{ edge.from.vertex, edge.to.vertex }].push_back(edge);
			}
		}
	}

	void run() {
		std::vector<bool> is_taken(_indexed.faces.size(), false);
		for (uint32_t seed = 0; seed < _indexed.faces.size(); ++seed) {
			if (is_taken[seed] || _indexed.faces[seed].loops.empty()) {
				continue;
			}
			const std::vector<uint32_t> set = grow(seed, is_taken);
			std::optional<Face> joined = set.size() > 1 ? join(set) : std::nullopt;
			if (joined) {
				for (const uint32_t face : set) {
					_indexed.faces[face].loops.clear();
				}
				_indexed.faces[seed] = std::move(*joined);
			}
		}
	}

private:
	std::vector<DirectedEdge> edges_of(uint32_t face) const {
		std::vector<DirectedEdge> edges;
		for (const Loop &loop : _indexed.faces[face].loops) {
			for (size_t i = 0; i < loop.size(); ++i) {
				edges.push_back({ loop[i], loop[(i + 1) % loop.size()], face });
			}
		}
		return edges;
	}

	bool have_equal_uvs(uint32_t a, uint32_t b) const {
		for (size_t set = 0; set < uv_set_count; ++set) {
			const glm::dvec2 *uvs = _geometry.uvs(set);
			if (uvs != nullptr && has_uv(uvs[a]) != has_uv(uvs[b])) {
				return false;
			}
			if (uvs != nullptr && has_uv(uvs[a]) && glm::distance(uvs[a], uvs[b]) > 1e-6) {
				return false;
			}
		}
		return true;
	}

	// The one face on the other side of an edge that may join; UINT32_MAX: none.
	uint32_t neighbour(const DirectedEdge &edge, uint32_t seed) const {
		const auto there = _edges.find({ edge.to.vertex, edge.from.vertex });
		if (there == _edges.end() || there->second.size() != 1 || _edges.at({ edge.from.vertex, edge.to.vertex }).size() != 1) {
			return UINT32_MAX;
		}
		const DirectedEdge &other = there->second[0];
		const bool is_alike = _geometry.faces[_indexed.faces[other.face].source].material == _geometry.faces[_indexed.faces[seed].source].material &&
				_geometry.faces[_indexed.faces[other.face].source].tag == _geometry.faces[_indexed.faces[seed].source].tag;
		const bool is_flat = glm::dot(_normals[other.face], _normals[seed]) >= _cosine;
		const bool fits = is_alike && is_flat && have_equal_uvs(edge.from.source, other.to.source) && have_equal_uvs(edge.to.source, other.from.source);
		return fits ? other.face : UINT32_MAX;
	}

	std::vector<uint32_t> grow(uint32_t seed, std::vector<bool> &is_taken) const {
		std::vector<uint32_t> set = { seed };
		is_taken[seed] = true;
		for (size_t i = 0; i < set.size(); ++i) {
			for (const DirectedEdge &edge : edges_of(set[i])) {
				const uint32_t face = neighbour(edge, seed);
				if (face != UINT32_MAX && !is_taken[face]) {
					is_taken[face] = true;
					set.push_back(face);
				}
			}
		}
		std::ranges::sort(set);
		return set;
	}

	// The border of a set as loops. None if it is not one outline with holes.
	std::optional<Face> join(const std::vector<uint32_t> &set) const {
		std::vector<DirectedEdge> border;
		std::map<EdgeKey, uint32_t> inside;
		for (const uint32_t face : set) {
			for (const DirectedEdge &edge : edges_of(face)) {
				++inside[{ edge.from.vertex, edge.to.vertex }];
			}
		}
		for (const uint32_t face : set) {
			for (const DirectedEdge &edge : edges_of(face)) {
				if (!inside.contains({ edge.to.vertex, edge.from.vertex })) {
					border.push_back(edge);
				}
			}
		}
		std::map<uint32_t, size_t> by_start;
		for (size_t i = 0; i < border.size(); ++i) {
			if (!by_start.emplace(border[i].from.vertex, i).second) {
				return std::nullopt; // the border branches
			}
		}
		Face result;
		result.source = _indexed.faces[set[0]].source;
		std::vector<bool> is_used(border.size(), false);
		for (size_t i = 0; i < border.size(); ++i) {
			if (is_used[i]) {
				continue;
			}
			Loop loop;
			if (!follow(border, by_start, i, is_used, loop)) {
				return std::nullopt;
			}
			add_loop(result, std::move(loop), _normals[set[0]]);
		}
		const bool is_sound = !result.loops.empty() && glm::dot(area_vector_of(_indexed, result.loops[0]), _normals[set[0]]) > 0.0;
		return is_sound && outline_count(result, _normals[set[0]]) == 1 ? std::optional<Face>(std::move(result)) : std::nullopt;
	}

	size_t outline_count(const Face &face, glm::dvec3 normal) const {
		return size_t(std::ranges::count_if(face.loops, [&](const Loop &loop) { return glm::dot(area_vector_of(_indexed, loop), normal) > 0.0; }));
	}

	// The outline goes first.
	void add_loop(Face &face, Loop loop, glm::dvec3 normal) const {
		const bool is_outline = glm::dot(area_vector_of(_indexed, loop), normal) > 0.0;
		face.loops.insert(is_outline ? face.loops.begin() : face.loops.end(), std::move(loop));
	}

	// From one edge of the border around. False: it does not close.
	static bool follow(const std::vector<DirectedEdge> &border, const std::map<uint32_t, size_t> &by_start, size_t start, std::vector<bool> &is_used, Loop &loop) {
		for (size_t at = start; !is_used[at];) {
			is_used[at] = true;
			loop.push_back(border[at].from);
			const auto next = by_start.find(border[at].to.vertex);
			if (next == by_start.end()) {
				return false;
			}
			at = next->second;
		}
		return loop.size() >= 3;
	}

	const Geometry &_geometry;
	IndexedFaces &_indexed;
	double _cosine;
	std::vector<glm::dvec3> _normals;
	std::map<EdgeKey, std::vector<DirectedEdge>> _edges;
};

const Geometry *rebuild(const Geometry &geometry, const IndexedFaces &indexed, GeometryBuilder &builder, Arena &arena) {
	builder.begin(geometry, glm::dmat3(1.0));
	for (const Face &face : indexed.faces) {
		for (const Loop &loop : face.loops) {
			for (const Corner &corner : loop) {
				builder.add_corner(indexed.vertices[corner.vertex], corner.source);
			}
			builder.end_loop(std::min<size_t>(loop.size(), 3));
		}
		builder.end_face(geometry.faces[face.source].tag, geometry.faces[face.source].material);
	}
	const Geometry *result = builder.finish(arena, false);
	const bool is_closed = result != nullptr && geometry.is_closed && has_paired_edges(*result);
	return is_closed ? builder.finish(arena, true) : result;
}

} // namespace

IndexedFaces index_faces(const Geometry &geometry, double distance) {
	IndexedFaces result;
	VertexFinder finder(result.vertices, distance);
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		const GeometryFace &source = geometry.faces[f];
		Face face;
		face.source = f;
		for (uint32_t l = source.first_loop; l < source.first_loop + source.loop_count; ++l) {
			Loop loop;
			for (uint32_t corner = geometry.first_point(l); corner < geometry.loop_ends[l]; ++corner) {
				loop.push_back({ finder.find_or_add(geometry.points[corner]), corner });
			}
			const size_t least = std::min<size_t>(loop.size(), 3); // edges and points stay what they are
			drop_repeated(loop);
			if (loop.size() >= least) {
				face.loops.push_back(std::move(loop));
			} else if (l == source.first_loop) {
				break; // without its outline the face is gone
			}
		}
		result.faces.push_back(std::move(face));
	}
	return result;
}

void put_faces(Shape &shape, const Geometry &geometry, const IndexedFaces &indexed, GeometryBuilder &builder, Arena &arena) {
	shape.geometry = rebuild(geometry, indexed, builder, arena);
	shape.geometry_offset = glm::dvec3(0.0);
	shape.geometry_scale = glm::dvec3(1.0);
}

void join_coplanar(const Geometry &geometry, IndexedFaces &indexed, double angle) { Joiner(geometry, indexed, angle).run(); }

glm::dvec3 normal_of(const IndexedFaces &indexed, const Face &face) {
	const glm::dvec3 area = face.loops.empty() ? glm::dvec3(0.0) : area_vector_of(indexed, face.loops[0]);
	const double length = glm::length(area);
	return length > 1e-14 ? area / length : glm::dvec3(0.0);
}

double area_of(const IndexedFaces &indexed, const Face &face) {
	glm::dvec3 sum(0.0);
	for (const Loop &loop : face.loops) {
		sum += area_vector_of(indexed, loop);
	}
	return 0.5 * glm::length(sum);
}

} // namespace pcg::cga
