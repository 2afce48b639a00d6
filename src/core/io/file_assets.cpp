#include "core/io/file_assets.h"

#include "core/io/built_in_pictures.h"
#include "core/io/text_asset.h"

namespace pcg {

namespace {

constexpr size_t max_text_bytes = size_t(64) << 20;
constexpr size_t max_image_bytes = size_t(256) << 20;

std::pair<std::string, std::string> key_of(std::string_view name, std::string_view rule_file) {
	const size_t slash = rule_file.find_last_of("/\\");
	return { std::string(rule_file.substr(0, slash == std::string_view::npos ? 0 : slash + 1)), std::string(name) };
}

} // namespace

// What has been read of one file; each part when it is first wanted.
struct FileAssets::File {
	std::string path;
	std::once_flag asset_flag, image_flag, text_flag, table_flag;
	Asset asset;
	ImageInfo image;
	std::string text;
	TextTable table;
};

FileAssets::FileAssets(std::vector<std::string> folders, std::shared_ptr<const FileTree> files, std::shared_ptr<const ImportedFiles> imports) :
		_files(std::move(files)), _imports(std::move(imports)), _search(*_files, std::move(folders)) {}

FileAssets::~FileAssets() = default;

std::string FileAssets::locate(std::string_view name, std::string_view rule_file) const {
	auto key = key_of(name, rule_file);
	{
		const std::scoped_lock lock(_mutex);
		const auto known = _paths.find(key);
		if (known != _paths.end()) {
			return known->second;
		}
	}
	std::string path = _search.locate(name, std::string(rule_file));
	const std::scoped_lock lock(_mutex);
	return _paths.emplace(std::move(key), std::move(path)).first->second;
}

FileAssets::File *FileAssets::file(std::string_view name, std::string_view rule_file) const {
	const std::string path = locate(name, rule_file);
	if (path.empty()) {
		return nullptr;
	}
	const std::scoped_lock lock(_mutex);
	std::unique_ptr<File> &file = _by_path[path];
	if (file == nullptr) {
		file = std::make_unique<File>();
		file->path = path;
	}
	return file.get();
}

const Asset *FileAssets::find(std::string_view name, std::string_view rule_file) const {
	File *found = file(name, rule_file);
	if (found == nullptr) {
		return nullptr;
	}
	std::call_once(found->asset_flag, [&] { found->asset = read_model(found->path); });
	return &found->asset;
}

Asset FileAssets::read_model(const std::string &path) const {
	std::optional<Asset> imported = _imports != nullptr ? _imports->model(path) : std::nullopt;
	return imported ? std::move(*imported) : read_asset(*_files, path);
}

ImageInfo FileAssets::read_picture_info(const std::string &path) const {
	const std::optional<ImageInfo> imported = _imports != nullptr ? _imports->picture(path) : std::nullopt;
	if (imported) {
		return *imported;
	}
	const Result<std::string> bytes = _files->read(path, max_image_bytes);
	return bytes ? read_image_info(*bytes) : ImageInfo();
}

std::shared_ptr<const AssetProvider::Paths> FileAssets::search(std::string_view query, std::string_view rule_file) const {
	auto key = key_of(query, rule_file);
	{
		const std::scoped_lock lock(_mutex);
		const auto known = _searches.find(key);
		if (known != _searches.end()) {
			return known->second;
		}
	}
	auto paths = std::make_shared<const Paths>(_search.search(query, std::string(rule_file)));
	const std::scoped_lock lock(_mutex);
	return _searches.emplace(std::move(key), std::move(paths)).first->second;
}

const FileAssets::File *FileAssets::image(std::string_view name, std::string_view rule_file) const {
	File *found = file(name, rule_file);
	if (found != nullptr) {
		std::call_once(found->image_flag, [&] { found->image = read_picture_info(found->path); });
	}
	return found;
}

glm::uvec2 FileAssets::image_size(std::string_view name, std::string_view rule_file) const {
	const glm::uvec2 built_in = built_in_picture_size(name);
	if (built_in.x > 0) {
		return built_in;
	}
	const File *found = image(name, rule_file);
	return found != nullptr ? found->image.size : glm::uvec2(0);
}

bool FileAssets::has_alpha(std::string_view name, std::string_view rule_file) const {
	const File *found = image(name, rule_file);
	return found != nullptr && found->image.has_alpha;
}

const std::string *FileAssets::text(std::string_view name, std::string_view rule_file) const {
	File *found = file(name, rule_file);
	if (found == nullptr) {
		return nullptr;
	}
	std::call_once(found->text_flag, [&] {
		const Result<std::string> bytes = _files->read(found->path, max_text_bytes);
		found->text = bytes ? decode_text(*bytes) : std::string();
	});
	return &found->text;
}

const TextTable *FileAssets::table(std::string_view name, std::string_view rule_file) const {
	const std::string *content = text(name, rule_file);
	if (content == nullptr) {
		return nullptr;
	}
	File *found = file(name, rule_file);
	std::call_once(found->table_flag, [&] { found->table = parse_table(*content); });
	return &found->table;
}

} // namespace pcg
