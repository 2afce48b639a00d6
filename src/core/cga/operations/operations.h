#pragma once

#include "core/lang/dialect.h"

// One function for each family of operations: adds its rows to the dialect's table.
namespace pcg::cga {

void add_transform_operations(Dialect &dialect); // t r s center ..
void add_frame_operations(Dialect &dialect); // alignScopeToAxes setPivot mirror ..
void add_split_operations(Dialect &dialect);
void add_split_area_operations(Dialect &dialect);
void add_perimeter_operations(Dialect &dialect); // splitAndSetbackPerimeter
void add_scatter_operations(Dialect &dialect);
void add_envelope_operations(Dialect &dialect);
void add_component_operations(Dialect &dialect); // comp
void add_setback_operations(Dialect &dialect); // setback setbackPerEdge setbackToArea
void add_wing_operations(Dialect &dialect); // shapeL shapeU shapeO innerRectangle
void add_outline_operations(Dialect &dialect); // offset convexify innerRect ..
void add_extrusion_operations(Dialect &dialect);
void add_cleanup_operations(Dialect &dialect); // cleanupGeometry setNormals ..
void add_roof_operations(Dialect &dialect);
void add_asset_operations(Dialect &dialect); // i, primitives
void add_appearance_operations(Dialect &dialect); // color texture set
void add_projection_operations(Dialect &dialect); // setupProjection projectUV
void add_uv_operations(Dialect &dialect); // translateUV tileUV ..
void add_uv_split_operations(Dialect &dialect); // split(u, ..)
void add_flow_operations(Dialect &dialect); // NIL report print label
void add_reset_operations(Dialect &dialect); // resetGeometry resetMaterial setMaterial
void add_semantic_operations(Dialect &dialect); // entrance zone place
void add_unbuilt(Dialect &dialect); // union tag modify ..

void add_variables(Dialect &dialect); // scope.sx split.index ..
void add_functions(Dialect &dialect); // str float ..
void add_geometry_functions(Dialect &dialect); // geometry.area ..
void add_place_functions(Dialect &dialect); // convert ..
void add_context_functions(Dialect &dialect); // inside touches minimumDistance ..
void add_uv_functions(Dialect &dialect); // geometry.du ..
void add_file_functions(Dialect &dialect); // fileExists assetInfo ..
// Of report(key, value), which is an operation and a function.
void report_value(Vm &vm, const Args &args);
// Of set(): false if the variable cannot be written to.
bool write_variable(Vm &vm, uint32_t variable, const Value &value);

} // namespace pcg::cga
