#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/io/asset_reader.h"
#include "core/io/asset_search.h"
#include "core/io/file_tree.h"
#include "core/io/image_info.h"
#include "core/ports/asset_provider.h"

namespace pcg {

// What a host keeps of files that it has turned into something of its own: a game that is handed out may have models and pictures only as its engine
// wants them. Safe to ask from several threads.
class ImportedFiles {
public:
	virtual ~ImportedFiles() = default;
	// nullopt: the file itself is there, or nothing is.
	virtual std::optional<Asset> model(const std::string &path) const = 0;
	virtual std::optional<ImageInfo> picture(const std::string &path) const = 0;
};

// Assets from files. Each name is looked up once and each file read once, whatever thread asks first; files that change afterwards are not read
// again.
class FileAssets final : public AssetProvider {
public:
	// `folders`: further places to look in, after the rule file's own project. `imports`: what stands for files that `files` names but cannot read.
	explicit FileAssets(std::vector<std::string> folders = {}, std::shared_ptr<const FileTree> files = std::make_shared<DiskTree>(),
			std::shared_ptr<const ImportedFiles> imports = nullptr);
	~FileAssets() override;

	const Asset *find(std::string_view name, std::string_view rule_file) const override;
	std::string locate(std::string_view name, std::string_view rule_file) const override;
	std::shared_ptr<const Paths> search(std::string_view query, std::string_view rule_file) const override;
	bool has_alpha(std::string_view name, std::string_view rule_file) const override;
	glm::uvec2 image_size(std::string_view name, std::string_view rule_file) const override;
	const std::string *text(std::string_view name, std::string_view rule_file) const override;
	const TextTable *table(std::string_view name, std::string_view rule_file) const override;

private:
	struct File;

	File *file(std::string_view name, std::string_view rule_file) const;
	Asset read_model(const std::string &path) const;
	ImageInfo read_picture_info(const std::string &path) const;
	const File *image(std::string_view name, std::string_view rule_file) const;

	std::shared_ptr<const FileTree> _files;
	std::shared_ptr<const ImportedFiles> _imports; // nullptr: there are none
	AssetSearch _search;
	mutable std::mutex _mutex; // of the maps; reading happens outside of it
	mutable std::map<std::pair<std::string, std::string>, std::string> _paths; // (folder of the rule file, name) to path
	mutable std::map<std::pair<std::string, std::string>, std::shared_ptr<const Paths>> _searches;
	mutable std::map<std::string, std::unique_ptr<File>> _by_path;
};

} // namespace pcg
