#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <glm/vec3.hpp>

#include "core/cga/geometry.h"
#include "core/cga/primitives.h"
#include "core/lang/value.h"
#include "core/ports/asset_provider.h"

namespace pcg {
struct Program;
}

namespace pcg::cga {

class ModelBuilder;

// The files that rules name, as one interpreter knows them: each name is looked up once for each rule file that says it, and the geometry of an asset
// is made once and shared by all shapes and all derivations of the interpreter. Nothing is forgotten before the interpreter.
class AssetStore {
public:
	enum class Up : uint8_t { Y, Z };

	struct Model {
		const Asset *asset = nullptr; // nullptr: there is no such file
		glm::dvec3 low{ 0.0 }, high{ 0.0 }; // bounds
		std::array<const Geometry *, 2> geometries = {}; // by Up, upright; nullptr: not made yet, or there are no faces
		uint64_t told_in = 0; // the derivation in which what is wrong with it was told

		glm::dvec3 size() const { return high - low; }
		bool is_usable() const { return asset != nullptr && !asset->mesh.is_empty(); }
	};
	struct FileList {
		std::vector<Text> items;
		Text joined; // "a;b;"
	};
	struct Table {
		std::vector<Value> texts, numbers;
		ArrayData text_array, number_array;
	};

	AssetStore(const AssetProvider *provider, const Program &program);

	void begin() { ++_derivation; }
	// `file` is the index of the rule file in the program.
	Model &model(std::string_view name, uint32_t file);
	// nullptr if it has no faces.
	const Geometry *geometry(Model &model, Up up, ModelBuilder &builder);
	// The same for built-in bodies; what is seldom wanted lies in `arena`.
	const Geometry *primitive(PrimitiveKind kind, uint32_t a, uint32_t b, Arena &arena);
	// True once in each derivation.
	bool is_first_time(Model &model);

	const FileList &search(std::string_view query, uint32_t file);
	bool has_file(std::string_view name, uint32_t file) const;
	glm::uvec2 image_size(std::string_view name, uint32_t file) const;
	// nullptr: no such file.
	const Text *text(std::string_view name, uint32_t file);
	const Table *table(std::string_view name, uint32_t file);

private:
	struct Hash {
		using is_transparent = void;
		size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
	};
	template <typename T> using ByName = std::unordered_map<std::string, T, Hash, std::equal_to<>>;
	struct Primitive {
		PrimitiveKind kind = PrimitiveKind::Cube;
		uint32_t a = 0, b = 0;
		const Geometry *geometry = nullptr;
	};
	struct Known { // of one rule file
		ByName<Model *> models;
		ByName<FileList *> lists;
		ByName<Text *> texts;
		ByName<Table *> tables;
	};

	Model *model_of(const Asset *asset);
	Table *make_table(const TextTable &source);

	const AssetProvider *_provider;
	const Program &_program;
	uint64_t _derivation = 0;
	std::vector<Known> _known; // by rule file
	std::unordered_map<const Asset *, Model *> _by_asset; // looked up only, never listed
	std::deque<Model> _models; // these never move
	std::deque<FileList> _lists;
	std::deque<Text> _texts;
	std::deque<Table> _tables;
	std::deque<std::string> _storage;
	std::vector<std::shared_ptr<const AssetProvider::Paths>> _paths; // what the lists view
	std::vector<Primitive> _primitives;
	Arena _arena;
};

} // namespace pcg::cga
