#include "core/cga/dialect.h"
#include "core/lang/parser.h"
#include "core/sim/dialect.h"
#include "fuzz/fuzz.h"

using namespace pcg;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
	Diagnostics diagnostics;
	std::string text = fuzz::text_of(data, size);
	if (decode_rule_text("main", text, diagnostics)) {
		const Source source("main", text);
		parse(source, cga::cga_dialect(), diagnostics);
		parse(source, pcg_dialect(), diagnostics);
	}
	return 0;
}
