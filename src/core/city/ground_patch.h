#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

// Ground for walking that was changed by hand since the city was generated.
namespace pcg {

struct GroundPatch {
	std::vector<glm::vec3> outline; // counter-clockwise from above; what lay within it cannot be walked on any more
	std::vector<std::vector<glm::vec3>> pieces; // convex; what can be walked on instead
};

// In the order in which they lie over each other: by layer, then by whose they are.
using LayeredPatches = std::map<std::pair<int, uint64_t>, GroundPatch>;

// A convex piece of ground and what a metre on it costs.
struct WalkablePiece {
	std::vector<glm::vec3> polygon;
	float cost = 1.0f;
};

// One patch after the other: later ones lie over earlier ones. What remains of a cut piece is convex again. New pieces get `cost`.
void apply_patches(std::vector<WalkablePiece> &ground, std::span<const GroundPatch> patches, float cost);

// Of convex pieces what lies within an outline, and what lies in none of several; convex, too.
std::vector<std::vector<glm::vec3>> pieces_within(std::span<const std::vector<glm::vec3>> pieces, const std::vector<glm::vec3> &outline);
std::vector<std::vector<glm::vec3>> pieces_without(std::vector<std::vector<glm::vec3>> pieces, std::span<const std::vector<glm::vec3>> outlines);

} // namespace pcg
