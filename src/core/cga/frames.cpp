#include "core/cga/frames.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/cga/extrude.h"
#include "core/geometry/bounding_rectangle.h"
#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

constexpr double tie = 1e-6; // metres and square metres: what differs less is equal, and the lower index is taken

glm::dvec3 unit(int axis) {
	glm::dvec3 result(0.0);
	result[axis] = 1.0;
	return result;
}

void fold_into_pivot(Shape &shape, Arena &arena) {
	shape.pivot = arena.make(shape.frame());
	shape.position = glm::dvec3(0.0);
	shape.rotation = glm::dmat3(1.0);
}

// Right-handed, looking into the box from its corner.
glm::dmat3 pivot_axes(PivotOrder order, glm::dvec3 inwards) {
	const glm::dvec3 x(inwards.x, 0.0, 0.0), y(0.0, inwards.y, 0.0), z(0.0, 0.0, inwards.z);
	const bool is_right_handed = inwards.x * inwards.y * inwards.z > 0.0;
	const glm::dmat3 axes = is_right_handed ? glm::dmat3(x, y, z) : glm::dmat3(z, y, x);
	return order == PivotOrder::Xyz ? axes
			: order == PivotOrder::Yzx ? glm::dmat3(axes[2], axes[0], axes[1])
									   : glm::dmat3(axes[1], axes[2], axes[0]);
}

// The faces of a shape with their corners in world-parallel coordinates.
class WorldFaces {
public:
	explicit WorldFaces(const Shape &shape) : _geometry(*shape.geometry) {
		const Frame frame = shape.frame();
		for (uint32_t i = 0; i < _geometry.point_count; ++i) {
			_points.push_back(frame.to_parent(shape.to_scope(_geometry.points[i])));
		}
	}

	uint32_t count() const { return _geometry.face_count; }
	std::span<const glm::dvec3> outline(uint32_t face) const {
		const uint32_t loop = _geometry.faces[face].first_loop;
		return { _points.data() + _geometry.first_point(loop), _geometry.loop(loop).size() };
	}
	double height(uint32_t face) const {
		double sum = 0.0;
		for (const glm::dvec3 &point : outline(face)) {
			sum += point.y;
		}
		return sum / double(outline(face).size());
	}
	double area(uint32_t face) const {
		double sum = 0.0;
		const GeometryFace &source = _geometry.faces[face];
		for (uint32_t l = source.first_loop; l < source.first_loop + source.loop_count; ++l) {
			const std::span<const glm::dvec3> loop(_points.data() + _geometry.first_point(l), _geometry.loop(l).size());
			sum += (l == source.first_loop ? 0.5 : -0.5) * glm::length(area_vector(loop));
		}
		return sum;
	}

private:
	const Geometry &_geometry;
	std::vector<glm::dvec3> _points;
};

struct Edge {
	uint32_t face = 0;
	glm::dvec3 from{ 0.0 }, to{ 0.0 };
};

Edge edge_at(const WorldFaces &faces, uint32_t face, size_t index) {
	const auto outline = faces.outline(face);
	return { face, outline[index % outline.size()], outline[(index + 1) % outline.size()] };
}

size_t wrapped(double index, size_t count) {
	const double rest = std::fmod(std::trunc(index), double(count));
	return size_t(rest < 0.0 ? rest + double(count) : rest) % count;
}

// The first of the edges for which `value` is least.
template <typename Value> Edge least_edge(const WorldFaces &faces, uint32_t first, uint32_t end, Value value) {
	Edge best = edge_at(faces, first, 0);
	for (uint32_t face = first; face < end; ++face) {
		for (size_t i = 0; i < faces.outline(face).size(); ++i) {
			const Edge edge = edge_at(faces, face, i);
			best = value(edge) < value(best) - tie ? edge : best;
		}
	}
	return best;
}

double height_of(const Edge &edge) { return 0.5 * (edge.from.y + edge.to.y); }
double shortness_of(const Edge &edge) { return -glm::distance(edge.from, edge.to); }

Edge choose_edge(const WorldFaces &faces, uint32_t first, uint32_t end, EdgeChoice choice) {
	switch (choice.kind) {
		case EdgeChoice::Kind::Index:
			return edge_at(faces, first, wrapped(choice.index, faces.outline(first).size()));
		case EdgeChoice::Kind::Longest:
			return least_edge(faces, first, end, shortness_of);
		case EdgeChoice::Kind::Lowest:
			return least_edge(faces, first, end, height_of);
		default: {
			const Edge lowest = least_edge(faces, first, end, height_of);
			const Edge highest = least_edge(faces, first, end, [](const Edge &edge) { return -height_of(edge); });
			return height_of(highest) - height_of(lowest) <= tie ? least_edge(faces, first, end, shortness_of) : lowest;
		}
	}
}

uint32_t choose_face(const WorldFaces &faces, FaceChoice choice) {
	if (choice.kind == FaceChoice::Kind::Index) {
		return uint32_t(wrapped(choice.index, faces.count()));
	}
	const auto value = [&](uint32_t face) { return choice.kind == FaceChoice::Kind::Lowest ? faces.height(face) : -faces.area(face); };
	uint32_t best = 0;
	for (uint32_t face = 1; face < faces.count(); ++face) {
		best = value(face) < value(best) - tie ? face : best;
	}
	return best;
}

} // namespace

