#pragma once

#include <memory>

#include "core/io/file_assets.h"
#include "godot/main_thread.h"

namespace pcg {

// Models and pictures of which only the engine's imports are left, as in exported games. Models come as triangles. The engine is asked on its main
// thread; whoever waits there for an answer calls MainThread::run_waiting() meanwhile.
class ImportedAssets final : public ImportedFiles {
public:
	explicit ImportedAssets(std::shared_ptr<MainThread> main) : _main(std::move(main)) {}

	std::optional<Asset> model(const std::string &path) const override;
	std::optional<ImageInfo> picture(const std::string &path) const override;

private:
	std::shared_ptr<MainThread> _main;
};

} // namespace pcg
