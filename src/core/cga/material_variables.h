#pragma once

#include "core/cga/look.h"
#include "core/cga/texture_files.h"
#include "core/lang/dialect.h"

// material.* of a shape (CGA reference: attr_material).
namespace pcg::cga {

class Context;

// Adds material.color.r, material.colormap.su ..
void add_material_variables(Dialect &dialect);
// Of set(): `index` counts from the first of these variables. False if the value is not one for it.
bool write_material_variable(Vm &vm, uint32_t index, const Value &value);

// An empty name takes the map away. Gives what is known of the file.
TextureFiles::Entry set_texture(Context &context, TextureUse use, const Text &name);

} // namespace pcg::cga
