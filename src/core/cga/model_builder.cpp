#include "core/cga/model_builder.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/base/shrink.h"
#include "core/cga/instances.h"
#include "core/cga/measure.h"
#include "core/cga/zone_prism.h"
#include "core/geometry/polygon.h"

namespace pcg::cga {

namespace {

constexpr double place_pitch = 0.6; // metres of an object's longer side for one person

glm::dvec3 unit_or(glm::dvec3 vector, glm::dvec3 fallback) {
	const double length = glm::length(vector);
	return length > 1e-12 ? vector / length : fallback;
}

// An object seen from above lies within these bounds of its frame.
struct Bounds {
	glm::dvec3 low{ 0.0 }, high{ 0.0 };
	bool is_empty = true;

	void add(glm::vec3 corner) {
		const glm::dvec3 point(corner);
		low = is_empty ? point : glm::min(low, point);
		high = is_empty ? point : glm::max(high, point);
		is_empty = false;
	}
};

std::vector<Bounds> bounds_of_objects(const DerivationResult &model) {
	std::vector<Bounds> bounds(model.objects.size());
	for (size_t i = 0; i < bounds.size(); ++i) {
		for (const glm::vec3 &point : model.objects[i].mesh.positions) {
			bounds[i].add(point);
		}
	}
	for (const ModelInstance &instance : model.instances) {
		if (instance.object >= 0) {
			for (const glm::vec3 &point : model.prototypes[instance.prototype].mesh->positions) {
				bounds[size_t(instance.object)].add(placed(instance, point));
			}
		}
	}
	return bounds;
}

// Corners that were added without a coordinate take that of set 0: there a map looks whose own set is missing.
void complete_uvs(Mesh &mesh, size_t set, size_t corner_count) {
	std::vector<glm::vec2> &uvs = mesh.uvs[set];
	const std::vector<glm::vec2> &base = mesh.uvs[0];
	const size_t first = uvs.size();
	if (first >= corner_count) {
		return;
	}
	uvs.resize(corner_count, glm::vec2(0.0f));
	const size_t end = set > 0 ? std::min(base.size(), corner_count) : first;
	if (first < end) {
		std::copy(base.begin() + std::ptrdiff_t(first), base.begin() + std::ptrdiff_t(end), uvs.begin() + std::ptrdiff_t(first));
	}
}

void complete_uvs(Mesh &mesh) {
	for (size_t set = 0; set < uv_set_count; ++set) {
		if (!mesh.uvs[set].empty()) {
			complete_uvs(mesh, set, mesh.positions.size());
		}
	}
}

// The faces before the first smooth one are flat.
void complete_normals(Mesh &mesh, size_t corner_count) {
	for (size_t i = 0; mesh.normals.empty() && i + 1 < mesh.faces.size(); ++i) {
		const MeshFace &face = mesh.faces[i];
		const uint32_t end = mesh.loop_ends[face.first_loop + face.loop_count - 1];
		for (uint32_t corner = mesh.first_corner(face.first_loop); corner < end; ++corner) {
			mesh.normals.push_back(face.normal);
		}
	}
	mesh.normals.resize(corner_count, glm::vec3(0.0f, 1.0f, 0.0f));
}

// A city keeps its meshes: what they have not filled is given back, unless it is next to nothing.
template <typename T> void trim(std::vector<T> &list) {
	if (list.capacity() > list.size() + list.size() / 8) {
		shrink(list);
	}
}

void trim(Mesh &mesh) {
	std::ranges::for_each(mesh.uvs, [](auto &uvs) { trim(uvs); });
	trim(mesh.loop_ends);
	trim(mesh.faces);
	trim(mesh.normals);
	trim(mesh.positions);
}

} // namespace

ModelBuilder::MeshSize ModelBuilder::size_of(const Mesh &mesh) {
	MeshSize size = { mesh.positions.size(), mesh.loop_ends.size(), mesh.faces.size() };
	std::ranges::transform(mesh.uvs, size.uvs.begin(), [](const auto &uvs) { return uvs.size(); });
	return size;
}

void ModelBuilder::begin(const Lot &lot, bool counts_vertices) {
	_lot = lot;
	_counts_vertices = counts_vertices;
	std::destroy_at(&_result); // nothing is in it as a rule: quicker than giving it an empty one
	std::construct_at(&_result);
	_result.mesh.positions.reserve(_expected.positions);
	_result.mesh.loop_ends.reserve(_expected.loops);
	_result.mesh.faces.reserve(_expected.faces);
	for (size_t set = 0; set < uv_set_count; ++set) {
		_result.mesh.uvs[set].reserve(_expected.uvs[set]);
	}
	_object_frames.clear();
	_materials.begin();
	_instances.begin();
	_vertices_of.clear();
	_report_order.clear();
	_print_order.clear();
	++_model;
}

DerivationResult ModelBuilder::take() {
	_result.materials = _materials.take();
	complete_uvs(_result.mesh);
	for (ModelObject &object : _result.objects) {
		complete_uvs(object.mesh);
	}
	const std::vector<Bounds> bounds = bounds_of_objects(_result);
	for (size_t i = 0; i < _result.objects.size(); ++i) {
		if (_result.objects[i].places.empty()) {
			add_default_places(_result.objects[i], _object_frames[i], bounds[i].low, bounds[i].high);
		}
	}
	_report_order.sort(_result.reports);
	_print_order.sort(_result.prints);
	_expected = size_of(_result.mesh);
	trim(_result.mesh);
	for (ModelObject &object : _result.objects) {
		trim(object.mesh);
	}
	return std::move(_result);
}

// Of the leaf's scope in the mesh that it goes to.
Frame ModelBuilder::target_frame(const Shape &shape) const {
	Frame frame = shape.frame();
	if (shape.object < 0) {
		frame.origin += _lot.origin;
		return frame;
	}
	const Frame &object = _object_frames[size_t(shape.object)];
	return { glm::transpose(object.axes) * frame.axes, object.to_local(frame.origin) };
}

uint32_t ModelBuilder::count_vertices(const Geometry &geometry) {
	if (geometry.face_count == 0 || geometry.outline(geometry.faces[0]).size() < 3) { // edges and points are not in the model
		return 0;
	}
	const Geometry *whole = geometry.inserted; // copies of it come and go in one place of the arena
	if (!geometry.is_instance || whole == nullptr || whole->points != geometry.points) {
		return vertex_count(geometry);
	}
	const auto [found, is_new] = _vertices_of.try_emplace(whole, 0);
	if (is_new) {
		found->second = vertex_count(geometry);
	}
	return found->second;
}

void ModelBuilder::add_leaf(const Shape &shape) {
	++_result.leaf_count;
	if (shape.geometry == nullptr) {
		return;
	}
	if (_counts_vertices && shape.object < 0) {
		_result.vertex_count += count_vertices(*shape.geometry);
	}
	const Frame frame = target_frame(shape);
	if (shape.geometry->is_instance && _instances.add(shape, frame, _materials, _result)) {
		return;
	}
	Mesh &mesh = shape.object < 0 ? _result.mesh : _result.objects[size_t(shape.object)].mesh;
	add_faces(mesh, shape, frame, [&](uint16_t material) { return _materials.index_of(*shape.look, material); });
}

template <typename MaterialOf> void ModelBuilder::add_faces(Mesh &mesh, const Shape &shape, const Frame &to_target, MaterialOf material_of) {
	const Geometry &geometry = *shape.geometry;
	if (_points.size() < geometry.point_count) {
		_points.resize(geometry.point_count);
		_shown_points.resize(geometry.point_count);
	}
	for (uint32_t i = 0; i < geometry.point_count; ++i) {
		_points[i] = to_target.to_parent(shape.to_scope(geometry.points[i]));
		_shown_points[i] = glm::vec3(_points[i]);
	}
	uint32_t material = 0;
	for (uint32_t i = 0; i < geometry.face_count; ++i) {
		const GeometryFace &face = geometry.faces[i];
		if (i == 0 || face.material != geometry.faces[i - 1].material) {
			material = material_of(face.material);
		}
		if (add_face(mesh, geometry, face, material) && (geometry.corners != nullptr || !mesh.normals.empty())) {
			add_corner_data(mesh, shape, face, to_target);
		}
	}
}

void ModelBuilder::add_model(const Geometry &geometry, const glm::dmat3 &turn, SharedMesh &shown) {
	for (uint32_t i = 0; i < geometry.face_count; ++i) {
		if (geometry.faces[i].material == 0) { // the shape's own, because there are too many
			return;
		}
	}
	_instances.add_model(geometry, turn, shown.get([&] { return make_shown(geometry, turn); }));
}

Mesh ModelBuilder::make_shown(const Geometry &geometry, const glm::dmat3 &turn) {
	const uint64_t face_count = _result.face_count;
	const std::vector<uint16_t> materials = materials_in(geometry);
	Shape shape;
	shape.geometry = &geometry;
	Mesh mesh;
	add_faces(mesh, shape, { glm::transpose(turn), glm::dvec3(0.0) },
			[&](uint16_t material) { return uint32_t(std::ranges::find(materials, material) - materials.begin()); });
	complete_uvs(mesh);
	_result.face_count = face_count;
	return mesh;
}

// Of the face added last.
void ModelBuilder::add_corner_data(Mesh &mesh, const Shape &shape, const GeometryFace &face, const Frame &to_target) {
	const Geometry &geometry = *shape.geometry;
	const size_t first = geometry.first_point(face.first_loop), count = geometry.face_point_count(face);
	const size_t corner = mesh.positions.size() - count;
	const CornerData *const corners = geometry.corners;
	const size_t set_end = corners != nullptr ? corners->set_end : 0;
	for (size_t set = 0; set < set_end; ++set) {
		if (corners->uvs[set] == nullptr) {
			continue;
		}
		const glm::dvec2 *uvs = corners->uvs[set], *base = corners->uvs[0];
		std::vector<glm::vec2> &target = mesh.uvs[set];
		if (target.size() < corner) {
			complete_uvs(mesh, set, corner);
		}
		for (size_t i = first; i < first + count; ++i) {
			const glm::dvec2 uv = has_uv(uvs[i]) || base == nullptr ? uvs[i] : base[i];
			target.push_back(has_uv(uv) ? glm::vec2(uv) : glm::vec2(0.0f));
		}
	}
	const glm::dvec3 *normals = corners != nullptr ? corners->normals : nullptr;
	if (normals == nullptr && mesh.normals.empty()) {
		return;
	}
	complete_normals(mesh, corner);
	const glm::vec3 face_normal = mesh.faces.back().normal;
	const glm::dmat3 turn = to_target.axes * normal_matrix(shape);
	for (size_t i = first; i < first + count; ++i) {
		const glm::dvec3 normal = normals != nullptr ? turn * normals[i] : glm::dvec3(0.0);
		const double length = glm::length(normal);
		mesh.normals.push_back(length > 1e-12 ? glm::vec3(normal / length) : face_normal);
	}
}

// Of the present leaf. False: it has no area.
bool ModelBuilder::add_face(Mesh &mesh, const Geometry &geometry, const GeometryFace &face, uint32_t material) {
	const uint32_t first = geometry.first_point(face.first_loop), end = geometry.loop_ends[face.first_loop + face.loop_count - 1];
	const glm::dvec3 area = area_vector(std::span(_points).subspan(first, geometry.loop_ends[face.first_loop] - first));
	const double size = glm::length(area);
	if (!(size > least_face_size) || !std::isfinite(size)) { // edges, points and what was flattened away
		return false;
	}
	const uint32_t first_loop = uint32_t(mesh.loop_ends.size()), corner = uint32_t(mesh.positions.size());
	mesh.positions.insert(mesh.positions.end(), _shown_points.begin() + first, _shown_points.begin() + end);
	for (uint32_t i = 0; i < face.loop_count; ++i) {
		mesh.loop_ends.push_back(corner + geometry.loop_ends[face.first_loop + i] - first);
	}
	mesh.faces.push_back({ first_loop, face.loop_count, material, glm::vec3(area / size) });
	++_result.face_count;
	return true;
}

int32_t ModelBuilder::begin_object(std::string_view tag, const Shape &shape) {
	Frame frame = shape.frame();
	frame.origin = frame.to_parent(glm::dvec3(0.5, 0.0, 0.5) * shape.size);
	ModelObject object;
	object.tag = tag;
	object.parent = shape.object;
	for (int axis = 0; axis < 3; ++axis) {
		object.frame[axis] = glm::vec4(glm::vec3(frame.axes[axis]), 0.0f);
	}
	object.frame[3] = glm::vec4(to_world(frame.origin), 1.0f);
	_object_frames.push_back(frame);
	_result.objects.push_back(std::move(object));
	return int32_t(_result.objects.size()) - 1;
}

void ModelBuilder::add_entrance(std::string_view type, const Shape &shape, double capacity) {
	const Frame frame = shape.frame();
	_result.entrances.push_back({ std::string(type), to_world(frame.origin), glm::vec3(frame.axes[2]), uint32_t(capacity) });
}

void ModelBuilder::add_zone(std::string_view type, const Shape &shape, double flat_height) {
	const ZonePrism prism = zone_prism(shape, flat_height);
	ModelZone zone;
	zone.type = type;
	zone.height = float(prism.height);
	for (const glm::dvec3 &point : prism.outline) {
		zone.polygon.push_back(to_world(point));
	}
	_result.zones.push_back(std::move(zone));
}

bool ModelBuilder::add_place(const Shape &shape) {
	if (shape.object < 0) {
		return false;
	}
	const Frame frame = shape.frame();
	_result.objects[size_t(shape.object)].places.push_back({ to_world(frame.origin), glm::vec3(frame.axes[2]) });
	return true;
}

// One person for each 0.6 m of the longer side, at the edge of the floor, looking outwards: along x on the scope's front, along z on the side
// that looks to the middle of the lot.
void ModelBuilder::add_default_places(ModelObject &object, const Frame &frame, glm::dvec3 low, glm::dvec3 high) {
	const glm::dvec3 size = high - low;
	const glm::dvec3 middle = 0.5 * (low + high);
	const int along = size.x >= size.z ? 0 : 2;
	const int across = 2 - along;
	const bool is_low_side = along == 2 && frame.to_local(_lot.center).x < middle.x;
	const double count = std::clamp(std::floor(size[along] / place_pitch + 1e-9), 1.0, 1000.0);
	glm::dvec3 facing(0.0);
	facing[across] = is_low_side ? -1.0 : 1.0;
	for (double i = 0.0; i < count; ++i) {
		glm::dvec3 point(0.0, low.y, 0.0);
		point[along] = low[along] + size[along] * (i + 0.5) / count;
		point[across] = is_low_side ? low[across] : high[across];
		const glm::dvec3 direction = unit_or(frame.axes * facing, { 0.0, 0.0, 1.0 });
		object.places.push_back({ to_world(frame.to_parent(point)), glm::vec3(direction) });
	}
}

ModelReport &ModelBuilder::find_report(const Text &key, ValueType type) {
	const bool is_of_program = key.symbol != no_symbol;
	if (is_of_program && key.symbol >= _report_places.size()) {
		_report_places.resize(key.symbol + 1u);
	}
	if (is_of_program && _report_places[key.symbol].model == _model && _result.reports[_report_places[key.symbol].index].type == type) {
		return _result.reports[_report_places[key.symbol].index];
	}
	auto found = std::ranges::find_if(_result.reports, [&](const ModelReport &report) { return report.key == key.view && report.type == type; });
	if (found == _result.reports.end()) {
		ModelReport report;
		report.key = key.view;
		report.type = type;
		_result.reports.push_back(std::move(report));
		found = _result.reports.end() - 1;
	}
	if (is_of_program) {
		_report_places[key.symbol] = { _model, size_t(found - _result.reports.begin()) };
	}
	return *found;
}

void ModelBuilder::add_report(const Text &key, const Value &value, uint32_t depth) {
	ModelReport &report = find_report(key, value.type);
	_report_order.note(size_t(&report - _result.reports.data()), depth);
	report.add(value);
}

void ModelBuilder::add_print(std::string line, uint32_t depth) {
	constexpr size_t most = 10'000;
	if (_result.prints.size() < most) {
		_print_order.note(_result.prints.size(), depth);
		_result.prints.push_back(std::move(line));
	}
}

} // namespace pcg::cga
