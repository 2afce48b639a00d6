#include "core/cga/cleanup.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/cga/disjoint_sets.h"
#include "core/cga/edges.h"
#include "core/cga/face_groups.h"
#include "core/cga/junctions.h"
#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

using Corner = IndexedFaces::Corner;
using Face = IndexedFaces::Face;
using Loop = std::vector<Corner>;

// Whether the corner adds nothing to its loop: neither a bend nor a bend of texture coordinates.
class StraightTest {
public:
	StraightTest(const Geometry &geometry, const IndexedFaces &indexed, double angle)
			: _geometry(geometry), _indexed(indexed), _sine(std::sin(angle * 0.017453292519943295) + 1e-7) {}

	bool operator()(const Corner &before, const Corner &corner, const Corner &after) const {
		const glm::dvec3 a = _indexed.vertices[corner.vertex] - _indexed.vertices[before.vertex];
		const glm::dvec3 b = _indexed.vertices[after.vertex] - _indexed.vertices[corner.vertex];
		const double size = glm::length(a) * glm::length(b);
		const bool is_straight = size > 0.0 && glm::dot(a, b) > 0.0 && glm::length(glm::cross(a, b)) <= _sine * size;
		return is_straight && has_even_uvs(before, corner, after, glm::length(a) / (glm::length(a) + glm::length(b)));
	}

private:
	bool has_even_uvs(const Corner &before, const Corner &corner, const Corner &after, double share) const {
		for (size_t set = 0; set < uv_set_count; ++set) {
			const glm::dvec2 *uvs = _geometry.uvs(set);
			if (uvs != nullptr && has_uv(uvs[corner.source]) &&
					!(glm::distance(uvs[corner.source], glm::mix(uvs[before.source], uvs[after.source], share)) <= 1e-6)) {
				return false;
			}
		}
		return true;
	}

	const Geometry &_geometry;
	const IndexedFaces &_indexed;
	double _sine;
};

// Takes vertices away that are straight wherever they are used, so that neighbours still fit.
void drop_straight(const Geometry &geometry, IndexedFaces &indexed, double angle) {
	const StraightTest is_straight(geometry, indexed, angle);
	std::vector<bool> is_bend(indexed.vertices.size(), false);
	const auto for_each_loop = [&](auto use) {
		for (Face &face : indexed.faces) {
			std::ranges::for_each(face.loops, use);
		}
	};
	for_each_loop([&](const Loop &loop) {
		for (size_t i = 0; i < loop.size(); ++i) {
			if (loop.size() < 3 || !is_straight(loop[(i + loop.size() - 1) % loop.size()], loop[i], loop[(i + 1) % loop.size()])) {
				is_bend[loop[i].vertex] = true;
			}
		}
	});
	for_each_loop([&](Loop &loop) {
		const auto bends = std::ranges::count_if(loop, [&](const Corner &corner) { return is_bend[corner.vertex]; });
		if (bends < 3 && loop.size() >= 3) {
			return;
		}
		size_t first = 0; // the edge that holds the first one begins at the last bend before it
		while (!is_bend[loop[first].vertex]) {
			first = (first + loop.size() - 1) % loop.size();
		}
		std::rotate(loop.begin(), loop.begin() + long(first), loop.end());
		std::erase_if(loop, [&](const Corner &corner) { return !is_bend[corner.vertex]; });
	});
}

// The later one of two faces with the same vertices goes, whichever way they look.
void drop_doubles(IndexedFaces &indexed) {
	std::set<std::vector<uint32_t>> known;
	for (Face &face : indexed.faces) {
		std::vector<uint32_t> vertices;
		for (const Loop &loop : face.loops) {
			for (const Corner &corner : loop) {
				vertices.push_back(corner.vertex);
			}
		}
		std::ranges::sort(vertices);
		if (!vertices.empty() && !known.insert(std::move(vertices)).second) {
			face.loops.clear();
		}
	}
}

