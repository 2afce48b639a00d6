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
	const auto take = [&](auto &target, const auto &source) {
		target.insert(target.end(), source.begin() + corner, source.begin() + corner + std::ptrdiff_t(flat.points.size()));
	};
	take(surface.positions, mesh.positions);
	if (mesh.normals.empty()) {
		surface.normals.resize(surface.positions.size(), face.normal);
	} else {
		take(surface.normals, mesh.normals);
	}
	for (size_t set = 0; set < uv_set_count; ++set) {
		if (!mesh.uvs[set].empty()) {
			take(surface.uvs[set], mesh.uvs[set]);
		}
	}
	for (const uint32_t index : flat.triangles) {
		surface.indices.push_back(first + index);
	}
}

// The normals of a mesh's corners behind those that the target has; flat faces give their own. A mesh added to itself fills what it lacks.
void add_normals(Mesh &target, const Mesh &source) {
	if (&target == &source && !target.normals.empty()) {
		return;
	}
	const size_t first = target.normals.size();
	if (!source.normals.empty()) {
		target.normals.insert(target.normals.end(), source.normals.begin(), source.normals.end());
		return;
	}
	target.normals.resize(first + source.positions.size(), glm::vec3(0.0f, 1.0f, 0.0f));
	for (const MeshFace &face : source.faces) {
		const auto corners = target.normals.begin() + std::ptrdiff_t(first);
		std::fill(corners + source.first_corner(face.first_loop), corners + source.loop_ends[face.first_loop + face.loop_count - 1], face.normal);
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
	const size_t corner_count = target.positions.size() + source.positions.size();
	for (size_t set = 0; set < uv_set_count; ++set) {
		std::vector<glm::vec2> &uvs = target.uvs[set];
		if (!uvs.empty() || !source.uvs[set].empty()) {
			uvs.resize(corner_offset, glm::vec2(0.0f));
			uvs.insert(uvs.end(), source.uvs[set].begin(), source.uvs[set].end());
			uvs.resize(corner_count, glm::vec2(0.0f));
		}
	}
	if (!target.normals.empty() || !source.normals.empty()) {
		add_normals(target, target);
		add_normals(target, source);
	}
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