void align_scope(Shape &shape, const glm::dmat3 &axes, GeometryBuilder &builder, Arena &arena) {
	turn_scope(shape, glm::transpose(shape.frame().axes) * axes, builder, arena);
	shape.pivot = arena.make(Frame{ axes, shape.frame().origin });
	shape.position = glm::dvec3(0.0);
	shape.rotation = glm::dmat3(1.0);
}

void set_pivot(Shape &shape, PivotOrder order, uint32_t corner, GeometryBuilder &builder, Arena &arena) {
	const bool is_far[3] = { corner % 4 == 1 || corner % 4 == 2, corner >= 4, corner % 4 >= 2 };
	const Frame old = shape.frame();
	const glm::dvec3 old_size = shape.size;
	glm::dvec3 place(0.0), inwards(1.0);
	for (int axis = 0; axis < 3; ++axis) {
		place[axis] = is_far[axis] ? old_size[axis] : 0.0;
		inwards[axis] = is_far[axis] != (old_size[axis] < 0.0) ? -1.0 : 1.0;
	}
	const glm::dmat3 axes = pivot_axes(order, inwards);
	turn_scope(shape, axes, builder, arena);
	const Frame wanted = { old.axes * axes, old.to_parent(place) };
	shape.geometry_offset -= glm::transpose(wanted.axes) * (wanted.origin - shape.frame().origin);
	shape.pivot = arena.make(wanted);
	shape.position = glm::dvec3(0.0);
	shape.rotation = glm::dmat3(1.0);
	shape.size = glm::abs(glm::transpose(axes) * old_size);
}

void turn_scope_to(Shape &shape, glm::dvec3 up, GeometryBuilder &builder, Arena &arena) {
	const glm::dmat3 axes = axes_from_y(up, glm::dvec3(1.0, 0.0, 0.0));
	const bool is_turned = glm::distance(axes[0], unit(0)) > 1e-12 || glm::distance(axes[1], unit(1)) > 1e-12;
	if (is_turned) {
		turn_scope(shape, axes, builder, arena);
	}
}

void mirror_scope(Shape &shape, int axis) {
	shape.position += shape.rotation * (shape.size[axis] * unit(axis));
	shape.geometry_offset[axis] -= shape.size[axis];
	shape.size[axis] = 0.0 - shape.size[axis]; // never -0
}

void mirror_geometry(Shape &shape, const bool (&axes)[3], GeometryBuilder &builder, Arena &arena) {
	if (shape.geometry == nullptr) {
		return;
	}
	for (int axis = 0; axis < 3; ++axis) {
		if (axes[axis]) {
			shape.geometry_offset[axis] = shape.size[axis] - shape.geometry_offset[axis];
			shape.geometry_scale[axis] = -shape.geometry_scale[axis];
		}
	}
	if (axes[0] == (axes[1] == axes[2])) { // an odd number turns faces inside out
		const Geometry &mirrored = *baked(shape, arena);
		builder.begin(mirrored, glm::dmat3(-1.0));
		for (uint32_t f = 0; f < mirrored.face_count; ++f) {
			const GeometryFace &face = mirrored.faces[f];
			for (uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
				const uint32_t first = mirrored.first_point(l), count = mirrored.loop_ends[l] - first;
				for (uint32_t i = 0; i < count; ++i) { // the other way around, with the same first edge
					const uint32_t corner = first + (count + 1 - i) % count;
					builder.add_corner(mirrored.points[corner], corner);
				}
				builder.end_loop(std::min(count, 3u));
			}
			builder.end_face(face.tag, face.material);
		}
		shape.geometry = builder.finish(arena, mirrored.is_closed);
		shape.geometry_offset = glm::dvec3(0.0);
		shape.geometry_scale = glm::dvec3(1.0);
	}
}

void align_scope_to_geometry(Shape &shape, bool is_z_up, FaceChoice face, EdgeChoice edge, GeometryBuilder &builder, Arena &arena) {
	if (shape.geometry == nullptr) {
		fold_into_pivot(shape, arena);
		return;
	}
	const WorldFaces faces(shape);
	const bool is_any = face.kind == FaceChoice::Kind::Any && edge.kind != EdgeChoice::Kind::Index;
	const uint32_t first = is_any || face.kind == FaceChoice::Kind::Any ? 0 : choose_face(faces, face);
	const Edge chosen = choose_edge(faces, first, is_any ? faces.count() : first + 1, edge);
	const glm::dmat3 old = shape.frame().axes;
	const glm::dvec3 normal = loop_normal(faces.outline(chosen.face), old[is_z_up ? 2 : 1]);
	const glm::dvec3 along = chosen.to == chosen.from ? old[0] : chosen.to - chosen.from;
	align_scope(shape, is_z_up ? axes_from_z(normal, along) : axes_from_y(normal, along), builder, arena);
}

void align_scope_to_rectangle(Shape &shape, int longer, int shorter, GeometryBuilder &builder, Arena &arena) {
	if (shape.geometry == nullptr) {
		fold_into_pivot(shape, arena);
		return;
	}
	std::vector<glm::dvec2> points;
	for (uint32_t i = 0; i < shape.geometry->point_count; ++i) {
		const glm::dvec3 point = shape.to_scope(shape.geometry->points[i]);
		points.push_back({ point[longer], point[shorter] });
	}
	const glm::dvec2 side = longer_side_of_least_rectangle(points, { 1.0, 0.0 });
	glm::dmat3 turn(1.0);
	turn[longer] = side.x * unit(longer) + side.y * unit(shorter);
	turn[shorter] = side.x * unit(shorter) - side.y * unit(longer);
	align_scope(shape, shape.frame().axes * turn, builder, arena);
}

} // namespace pcg::cga
