#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "core/base/diagnostic.h"
#include "core/geometry/material.h"
#include "core/io/file_tree.h"
#include "core/io/gltf_library.h"
#include "core/io/picture.h"

namespace pcg {

// Materials of a glTF model, equal ones once, with their pictures, each file once. What glTF cannot say is approximated: see
// docs/cga-differences.md.
class GltfMaterials {
public:
	// `pictures` reads the files; nullptr: this machine's. All outlive this.
	GltfMaterials(tinygltf::Model &model, const FileTree *pictures, Diagnostics &diagnostics);

	// The material's index. `sets`: bit n is set if the surface has texture coordinate set n; without any there are no pictures.
	int add(const Material &material, uint32_t sets);
	// Adds the pictures' bytes to the buffer, as views behind those that are there.
	void finish(tinygltf::Buffer &buffer);

private:
	tinygltf::Material to_gltf(const Material &material, uint32_t sets);
	template <typename Info> void set_texture(Info &info, const TextureMap *map, uint32_t sets);
	template <typename Info> void place_texture(Info &info, int texture, const TextureMap &map, uint32_t sets);
	void set_factors(tinygltf::Material &target, const Material &material) const;
	void set_textures(tinygltf::Material &target, const Material &material, uint32_t sets);
	void set_color(tinygltf::Material &target, const Material &material, uint32_t sets);
	void set_metal(tinygltf::Material &target, const Material &material, uint32_t sets);
	int texture_of(const std::string &file);
	template <typename Mix> int mixed_texture(const TextureMap *a, const TextureMap *b, const char *kind, Mix mix);
	int add_file(const std::string &file);
	std::optional<Picture> decoded(const TextureMap *map);
	int add_picture(const std::string &name, const char *type, std::string bytes);
	void tell(const std::string &file, const std::string &message);

	tinygltf::Model &_model;
	const DiskTree _disk;
	const FileTree &_pictures;
	Diagnostics &_diagnostics;
	std::map<std::string, int> _materials; // by all they say
	std::map<std::string, int> _textures; // by file or, of two in one, by both and what they are for; -1: there is none
	std::set<std::string> _told; // files of which something was said
	std::vector<std::string> _bytes; // of the model's images
};

// Bit n: there is a set n. In files the sets that are there are numbered one after the other.
uint32_t sets_of(const std::vector<glm::vec2> *uvs);
int file_set(uint32_t sets, size_t set);

} // namespace pcg
