#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "core/geometry/mesh.h"

// What i("file") inserts: the host knows where assets lie and how to read them.
namespace pcg {

// A model as its file has it, y up, metres.
struct Asset {
	Mesh mesh;
	std::vector<Material> materials;
};

// Safe to ask from several threads; each asset is loaded once and lives as long as the provider.
class AssetProvider {
public:
	virtual ~AssetProvider() = default;
	// nullptr: there is none of that name. `rule_file` is the file whose text names the asset: relative names are sought beside it.
	virtual const Asset *find(std::string_view name, std::string_view rule_file) const = 0;
	// The path of a file of any kind, as the host opens it; empty: there is none.
	virtual std::string locate(std::string_view, std::string_view /*rule_file*/) const { return {}; }
	// Whether a picture has an alpha channel.
	virtual bool has_alpha(std::string_view, std::string_view /*rule_file*/) const { return false; }
};

} // namespace pcg
