#include "core/cga/texture_files.h"

#include <string>

#include "core/cga/context.h"
#include "core/ports/asset_provider.h"

namespace pcg::cga {

TextureFiles::Entry TextureFiles::find(Context &context, const Text &name) {
	const AssetProvider *assets = context.options().assets;
	const bool is_built_in = name.view.starts_with("builtin:");
	if (assets == nullptr || name.view.empty() || is_built_in) {
		return {};
	}
	TextPool &texts = context.model.materials().texts();
	const uint32_t file = context.vm.place().file;
	const auto [place, is_new] = _entries.try_emplace((uint64_t(file) << 32) | texts.intern(name));
	if (is_new) {
		const std::string &rule_file = context.vm.program().files[file];
		place->second = { texts.intern(std::string_view(assets->locate(name.view, rule_file))), assets->has_alpha(name.view, rule_file) };
	}
	if (place->second.path == 0 && !context.vm.has_warned()) {
		context.vm.warn("missing-texture", "there is no picture \"" + std::string(name.view) + "\"; the surface has its colour only");
	}
	return place->second;
}

} // namespace pcg::cga
