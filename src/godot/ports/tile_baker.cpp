#include "godot/ports/tile_baker.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <godot_cpp/classes/navigation_server3d.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include "core/city/walkable.h"
#include "godot/convert.h"

using namespace godot;

namespace pcg {

namespace {

constexpr float off_line = 1e-3f; // metres

float area_of(const PackedVector3Array &vertices, const PackedInt32Array &polygon) {
	float doubled = 0.0f;
	for (int64_t i = 1; i + 1 < polygon.size(); ++i) {
		doubled += (vertices[polygon[i]] - vertices[polygon[0]]).cross(vertices[polygon[i + 1]] - vertices[polygon[0]]).length();
	}
	return doubled / 2.0f;
}

// Where outlines touch themselves the engine's baker lays polygons over one another, and the map complains of edges that more than two share. The smallest
// on such an edge go: what they lie on stays.
void remove_overlaid(const Ref<NavigationMesh> &mesh) {
	const PackedVector3Array vertices = mesh->get_vertices();
	std::vector<PackedInt32Array> polygons;
	std::vector<std::pair<float, size_t>> by_area; // the largest first
	for (int i = 0; i < mesh->get_polygon_count(); ++i) {
		polygons.push_back(mesh->get_polygon(i));
		by_area.emplace_back(-area_of(vertices, polygons.back()), size_t(i));
	}
	std::sort(by_area.begin(), by_area.end());
	std::map<std::pair<int32_t, int32_t>, int> users; // of edges, by their ends
	std::vector<bool> is_kept(polygons.size());
	for (const auto &[area, index] : by_area) {
		const PackedInt32Array &polygon = polygons[index];
		std::vector<int *> counts;
		for (int64_t i = 0; i < polygon.size(); ++i) {
			counts.push_back(&users[std::minmax(int32_t(polygon[i]), int32_t(polygon[(i + 1) % polygon.size()]))]);
		}
		is_kept[index] = std::ranges::all_of(counts, [](const int *count) { return *count < 2; });
		for (int *count : counts) {
			*count += is_kept[index];
		}
	}
	if (std::ranges::find(is_kept, false) == is_kept.end()) {
		return;
	}
	mesh->clear_polygons();
	for (size_t i = 0; i < polygons.size(); ++i) {
		if (is_kept[i]) {
			mesh->add_polygon(polygons[i]);
		}
	}
}

} // namespace

TileBaker::TileBaker(const City &city, BakeSettings settings) : _city(city), _settings(settings) {
	_jobs.resize(city.layout.tiles.size());
}

float TileBaker::snap(float metres) const { return std::round(metres / _settings.cell_size) * _settings.cell_size; }

// The engine warns where its remainder by the size of cells is not nearly 0, which depends on how the two are rounded.
float TileBaker::border_size() const {
	float size = border;
	for (float cells = std::ceil(border / _settings.cell_size); cells < 64.0f; ++cells) {
		size = cells * _settings.cell_size;
		if (std::fmod(size, _settings.cell_size) < 1e-5f) {
			break;
		}
	}
	return size;
}

AABB TileBaker::snapped(glm::vec3 min, glm::vec3 max) const {
	const float border = border_size();
	const Vector3 low(snap(min.x) - border, -1.0f, snap(min.z) - border);
	const Vector3 high(snap(max.x) + border, 3.0f, snap(max.z) + border);
	return AABB(low, high - low);
}

void TileBaker::bake(uint32_t tile, bool is_async) {
	Job &job = _jobs[tile];
	const Tile &place = _city.layout.tiles[tile];
	const std::vector<glm::vec3> triangles = tile_faces(_city, place, border_size(), false);
	PackedVector3Array faces; // the baker wants the engine's winding: clockwise from above
	for (size_t i = 0; i + 2 < triangles.size(); i += 3) {
		faces.push_back(to_godot(triangles[i]));
		faces.push_back(to_godot(triangles[i + 2]));
		faces.push_back(to_godot(triangles[i + 1]));
	}
	job.source.instantiate();
	job.source->add_faces(faces, Transform3D());
	job.mesh.instantiate();
	job.mesh->set_cell_size(_settings.cell_size);
	job.mesh->set_cell_height(_settings.cell_height);
	job.mesh->set_agent_radius(std::ceil(_settings.agent_radius / _settings.cell_size - 1e-4f) * _settings.cell_size);
	job.mesh->set_agent_height(std::ceil(_settings.agent_height / _settings.cell_height) * _settings.cell_height);
	job.mesh->set_agent_max_climb(std::floor(_settings.agent_max_climb / _settings.cell_height) * _settings.cell_height);
	job.mesh->set_agent_max_slope(_settings.agent_max_slope);
	job.mesh->set_border_size(border_size());
	job.mesh->set_filter_baking_aabb(snapped(place.min, place.max));
	job.is_finished = faces.is_empty(); // the engine would complain
	if (job.is_finished) {
		return;
	}
	NavigationServer3D *server = NavigationServer3D::get_singleton();
	if (is_async) {
		server->bake_from_source_geometry_data_async(job.mesh, job.source);
	} else {
		server->bake_from_source_geometry_data(job.mesh, job.source);
	}
}

bool TileBaker::is_baking(uint32_t tile) const {
	const Job &job = _jobs[tile];
	return !job.is_finished && job.mesh.is_valid() && NavigationServer3D::get_singleton()->is_baking_navigation_mesh(job.mesh);
}

Ref<NavigationMesh> TileBaker::finish(uint32_t tile) {
	Job &job = _jobs[tile];
	if (!job.is_finished) {
		job.is_finished = true;
		job.source.unref();
		PackedVector3Array vertices = job.mesh->get_vertices();
		Vector3 *vertex = vertices.ptrw();
		for (int64_t i = 0; i < vertices.size(); ++i) {
			vertex[i] = Vector3(snap(vertex[i].x) + off_line, vertex[i].y + off_line - 2.0f * _settings.cell_height, snap(vertex[i].z) + off_line);
		}
		job.mesh->set_vertices(vertices);
		remove_overlaid(job.mesh);
		job.mesh->set_cell_size(_settings.map_cell_size); // the map takes no others
	}
	return job.mesh;
}

} // namespace pcg