void drop_small(IndexedFaces &indexed, double area) {
	for (Face &face : indexed.faces) {
		const bool is_face = !face.loops.empty() && face.loops[0].size() >= 3;
		if (is_face && area_of(indexed, face) <= area) {
			face.loops.clear();
		}
	}
}

// The geometry in scope coordinates becomes the shape's own; the scope stays.
void put(Shape &shape, const Geometry *geometry) {
	shape.geometry = geometry;
	shape.geometry_offset = glm::dvec3(0.0);
	shape.geometry_scale = glm::dvec3(1.0);
}

// --- Normals

std::vector<glm::dvec3> normals_of(const Geometry &geometry) {
	std::vector<glm::dvec3> normals;
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		normals.push_back(face_normal(geometry, geometry.faces[f]));
	}
	return normals;
}

// Corners at one vertex that are shaded as one, because the edges between their faces are soft.
DisjointSets soft_corners(const Geometry &geometry, const std::vector<glm::dvec3> &normals, double angle) {
	DisjointSets sets(geometry.point_count);
	const double cosine = angle >= 180.0 ? -2.0 : std::cos(angle * 0.017453292519943295);
	for_each_edge_group(grouped_edges(geometry), [&](std::span<const FaceEdge> group) {
		for (size_t i = 1; i < group.size(); ++i) {
			const FaceEdge &a = group[0], &b = group[i];
			if (glm::dot(normals[a.face], normals[b.face]) > cosine) {
				sets.join(a.corner, a.from == b.from ? b.corner : b.end_corner);
				sets.join(a.end_corner, a.from == b.from ? b.end_corner : b.corner);
			}
		}
	});
	return sets;
}

} // namespace

void clean_up(Shape &shape, const Cleanup &cleanup, GeometryBuilder &builder, Arena &arena) {
	const Geometry *geometry = baked(shape, arena);
	if (geometry == nullptr) {
		return;
	}
	const double tolerance = glm::clamp(cleanup.tolerance, 0.0, 1.0);
	const double degrees = std::max(10.0 * tolerance, 1e-3);
	if (cleanup.edges) { // neighbours that share part of an edge only are neighbours as well
		geometry = with_junctions(*geometry, tolerance, degrees, builder, arena);
	}
	IndexedFaces indexed = index_faces(*geometry, tolerance);
	if (cleanup.faces) {
		drop_doubles(indexed);
	}
	if (cleanup.edges) {
		join_coplanar(*geometry, indexed, degrees);
	}
	if (cleanup.vertices) {
		drop_straight(*geometry, indexed, degrees);
	}
	if (cleanup.faces) { // last: what was small may have become part of something larger
		drop_small(indexed, std::max(tolerance, 1e-9));
	}
	put_faces(shape, *geometry, indexed, builder, arena);
}

void soften_normals(Shape &shape, double angle, Arena &arena) {
	const Geometry *geometry = baked(shape, arena);
	if (geometry == nullptr) {
		return;
	}
	CornerData *corners = arena.make(geometry->corners != nullptr ? *geometry->corners : CornerData());
	corners->normals = nullptr;
	if (angle > 0.0) {
		const std::vector<glm::dvec3> normals = normals_of(*geometry);
		DisjointSets sets = soft_corners(*geometry, normals, angle);
		std::vector<glm::dvec3> sums(geometry->point_count, glm::dvec3(0.0));
		for (const FaceEdge &edge : face_edges(*geometry)) {
			sums[sets.find(edge.corner)] += normals[edge.face];
		}
		glm::dvec3 *result = arena.allocate<glm::dvec3>(geometry->point_count);
		for (uint32_t i = 0; i < geometry->point_count; ++i) {
			const glm::dvec3 sum = sums[sets.find(i)];
			result[i] = glm::length(sum) > 1e-9 ? glm::normalize(sum) : glm::dvec3(0.0);
		}
		corners->normals = result;
	}
	Geometry result = *geometry;
	result.corners = corners;
	result.is_block = result.is_block && corners->normals == nullptr && geometry->corners == nullptr;
	put(shape, arena.make(result));
}

