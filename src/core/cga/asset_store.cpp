#include "core/cga/asset_store.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <glm/common.hpp>

#include "core/cga/model_builder.h"
#include "core/lang/program.h"

namespace pcg::cga {

namespace {

struct DirectedEdge {
	glm::dvec3 from, to;

	auto key() const { return std::array{ from.x, from.y, from.z, to.x, to.y, to.z }; }
	auto opposite() const { return std::array{ to.x, to.y, to.z, from.x, from.y, from.z }; }
};

// Each edge belongs to two faces, which run along it in opposite directions.
bool encloses_volume(const Geometry &geometry) {
	std::vector<std::array<double, 6>> edges;
	edges.reserve(geometry.point_count);
	std::vector<std::array<double, 6>> opposites;
	opposites.reserve(geometry.point_count);
	for (uint32_t i = 0; i < geometry.loop_count; ++i) {
		const auto loop = geometry.loop(i);
		for (size_t k = 0; k < loop.size(); ++k) {
			const DirectedEdge edge{ loop[k], loop[(k + 1) % loop.size()] };
			edges.push_back(edge.key());
			opposites.push_back(edge.opposite());
		}
	}
	std::ranges::sort(edges);
	std::ranges::sort(opposites);
	return edges == opposites && std::ranges::adjacent_find(edges) == edges.end();
}

double number_of(std::string_view text) {
	text.remove_prefix(std::min(text.find_first_not_of(" \t+"), text.size()));
	double result = NAN;
	std::from_chars(text.data(), text.data() + text.size(), result);
	return result;
}

} // namespace

AssetStore::AssetStore(const AssetProvider *provider, const Program &program) : _provider(provider), _program(program), _known(program.files.size()) {}

AssetStore::Model &AssetStore::model(std::string_view name, uint32_t file) {
	ByName<Model *> &known = _known[file].models;
	const auto found = known.find(name);
	if (found != known.end()) {
		return *found->second;
	}
	const Asset *asset = _provider != nullptr ? _provider->find(name, _program.files[file]) : nullptr;
	return *known.emplace(name, model_of(asset)).first->second;
}

AssetStore::Model *AssetStore::model_of(const Asset *asset) {
	const auto found = asset != nullptr ? _by_asset.find(asset) : _by_asset.end();
	if (found != _by_asset.end()) {
		return found->second;
	}
	Model &model = _models.emplace_back();
	model.asset = asset;
	if (model.is_usable()) {
		model.low = model.high = glm::dvec3(asset->mesh.positions.front());
		for (const glm::vec3 &point : asset->mesh.positions) {
			model.low = glm::min(model.low, glm::dvec3(point));
			model.high = glm::max(model.high, glm::dvec3(point));
		}
		_by_asset.emplace(asset, &model);
	}
	return &model;
}

namespace {

// -90 degrees about x.
constexpr glm::dmat3 upright{ { 1.0, 0.0, 0.0 }, { 0.0, 0.0, -1.0 }, { 0.0, 1.0, 0.0 } };

// The corners of a mesh as geometry without faces, from which a builder can take them.
Geometry corners_of(const Mesh &mesh, Arena &arena) {
	Geometry source;
	CornerData data;
	const size_t count = mesh.positions.size();
	source.point_count = uint32_t(count);
	for (size_t set = 0; set < uv_set_count; ++set) {
		if (mesh.uvs[set].size() == count) {
			glm::dvec2 *uvs = arena.allocate<glm::dvec2>(count);
			std::ranges::transform(mesh.uvs[set], uvs, [](glm::vec2 uv) { return uv.x == uv.x && uv.y == uv.y ? glm::dvec2(uv) : no_uv(); });
			data.put(set, uvs);
			source.corners = arena.make(data);
		}
	}
	if (mesh.normals.size() == count) {
		glm::dvec3 *normals = arena.allocate<glm::dvec3>(count);
		std::ranges::transform(mesh.normals, normals, [](glm::vec3 normal) { return normal.x == normal.x ? glm::dvec3(normal) : glm::dvec3(0.0); });
		data.normals = normals;
		source.corners = arena.make(data);
	}
	return source;
}

} // namespace

const Geometry *AssetStore::geometry(Model &model, Up up, ModelBuilder &builder) {
	const Geometry *&made = model.geometries[size_t(up)];
	if (made != nullptr || !model.is_usable()) {
		return made;
	}
	std::vector<uint16_t> materials;
	for (const Material &material : model.asset->materials) {
		materials.push_back(builder.materials().asset_material(material));
	}
	const Mesh &mesh = model.asset->mesh;
	const glm::dmat3 turn = up == Up::Y ? glm::dmat3(1.0) : upright;
	Arena corner_arena;
	const Geometry source = corners_of(mesh, corner_arena);
	GeometryBuilder geometry;
	geometry.begin(source, turn);
	for (const MeshFace &face : mesh.faces) {
		for (uint32_t i = 0; i < face.loop_count; ++i) {
			for (uint32_t corner = mesh.first_corner(face.first_loop + i); corner < mesh.loop_ends[face.first_loop + i]; ++corner) {
				geometry.add_corner(turn * glm::dvec3(mesh.positions[corner]), corner);
			}
			geometry.end_loop();
		}
		geometry.end_face(FaceTag::None, face.material < materials.size() ? materials[face.material] : uint16_t(0));
	}
	const Arena::Mark mark = _arena.mark();
	made = geometry.finish(_arena, false);
	if (made != nullptr) {
		const bool is_closed = encloses_volume(*made);
		_arena.release(mark);
		Geometry *instance = _arena.make(*geometry.finish(_arena, is_closed));
		instance->is_instance = true;
		instance->inserted = instance;
		made = instance;
		builder.add_model(*made, turn, *model.asset->shown);
	}
	return made;
}

const Geometry *AssetStore::primitive(PrimitiveKind kind, uint32_t a, uint32_t b, Arena &arena) {
	constexpr size_t most = 64; // kept; rules may ask for any number of sides
	for (const Primitive &known : _primitives) {
		if (known.kind == kind && known.a == a && known.b == b) {
			return known.geometry;
		}
	}
	const bool is_kept = _primitives.size() < most;
	Arena &place = is_kept ? _arena : arena;
	Geometry *geometry = place.make(*make_primitive(kind, a, b, place));
	geometry->inserted = geometry;
	if (is_kept) {
		_primitives.push_back({ kind, a, b, geometry });
	}
	return geometry;
}

bool AssetStore::is_first_time(Model &model) {
	const bool is_first = model.told_in != _derivation;
	model.told_in = _derivation;
	return is_first;
}

const AssetStore::FileList &AssetStore::search(std::string_view query, uint32_t file) {
	ByName<FileList *> &known = _known[file].lists;
	const auto found = known.find(query);
	if (found != known.end()) {
		return *found->second;
	}
	FileList &list = _lists.emplace_back();
	_paths.push_back(_provider != nullptr ? _provider->search(query, _program.files[file]) : std::make_shared<const AssetProvider::Paths>());
	std::string &joined = _storage.emplace_back();
	for (const std::string &path : *_paths.back()) {
		list.items.push_back({ path, no_symbol });
		joined += path + ";";
	}
	list.joined.view = joined;
	known.emplace(query, &list);
	return list;
}

bool AssetStore::has_file(std::string_view name, uint32_t file) const {
	return _provider != nullptr && !_provider->locate(name, _program.files[file]).empty();
}

glm::uvec2 AssetStore::image_size(std::string_view name, uint32_t file) const {
	return _provider != nullptr ? _provider->image_size(name, _program.files[file]) : glm::uvec2(0);
}

const Text *AssetStore::text(std::string_view name, uint32_t file) {
	ByName<Text *> &known = _known[file].texts;
	const auto found = known.find(name);
	if (found != known.end()) {
		return found->second;
	}
	const std::string *content = _provider != nullptr ? _provider->text(name, _program.files[file]) : nullptr;
	Text *text = content != nullptr ? &_texts.emplace_back(Text{ *content, no_symbol }) : nullptr;
	known.emplace(name, text);
	return text;
}

const AssetStore::Table *AssetStore::table(std::string_view name, uint32_t file) {
	ByName<Table *> &known = _known[file].tables;
	const auto found = known.find(name);
	if (found != known.end()) {
		return found->second;
	}
	const TextTable *content = _provider != nullptr ? _provider->table(name, _program.files[file]) : nullptr;
	return known.emplace(name, content != nullptr ? make_table(*content) : nullptr).first->second;
}

// Rows beyond the size of an array are left out.
AssetStore::Table *AssetStore::make_table(const TextTable &source) {
	const size_t rows = source.columns > 0 ? std::min<size_t>(source.rows, max_array_size / source.columns) : 0;
	Table &table = _tables.emplace_back();
	for (size_t i = 0; i < rows * source.columns; ++i) {
		table.texts.push_back(Value::of(&_texts.emplace_back(Text{ source.cells[i], no_symbol })));
		table.numbers.push_back(Value::of(number_of(source.cells[i])));
	}
	table.text_array = { table.texts.data(), uint32_t(rows), source.columns, ValueType::Text };
	table.number_array = { table.numbers.data(), uint32_t(rows), source.columns, ValueType::Number };
	return &table;
}

} // namespace pcg::cga
