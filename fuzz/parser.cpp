#include "core/lang/parser.h"
#include "fuzz/fuzz.h"

using namespace pcg;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
	Diagnostics diagnostics;
	std::string text = fuzz::text_of(data, size);
	if (decode_rule_text("main", text, diagnostics)) {
		const Source source("main", text);
		parse(source, false, diagnostics);
		parse(source, true, diagnostics);
	}
	return 0;
}