namespace {

// Which faces look to the other side than the first of their set; neighbours run along their edge in opposite directions.
class Conformer {
public:
	Conformer(const Geometry &geometry, glm::dvec3 up) : _geometry(geometry), _up(up), _neighbours(geometry.face_count), _is_turned(geometry.face_count, false) {
		for_each_edge_group(grouped_edges(geometry), [&](std::span<const FaceEdge> group) {
			if (group.size() == 2) {
				const bool is_same = group[0].from != group[1].from;
				_neighbours[group[0].face].push_back({ group[1].face, is_same });
				_neighbours[group[1].face].push_back({ group[0].face, is_same });
			}
		});
	}

	std::vector<bool> run() {
		std::vector<bool> is_known(_geometry.face_count, false);
		for (uint32_t f = 0; f < _geometry.face_count; ++f) {
			if (!is_known[f]) {
				turn_set(f, is_known);
			}
		}
		return _is_turned;
	}

private:
	struct Neighbour {
		uint32_t face;
		bool is_same; // looks to the same side already
	};

	void turn_set(uint32_t first, std::vector<bool> &is_known) {
		std::vector<uint32_t> set = { first };
		is_known[first] = true;
		for (size_t i = 0; i < set.size(); ++i) {
			for (const Neighbour &neighbour : _neighbours[set[i]]) {
				if (!is_known[neighbour.face]) {
					is_known[neighbour.face] = true;
					_is_turned[neighbour.face] = _is_turned[set[i]] == neighbour.is_same;
					set.push_back(neighbour.face);
				}
			}
		}
		if (outwardness(set) < 0.0) {
			for (const uint32_t face : set) {
				_is_turned[face] = !_is_turned[face];
			}
		}
	}

	// Volume within the set as seen from its middle; for flat sets how far it looks up.
	double outwardness(const std::vector<uint32_t> &set) const {
		const glm::dvec3 middle = 0.5 * (_geometry.low + _geometry.high);
		double volume = 0.0, up = 0.0, area = 0.0;
		for (const uint32_t face : set) {
			const auto loop = _geometry.outline(_geometry.faces[face]);
			const glm::dvec3 vector = area_vector(loop) * (_is_turned[face] ? -1.0 : 1.0);
			volume += glm::dot(loop[0] - middle, vector);
			up += glm::dot(vector, _up);
			area += glm::length(vector);
		}
		return std::abs(volume) > 1e-9 * area * glm::distance(_geometry.low, _geometry.high) ? volume : up;
	}

	const Geometry &_geometry;
	glm::dvec3 _up; // the world's, in scope coordinates
	std::vector<std::vector<Neighbour>> _neighbours;
	std::vector<bool> _is_turned;
};

} // namespace

void conform_normals(Shape &shape, GeometryBuilder &builder, Arena &arena) {
	const Geometry *geometry = baked(shape, arena);
	if (geometry == nullptr) {
		return;
	}
	const std::vector<bool> is_turned = Conformer(*geometry, glm::transpose(shape.frame().axes)[1]).run();
	builder.begin(*geometry, glm::dmat3(0.0));
	for (uint32_t f = 0; f < geometry->face_count; ++f) {
		const GeometryFace &face = geometry->faces[f];
		for (uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
			const uint32_t first = geometry->first_point(l), count = geometry->loop_ends[l] - first;
			for (uint32_t i = 0; i < count; ++i) {
				const uint32_t corner = first + (is_turned[f] ? (count + 1 - i) % count : i);
				builder.add_corner(geometry->points[corner], corner);
			}
			builder.end_loop(1);
		}
		builder.end_face(face.tag, face.material);
	}
	put(shape, builder.finish(arena, geometry->is_closed));
}

} // namespace pcg::cga
