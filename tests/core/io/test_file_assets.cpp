#include <doctest/doctest.h>

#include <atomic>
#include <thread>

#include "core/io/file_assets.h"
#include "core/io/image_info.h"
#include "core/io/text_asset.h"

using namespace pcg;

namespace {

// Counts what is read.
class CountingTree final : public FileTree {
public:
	MemoryTree files;
	mutable std::atomic<int> reads = 0;

	bool has_file(const std::string &path) const override { return files.has_file(path); }
	bool has_folder(const std::string &path) const override { return files.has_folder(path); }
	std::vector<Entry> list(const std::string &folder) const override { return files.list(folder); }
	Result<std::string> read(const std::string &path, size_t limit) const override {
		++reads;
		return files.read(path, limit);
	}
};

// Knows what an exported game still has of lost.obj and lost.png.
class Imports final : public ImportedFiles {
public:
	std::optional<Asset> model(const std::string &path) const override {
		++asked;
		if (path != "p/assets/lost.obj") {
			return std::nullopt;
		}
		Asset asset;
		asset.mesh.positions = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
		asset.mesh.loop_ends = { 3 };
		asset.mesh.faces = { { 0, 1, 0, { 0, 0, 1 } } };
		return asset;
	}
	std::optional<ImageInfo> picture(const std::string &path) const override {
		return path == "p/assets/lost.png" ? std::optional(ImageInfo{ { 8, 4 }, true }) : std::nullopt;
	}

	mutable int asked = 0;
};

} // namespace

TEST_CASE("what is only there as an import is taken from there, once; everything else is read") {
	auto tree = std::make_shared<MemoryTree>();
	tree->add("p/assets/lost.obj", ""); // the tree tells of them, and has nothing in them
	tree->add("p/assets/lost.png", "");
	tree->add("p/assets/a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
	const auto imports = std::make_shared<Imports>();
	const FileAssets assets({}, tree, imports);
	for (int i = 0; i < 2; ++i) {
		const Asset *lost = assets.find("lost.obj", "p/rules/x.cga"), *kept = assets.find("a.obj", "p/rules/x.cga");
		REQUIRE((lost != nullptr && kept != nullptr));
		CHECK(lost->mesh.positions.size() == 3);
		CHECK(kept->mesh.positions.size() == 4);
	}
	CHECK(imports->asked == 2);
	CHECK(assets.image_size("lost.png", "p/rules/x.cga") == glm::uvec2(8, 4));
	CHECK(assets.has_alpha("lost.png", "p/rules/x.cga"));
}

TEST_CASE("an asset is read once, by whatever name and thread it is wanted") {
	auto tree = std::make_shared<CountingTree>();
	tree->files.add("p/assets/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
	const FileAssets assets({}, tree);
	std::vector<const Asset *> found(8);
	std::vector<std::thread> threads;
	for (size_t i = 0; i < found.size(); ++i) {
		threads.emplace_back([&, i] { found[i] = assets.find(i % 2 == 0 ? "a.obj" : "assets/a.obj", i < 4 ? "p/rules/x.cga" : "p/rules/y.cga"); });
	}
	for (std::thread &thread : threads) {
		thread.join();
	}
	for (const Asset *asset : found) {
		CHECK(asset == found[0]);
	}
	REQUIRE(found[0] != nullptr);
	CHECK(found[0]->mesh.faces.size() == 1);
	CHECK(tree->reads == 1);
	CHECK(assets.find("b.obj", "p/rules/x.cga") == nullptr);
	CHECK(assets.search("*.obj", "p/rules/x.cga") == assets.search("*.obj", "p/rules/x.cga"));
}

TEST_CASE("texts and tables as rules read them") {
	CHECK(decode_text("\xEF\xBB\xBF" "a\r\nb\rc\x01") == "a\nb\nc?");
	CHECK(decode_text(std::string_view("\xFF\xFE" "a\0\xE4\0", 6)) == "a\xC3\xA4");
	CHECK(decode_text("\xE4") == "\xC3\xA4");
	const TextTable table = parse_table("a;b, c;\"d \"\"e\"\"; f\"\n\n1; 2\n");
	CHECK(table.rows == 2);
	CHECK(table.columns == 3);
	CHECK(table.cells == std::vector<std::string>{ "a", "b, c", "d \"e\"; f", "1", "2", "" });
	CHECK(parse_table("x  y z\n1 2 3").cells == std::vector<std::string>{ "x", "y", "z", "1", "2", "3" });
	CHECK(parse_table("").rows == 0);
	CHECK(parse_table("\"open").cells == std::vector<std::string>{ "open" });
}

TEST_CASE("sizes of pictures come from their first bytes") {
	CHECK(read_image_info(std::string_view("GIF89a\3\0\2\0\0\0\0", 13)).size == glm::uvec2(3, 2));
	// TIFF, two entries: width 640 as a short, height 480 as a long.
	std::string tiff("II*\0\x08\0\0\0\x02\0\x00\x01\x03\0\1\0\0\0\x80\x02\0\0\x01\x01\x04\0\1\0\0\0\xE0\x01\0\0\0\0\0\0", 38);
	CHECK(read_image_info(tiff).size == glm::uvec2(640, 480));
	CHECK_FALSE(read_image_info(tiff).has_alpha);
	CHECK(read_image_info(tiff.substr(0, 20)).size.y == 0);
	tiff[22] = '\x52'; // the second entry, with the tag 338, tells of a further sample
	CHECK(read_image_info(tiff).has_alpha);
	CHECK(read_image_info("no picture").size == glm::uvec2(0, 0));
	CHECK(read_image_info("").size == glm::uvec2(0, 0));
}
