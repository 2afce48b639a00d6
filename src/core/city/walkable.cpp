#include "core/city/walkable.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <string>

#include <glm/geometric.hpp>

#include "core/city/lot_ground.h"

namespace pcg {

namespace {

bool is_near(const std::vector<glm::vec3> &polygon, glm::vec3 min, glm::vec3 max) {
	if (polygon.empty()) {
		return false;
	}
	glm::vec3 low = polygon[0], high = polygon[0];
	for (const glm::vec3 &corner : polygon) {
		low = { std::min(low.x, corner.x), 0.0f, std::min(low.z, corner.z) };
		high = { std::max(high.x, corner.x), 0.0f, std::max(high.z, corner.z) };
	}
	return low.x <= max.x && high.x >= min.x && low.z <= max.z && high.z >= min.z;
}

void add_fan(std::vector<glm::vec3> &triangles, const std::vector<glm::vec3> &polygon) {
	for (size_t i = 1; i + 1 < polygon.size(); ++i) {
		triangles.insert(triangles.end(), { polygon[0], polygon[i], polygon[i + 1] });
	}
}

// Long strips are cut across into pieces of about this length: estimates of what lies ahead are better with short gaps.
constexpr float piece_length = 20.0f;

void add_ground(std::vector<WalkablePiece> &pieces, std::vector<glm::vec3> quad, float cost) {
	if (quad.size() != 4) {
		pieces.push_back({ std::move(quad), cost });
		return;
	}
	const float length = glm::distance(quad[0], quad[1]);
	if (length < glm::distance(quad[1], quad[2])) {
		std::rotate(quad.begin(), quad.begin() + 1, quad.end());
	}
	const int count = std::max(1, int(std::round(glm::distance(quad[0], quad[1]) / piece_length)));
	for (int i = 0; i < count; ++i) {
		const float a = float(i) / float(count), b = float(i + 1) / float(count);
		pieces.push_back({ { glm::mix(quad[0], quad[1], a), glm::mix(quad[0], quad[1], b), glm::mix(quad[3], quad[2], b),
								   glm::mix(quad[3], quad[2], a) }, cost });
	}
}

bool is_carriageway(GroundKind kind) { return kind == GroundKind::Street || kind == GroundKind::Junction; }

float cost_of(GroundKind kind, const GroundCosts &costs) {
	switch (kind) {
		case GroundKind::Street:
		case GroundKind::Junction: return costs.street;
		case GroundKind::Crossing: return costs.crossing;
		case GroundKind::Pavement: return costs.pavement;
	}
	return 1.0f;
}

constexpr size_t named_records = 5; // in a message; who wants all of them looks at the verdicts

bool is_cut_off(Reach reach) { return reach == Reach::OffMesh || reach == Reach::Island; }

std::string place_name(const City &city, LotId lot, const char *otherwise) {
	return index_of(lot) < city.layout.lots.size() ? lot_name(city.layout, lot) : otherwise;
}

// "2 of 30 entrances cannot be reached on foot: ..", of `name(i)` and a reason each; empty if there is nothing to tell.
template <typename Name>
std::string list_cut_off(std::span<const Reach> verdicts, const std::string &one, const std::string &many, const char *off_mesh, const char *island, Name name) {
	std::string names;
	size_t count = 0;
	const size_t total = verdicts.size() - size_t(std::count(verdicts.begin(), verdicts.end(), Reach::Removed));
	for (size_t i = 0; i < verdicts.size(); ++i) {
		if (is_cut_off(verdicts[i]) && ++count <= named_records) {
			names += (count > 1 ? "; " : "") + name(i) + ", " + (verdicts[i] == Reach::OffMesh ? off_mesh : island);
		}
	}
	if (count == 0) {
		return {};
	}
	const std::string rest = count > named_records ? "; and " + std::to_string(count - named_records) + " more" : "";
	return std::to_string(count) + " of " + std::to_string(total) + " " + (total == 1 ? one : many) + " cannot be reached on foot: " + names + rest;
}

} // namespace

std::vector<glm::vec3> tile_faces(const City &city, const Tile &tile, float border, bool has_carriageways) {
	const std::vector<Ground> &all = city.layout.ground;
	has_carriageways |= std::none_of(all.begin(), all.end(), [](const Ground &ground) { return ground.kind == GroundKind::Crossing; });
	const glm::vec3 min = tile.min - glm::vec3(border), max = tile.max + glm::vec3(border);
	std::vector<WalkablePiece> pieces;
	for (const Ground &ground : all) {
		if ((has_carriageways || !is_carriageway(ground.kind)) && is_near(ground.polygon, min, max)) {
			pieces.push_back({ ground.polygon });
		}
	}
	for (size_t i = 0; i < city.lots.size(); ++i) {
		if (is_near(city.layout.lots[i].polygon, min, max)) {
			for (std::vector<glm::vec3> &piece : lot_ground(city, LotId(i))) {
				pieces.push_back({ std::move(piece) });
			}
		}
	}
	std::vector<GroundPatch> patches;
	std::copy_if(city.patches.begin(), city.patches.end(), std::back_inserter(patches),
			[&](const GroundPatch &patch) { return is_near(patch.outline, min, max); });
	apply_patches(pieces, patches, 1.0f);
	std::vector<glm::vec3> triangles;
	for (const WalkablePiece &piece : pieces) {
		add_fan(triangles, piece.polygon);
	}
	return triangles;
}

NavRegion city_nav_region(const City &city, const GroundCosts &costs) {
	std::vector<WalkablePiece> pieces;
	for (const Ground &ground : city.layout.ground) {
		add_ground(pieces, ground.polygon, cost_of(ground.kind, costs));
	}
	for (size_t i = 0; i < city.lots.size(); ++i) {
		for (std::vector<glm::vec3> &piece : lot_ground(city, LotId(i))) {
			pieces.push_back({ std::move(piece), costs.lot });
		}
	}
	apply_patches(pieces, city.patches, costs.lot);
	NavRegion region;
	for (const WalkablePiece &piece : pieces) {
		std::vector<uint32_t> indices(piece.polygon.size());
		std::iota(indices.begin(), indices.end(), uint32_t(region.vertices.size()));
		region.vertices.insert(region.vertices.end(), piece.polygon.begin(), piece.polygon.end());
		region.polygons.push_back(std::move(indices));
		region.costs.push_back(piece.cost);
	}
	return region;
}

NavMesh city_nav_mesh(const City &city, const GroundCosts &costs) {
	const NavRegion region = city_nav_region(city, costs);
	NavMeshOptions options;
	options.margin = 0.05f; // pieces fit exactly, but for rounding
	return NavMesh::build({ &region, 1 }, options);
}

void report_unreachable(const City &city, std::span<const Reach> verdicts, Diagnostics &diagnostics) {
	const std::string message = list_cut_off(verdicts, "entrance", "entrances", "no walkable ground before it",
			"the ground before it is not connected with the streets", [&](size_t i) {
				const Entrance &entrance = city.model.entrances()[i];
				return place_name(city, city.model.building(entrance.building).lot, "a building without a lot") + ", type `" +
						std::string(city.model.types.name(entrance.type)) + "`";
			});
	if (!message.empty()) {
		diagnostics.warning("unreachable-entrance", message, "leave free ground between each of these doors and the street");
	}
}

void report_unreachable_zones(const City &city, std::span<const Reach> verdicts, Diagnostics &diagnostics) {
	const std::string message = list_cut_off(verdicts, "zone", "zones", "no walkable ground in it", "its ground is not connected with the streets", [&](size_t i) {
		const Zone &zone = city.model.zones()[i];
		return place_name(city, zone.lot, "on no lot") + ", type `" + std::string(city.model.types.name(zone.type)) + "`";
	});
	if (!message.empty()) {
		diagnostics.warning("unreachable-zone", message, "leave free ground in each of these zones, or beside it, and from there to the street");
	}
}

} // namespace pcg
