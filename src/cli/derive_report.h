#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/cga/derivation.h"

namespace pcg::cli {

// What pcg derive tells: models of several initial shapes, their sum, and how long one pass over all of them took.
struct DeriveOutcome {
	std::vector<std::string> names; // of the initial shapes
	std::vector<cga::DerivationResult> models;
	cga::DerivationResult sum;
	double seconds = 0.0;
};

// One model of all: meshes, materials and lists one behind the other, reports with equal keys added up.
cga::DerivationResult sum_of(std::span<const cga::DerivationResult> models);

void print_summary(const DeriveOutcome &outcome);
// Faces, vertices, area and bounds are those of the meshes without the objects; the objects' faces are in their list.
std::string report_json(const DeriveOutcome &outcome, const Diagnostics &diagnostics);
// As triangles in world coordinates, one OBJ object for each model and one for each of its objects.
std::string obj_text(const DeriveOutcome &outcome);

} // namespace pcg::cli
