#pragma once

#include "core/io/file_tree.h"

namespace pcg {

// Files and folders as the engine sees them: res://, user:// and the system's, in exported games too. There a model or picture is known by the name of
// the file that it was imported from, though only the import is left (ImportedAssets). Relative paths count from res://.
class EngineTree final : public FileTree {
public:
	bool has_file(const std::string &path) const override;
	bool has_folder(const std::string &path) const override;
	std::vector<Entry> list(const std::string &folder) const override;
	Result<std::string> read(const std::string &path, size_t limit) const override;
	std::string absolute(const std::string &path) const override;
};

} // namespace pcg
