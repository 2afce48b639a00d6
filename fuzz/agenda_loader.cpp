#include "core/sim/dialect.h"
#include "fuzz/fuzz.h"

using namespace pcg;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
	Diagnostics diagnostics;
	fuzz::load(fuzz::text_of(data, size), pcg_dialect(), diagnostics);
	to_text(diagnostics);
	return 0;
}
