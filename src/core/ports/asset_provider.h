#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/geometry/mesh.h"
#include "core/geometry/shared_mesh.h"

// The files that rules name: models for i("file"), pictures, tables, lists of files. The host knows where they lie and how to read them.
namespace pcg {

// A model as its file has it, y up, metres.
struct Asset {
	Mesh mesh; // empty: the file is broken. Corners that lack a texture coordinate or a normal have nan there
	std::vector<Material> materials;
	std::string problem; // what is wrong with the file, for a warning; empty: nothing
	// The mesh without gaps, as instances show it: one for all derivations, made by the first that inserts the model.
	std::shared_ptr<SharedMesh> shown = std::make_shared<SharedMesh>();
};

// Rows of equal length, one behind the other.
struct TextTable {
	uint32_t rows = 0;
	uint32_t columns = 0;
	std::vector<std::string> cells;
};

// Safe to ask from several threads; each file is read once, and what is pointed at lives as long as the provider. `rule_file` is the file whose
// text asks: names that do not begin with / are sought in its project (CGA reference: cga_assetSearch).
class AssetProvider {
public:
	using Paths = std::vector<std::string>;

	virtual ~AssetProvider() = default;
	// nullptr: there is none of that name.
	virtual const Asset *find(std::string_view name, std::string_view rule_file) const = 0;
	// The path of a file of any kind, as the host opens it; empty: there is none.
	virtual std::string locate(std::string_view, std::string_view /*rule_file*/) const { return {}; }
	// All files that fit a query, sorted, as names that the other functions understand (CGA reference: func_fileSearch). Never nullptr.
	virtual std::shared_ptr<const Paths> search(std::string_view, std::string_view /*rule_file*/) const { return std::make_shared<Paths>(); }
	// Whether a picture has an alpha channel.
	virtual bool has_alpha(std::string_view, std::string_view /*rule_file*/) const { return false; }
	// Width and height in pixels; 0, 0: no such picture.
	virtual glm::uvec2 image_size(std::string_view, std::string_view /*rule_file*/) const { return { 0, 0 }; }
	// As UTF-8, lines ended by \n. nullptr: no such file.
	virtual const std::string *text(std::string_view, std::string_view /*rule_file*/) const { return nullptr; }
	// A table of comma-separated values. nullptr: no such file.
	virtual const TextTable *table(std::string_view, std::string_view /*rule_file*/) const { return nullptr; }
};

} // namespace pcg
