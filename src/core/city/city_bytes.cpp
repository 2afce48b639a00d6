#include "core/city/city_bytes.h"

#include <algorithm>
#include <cmath>

#include "core/base/bytes.h"
#include "core/base/random.h"

namespace pcg {

namespace {

constexpr uint32_t version = 0x50434704; // changes with the records below

// Each visit names the fields of a record once, for writing and reading.
template <typename Bytes, typename Point> void visit_point(Bytes &bytes, Point &point) { bytes.values(point.x, point.y, point.z); }

template <typename Bytes, typename Polygon> void visit_polygon(Bytes &bytes, Polygon &polygon) {
	bytes.list(polygon, [](Bytes &inner, auto &point) { visit_point(inner, point); });
}

template <typename Bytes, typename List> void visit_values(Bytes &bytes, List &list) {
	bytes.list(list, [](Bytes &inner, auto &value) { inner.values(value); });
}

template <typename Bytes, typename Record> void visit_lot(Bytes &bytes, Record &lot) {
	bytes.values(lot.block, lot.seed, lot.height);
	bytes.text(lot.type);
	visit_polygon(bytes, lot.polygon);
	visit_values(bytes, lot.street_widths);
}

template <typename Bytes, typename Record> void visit_courtyards(Bytes &bytes, Record &lot) {
	bytes.values(lot.around);
	bytes.list(lot.holes, [](Bytes &inner, auto &hole) { visit_polygon(inner, hole); });
}

template <typename Bytes, typename Record> void visit_ground(Bytes &bytes, Record &ground) {
	bytes.choice(ground.kind, size_t(GroundKind::Pavement) + 1);
	bytes.values(ground.block, ground.street);
	visit_polygon(bytes, ground.polygon);
}

template <typename Bytes, typename Record> void visit_layout(Bytes &bytes, Record &layout) {
	bytes.values(layout.seed);
	bytes.list(layout.blocks, [](Bytes &inner, auto &block) {
		visit_values(inner, block.lots);
		visit_values(inner, block.pavements);
		visit_polygon(inner, block.outline);
	});
	bytes.list(layout.lots, [](Bytes &inner, auto &lot) {
		visit_lot(inner, lot);
		visit_courtyards(inner, lot);
	});
	visit_polygon(bytes, layout.junctions);
	bytes.list(layout.streets, [](Bytes &inner, auto &street) { inner.values(street.from, street.to, street.width); });
	bytes.list(layout.ground, [](Bytes &inner, auto &ground) { visit_ground(inner, ground); });
	bytes.list(layout.tiles, [](Bytes &inner, auto &tile) {
		visit_point(inner, tile.min);
		visit_point(inner, tile.max);
	});
	bytes.list(layout.overlaps, [](Bytes &inner, auto &overlap) { inner.values(overlap.a, overlap.b, overlap.area); });
	visit_polygon(bytes, layout.outline);
	visit_point(bytes, layout.min);
	visit_point(bytes, layout.max);
}

template <typename Bytes, typename Record> void visit_build(Bytes &bytes, Record &build) {
	bytes.values(build.building, build.model.face_count);
	visit_values(bytes, build.entrances);
	visit_values(bytes, build.zones);
	visit_values(bytes, build.objects);
	bytes.list(build.free_ground, [](Bytes &inner, auto &piece) { visit_polygon(inner, piece); });
}

template <typename Bytes, typename List> void visit_ground_builds(Bytes &bytes, List &builds) {
	bytes.list(builds, [](Bytes &inner, auto &build) {
		inner.values(build.model.face_count);
		visit_values(inner, build.zones);
		visit_values(inner, build.objects);
	});
}

template <typename Bytes, typename Record> void visit_baked(Bytes &bytes, Record &baked) {
	bytes.list(baked.patches, [](Bytes &inner, auto &patch) {
		visit_polygon(inner, patch.outline);
		inner.list(patch.pieces, [](Bytes &innermost, auto &piece) { visit_polygon(innermost, piece); });
	});
	visit_values(bytes, baked.stale_tiles);
}

template <typename Bytes, typename Record> void visit_city(Bytes &bytes, Record &city) {
	visit_layout(bytes, city.layout);
	bytes.list(city.lots, [](Bytes &inner, auto &build) { visit_build(inner, build); });
	visit_ground_builds(bytes, city.ground.streets);
	visit_ground_builds(bytes, city.ground.blocks);
	visit_baked(bytes, city.baked);
}

bool is_polygon(const std::vector<glm::vec3> &polygon) {
	return polygon.size() >= 3 &&
			std::ranges::all_of(polygon, [](glm::vec3 corner) { return std::isfinite(corner.x + corner.y + corner.z); });
}

bool is_sound(const CityBlock &block, const Layout &layout) {
	return std::ranges::all_of(block.lots, [&](LotId lot) { return index_of(lot) < layout.lots.size(); }) &&
			std::ranges::all_of(block.pavements, [&](uint32_t i) { return i < layout.ground.size(); });
}

bool is_sound(const Layout &layout) {
	const auto is_sound_lot = [&](const Lot &lot) {
		return index_of(lot.block) < layout.blocks.size() && is_polygon(lot.polygon) && lot.street_widths.size() == lot.polygon.size() &&
				std::ranges::all_of(lot.holes, is_polygon) && (!is_valid(lot.around) || index_of(lot.around) < layout.lots.size());
	};
	const auto is_sound_street = [&](const Street &street) { return std::max(street.from, street.to) < layout.junctions.size(); };
	const auto is_sound_ground = [&](const Ground &ground) {
		return is_polygon(ground.polygon) && (!is_valid(ground.block) || index_of(ground.block) < layout.blocks.size()) &&
				(ground.street == no_street || ground.street < layout.streets.size());
	};
	const auto is_sound_overlap = [&](const LotOverlap &overlap) { return std::max(index_of(overlap.a), index_of(overlap.b)) < layout.lots.size(); };
	return std::ranges::all_of(layout.overlaps, is_sound_overlap) && std::ranges::all_of(layout.blocks, [&](const CityBlock &block) { return is_sound(block, layout); }) &&
			std::ranges::all_of(layout.lots, is_sound_lot) && std::ranges::all_of(layout.streets, is_sound_street) &&
			std::ranges::all_of(layout.ground, is_sound_ground);
}

// Only compared with what patches are now.
bool is_sound(const BakedGround &baked, const Layout &layout) {
	const auto is_tile = [&](uint32_t tile) { return tile < layout.tiles.size(); };
	return std::ranges::all_of(baked.stale_tiles, is_tile) && std::ranges::all_of(baked.patches, [](const GroundPatch &patch) { return is_polygon(patch.outline); });
}

} // namespace

uint64_t fingerprint_of(const Layout &layout) {
	ByteWriter bytes;
	bytes.values(layout.seed);
	bytes.list(layout.lots, [](ByteWriter &inner, const Lot &lot) {
		visit_lot(inner, lot);
		if (!lot.holes.empty()) { // without any it is what it was before there were any
			visit_courtyards(inner, lot);
		}
	});
	return hash_text(bytes.bytes()) | 1;
}

std::string city_bytes(const City &city) {
	ByteWriter bytes;
	bytes.values(version);
	visit_city(bytes, city);
	return bytes.take();
}

std::optional<City> city_from_bytes(std::string_view bytes, Diagnostics &diagnostics) {
	ByteReader reader(bytes);
	uint32_t found = 0;
	reader.values(found);
	City city;
	if (found == version) {
		visit_city(reader, city);
	}
	const bool is_whole = found == version && reader.is_good() && reader.is_at_end() && city.lots.size() == city.layout.lots.size() && is_sound(city.layout) &&
			city.ground.streets.size() == city.layout.tiles.size() && city.ground.blocks.size() == city.layout.blocks.size() &&
			std::ranges::all_of(city.lots, [](const LotBuild &lot) { return std::ranges::all_of(lot.free_ground, is_polygon); }) && is_sound(city.baked, city.layout);
	if (!is_whole) {
		diagnostics.error("bad-saved-city", found == version ? "the saved layout of this city is damaged" : "this city was saved by another version",
				"generate it anew");
		return std::nullopt;
	}
	city.model.origin = fingerprint_of(city.layout);
	return city;
}

} // namespace pcg
