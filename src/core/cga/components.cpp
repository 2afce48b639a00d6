#include "core/cga/components.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

auto key_of(glm::dvec3 p) {
	return std::tuple(p.x, p.y, p.z);
}

// One edge of one face; `from` and `to` as the face runs.
struct FaceEdge {
	glm::dvec3 from, to;
	uint32_t face;
	uint32_t order; // among all edges

	auto low() const { return std::min(key_of(from), key_of(to)); }
	auto high() const { return std::max(key_of(from), key_of(to)); }
	auto key() const { return std::pair(low(), high()); }
};

std::vector<FaceEdge> face_edges(const Geometry &geometry) {
	std::vector<FaceEdge> edges;
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		const GeometryFace &face = geometry.faces[f];
		for (uint32_t l = 0; l < face.loop_count; ++l) {
			const auto loop = geometry.loop(face.first_loop + l);
			for (size_t i = 0; i < loop.size(); ++i) {
				edges.push_back({ loop[i], loop[(i + 1) % loop.size()], f, uint32_t(edges.size()) });
			}
		}
	}
	return edges;
}

// Edges with equal ends side by side, each group in its original order.
std::vector<FaceEdge> grouped(std::vector<FaceEdge> edges) {
	std::ranges::stable_sort(edges, {}, &FaceEdge::key);
	return edges;
}

template <typename Use> void for_each_group(const std::vector<FaceEdge> &edges, Use use) {
	for (size_t i = 0; i < edges.size();) {
		size_t end = i + 1;
		while (end < edges.size() && edges[end].key() == edges[i].key()) {
			++end;
		}
		use(std::span(edges).subspan(i, end - i));
		i = end;
	}
}

std::vector<glm::dvec3> face_normals(const Geometry &geometry) {
	std::vector<glm::dvec3> normals;
	for (uint32_t i = 0; i < geometry.face_count; ++i) {
		normals.push_back(face_normal(geometry, geometry.faces[i]));
	}
	return normals;
}

std::vector<ComponentInfo> all_faces(const Geometry &geometry) {
	std::vector<ComponentInfo> result(geometry.face_count);
	bool needs_borders = false;
	for (uint32_t i = 0; i < geometry.face_count; ++i) {
		result[i].face = i;
		result[i].component.normal = face_normal(geometry, geometry.faces[i]);
		result[i].component.is_border = geometry.faces[i].tag == FaceTag::Border;
		needs_borders |= geometry.faces[i].tag == FaceTag::None && !geometry.is_closed;
	}
	if (needs_borders) {
		for_each_group(grouped(face_edges(geometry)), [&](std::span<const FaceEdge> group) {
			if (group.size() == 1 && geometry.faces[group[0].face].tag == FaceTag::None) {
				result[group[0].face].component.is_border = true;
			}
		});
	}
	return result;
}

glm::dvec3 unit(glm::dvec3 vector, glm::dvec3 fallback) {
	const double length = glm::length(vector);
	return length > 1e-12 ? vector / length : fallback;
}

std::vector<ComponentInfo> shared_edges(const Geometry &geometry) {
	const std::vector<glm::dvec3> normals = face_normals(geometry);
	std::vector<std::pair<uint32_t, ComponentInfo>> found;
	for_each_group(grouped(face_edges(geometry)), [&](std::span<const FaceEdge> group) {
		glm::dvec3 sum(0.0);
		for (const FaceEdge &edge : group) {
			sum += normals[edge.face];
		}
		found.push_back({ group[0].order, { { unit(sum, normals[group[0].face]), group.size() == 1 }, group[0].face, group[0].from, group[0].to } });
	});
	std::ranges::sort(found, {}, [](const auto &pair) { return pair.first; });
	std::vector<ComponentInfo> result;
	for (const auto &[order, info] : found) {
		result.push_back(info);
	}
	return result;
}

std::vector<ComponentInfo> edges_by_face(const Geometry &geometry) {
	std::vector<ComponentInfo> result;
	for (const FaceEdge &edge : face_edges(geometry)) {
		const glm::dvec3 normal = face_normal(geometry, geometry.faces[edge.face]);
		const glm::dvec3 outwards = unit(glm::cross(edge.to - edge.from, normal), normal);
		result.push_back({ { outwards, true }, edge.face, edge.from, edge.to });
	}
	return result;
}

