#include "core/cga/texture_files.h"

#include <string>

#include "core/cga/context.h"
#include "core/ports/asset_provider.h"

namespace pcg::cga {

TextureFiles::Entry TextureFiles::find(Context &context, const Text &name) {
	TextPool &texts = context.model.materials().texts();
	const uint32_t rule_file = context.vm.place().file, text = texts.intern(name);
	if (rule_file >= _entries.size()) {
		_entries.resize(rule_file + 1u);
	}
	std::vector<Known> &entries = _entries[rule_file];
	if (text >= entries.size()) {
		entries.resize(text + 1u);
	}
	Known &known = entries[text];
	if (!known.was_asked) {
		known = ask(context, name, rule_file);
	}
	if (known.is_missing && !context.vm.has_warned()) {
		context.vm.warn("missing-texture", "there is no picture \"" + std::string(name.view) + "\"; the surface has its colour only");
	}
	return known;
}

TextureFiles::Known TextureFiles::ask(Context &context, const Text &name, uint32_t rule_file) const {
	TextPool &texts = context.model.materials().texts();
	const AssetProvider *assets = context.options().assets;
	Known known;
	known.file = texts.intern(name);
	known.was_asked = true;
	if (assets != nullptr && !name.view.empty() && !name.view.starts_with("builtin:")) {
		const std::string &from = context.vm.program().files[rule_file];
		known.path = texts.intern(std::string_view(assets->locate(name.view, from)));
		known.has_alpha = assets->has_alpha(name.view, from);
		known.is_missing = known.path == 0;
	}
	return known;
}

} // namespace pcg::cga
