#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <glm/mat4x4.hpp>

#include "core/geometry/polygon.h"
#include "core/io/asset_reader.h"
#include "core/io/gltf_accessor.h"
#include "core/io/gltf_material.h"

// glTF 2.0, as text with its buffers beside it or as one binary file.
namespace pcg {

namespace {

constexpr size_t max_node_depth = 256;
constexpr size_t max_node_visits = 200'000; // a node may hang below several others, by mistake in circles

glm::dmat4 local_matrix(const tinygltf::Node &node) {
	if (node.matrix.size() == 16) {
		return glm::make_mat4(node.matrix.data());
	}
	glm::dmat4 matrix(1.0);
	if (node.rotation.size() == 4) {
		matrix = glm::mat4_cast(glm::normalize(glm::dquat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2])));
	}
	for (int axis = 0; axis < 3; ++axis) {
		matrix[axis] *= node.scale.size() == 3 ? node.scale[size_t(axis)] : 1.0;
		matrix[3][axis] = node.translation.size() == 3 ? node.translation[size_t(axis)] : 0.0;
	}
	return matrix;
}

class GltfReader {
public:
	GltfReader(const tinygltf::Model &model, const std::string &path, const AssetLimits &limits) : _model(model), _path(path), _limits(limits) {}

	Asset read() {
		for (const tinygltf::Material &material : _model.materials) {
			_asset.materials.push_back(material_of_gltf(_model, material, _path));
		}
		_asset.materials.emplace_back(); // of surfaces without one
		std::vector<Visit> open;
		for (int root : roots()) {
			open.push_back({ root, 0, glm::dmat4(1.0) });
		}
		std::ranges::reverse(open);
		for (size_t visits = 0; !open.empty() && visits < max_node_visits; ++visits) {
			const Visit visit = open.back();
			open.pop_back();
			visit_node(visit, open);
		}
		if (_asset.mesh.is_empty() && _asset.problem.empty()) {
			_asset.problem = "there is no face in it";
		}
		complete_corners(_asset.mesh);
		return std::move(_asset);
	}

private:
	struct Visit {
		int node;
		size_t depth;
		glm::dmat4 parent;
	};

	std::vector<int> roots() const {
		const int scene = _model.defaultScene >= 0 ? _model.defaultScene : 0;
		if (size_t(scene) < _model.scenes.size()) {
			return _model.scenes[size_t(scene)].nodes;
		}
		std::vector<bool> is_child(_model.nodes.size(), false);
		for (const tinygltf::Node &node : _model.nodes) {
			for (int child : node.children) {
				if (child >= 0 && size_t(child) < is_child.size()) {
					is_child[size_t(child)] = true;
				}
			}
		}
		std::vector<int> result;
		for (size_t i = 0; i < is_child.size(); ++i) {
			if (!is_child[i]) {
				result.push_back(int(i));
			}
		}
		return result;
	}

