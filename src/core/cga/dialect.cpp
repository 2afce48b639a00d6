#include "core/cga/dialect.h"

#include "core/cga/operations/operations.h"

namespace pcg::cga {

namespace {

Dialect make_dialect() {
	Dialect dialect;
	dialect.name = "cga";
	dialect.title = "CGA shape grammar";
	dialect.locals = Dialect::Locals::Lexical;
	dialect.rule_calls = Dialect::RuleCalls::ByHost;
	dialect.unknown_names = Dialect::UnknownNames::LeafSymbol;
	add_annotations(dialect);
	add_math_functions(dialect);
	add_functions(dialect);
	add_context_functions(dialect);
	add_uv_functions(dialect);
	add_file_functions(dialect);
	add_variables(dialect);
	add_transform_operations(dialect);
	add_frame_operations(dialect);
	add_split_operations(dialect);
	add_split_area_operations(dialect);
	add_perimeter_operations(dialect);
	add_scatter_operations(dialect);
	add_envelope_operations(dialect);
	add_component_operations(dialect);
	add_setback_operations(dialect);
	add_wing_operations(dialect);
	add_outline_operations(dialect);
	add_extrusion_operations(dialect);
	add_cleanup_operations(dialect);
	add_roof_operations(dialect);
	add_asset_operations(dialect);
	add_appearance_operations(dialect);
	add_projection_operations(dialect);
	add_uv_operations(dialect);
	add_uv_split_operations(dialect);
	add_flow_operations(dialect);
	add_reset_operations(dialect);
	add_semantic_operations(dialect);
	add_unbuilt(dialect);
	return dialect;
}

} // namespace

const Dialect &cga_dialect() {
	static const Dialect dialect = make_dialect();
	return dialect;
}

} // namespace pcg::cga
