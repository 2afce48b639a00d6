#pragma once

#include <span>
#include <string>
#include <string_view>

#include "cli/args.h"

namespace pcg::cli {

// A file that the command line names: "--out" and what stands behind it. Empty and "-" are no files.
struct NamedFile {
	std::string_view option; // or "the rule file"
	std::string path;
};

// Notes a problem for each output that is also an input or an output named before: it would be lost.
void check_outputs(Args &args, std::span<const NamedFile> inputs, std::span<const NamedFile> outputs);

} // namespace pcg::cli
