#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/base/parallel.h"
#include "core/cga/derivation.h"

// Several initial shapes whose rules may ask about each other (CGA reference: cga_context, "inter").
namespace pcg::cga {

// What a rule set asks about its surroundings: known once it is compiled, and only who asks pays.
struct ContextUse {
	bool intra = false; // other shapes of the same initial shape
	bool inter_occlusion = false; // inside, overlaps, touches: initial shapes close by
	bool inter_labels = false; // minimumDistance, contextCount, contextCompare: all initial shapes

	bool asks_inter() const { return inter_occlusion || inter_labels; }
	bool asks_nothing() const { return !intra && !asks_inter(); }
};
ContextUse context_use(const Program &program);

// One initial shape and the rules that build it; `program` null: nothing is built and nothing is seen of it.
struct DeriveJob {
	const Program *program = nullptr;
	const InitialShape *shape = nullptr;
};

// For each job whether a job that asks (`asking`: indices) may ask about it.
std::vector<bool> asked_about(std::span<const DeriveJob> jobs, std::span<const size_t> asking, double occlusion_distance);

// Derives several initial shapes by one rule set: the same models for any number of threads. Cancelled: models that are missing are empty.
std::vector<DerivationResult> derive_all(const Program &program, std::span<const InitialShape> shapes, const DeriveOptions &options = {},
		const WorkOptions &work = {});

} // namespace pcg::cga
