#pragma once

#include "core/cga/look.h"
#include "core/lang/dialect.h"

// material.* of a shape (CGA reference: attr_material).
namespace pcg::cga {

class Context;

// Adds material.color.r, material.colormap.su ..
void add_material_variables(Dialect &dialect);
// Of set(): `index` counts from the first of these variables. False if the value is not one for it.
bool write_material_variable(Vm &vm, uint32_t index, const Value &value);

// texture(): the picture of the colour map and, if it has an alpha channel, of the opacity map. An empty name takes both away.
void set_color_texture(Context &context, const Text &name);

} // namespace pcg::cga
