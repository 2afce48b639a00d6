#include "core/city/layout.h"

#include <cmath>
#include <numeric>

#include "core/base/random.h"
#include "core/city/plan_layout.h"
#include "core/city/street_generators.h"

namespace pcg {

namespace {

template <typename T>
bool check_limit(std::string_view name, T value, T low, T high, Diagnostics &diagnostics) {
	if (value >= low && value <= high) { // false for NaN
		return true;
	}
	diagnostics.error("bad-layout", "layout: " + std::string(name) + " is " + std::to_string(value) + ", but must be from " +
					std::to_string(low) + " to " + std::to_string(high), "change this parameter of the layout");
	return false;
}

StreetPlan plan_of(const LayoutParameters &p) {
	StreetPlan plan;
	switch (p.kind) {
		case LayoutKind::Grid: plan = grid_streets(p); break;
		case LayoutKind::Radial: plan = radial_streets(p); break;
		case LayoutKind::Grown: plan = grown_streets(p); break;
	}
	remove_streets(plan, double(p.removed), Random(derive_seed(p.seed, hash_text("removed streets"))));
	const glm::dvec2 land = block_size(p) - double(p.street_width) - 2.0 * double(p.pavement_width);
	move_nodes(plan, double(p.jitter) * std::fmin(land.x, land.y), Random(derive_seed(p.seed, hash_text("jitter"))));
	return plan;
}

} // namespace

bool check_parameters(const LayoutParameters &p, Diagnostics &diagnostics) {
	bool is_good = check_limit<uint32_t>("the number of blocks in x", p.blocks_x, 1, 1000, diagnostics);
	is_good &= check_limit<uint32_t>("the number of blocks in z", p.blocks_z, 1, 1000, diagnostics);
	is_good &= check_limit<uint32_t>("the number of lots along a block", p.lots_along, 1, 100, diagnostics);
	is_good &= check_limit<uint32_t>("the depth of a block in lots", p.lots_deep, 1, 2, diagnostics);
	is_good &= check_limit("the front of a lot", p.lot_front, 5.0f, 500.0f, diagnostics);
	is_good &= check_limit("the aspect of a lot", p.lot_aspect, 0.25f, 4.0f, diagnostics);
	is_good &= check_limit("the width of streets", p.street_width, 2.0f, 100.0f, diagnostics);
	is_good &= check_limit("the width of pavements", p.pavement_width, 0.5f, 50.0f, diagnostics);
	is_good &= check_limit("the width of main streets", p.main_street_width, 2.0f, 100.0f, diagnostics);
	is_good &= check_limit<uint32_t>("the number of rings", p.rings, 1, 100, diagnostics);
	is_good &= check_limit<uint32_t>("the number of spokes", p.spokes, 5, 64, diagnostics);
	is_good &= check_limit("the jitter", p.jitter, 0.0f, 0.25f, diagnostics);
	is_good &= check_limit("the part of streets that is removed", p.removed, 0.0f, 0.5f, diagnostics);
	if (is_good && size_t(block_count(p)) * p.lots_along * p.lots_deep > max_lots) {
		diagnostics.error("bad-layout", "layout: this would be more than " + std::to_string(max_lots) + " lots", "use fewer blocks");
		return false;
	}
	return is_good;
}

bool assign_types(Layout &layout, const LayoutParameters &p, Diagnostics &diagnostics) {
	std::vector<glm::vec2> positions;
	std::vector<size_t> lots;
	for (size_t i = 0; i < layout.lots.size(); ++i) {
		const Lot &lot = layout.lots[i];
		if (!lot.type.empty()) {
			continue;
		}
		glm::vec3 middle(0.0f);
		for (const glm::vec3 &corner : lot.polygon) {
			middle += corner / float(lot.polygon.size());
		}
		const glm::vec3 fraction = (middle - layout.min) / (layout.max - layout.min + glm::vec3(0.0f, 1.0f, 0.0f));
		positions.push_back({ fraction.x, fraction.z });
		lots.push_back(i);
	}
	const std::vector<std::string> types = assign_land_use(positions, p.land_use, p.districts, p.seed, diagnostics);
	for (size_t i = 0; i < types.size(); ++i) {
		layout.lots[lots[i]].type = types[i];
	}
	return types.size() == lots.size();
}

std::optional<Layout> make_layout(const LayoutParameters &parameters, Diagnostics &diagnostics) {
	if (!check_parameters(parameters, diagnostics)) {
		return std::nullopt;
	}
	std::optional<Layout> layout = layout_of_plan(plan_of(parameters), parameters, diagnostics);
	if (layout && layout->lots.empty()) {
		diagnostics.error("bad-layout", "layout: no block has room for a lot", "make lot_front smaller or the blocks larger");
		return std::nullopt;
	}
	if (!layout || !assign_types(*layout, parameters, diagnostics)) {
		return std::nullopt;
	}
	return layout;
}

uint32_t block_count(const LayoutParameters &parameters) {
	if (parameters.kind != LayoutKind::Radial) {
		return parameters.blocks_x * parameters.blocks_z;
	}
	const std::vector<uint32_t> counts = blocks_by_ring(parameters);
	return std::accumulate(counts.begin(), counts.end(), 0u);
}

LayoutParameters layout_for_lots(uint32_t count, LayoutParameters base) {
	const double per_block = double(base.lots_along) * base.lots_deep;
	if (base.kind == LayoutKind::Radial) {
		base.rings = 1;
		while (base.rings < 100 && block_count(base) * per_block < count) {
			++base.rings;
		}
		return base;
	}
	if (count <= 20) {
		base.blocks_x = base.blocks_z = count > 0 ? 1 : 0;
		base.lots_deep = count % 2 == 0 ? 2 : 1;
		base.lots_along = count > 0 ? count / base.lots_deep : 1;
		return base;
	}
	const glm::dvec2 block = block_size(base);
	double best = INFINITY;
	for (uint32_t x = 1; x <= 1000; ++x) {
		const double rows = std::fmin(1000.0, std::fmax(1.0, std::round(count / (per_block * x))));
		// A tenth too many lots weighs as much as a city that is e^2 = 7 times as wide as deep.
		const double miss = std::abs(rows * x * per_block - count) / count * 20.0;
		const double stretch = std::abs(std::log(x * block.x / (rows * block.y)));
		if (miss + stretch < best) {
			best = miss + stretch;
			base.blocks_x = x;
			base.blocks_z = uint32_t(rows);
		}
	}
	return base;
}

std::vector<std::vector<glm::vec3>> lots_within(const Layout &layout, LotId lot) {
	std::vector<std::vector<glm::vec3>> outlines;
	if (layout.lot(lot).holes.empty()) {
		return outlines;
	}
	for (const Lot &other : layout.lots) {
		if (other.around == lot) {
			outlines.push_back(other.polygon);
		}
	}
	return outlines;
}

std::vector<LotId> lots_around(const Layout &layout, LotId lot) {
	std::vector<LotId> result;
	for (LotId around = layout.lot(lot).around; is_valid(around) && result.size() < layout.lots.size(); around = layout.lot(around).around) {
		result.push_back(around);
	}
	return result;
}

std::string lot_name(const Layout &layout, LotId lot) {
	return "lot " + std::to_string(index_of(lot)) + " (" + layout.lot(lot).type + ")";
}

} // namespace pcg
