#include "core/geometry/mesh.h"

#include <algorithm>
#include <map>

#include <glm/geometric.hpp>

#include "core/geometry/polygon.h"
#include "core/geometry/triangulate.h"

namespace pcg {

namespace {

// The corners of one face laid into a plane, with the ends of its loops counted from its own first corner.
struct FlatFace {
	std::vector<glm::dvec2> points;
	std::vector<uint32_t> loop_ends;
	std::vector<uint32_t> triangles;

	void set(const Mesh &mesh, const MeshFace &face) {
		points.clear();
		loop_ends.clear();
		triangles.clear();
		for (uint32_t i = 0; i < face.loop_count; ++i) {
			for (const glm::vec3 point : mesh.loop(face.first_loop + i)) {
				points.push_back(flatten(glm::dvec3(point), glm::dvec3(face.normal)));
			}
			loop_ends.push_back(uint32_t(points.size()));
		}
		triangulate(points, loop_ends, triangles);
	}
};

void add_face(MeshSurface &surface, const Mesh &mesh, const MeshFace &face, const FlatFace &flat) {
	const uint32_t first = uint32_t(surface.positions.size());
	const uint32_t corner = mesh.first_corner(face.first_loop);
	surface.positions.insert(surface.positions.end(), mesh.positions.begin() + corner,
			mesh.positions.begin() + corner + std::ptrdiff_t(flat.points.size()));
	surface.normals.resize(surface.positions.size(), face.normal);
	for (const uint32_t index : flat.triangles) {
		surface.indices.push_back(first + index);
	}
}

} // namespace

std::vector<MeshSurface> make_surfaces(const Mesh &mesh) {
	std::map<uint32_t, MeshSurface> surfaces;
	FlatFace flat;
	for (const MeshFace &face : mesh.faces) {
		flat.set(mesh, face);
		if (!flat.triangles.empty()) {
			add_face(surfaces[face.material], mesh, face, flat);
		}
	}
	std::vector<MeshSurface> result;
	for (auto &[material, surface] : surfaces) {
		surface.material = material;
		result.push_back(std::move(surface));
	}
	return result;
}

void append(Mesh &target, const Mesh &source, uint32_t material_offset) {
	const uint32_t corner_offset = uint32_t(target.positions.size());
	const uint32_t loop_offset = uint32_t(target.loop_ends.size());
	target.positions.insert(target.positions.end(), source.positions.begin(), source.positions.end());
	for (const uint32_t end : source.loop_ends) {
		target.loop_ends.push_back(end + corner_offset);
	}
	for (MeshFace face : source.faces) {
		face.first_loop += loop_offset;
		face.material += material_offset;
		target.faces.push_back(face);
	}
}

double area(const Mesh &mesh) {
	double sum = 0.0;
	std::vector<glm::dvec3> loop;
	for (const MeshFace &face : mesh.faces) {
		for (uint32_t i = 0; i < face.loop_count; ++i) {
			const auto points = mesh.loop(face.first_loop + i);
			loop.assign(points.begin(), points.end());
			const double size = 0.5 * glm::length(area_vector(loop));
			sum += i == 0 ? size : -size;
		}
	}
	return sum;
}

} // namespace pcg
