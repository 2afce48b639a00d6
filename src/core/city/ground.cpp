#include "core/city/ground.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace pcg {

namespace {

const Material asphalt{ "asphalt", { 0.25f, 0.25f, 0.27f, 1.0f } }, stripe{ "stripe", { 0.9f, 0.9f, 0.88f, 1.0f } },
		paving{ "paving", { 0.62f, 0.6f, 0.57f, 1.0f } }, grass{ "grass", { 0.38f, 0.52f, 0.27f, 1.0f } };

constexpr float lot_height = -0.02f;
constexpr float stripe_height = 0.01f;
constexpr float stripe_width = 0.5f; // and as much between two

void add_face(Mesh &mesh, const std::vector<glm::vec3> &polygon, float height, uint32_t material) {
	MeshFace face;
	face.first_loop = uint32_t(mesh.loop_ends.size());
	face.material = material;
	for (const glm::vec3 &corner : polygon) {
		mesh.positions.push_back({ corner.x, corner.y + height, corner.z });
	}
	mesh.loop_ends.push_back(uint32_t(mesh.positions.size()));
	mesh.faces.push_back(face);
}

// Bars across a four-cornered crossing, whose first edge runs along the street: who crosses walks from it over one bar after the other.
void add_stripes(Mesh &mesh, std::vector<glm::vec3> quad) {
	std::rotate(quad.begin(), quad.begin() + 1, quad.end());
	const float length = glm::distance(quad[0], quad[1]);
	const size_t bars = std::min<size_t>(100, size_t((length + stripe_width) / (2.0f * stripe_width)));
	const float margin = (length - stripe_width * float(2 * bars - 1)) / 2.0f;
	for (size_t i = 0; i < bars; ++i) {
		const float a = (margin + stripe_width * float(2 * i)) / length, b = a + stripe_width / length;
		add_face(mesh, { glm::mix(quad[0], quad[1], a), glm::mix(quad[0], quad[1], b), glm::mix(quad[3], quad[2], b),
						 glm::mix(quad[3], quad[2], a) }, stripe_height, 1);
	}
}

// The tile whose middle is nearest, which is the one that the piece lies in, mostly.
size_t tile_of(const Layout &layout, const Ground &ground) {
	glm::vec3 middle(0.0f);
	for (const glm::vec3 &corner : ground.polygon) {
		middle += corner / float(ground.polygon.size());
	}
	const auto nearest = std::ranges::min_element(layout.tiles, {}, [&](const Tile &tile) { return glm::distance((tile.min + tile.max) / 2.0f, middle); });
	return size_t(nearest - layout.tiles.begin());
}

} // namespace

GroundGroups group_ground(const Layout &layout) {
	GroundGroups groups;
	groups.streets.resize(layout.tiles.size());
	groups.blocks.resize(layout.blocks.size());
	for (uint32_t i = 0; i < layout.ground.size(); ++i) {
		const Ground &ground = layout.ground[i];
		(ground.kind == GroundKind::Pavement ? groups.blocks[index_of(ground.block)] : groups.streets[tile_of(layout, ground)]).push_back(i);
	}
	return groups;
}

cga::DerivationResult plain_ground(const Ground &ground) {
	cga::DerivationResult result;
	const bool is_pavement = ground.kind == GroundKind::Pavement;
	result.materials = is_pavement ? std::vector<Material>{ paving } : std::vector<Material>{ asphalt, stripe };
	add_face(result.mesh, ground.polygon, 0.0f, 0);
	if (ground.kind == GroundKind::Crossing && ground.polygon.size() == 4) {
		add_stripes(result.mesh, ground.polygon);
	}
	return result;
}

cga::DerivationResult lot_ground(const Layout &layout, const CityBlock &block) {
	cga::DerivationResult result;
	result.materials = { grass };
	for (const LotId lot : block.lots) {
		add_face(result.mesh, layout.lot(lot).polygon, lot_height, 0);
	}
	return result;
}

} // namespace pcg
