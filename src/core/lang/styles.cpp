#include "core/lang/styles.h"

#include <algorithm>

namespace pcg {

bool has_style(const std::vector<AstStyle> &styles, std::string_view name) {
	return name.empty() || name == "Default" || std::any_of(styles.begin(), styles.end(), [&](const AstStyle &style) { return style.name == name; });
}

std::string style_names(const std::vector<AstStyle> &styles) {
	std::string names = "its styles: Default";
	for (const AstStyle &style : styles) {
		names += ", " + std::string(style.name);
	}
	return names;
}

void require_style(const ParsedFile &file, std::string_view style, Diagnostics &diagnostics) {
	if (!has_style(file.ast.styles, style)) {
		diagnostics.add({ Severity::Error, "unknown-style", file.path, 0, 0, "the file has no style `" + std::string(style) + "`", style_names(file.ast.styles), {} });
	}
}

std::vector<std::string_view> style_chain(const ParsedFile &file, std::string_view style, Diagnostics &diagnostics) {
	std::vector<std::string_view> chain;
	const std::vector<AstStyle> &styles = file.ast.styles;
	while (!style.empty() && style != "Default" && chain.size() <= styles.size()) {
		const auto found = std::find_if(styles.begin(), styles.end(), [&](const AstStyle &other) { return other.name == style; });
		if (found == styles.end()) {
			break;
		}
		chain.push_back(style);
		if (!has_style(styles, found->base) || std::find(chain.begin(), chain.end(), found->base) != chain.end()) {
			diagnostics.add(file.source->diagnostic(Severity::Warning, "unknown-style", found->offset,
					"`" + std::string(style) + "` extends `" + std::string(found->base) + "`, which is no other style of this file", style_names(styles)));
			break;
		}
		style = found->base;
	}
	chain.push_back("Default");
	return chain;
}

} // namespace pcg
