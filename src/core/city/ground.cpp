#include "core/city/ground.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace pcg {

namespace {

enum GroundMaterial : uint32_t { Asphalt, Stripe, Paving, Grass };

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
						 glm::mix(quad[3], quad[2], a) }, stripe_height, Stripe);
	}
}

} // namespace

GroundModel make_ground(const Layout &layout) {
	GroundModel model;
	model.materials = { { "asphalt", { 0.25f, 0.25f, 0.27f, 1.0f } }, { "stripe", { 0.9f, 0.9f, 0.88f, 1.0f } },
		{ "paving", { 0.62f, 0.6f, 0.57f, 1.0f } }, { "grass", { 0.38f, 0.52f, 0.27f, 1.0f } } };
	model.blocks.resize(layout.blocks.size());
	for (const Ground &ground : layout.ground) {
		const bool is_pavement = ground.kind == GroundKind::Pavement;
		Mesh &mesh = is_pavement ? model.blocks[index_of(ground.block)] : model.streets;
		add_face(mesh, ground.polygon, 0.0f, is_pavement ? Paving : Asphalt);
		if (ground.kind == GroundKind::Crossing && ground.polygon.size() == 4) {
			add_stripes(mesh, ground.polygon);
		}
	}
	for (const Lot &lot : layout.lots) {
		add_face(model.blocks[index_of(lot.block)], lot.polygon, lot_height, Grass);
	}
	return model;
}

} // namespace pcg
