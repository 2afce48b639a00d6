#pragma once

#include <string>

#include "core/base/diagnostic.h"
#include "core/cga/derivation.h"
#include "core/city/city.h"

// Models as binary glTF 2.0 files (.glb), which Godot, Blender and viewers open. Metres, y up; triangles with normals; materials as
// metallic-roughness, with their pictures (PNG and JPEG) inside. Files are written whole or not at all; false, and an error in `diagnostics`, if that
// was not possible. `pictures` reads the files that materials name; nullptr: this machine's. A picture that cannot be had is a warning.
namespace pcg {

class FileTree;

// Nodes: "streets", and "block 0" .. with their pavements; below each block its lots ("lot 12 (house)", extras lot and type), and below each lot
// its objects ("bench", extras object and type). Equal objects share one mesh. What is inserted from a file is one mesh, with a
// node "instance" for each place where it stands.
bool write_glb(const City &city, const std::string &path, Diagnostics &diagnostics, const FileTree *pictures = nullptr);
// One derivation: a node `name` with its objects below.
bool write_glb(const cga::DerivationResult &model, const std::string &name, const std::string &path, Diagnostics &diagnostics,
		const FileTree *pictures = nullptr);

} // namespace pcg
