#include "core/cga/functions/functions.h"
#include "core/cga/operations/operations.h"

// Functions of the shape grammar (CGA reference, sections 8.1 and 8.3).
namespace pcg::cga {

void add_functions(Dialect &dialect) {
	add_geometry_functions(dialect);
	add_place_functions(dialect);
	add_text_functions(dialect);
	add_list_functions(dialect);
	add_color_functions(dialect);
	add_array_functions(dialect);
	add_flow_functions(dialect);
	extend_math_functions(dialect);
}

} // namespace pcg::cga
