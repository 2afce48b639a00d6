#pragma once

#include <map>
#include <memory>
#include <string>

#include "core/base/diagnostic.h"
#include "core/lang/program.h"
#include "core/lang/source.h"

// From a path to a program: reads the file and what it imports, parses, resolves and compiles.
namespace pcg {

// Files of this machine.
class FileSourceProvider : public SourceProvider {
public:
	Result<std::string> read(const std::string &path) override;
	bool has(const std::string &path) override;
};

// Texts by path: for tests and for hosts that hold the text already.
class MemorySourceProvider : public SourceProvider {
public:
	void add(std::string path, std::string text) { _texts[std::move(path)] = std::move(text); }
	Result<std::string> read(const std::string &path) override;
	bool has(const std::string &path) override { return _texts.contains(path); }

private:
	std::map<std::string, std::string> _texts;
};

// Null if there were errors; warnings may come with a program. The dialect must outlive the program. `style`: of the main file
// (CGA reference: style), one of Program::styles or empty for Default.
std::shared_ptr<const Program> load_program(const std::string &path, const Dialect &dialect, SourceProvider &provider,
		Diagnostics &diagnostics, std::string_view style = {});
// The same from this machine's files.
std::shared_ptr<const Program> load_program(const std::string &path, const Dialect &dialect, Diagnostics &diagnostics,
		std::string_view style = {});

} // namespace pcg