	void visit_node(const Visit &visit, std::vector<Visit> &open) {
		if (visit.node < 0 || size_t(visit.node) >= _model.nodes.size() || visit.depth > max_node_depth) {
			_asset.problem = "its nodes are not in order";
			return;
		}
		const tinygltf::Node &node = _model.nodes[size_t(visit.node)];
		const glm::dmat4 matrix = visit.parent * local_matrix(node);
		if (node.mesh >= 0 && size_t(node.mesh) < _model.meshes.size()) {
			for (const tinygltf::Primitive &primitive : _model.meshes[size_t(node.mesh)].primitives) {
				add_primitive(primitive, matrix);
			}
		}
		for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
			open.push_back({ *child, visit.depth + 1, matrix });
		}
	}

	void add_primitive(const tinygltf::Primitive &primitive, const glm::dmat4 &matrix) {
		const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
		if (mode != TINYGLTF_MODE_TRIANGLES && mode != TINYGLTF_MODE_TRIANGLE_STRIP && mode != TINYGLTF_MODE_TRIANGLE_FAN) {
			return; // points and lines
		}
		_points.clear();
		const std::vector<double> numbers = read_accessor(_model, attribute(primitive, "POSITION"), 3);
		for (size_t i = 0; i + 2 < numbers.size(); i += 3) {
			_points.push_back(glm::dvec3(matrix * glm::dvec4(numbers[i], numbers[i + 1], numbers[i + 2], 1.0)));
		}
		std::vector<uint32_t> indices = primitive.indices >= 0 ? read_indices(_model, primitive.indices) : counting(_points.size());
		if (_points.empty() || indices.size() < 3) {
			_asset.problem = "a surface points outside of its buffers, or is packed in a way that is not read (sparse, Draco)";
			return;
		}
		read_corners(primitive, matrix);
		add_triangles(mode, indices, material_of(primitive), glm::determinant(glm::dmat3(matrix)) < 0.0);
	}

	// Texture coordinates as the material's pictures want them, and normals.
	void read_corners(const tinygltf::Primitive &primitive, const glm::dmat4 &matrix) {
		const bool has_material = primitive.material >= 0 && size_t(primitive.material) < _model.materials.size();
		const std::vector<TexturePlace> places = textures_of(has_material ? _model.materials[size_t(primitive.material)] : tinygltf::Material());
		for (std::vector<double> &uvs : _uvs) {
			uvs.clear();
		}
		_uvs[0] = read_uvs(primitive, places[0].uv_set);
		for (const TexturePlace &place : places) {
			if (place.texture >= 0 && place.uv_set != places[0].uv_set) {
				_uvs[size_t(place.use)] = read_uvs(primitive, place.uv_set);
			}
		}
		_normals.clear();
		const std::vector<double> numbers = read_accessor(_model, attribute(primitive, "NORMAL"), 3);
		const glm::dmat3 turn = glm::transpose(glm::inverse(glm::dmat3(matrix)));
		for (size_t i = 0; i + 2 < numbers.size() && numbers.size() == 3 * _points.size(); i += 3) {
			_normals.push_back(turn * glm::dvec3(numbers[i], numbers[i + 1], numbers[i + 2]));
		}
	}

	std::vector<double> read_uvs(const tinygltf::Primitive &primitive, int set) const {
		std::vector<double> uvs = read_accessor(_model, attribute(primitive, ("TEXCOORD_" + std::to_string(set)).c_str()), 2);
		if (uvs.size() != 2 * _points.size()) {
			uvs.clear();
		}
		return uvs;
	}

	void add_corner_data(uint32_t vertex) {
		Mesh &mesh = _asset.mesh;
		const size_t corner = mesh.positions.size();
		for (size_t set = 0; set < uv_set_count; ++set) {
			if (!_uvs[set].empty()) {
				mesh.uvs[set].resize(corner, glm::vec2(NAN));
				mesh.uvs[set].push_back({ float(_uvs[set][2 * size_t(vertex)]), float(1.0 - _uvs[set][2 * size_t(vertex) + 1]) }); // glTF counts v downwards
			}
		}
		if (!_normals.empty()) {
			const double length = glm::length(_normals[vertex]);
			mesh.normals.resize(corner, glm::vec3(NAN));
			mesh.normals.push_back(length > 0.0 && std::isfinite(length) ? glm::vec3(_normals[vertex] / length) : glm::vec3(NAN));
		}
	}

	static int attribute(const tinygltf::Primitive &primitive, const char *name) {
		const auto found = primitive.attributes.find(name);
		return found == primitive.attributes.end() ? -1 : found->second;
	}

	uint32_t material_of(const tinygltf::Primitive &primitive) const {
		const size_t plain = _model.materials.size();
		return uint32_t(primitive.material >= 0 && size_t(primitive.material) < plain ? size_t(primitive.material) : plain);
	}

	static std::vector<uint32_t> counting(size_t count) {
		std::vector<uint32_t> numbers(count);
		for (size_t i = 0; i < count; ++i) {
			numbers[i] = uint32_t(i);
		}
		return numbers;
	}

	void add_triangles(int mode, const std::vector<uint32_t> &indices, uint32_t material, bool is_mirrored) {
		const bool is_list = mode == TINYGLTF_MODE_TRIANGLES;
		const size_t step = is_list ? 3 : 1;
		for (size_t i = 0; i + 2 < indices.size(); i += step) {
			uint32_t a = indices[i], b = indices[i + 1], c = indices[i + 2];
			if (mode == TINYGLTF_MODE_TRIANGLE_FAN) {
				a = indices[0];
			} else if (!is_list && i % 2 == 1) {
				std::swap(b, c);
			}
			if (is_mirrored) {
				std::swap(b, c);
			}
			if (!add_triangle(a, b, c, material)) {
				return;
			}
		}
	}

	// False: this surface ends here.
	bool add_triangle(uint32_t a, uint32_t b, uint32_t c, uint32_t material) {
		Mesh &mesh = _asset.mesh;
		if (std::max({ a, b, c }) >= _points.size()) {
			_asset.problem = "a triangle names a vertex that does not exist";
			return false;
		}
		if (mesh.faces.size() >= _limits.faces) {
			_asset.problem = "more than " + std::to_string(_limits.faces) + " faces; the rest is left out";
			return false;
		}
		const glm::dvec3 points[3] = { _points[a], _points[b], _points[c] };
		for (const glm::dvec3 &point : points) {
			if (!(std::abs(point.x) <= 1e7 && std::abs(point.y) <= 1e7 && std::abs(point.z) <= 1e7)) {
				_asset.problem = "a vertex lies outside of +-1e7";
				return true;
			}
		}
		const glm::dvec3 normal = area_vector(points);
		if (glm::length(normal) > 0.0) {
			for (uint32_t vertex : { a, b, c }) {
				add_corner_data(vertex);
				mesh.positions.push_back(glm::vec3(_points[vertex]));
			}
			mesh.loop_ends.push_back(uint32_t(mesh.positions.size()));
			mesh.faces.push_back({ uint32_t(mesh.loop_ends.size()) - 1, 1, material, glm::vec3(glm::normalize(normal)) });
		}
		return true;
	}

	const tinygltf::Model &_model;
	const std::string &_path;
	const AssetLimits &_limits;
	Asset _asset;
	std::vector<glm::dvec3> _points, _normals; // of the surface that is being read
	std::array<std::vector<double>, uv_set_count> _uvs;
};

