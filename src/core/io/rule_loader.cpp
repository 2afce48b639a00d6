#include "core/io/rule_loader.h"

#include <filesystem>
#include <fstream>
#include <system_error>

#include "core/lang/compiler.h"
#include "core/lang/rule_set.h"

namespace pcg {

namespace {

Diagnostic unreadable(const std::string &path, std::string message, std::string hint) {
	return { Severity::Error, "unreadable-file", path, 0, 0, std::move(message), std::move(hint), {} };
}

bool is_other_language(std::string_view path, const Dialect &dialect) {
	return (dialect.name == "cga" && path.ends_with(".pcg")) || (dialect.name == "pcg" && path.ends_with(".cga"));
}

} // namespace

Result<std::string> FileSourceProvider::read(const std::string &path) {
	std::error_code code;
	const std::filesystem::file_status status = std::filesystem::status(path, code);
	if (!std::filesystem::exists(status)) {
		return unreadable(path, "there is no such file", "check the path");
	}
	if (std::filesystem::is_directory(status)) {
		return unreadable(path, "this is a folder, not a file", "name a rule file in it");
	}
	std::ifstream stream(path, std::ios::binary);
	std::string bytes;
	// Reads at most one byte more than is accepted, so that a huge file or an endless device ends here too.
	constexpr size_t most = (size_t(64) << 20) + 1;
	char buffer[65536];
	while (stream && bytes.size() < most) {
		stream.read(buffer, std::streamsize(std::min(sizeof buffer, most - bytes.size())));
		bytes.append(buffer, size_t(stream.gcount()));
	}
	if (stream.bad() || (!stream.eof() && bytes.size() < most)) {
		return unreadable(path, "the file cannot be read", "check its permissions");
	}
	return bytes;
}

bool FileSourceProvider::has(const std::string &path) {
	std::error_code code;
	return std::filesystem::is_regular_file(path, code);
}

Result<std::string> MemorySourceProvider::read(const std::string &path) {
	const auto found = _texts.find(path);
	if (found == _texts.end()) {
		return unreadable(path, "there is no such file", "check the path");
	}
	return found->second;
}

std::shared_ptr<const Program> load_program(const std::string &path, const Dialect &dialect, SourceProvider &provider,
		Diagnostics &diagnostics, std::string_view style) {
	if (is_other_language(path, dialect)) {
		diagnostics.add({ Severity::Error, "wrong-dialect", path, 0, 0, "this file is not in the language that is wanted here: " + std::string(dialect.title), "buildings are written in .cga files, days in .pcg files", {} });
		return nullptr;
	}
	Diagnostics found;
	const RuleSet set = load_rule_set(path, dialect, provider, found, style);
	auto program = compile(set, dialect, found);
	found.sort();
	diagnostics.append(found);
	return program;
}

std::shared_ptr<const Program> load_program(const std::string &path, const Dialect &dialect, Diagnostics &diagnostics,
		std::string_view style) {
	FileSourceProvider files;
	return load_program(path, dialect, files, diagnostics, style);
}

} // namespace pcg
