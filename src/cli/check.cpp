#include <cstdio>
#include <string>

#include <nlohmann/json.hpp>

#include "cli/args.h"
#include "core/cga/dialect.h"
#include "core/io/rule_loader.h"
#include "core/lang/reference.h"
#include "core/sim/dialect.h"

namespace pcg::cli {

namespace {

const Dialect *dialect_of(std::string_view path) {
	if (path.ends_with(".cga")) {
		return &cga::cga_dialect();
	}
	return path.ends_with(".pcg") ? &pcg_dialect() : nullptr;
}

nlohmann::json to_json(const Diagnostic &diagnostic) {
	return { { "severity", diagnostic.severity == Severity::Error ? "error" : "warning" }, { "id", diagnostic.id }, { "file", diagnostic.file },
		{ "line", diagnostic.line }, { "column", diagnostic.column }, { "message", diagnostic.message }, { "hint", diagnostic.hint } };
}

void check_file(const std::string &path, Diagnostics &diagnostics) {
	const Dialect *const dialect = dialect_of(path);
	if (dialect == nullptr) {
		diagnostics.add({ Severity::Error, "unknown-language", path, 0, 0, "this is neither a .cga nor a .pcg file", "", {} });
		return;
	}
	const auto program = load_program(path, *dialect, diagnostics);
	// Several starts are normal in CGA: the host names the one it wants.
	if (program != nullptr && dialect->is_strict()) {
		require_start_rule(*program, diagnostics);
	}
}

int run_check(std::span<const std::string_view> raw) {
	Args args(raw, { { "--json", "" } });
	args.require_positional(1, SIZE_MAX, "rule files to check");
	if (!args.is_valid()) {
		return args.report({ "check", "pcg check FILE.. [--json]", "", nullptr });
	}
	bool has_errors = false;
	nlohmann::json list = nlohmann::json::array();
	for (const std::string &path : args.positional()) {
		Diagnostics diagnostics;
		check_file(path, diagnostics);
		has_errors |= diagnostics.has_errors();
		if (!args.has("--json")) {
			std::fputs(to_text(diagnostics).c_str(), stderr);
		}
		for (const Diagnostic &diagnostic : diagnostics.list()) {
			list.push_back(to_json(diagnostic));
		}
	}
	if (args.has("--json")) {
		const nlohmann::json document = { { "files", args.positional().size() }, { "diagnostics", list } };
		std::puts(document.dump(1, '\t', false, nlohmann::json::error_handler_t::replace).c_str());
	}
	return has_errors ? 1 : 0;
}

int run_docs(std::span<const std::string_view> raw) {
	Args args(raw, {});
	args.require_positional(1, 1, "the language: cga or pcg");
	const std::string language = args.positional().empty() ? "" : args.positional()[0];
	if (args.is_valid() && language != "cga" && language != "pcg") {
		args.problem("unknown language \"" + language + "\"; it is cga or pcg");
	}
	if (!args.is_valid()) {
		return args.report({ "docs", "pcg docs cga|pcg", "", nullptr });
	}
	std::fputs(to_markdown(language == "cga" ? cga::cga_dialect() : pcg_dialect()).c_str(), stdout);
	return 0;
}

} // namespace

extern const Command check_command;
extern const Command docs_command;

const Command check_command = { "check",
	"pcg check FILE.. [--json]\n"
	"  Parses and resolves rule files (.cga, .pcg) without running them, and prints what is wrong with them.\n"
	"  --json   diagnostics as JSON on standard output",
	"look for mistakes in rule files", run_check };

const Command docs_command = { "docs",
	"pcg docs cga|pcg\n"
	"  Prints tables of the operations, functions and variables of a rule language in Markdown.",
	"print the reference tables of a rule language", run_docs };

} // namespace pcg::cli
