#include "tests/core/rules/rule_file.h"

#include <doctest/doctest.h>

#include <sstream>

#include "core/io/rule_loader.h"

namespace pcg {

std::string trimmed(const std::string &text) {
	const size_t first = text.find_first_not_of(" \t\r");
	return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

void read_rule_file(const std::string &path, MemorySourceProvider &files, const std::function<void(const RuleFileLine &)> &on_line) {
	FileSourceProvider disk;
	const Result<std::string> text = disk.read(path);
	REQUIRE(text.is_ok());
	std::istringstream lines(*text);
	std::string line, content;
	RuleFileLine current{ path, 0, {}, false };
	while (std::getline(lines, line)) {
		++current.number;
		const size_t mark = line.find("// ");
		current.remark = mark == std::string::npos ? "" : trimmed(line.substr(mark + 3));
		current.is_whole_line = mark == 0;
		if (current.remark.starts_with("file ")) {
			files.add(current.file, content);
			current.file = path.substr(0, path.find_last_of('/') + 1) + trimmed(current.remark.substr(5));
			current.number = 0;
			content.clear();
			continue;
		}
		content += line + "\n";
		on_line(current);
	}
	files.add(current.file, content);
}

} // namespace pcg
