#include "core/city/drawn_blocks.h"
#include "core/io/geojson.h"
#include "fuzz/fuzz.h"

using namespace pcg;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
	Diagnostics diagnostics;
	const auto footprints = parse_geojson(fuzz::text_of(data, size), "map.geojson", diagnostics);
	if (footprints && footprints->size() < 50) {
		LayoutParameters parameters;
		layout_of_footprints(*footprints, parameters, diagnostics);
		parameters.lot_front = 500.0f; // large maps have few lots
		layout_of_blocks(*footprints, parameters, diagnostics);
	}
	to_text(diagnostics);
	return 0;
}
