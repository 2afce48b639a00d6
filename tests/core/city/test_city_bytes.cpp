#include <doctest/doctest.h>

#include "core/city/city_bytes.h"
#include "core/city/free_ground.h"

using namespace pcg;

namespace {

City small_city(LayoutKind kind) {
	LayoutParameters parameters = layout_for_lots(20);
	parameters.kind = kind;
	parameters.rings = 1;
	Diagnostics diagnostics;
	City city;
	city.layout = *make_layout(parameters, diagnostics);
	city.lots.resize(city.layout.lots.size());
	for (size_t i = 0; i < city.lots.size(); ++i) {
		city.lots[i].free_ground = free_ground(city.layout.lots[i], cga::DerivationResult());
		city.lots[i].building = BuildingId(i);
		city.lots[i].entrances = { EntranceId(2 * i), EntranceId(2 * i + 1) };
		city.lots[i].model.face_count = 7 * i;
	}
	city.layout.lots[4].holes = { { { 1, 0, -1 }, { 2, 0, -1 }, { 2, 0, -2 } } };
	city.layout.lots[5].around = LotId(4);
	city.ground.streets.resize(city.layout.tiles.size());
	city.ground.blocks.resize(city.layout.blocks.size());
	city.ground.blocks[0].model.face_count = 5;
	city.ground.blocks[0].objects = { ObjectId(3) };
	city.baked.patches = { { { { 1, 0, -1 }, { 2, 0, -1 }, { 2, 0, -2 } }, { { { 1, 0, -1 }, { 2, 0, -1 }, { 2, 0, -1.5f } } } } };
	city.baked.stale_tiles = { 1 };
	return city;
}

} // namespace

TEST_CASE("a city read back from its bytes writes the same bytes") {
	for (LayoutKind kind : { LayoutKind::Grid, LayoutKind::Radial, LayoutKind::Grown }) {
		const City city = small_city(kind);
		const std::string bytes = city_bytes(city);
		Diagnostics diagnostics;
		const std::optional<City> again = city_from_bytes(bytes, diagnostics);
		REQUIRE(again);
		CHECK(diagnostics.is_empty());
		CHECK(city_bytes(*again) == bytes);
		CHECK(again->layout.lots.back().polygon == city.layout.lots.back().polygon);
		CHECK(again->layout.lots[4].holes == city.layout.lots[4].holes);
		CHECK(again->layout.lots[5].around == LotId(4));
		CHECK(again->model.origin == fingerprint_of(city.layout));
		CHECK(again->layout.lots.back().type == city.layout.lots.back().type);
		CHECK(again->lots.back().free_ground == city.lots.back().free_ground);
		CHECK(again->lots[3].entrances == city.lots[3].entrances);
		CHECK(again->ground.blocks[0].objects == city.ground.blocks[0].objects);
		CHECK(again->ground.blocks[0].model.face_count == 5);
		CHECK(again->baked.patches[0].pieces == city.baked.patches[0].pieces);
		CHECK(again->baked.stale_tiles == city.baked.stale_tiles);
	}
}

TEST_CASE("the fingerprint tells cities apart by seed and lots") {
	const Layout layout = small_city(LayoutKind::Grid).layout;
	CHECK(fingerprint_of(layout) == fingerprint_of(small_city(LayoutKind::Grid).layout));
	CHECK(fingerprint_of(layout) != 0);
	CHECK(fingerprint_of(layout) != fingerprint_of(small_city(LayoutKind::Radial).layout));
	Layout seeded = layout, typed = layout, moved = layout, shorter = layout, filled = layout;
	filled.lots[4].holes.clear();
	CHECK(fingerprint_of(filled) != fingerprint_of(layout));
	++seeded.seed;
	typed.lots[3].type += "s";
	moved.lots[3].polygon[0].x += 0.01f;
	shorter.lots.pop_back();
	for (const Layout *other : { &seeded, &typed, &moved, &shorter }) {
		CHECK(fingerprint_of(*other) != fingerprint_of(layout));
	}
}

TEST_CASE("bytes of a city that were cut off or changed are refused, and read nothing out of bounds") {
	const std::string bytes = city_bytes(small_city(LayoutKind::Grid));
	Diagnostics diagnostics;
	for (size_t length = 0; length < bytes.size(); length += 1 + length / 16) {
		CHECK_FALSE(city_from_bytes(bytes.substr(0, length), diagnostics));
	}
	CHECK_FALSE(city_from_bytes(bytes + "x", diagnostics));
	std::string other = bytes;
	other[0] = char(other[0] + 1);
	Diagnostics versions;
	CHECK_FALSE(city_from_bytes(other, versions));
	CHECK(versions.list()[0].message.find("another version") != std::string::npos);
	for (size_t i = 4; i < bytes.size(); i += 37) { // whatever comes of it, what is accepted can be used
		other = bytes;
		other[i] = char(0xFF);
		if (const std::optional<City> city = city_from_bytes(other, diagnostics)) {
			CHECK(city->lots.size() == city->layout.lots.size());
			for (const Lot &lot : city->layout.lots) {
				CHECK(index_of(lot.block) < city->layout.blocks.size());
			}
			for (const uint32_t tile : city->baked.stale_tiles) {
				CHECK(tile < city->layout.tiles.size());
			}
		}
	}
}
