#pragma once

#include <functional>
#include <string>

#include "core/io/rule_loader.h"

namespace pcg {

// Without the blanks at both ends.
std::string trimmed(const std::string &text);

// The remark of one line, without its slashes and blanks; empty if there is none.
struct RuleFileLine {
	std::string file; // the file that it belongs to: the test itself, or one that the test holds
	size_t number = 0; // in that file, from 1
	std::string remark;
	bool is_whole_line = false; // nothing stands before the remark
};

// Reads a test of tests/rules: `// file NAME` begins another file beside it. All of them end up in `files`.
void read_rule_file(const std::string &path, MemorySourceProvider &files, const std::function<void(const RuleFileLine &)> &on_line);

} // namespace pcg