std::vector<ComponentInfo> vertices(const Geometry &geometry) {
	const std::vector<glm::dvec3> normals = face_normals(geometry);
	std::vector<FaceEdge> edges = face_edges(geometry); // each corner is the start of one
	std::ranges::stable_sort(edges, {}, [](const FaceEdge &edge) { return key_of(edge.from); });
	std::vector<std::pair<uint32_t, ComponentInfo>> found;
	for (size_t i = 0; i < edges.size();) {
		glm::dvec3 sum(0.0);
		const size_t first = i;
		for (; i < edges.size() && edges[i].from == edges[first].from; ++i) {
			sum += normals[edges[i].face];
		}
		const glm::dvec3 normal = unit(sum, normals[edges[first].face]);
		found.push_back({ edges[first].order, { { normal, !geometry.is_closed }, edges[first].face, edges[first].from, edges[first].from } });
	}
	std::ranges::sort(found, {}, [](const auto &pair) { return pair.first; });
	std::vector<ComponentInfo> result;
	for (const auto &[order, info] : found) {
		result.push_back(info);
	}
	return result;
}

// Points closer than `flat` to the plane z = 0 are put into it: a plane face is exactly plane in its own scope.
void add_points(GeometryBuilder &builder, const Geometry &geometry, const GeometryFace &face, const Frame &frame, double flat) {
	for (uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
		for (uint32_t i = geometry.first_point(l); i < geometry.loop_ends[l]; ++i) {
			glm::dvec3 local = frame.to_local(geometry.points[i]);
			local.z = std::abs(local.z) <= flat ? 0.0 : local.z;
			builder.add_corner(local, i);
		}
		builder.end_loop();
	}
	builder.end_face(face.tag, face.material);
}

void set_pivot(Shape &shape, const Shape &parent, const Frame &local, Arena &arena) {
	shape.pivot = arena.make(parent.frame() * local);
	shape.position = glm::dvec3(0.0);
	shape.rotation = glm::dmat3(1.0);
}

} // namespace

std::vector<ComponentInfo> components_of(const Geometry &geometry, ComponentKind kind) {
	switch (kind) {
		case ComponentKind::Edges:
			return shared_edges(geometry);
		case ComponentKind::Vertices:
			return vertices(geometry);
		case ComponentKind::FaceEdges:
			return edges_by_face(geometry);
		default:
			return all_faces(geometry);
	}
}

Shape face_shape(const Shape &parent, const Geometry &geometry, std::span<const uint32_t> faces, bool keeps_axes, GeometryBuilder &builder, Arena &arena) {
	const GeometryFace &first = geometry.faces[faces[0]];
	const auto outline = geometry.outline(first);
	Shape shape = parent;
	Frame frame;
	if (!keeps_axes && outline.size() >= 2) {
		frame = { axes_from_z(face_normal(geometry, first), outline[1] - outline[0]), outline[0] };
		set_pivot(shape, parent, frame, arena);
	}
	const glm::dvec3 extent = geometry.high - geometry.low;
	const double flat = 1e-9 * (extent.x + extent.y + extent.z);
	builder.begin(geometry, glm::transpose(frame.axes));
	for (const uint32_t face : faces) {
		add_points(builder, geometry, geometry.faces[face], frame, flat);
	}
	set_geometry(shape, builder.finish(arena, false));
	return shape;
}

Shape edge_shape(const Shape &parent, const ComponentInfo &info, Arena &arena) {
	Shape shape = parent;
	const Frame frame = { axes_from_z(info.component.normal, info.to - info.from), info.from };
	set_pivot(shape, parent, frame, arena);
	GeometryBuilder builder;
	builder.add_point(glm::dvec3(0.0));
	if (info.from != info.to) {
		builder.add_point({ glm::distance(info.from, info.to), 0.0, 0.0 });
	}
	builder.end_loop(1);
	builder.end_face();
	set_geometry(shape, builder.finish(arena, false));
	return shape;
}

std::vector<uint32_t> connected_sets(const Geometry &geometry, std::span<const uint32_t> faces) {
	std::vector<uint32_t> set_of(geometry.face_count, UINT32_MAX);
	for (const uint32_t face : faces) {
		set_of[face] = face;
	}
	const std::vector<FaceEdge> edges = grouped(face_edges(geometry));
	for (bool has_changed = true; has_changed;) { // the smallest number spreads over shared edges
		has_changed = false;
		for_each_group(edges, [&](std::span<const FaceEdge> group) {
			uint32_t least = UINT32_MAX;
			for (const FaceEdge &edge : group) {
				least = std::min(least, set_of[edge.face]);
			}
			for (const FaceEdge &edge : group) {
				if (set_of[edge.face] != UINT32_MAX && set_of[edge.face] > least) {
					set_of[edge.face] = least;
					has_changed = true;
				}
			}
		});
	}
	return set_of;
}

} // namespace pcg::cga
