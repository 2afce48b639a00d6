#include "fuzz/fuzz.h"

#include "core/lang/lexer.h"

using namespace pcg;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
	const bool has_time_units = size > 0 && data[0] % 2 == 1;
	Diagnostics diagnostics;
	std::string text = fuzz::text_of(data, size);
	if (decode_rule_text("main", text, diagnostics)) {
		tokenize(Source("main", text), has_time_units, diagnostics);
	}
	to_text(diagnostics);
	return 0;
}
