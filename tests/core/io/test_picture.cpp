#include <doctest/doctest.h>

#include "core/io/asset_reader.h"
#include "core/io/built_in_pictures.h"
#include "core/io/file_assets.h"
#include "core/io/picture.h"

using namespace pcg;

namespace {

// One row of two pixels.
Picture pair(std::vector<uint8_t> pixels, bool has_alpha = true) {
	return { { 2, 1 }, std::move(pixels), has_alpha };
}

} // namespace

TEST_CASE("a picture that is written and read is the same to the bit") {
	const Picture picture = pair({ 1, 2, 3, 4, 250, 251, 252, 253 });
	const auto read = decode_picture(encode_png(picture));
	REQUIRE(read.has_value());
	CHECK(read->size == picture.size);
	CHECK(read->pixels == picture.pixels);
	CHECK(read->has_alpha);
}

TEST_CASE("what is no whole picture is none") {
	const std::string bytes = encode_png(pair({ 1, 2, 3, 4, 5, 6, 7, 8 }));
	CHECK(!decode_picture("").has_value());
	CHECK(!decode_picture("not a picture").has_value());
	CHECK(!decode_picture(bytes.substr(0, bytes.size() / 2)).has_value());
	CHECK(encode_png(Picture()).empty());
}

TEST_CASE("opacity comes from the alpha channel, else from the brightness") {
	const Picture color = pair({ 10, 20, 30, 255, 40, 50, 60, 255 }, false);
	const Picture alpha = pair({ 255, 255, 255, 7, 255, 255, 255, 9 });
	CHECK(with_opacity(&color, alpha).pixels == std::vector<uint8_t>{ 10, 20, 30, 7, 40, 50, 60, 9 });
	// 0.299 of red, 0.587 of green, 0.114 of blue: pure red is 76.245, white 255.
	const Picture bright = pair({ 255, 0, 0, 255, 255, 255, 255, 255 }, false);
	CHECK(with_opacity(&color, bright).pixels == std::vector<uint8_t>{ 10, 20, 30, 76, 40, 50, 60, 255 });
	CHECK(with_opacity(nullptr, alpha).pixels == std::vector<uint8_t>{ 255, 255, 255, 7, 255, 255, 255, 9 });
}

TEST_CASE("of two sizes the larger counts, by axis, and pixels of the other are repeated") {
	const Picture wide = pair({ 1, 1, 1, 255, 2, 2, 2, 255 });
	const Picture tall{ { 1, 2 }, { 0, 0, 0, 50, 0, 0, 0, 60 }, true };
	const Picture both = with_opacity(&wide, tall);
	CHECK(both.size == glm::uvec2(2, 2));
	CHECK(both.pixels == std::vector<uint8_t>{ 1, 1, 1, 50, 2, 2, 2, 50, 1, 1, 1, 60, 2, 2, 2, 60 });
}

TEST_CASE("roughness lies in green, metal in blue, and what is missing is 1") {
	const Picture roughness = pair({ 9, 10, 11, 255, 19, 20, 21, 255 });
	const Picture metallic = pair({ 29, 30, 31, 255, 39, 40, 41, 255 });
	CHECK(metallic_roughness(&roughness, &metallic).pixels == std::vector<uint8_t>{ 255, 10, 31, 255, 255, 20, 41, 255 });
	CHECK(metallic_roughness(&roughness, nullptr).pixels == std::vector<uint8_t>{ 255, 10, 255, 255, 255, 20, 255, 255 });
	CHECK(metallic_roughness(nullptr, &metallic).pixels == std::vector<uint8_t>{ 255, 255, 31, 255, 255, 255, 41, 255 });
}

TEST_CASE("pictures that are built in are read and measured without files") {
	for (const auto &[name, size] : { std::pair("builtin:default", 128u), std::pair("builtin:uvtest.png", 512u) }) {
		const Result<std::string> bytes = read_picture(DiskTree(), name, size_t(1) << 20);
		REQUIRE(bytes);
		const auto picture = decode_picture(*bytes);
		REQUIRE(picture.has_value());
		CHECK(picture->size == glm::uvec2(size));
		CHECK(FileAssets().image_size(name, "rules/a.cga") == glm::uvec2(size));
	}
	// Black in the lower left corner, and each eighth pixel another field.
	const auto checkers = built_in_picture("builtin:default");
	CHECK(checkers->pixel({ 0, 127 })[0] == 0);
	CHECK(checkers->pixel({ 8, 127 })[0] == 255);
	CHECK(checkers->pixel({ 8, 119 })[0] == 0);
	// Red grows along u, green upwards: in the file from the last row to the first.
	const auto test = built_in_picture("builtin:uvtest.png");
	CHECK(test->pixel({ 32, 480 })[0] < test->pixel({ 160, 480 })[0]);
	CHECK(test->pixel({ 32, 480 })[1] < test->pixel({ 32, 352 })[1]);
	CHECK(!built_in_picture("builtin:cube").has_value());
	CHECK(built_in_picture_size("builtin:cube") == glm::uvec2(0));
}
