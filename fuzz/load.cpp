#include "fuzz/fuzz.h"

namespace pcg::fuzz {

std::shared_ptr<const Program> load(const std::string &bytes, const Dialect &dialect, Diagnostics &diagnostics) {
	MemorySourceProvider provider;
	provider.add("main", bytes);
	provider.add("lib", "attr h = 4\nf(x) = h + x\nstart Go --> Roof\nextension Roof --> Leaf.\nstyle Night\nattr h = 5");
	return load_program("main", dialect, provider, diagnostics);
}

} // namespace pcg::fuzz