// What the library asks for while it reads.
struct Reading {
	const FileTree &files;
	size_t limit;
};

bool has_file(const std::string &path, void *user) {
	return static_cast<const Reading *>(user)->files.has_file(path);
}

bool read_whole_file(std::vector<unsigned char> *bytes, std::string *error, const std::string &path, void *user) {
	const Reading &reading = *static_cast<const Reading *>(user);
	const Result<std::string> text = reading.files.read(path, reading.limit);
	if (!text) {
		*error += text.diagnostic().message;
		return false;
	}
	bytes->assign(text->begin(), text->end());
	return true;
}

bool keep_encoded(tinygltf::Image *image, const int, std::string *, std::string *, int, int, const unsigned char *bytes, int size, void *) {
	image->image.assign(bytes, bytes + std::max(size, 0));
	return true;
}

std::string first_line(const std::string &text) {
	return text.substr(0, std::min<size_t>(text.find('\n'), 200));
}

// False, with a word on what is wrong in `problem`.
bool load(const FileTree &files, const std::string &path, size_t limit, tinygltf::Model &model, std::string &problem) {
	const Result<std::string> bytes = files.read(path, limit);
	if (!bytes) {
		problem = bytes.diagnostic().message;
		return false;
	}
	Reading reading{ files, limit };
	tinygltf::TinyGLTF loader;
	loader.SetFsCallbacks({ has_file, [](const std::string &name, void *) { return name; }, read_whole_file, nullptr, &reading });
	loader.SetImageLoader(keep_encoded, nullptr);
	std::string error, warning;
	const bool is_read = bytes->starts_with("glTF")
			? loader.LoadBinaryFromMemory(&model, &error, &warning, reinterpret_cast<const unsigned char *>(bytes->data()), unsigned(bytes->size()), folder_of(path))
			: loader.LoadASCIIFromString(&model, &error, &warning, bytes->data(), unsigned(bytes->size()), folder_of(path));
	if (!is_read) {
		problem = "it is no glTF that can be read: " + first_line(error);
	}
	return is_read;
}

} // namespace

Asset read_gltf_asset(const FileTree &files, const std::string &path, const AssetLimits &limits) {
	tinygltf::Model model;
	Asset asset;
	return load(files, path, limits.bytes, model, asset.problem) ? GltfReader(model, path, limits).read() : asset;
}

Result<std::string> read_gltf_picture(const FileTree &files, const std::string &path, size_t index, size_t limit) {
	tinygltf::Model model;
	std::string problem;
	if (load(files, path, limit, model, problem) && index < model.images.size()) {
		const std::vector<unsigned char> &bytes = model.images[index].image;
		return std::string(bytes.begin(), bytes.end());
	}
	problem = problem.empty() ? "there is no picture " + std::to_string(index) + " in it" : problem;
	return Diagnostic{ Severity::Error, "cannot-read-file", path, 0, 0, problem, "", {} };
}

} // namespace pcg
