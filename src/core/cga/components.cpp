#include "core/cga/components.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/cga/disjoint_sets.h"
#include "core/cga/edges.h"
#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

auto key_of(glm::dvec3 p) { return FaceEdge::key_of(p); }

// Edges and points look along z of their scope.
glm::dvec3 component_normal(const Geometry &geometry, const GeometryFace &face) {
	return geometry.outline(face).size() >= 3 ? face_normal(geometry, face) : glm::dvec3(0.0, 0.0, 1.0);
}

std::vector<glm::dvec3> face_normals(const Geometry &geometry) {
	std::vector<glm::dvec3> normals;
	for (uint32_t i = 0; i < geometry.face_count; ++i) {
		normals.push_back(component_normal(geometry, geometry.faces[i]));
	}
	return normals;
}

std::vector<ComponentInfo> all_faces(const Geometry &geometry) {
	std::vector<ComponentInfo> result(geometry.face_count);
	bool needs_borders = false;
	for (uint32_t i = 0; i < geometry.face_count; ++i) {
		result[i].face = i;
		result[i].component.normal = component_normal(geometry, geometry.faces[i]);
		result[i].component.is_border = geometry.faces[i].tag == FaceTag::Border;
		needs_borders |= geometry.faces[i].tag == FaceTag::None && !geometry.is_closed;
	}
	if (needs_borders) {
		for_each_edge_group(grouped_edges(geometry), [&](std::span<const FaceEdge> group) {
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
	for_each_edge_group(grouped_edges(geometry), [&](std::span<const FaceEdge> group) {
		glm::dvec3 sum(0.0);
		for (const FaceEdge &edge : group) {
			sum += normals[edge.face];
		}
		ComponentInfo info;
		info.component = { unit(sum, normals[group[0].face]), group.size() == 1 };
		info.face = group[0].face;
		info.from = group[0].from;
		info.to = group[0].to;
		found.push_back({ group[0].order, std::move(info) });
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
	result.reserve(geometry.point_count);
	glm::dvec3 normal(0.0);
	for_each_face_edge(geometry, [&](const FaceEdge &edge) {
		const bool is_first = result.empty() || result.back().face != edge.face;
		normal = is_first ? component_normal(geometry, geometry.faces[edge.face]) : normal;
		ComponentInfo &info = result.emplace_back();
		info.component = { unit(glm::cross(edge.to - edge.from, normal), normal), true };
		info.face = edge.face;
		info.from = edge.from;
		info.to = edge.to;
	});
	return result;
}

// Corners face by face, in the order of the loops.
std::vector<ComponentInfo> corners(const Geometry &geometry) {
	const std::vector<glm::dvec3> normals = face_normals(geometry);
	std::vector<ComponentInfo> result;
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		const GeometryFace &face = geometry.faces[f];
		for (uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
			for (const glm::dvec3 &point : geometry.loop(l)) {
				ComponentInfo info;
				info.component = { normals[f], false };
				info.face = f;
				info.from = info.to = point;
				result.push_back(std::move(info));
			}
		}
	}
	return result;
}


// Ends of edges with one face, sorted.
std::vector<PointKey> border_points(const Geometry &geometry) {
	std::vector<PointKey> points;
	for_each_edge_group(grouped_edges(geometry), [&](std::span<const FaceEdge> group) {
		if (group.size() == 1) {
			points.push_back(key_of(group[0].from));
			points.push_back(key_of(group[0].to));
		}
	});
	std::ranges::sort(points);
	return points;
}

// Equal corners are one vertex; it faces as the sum of its corners does.
std::vector<ComponentInfo> vertices(const Geometry &geometry) {
	std::vector<ComponentInfo> all = corners(geometry);
	std::vector<uint32_t> order(all.size());
	std::iota(order.begin(), order.end(), 0);
	std::ranges::stable_sort(order, {}, [&](uint32_t i) { return key_of(all[i].from); });
	const std::vector<PointKey> border = border_points(geometry);
	std::vector<uint32_t> kept;
	for (size_t i = 0; i < order.size();) {
		ComponentInfo &vertex = all[order[i]];
		glm::dvec3 sum(0.0);
		for (; i < order.size() && all[order[i]].from == vertex.from; ++i) {
			sum += all[order[i]].component.normal;
		}
		vertex.component = { unit(sum, vertex.component.normal), std::ranges::binary_search(border, key_of(vertex.from)) };
		kept.push_back(uint32_t(&vertex - all.data()));
	}
	std::ranges::sort(kept);
	std::vector<ComponentInfo> result;
	for (const uint32_t index : kept) {
		result.push_back(std::move(all[index]));
	}
	return result;
}

// Sets of faces: all of them, or those of each material.
std::vector<ComponentInfo> face_sets(const Geometry &geometry, bool is_by_material) {
	const std::vector<ComponentInfo> faces = all_faces(geometry);
	std::vector<ComponentInfo> result;
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		const auto has_material = [&](const ComponentInfo &set) { return !is_by_material || geometry.faces[set.face].material == geometry.faces[f].material; };
		auto found = std::ranges::find_if(result, has_material);
		if (found == result.end()) {
			result.push_back(faces[f]);
			found = result.end() - 1;
		}
		found->faces.push_back(f);
	}
	return result;
}

std::vector<ComponentInfo> holes(const Geometry &geometry) {
	std::vector<ComponentInfo> result;
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		const GeometryFace &face = geometry.faces[f];
		for (uint32_t l = face.first_loop + 1; l < face.first_loop + face.loop_count; ++l) {
			ComponentInfo info;
			info.component = { face_normal(geometry, face), false };
			info.face = f;
			info.loop = l;
			result.push_back(std::move(info));
		}
	}
	return result;
}

// Points closer than `flat` to the plane z = 0 are put into it: a plane face is exactly plane in its own scope.
glm::dvec3 in_frame(glm::dvec3 point, const Frame &frame, double flat) {
	glm::dvec3 local = frame.to_local(point);
	local.z = std::abs(local.z) <= flat ? 0.0 : local.z;
	return local;
}

// What the corners of a face carry, which lie side by side in its geometry.
const CornerData *corners_from(const CornerData &source, uint32_t first, Arena &arena) {
	CornerData *result = arena.make(source);
	for (const glm::dvec2 *&uvs : std::span(result->uvs).first(result->set_end)) {
		uvs = uvs != nullptr ? uvs + first : nullptr;
	}
	return result;
}

// One face without holes and smooth corners. nullptr where corners fall together, which the builder sees to.
const Geometry *outline_in_frame(const Geometry &geometry, const GeometryFace &face, const Frame &frame, double flat, Arena &arena) {
	const auto outline = geometry.outline(face);
	glm::dvec3 *points = arena.allocate<glm::dvec3>(outline.size());
	bool is_clear = outline.size() >= 3;
	for (size_t i = 0; i < outline.size(); ++i) {
		points[i] = in_frame(outline[i], frame, flat);
		is_clear &= i == 0 || points[i] != points[i - 1];
	}
	if (!is_clear || points[0] == points[outline.size() - 1]) {
		return nullptr;
	}
	Geometry *polygon = make_polygon({ points, outline.size() }, face.tag, face.material, arena);
	if (geometry.corners != nullptr) {
		polygon->corners = corners_from(*geometry.corners, geometry.first_point(face.first_loop), arena);
	}
	return polygon;
}

void add_points(GeometryBuilder &builder, const Geometry &geometry, const GeometryFace &face, const Frame &frame, double flat) {
	for (uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
		for (uint32_t i = geometry.first_point(l); i < geometry.loop_ends[l]; ++i) {
			builder.add_corner(in_frame(geometry.points[i], frame, flat), i);
		}
		builder.end_loop();
	}
	builder.end_face(face.tag, face.material);
}

void set_pivot(Shape &shape, const Frame &parent, const Frame &local, Arena &arena) {
	shape.pivot = arena.make(parent * local);
	shape.position = glm::dvec3(0.0);
	shape.rotation = glm::dmat3(1.0);
}

// x along an edge, z as near to its normal as that leaves; of vertices z is the normal.
glm::dmat3 edge_axes(glm::dvec3 normal, glm::dvec3 along) {
	if (glm::length(along) < 1e-12) {
		return axes_from_z(normal, along);
	}
	const glm::dvec3 x = glm::normalize(along), z = axes_from_z(x, normal)[0];
	return { x, glm::cross(z, x), z };
}

// Edges and vertices keep where they face, one for each of the geometry's faces, for extrude().
const Geometry *with_noted_normals(const Geometry &geometry, std::span<const ComponentInfo *const> infos, const Frame &frame, Arena &arena) {
	glm::dvec3 *normals = arena.allocate<glm::dvec3>(geometry.point_count);
	for (uint32_t f = 0; f < geometry.face_count; ++f) {
		const GeometryFace &face = geometry.faces[f];
		std::fill_n(normals + geometry.first_point(face.first_loop), geometry.face_point_count(face), glm::transpose(frame.axes) * infos[f]->component.normal);
	}
	CornerData *corners = arena.make(CornerData());
	corners->normals = normals;
	Geometry *result = arena.make(geometry);
	result->corners = corners;
	return result;
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
		case ComponentKind::FaceVertices:
			return corners(geometry);
		case ComponentKind::Groups:
		case ComponentKind::Materials:
			return face_sets(geometry, kind == ComponentKind::Materials);
		case ComponentKind::Holes:
			return holes(geometry);
		default:
			return all_faces(geometry);
	}
}

Shape face_shape(const Shape &parent, const Frame &scope, const Geometry &geometry, std::span<const uint32_t> faces, glm::dvec3 first_normal, bool keeps_axes,
		GeometryBuilder &builder, Arena &arena) {
	const GeometryFace &first = geometry.faces[faces[0]];
	const auto outline = geometry.outline(first);
	Shape shape = parent;
	Frame frame;
	if (!keeps_axes && outline.size() >= 2) {
		frame = { axes_from_z(first_normal, outline[1] - outline[0]), outline[0] };
		set_pivot(shape, scope, frame, arena);
	}
	const glm::dvec3 extent = geometry.high - geometry.low;
	const double flat = 1e-9 * (extent.x + extent.y + extent.z);
	const bool is_smooth = geometry.corners != nullptr && geometry.corners->normals != nullptr;
	const bool is_plain = faces.size() == 1 && first.loop_count == 1 && !is_smooth;
	if (const Geometry *face = is_plain ? outline_in_frame(geometry, first, frame, flat, arena) : nullptr) {
		set_geometry(shape, face);
		return shape;
	}
	builder.begin(geometry, glm::transpose(frame.axes));
	for (const uint32_t face : faces) {
		add_points(builder, geometry, geometry.faces[face], frame, flat);
	}
	set_geometry(shape, builder.finish(arena, false));
	return shape;
}

Shape edge_shape(const Shape &parent, std::span<const ComponentInfo *const> infos, bool keeps_axes, bool is_roof_edge, GeometryBuilder &builder, Arena &arena) {
	Shape shape = parent;
	Frame frame;
	const auto from = [&](const ComponentInfo &info) { return is_roof_edge && info.runs_back ? info.to : info.from; };
	const auto to = [&](const ComponentInfo &info) { return is_roof_edge && info.runs_back ? info.from : info.to; };
	const ComponentInfo &first = *infos[0];
	if (!keeps_axes) {
		frame = { edge_axes(first.component.normal, to(first) - from(first)), from(first) };
		set_pivot(shape, parent.frame(), frame, arena);
	}
	builder.clear();
	for (const ComponentInfo *info : infos) {
		builder.add_point(frame.to_local(from(*info)));
		if (info->from != info->to) {
			const bool is_first = info == &first && !keeps_axes; // lies exactly on x
			builder.add_point(is_first ? glm::dvec3(glm::distance(info->from, info->to), 0.0, 0.0) : frame.to_local(to(*info)));
		}
		builder.end_loop(1);
		builder.end_face();
	}
	set_geometry(shape, with_noted_normals(*builder.finish(arena, false), infos, frame, arena));
	return shape;
}

Shape hole_shape(const Shape &parent, const Geometry &geometry, std::span<const ComponentInfo *const> holes, bool keeps_axes, GeometryBuilder &builder,
		Arena &arena) {
	Shape shape = parent;
	const auto first = geometry.loop(holes[0]->loop);
	Frame frame;
	if (!keeps_axes) {
		frame = { axes_from_z(holes[0]->component.normal, first[0] - first[1]), first[1] };
		set_pivot(shape, parent.frame(), frame, arena);
	}
	builder.begin(geometry, glm::dmat3(0.0));
	for (const ComponentInfo *hole : holes) {
		const uint32_t first_corner = geometry.first_point(hole->loop), count = geometry.loop_ends[hole->loop] - first_corner;
		for (uint32_t i = 0; i < count; ++i) { // the other way around, its first edge first
			const uint32_t corner = first_corner + (count + 1 - i) % count;
			builder.add_corner(frame.to_local(geometry.points[corner]), corner);
		}
		builder.end_loop();
		builder.end_face(FaceTag::None, geometry.faces[hole->face].material);
	}
	set_geometry(shape, builder.finish(arena, false));
	return shape;
}

std::vector<uint32_t> connected_sets(const Geometry &geometry, std::span<const uint32_t> faces) {
	std::vector<bool> is_asked(geometry.face_count, false);
	for (const uint32_t face : faces) {
		is_asked[face] = true;
	}
	DisjointSets sets(geometry.face_count);
	for_each_edge_group(grouped_edges(geometry), [&](std::span<const FaceEdge> group) {
		uint32_t first = UINT32_MAX;
		for (const FaceEdge &edge : group) {
			if (is_asked[edge.face]) {
				first = first == UINT32_MAX ? edge.face : first;
				sets.join(first, edge.face);
			}
		}
	});
	std::vector<uint32_t> result(geometry.face_count, UINT32_MAX);
	for (const uint32_t face : faces) {
		result[face] = sets.find(face);
	}
	return result;
}

std::vector<uint32_t> connected_edges(std::span<const ComponentInfo> edges, std::span<const uint32_t> asked) {
	std::vector<std::pair<PointKey, uint32_t>> ends;
	for (const uint32_t edge : asked) {
		ends.push_back({ key_of(edges[edge].from), edge });
		ends.push_back({ key_of(edges[edge].to), edge });
	}
	std::ranges::sort(ends);
	DisjointSets sets(edges.size());
	for (size_t i = 1; i < ends.size(); ++i) {
		if (ends[i].first == ends[i - 1].first) {
			sets.join(ends[i].second, ends[i - 1].second);
		}
	}
	std::vector<uint32_t> result(edges.size(), UINT32_MAX);
	for (const uint32_t edge : asked) {
		result[edge] = sets.find(edge);
	}
	return result;
}

} // namespace pcg::cga
