#include "core/cga/derivation.h"

#include "core/cga/dialect.h"
#include "fuzz/fuzz.h"

using namespace pcg;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
	Diagnostics diagnostics;
	const auto program = fuzz::load(fuzz::text_of(data, size), cga::cga_dialect(), diagnostics);
	if (program == nullptr) {
		return 0;
	}
	cga::DeriveOptions options;
	options.limits.max_shapes = 500;
	options.limits.max_repeats = 200;
	options.limits.max_faces = 5'000;
	options.limits.max_steps = 20'000;
	options.limits.max_depth = 40;
	cga::derive(*program, cga::InitialShape::rectangle(10.0, 6.0, size), options);
	return 0;
}
