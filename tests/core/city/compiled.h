#pragma once

#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <string_view>

#include "core/cga/dialect.h"
#include "core/io/rule_loader.h"

// Rules of tests.
namespace pcg {

inline std::shared_ptr<const Program> compile(std::string_view text) {
	MemorySourceProvider sources;
	sources.add("rules.cga", std::string(text));
	Diagnostics diagnostics;
	std::shared_ptr<const Program> program = load_program("rules.cga", cga::cga_dialect(), sources, diagnostics);
	REQUIRE_MESSAGE(program, to_text(diagnostics));
	return program;
}

} // namespace pcg
