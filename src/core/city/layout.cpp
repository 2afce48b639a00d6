#include "core/city/layout.h"

#include <cmath>

#include "core/base/random.h"

namespace pcg {

namespace {

// Zebra crossings at both ends of a stretch of street; narrower where a short block leaves less.
constexpr float crossing_width = 3.0f;
constexpr size_t max_lots = 2'000'000;

struct Rectangle {
	float x0, z0, x1, z1;
};

// Starts at the south-west corner.
std::vector<glm::vec3> outline(Rectangle r) {
	return { { r.x0, 0.0f, r.z1 }, { r.x1, 0.0f, r.z1 }, { r.x1, 0.0f, r.z0 }, { r.x0, 0.0f, r.z0 } };
}

template <typename T>
bool check_limit(std::string_view name, T value, T low, T high, Diagnostics &diagnostics) {
	if (value >= low && value <= high) { // false for NaN
		return true;
	}
	diagnostics.error("bad-layout", "layout: " + std::string(name) + " is " + std::to_string(value) + ", but must be from " +
					std::to_string(low) + " to " + std::to_string(high), "change this parameter of the layout");
	return false;
}

bool check(const LayoutParameters &p, Diagnostics &diagnostics) {
	bool is_good = check_limit<uint32_t>("the number of blocks in x", p.blocks_x, 1, 1000, diagnostics);
	is_good &= check_limit<uint32_t>("the number of blocks in z", p.blocks_z, 1, 1000, diagnostics);
	is_good &= check_limit<uint32_t>("the number of lots along a block", p.lots_along, 1, 100, diagnostics);
	is_good &= check_limit<uint32_t>("the depth of a block in lots", p.lots_deep, 1, 2, diagnostics);
	is_good &= check_limit("the front of a lot", p.lot_front, 5.0f, 500.0f, diagnostics);
	is_good &= check_limit("the aspect of a lot", p.lot_aspect, 0.25f, 4.0f, diagnostics);
	is_good &= check_limit("the width of streets", p.street_width, 2.0f, 100.0f, diagnostics);
	is_good &= check_limit("the width of pavements", p.pavement_width, 0.5f, 50.0f, diagnostics);
	if (is_good && size_t(p.blocks_x) * p.blocks_z * p.lots_along * p.lots_deep > max_lots) {
		diagnostics.error("bad-layout", "layout: this would be more than " + std::to_string(max_lots) + " lots", "use fewer blocks");
		return false;
	}
	return is_good;
}

// The grid of streets: where blocks begin and end.
class Grid {
public:
	explicit Grid(const LayoutParameters &p) :
			_p(p), _width(float(p.lots_along) * p.lot_front + 2.0f * p.pavement_width),
			_depth(float(p.lots_deep) * p.lot_front * p.lot_aspect + 2.0f * p.pavement_width),
			_corner_x(-((_width + p.street_width) * float(p.blocks_x) + p.street_width) / 2.0f),
			_corner_z(-((_depth + p.street_width) * float(p.blocks_z) + p.street_width) / 2.0f) {}

	// With pavements. Also gives where streets run: street i lies west of block i, as does the last one of block `blocks_x`.
	float west(uint32_t i) const { return _corner_x + _p.street_width + (_width + _p.street_width) * float(i); }
	float east(uint32_t i) const { return west(i + 1) - _p.street_width; }
	float north(uint32_t j) const { return _corner_z + _p.street_width + (_depth + _p.street_width) * float(j); }
	float south(uint32_t j) const { return north(j + 1) - _p.street_width; }
	float west_of_street(uint32_t i) const { return west(i) - _p.street_width; }
	float north_of_street(uint32_t j) const { return north(j) - _p.street_width; }
	Rectangle block(uint32_t i, uint32_t j) const { return { west(i), north(j), east(i), south(j) }; }
	Rectangle city() const { return { _corner_x, _corner_z, east(_p.blocks_x), south(_p.blocks_z) }; }
	Rectangle cell(uint32_t i, uint32_t j) const {
		const float half = _p.street_width / 2.0f;
		return { i == 0 ? west_of_street(0) : west(i) - half, j == 0 ? north_of_street(0) : north(j) - half,
			i + 1 == _p.blocks_x ? west(i + 1) : east(i) + half, j + 1 == _p.blocks_z ? north(j + 1) : south(j) + half };
	}

private:
	const LayoutParameters &_p;
	float _width, _depth; // of a block with its pavements
	float _corner_x, _corner_z;
};

void add_ground(Layout &layout, GroundKind kind, Rectangle r, BlockId block = BlockId::Invalid) {
	if (is_valid(block)) {
		layout.blocks[index_of(block)].pavements.push_back(uint32_t(layout.ground.size()));
	}
	layout.ground.push_back({ kind, outline(r), block });
}

// A stretch between two crossings of streets, with a zebra at each end. `is_along_x`: the street runs from west to east.
void add_stretch(Layout &layout, Rectangle r, bool is_along_x) {
	const float length = is_along_x ? r.x1 - r.x0 : r.z1 - r.z0;
	const float zebra = std::fmin(crossing_width, length / 4.0f);
	if (is_along_x) {
		add_ground(layout, GroundKind::Crossing, { r.x0, r.z0, r.x0 + zebra, r.z1 });
		add_ground(layout, GroundKind::Street, { r.x0 + zebra, r.z0, r.x1 - zebra, r.z1 });
		add_ground(layout, GroundKind::Crossing, { r.x1 - zebra, r.z0, r.x1, r.z1 });
	} else {
		add_ground(layout, GroundKind::Crossing, { r.x0, r.z0, r.x1, r.z0 + zebra });
		add_ground(layout, GroundKind::Street, { r.x0, r.z0 + zebra, r.x1, r.z1 - zebra });
		add_ground(layout, GroundKind::Crossing, { r.x0, r.z1 - zebra, r.x1, r.z1 });
	}
}

void add_streets(Layout &layout, const LayoutParameters &p, const Grid &grid) {
	for (uint32_t j = 0; j <= p.blocks_z; ++j) {
		for (uint32_t i = 0; i <= p.blocks_x; ++i) {
			const float x0 = grid.west_of_street(i), x1 = grid.west(i), z0 = grid.north_of_street(j), z1 = grid.north(j);
			add_ground(layout, GroundKind::Street, { x0, z0, x1, z1 });
			if (i < p.blocks_x) {
				add_stretch(layout, { x1, z0, grid.east(i), z1 }, true);
			}
			if (j < p.blocks_z) {
				add_stretch(layout, { x0, z1, x1, grid.south(j) }, false);
			}
		}
	}
}

void add_pavements(Layout &layout, Rectangle r, float width, BlockId block) {
	add_ground(layout, GroundKind::Pavement, { r.x0, r.z0, r.x1, r.z0 + width }, block);
	add_ground(layout, GroundKind::Pavement, { r.x0, r.z1 - width, r.x1, r.z1 }, block);
	add_ground(layout, GroundKind::Pavement, { r.x0, r.z0 + width, r.x0 + width, r.z1 - width }, block);
	add_ground(layout, GroundKind::Pavement, { r.x1 - width, r.z0 + width, r.x1, r.z1 - width }, block);
}

// `row` 0 is the southern one, whose lots face south; the other faces north.
Lot make_lot(const LayoutParameters &p, Rectangle inner, uint32_t column, uint32_t row) {
	const float width = (inner.x1 - inner.x0) / float(p.lots_along), depth = (inner.z1 - inner.z0) / float(p.lots_deep);
	const bool is_last = column + 1 == p.lots_along;
	const float x0 = inner.x0 + width * float(column), x1 = is_last ? inner.x1 : inner.x0 + width * float(column + 1);
	const float middle = inner.z1 - depth;
	const bool is_single = p.lots_deep == 1;
	const auto street = [&](bool is_street) { return is_street ? p.street_width : 0.0f; };
	Lot lot;
	if (row == 0) {
		lot.polygon = outline({ x0, is_single ? inner.z0 : middle, x1, inner.z1 });
		lot.street_widths = { street(true), street(is_last), street(is_single), street(column == 0) };
	} else {
		lot.polygon = outline({ x0, inner.z0, x1, middle });
		std::swap(lot.polygon[0], lot.polygon[2]);
		std::swap(lot.polygon[1], lot.polygon[3]);
		lot.street_widths = { street(true), street(column == 0), street(false), street(is_last) };
	}
	return lot;
}

void add_block(Layout &layout, const LayoutParameters &p, const Grid &grid, uint32_t i, uint32_t j) {
	const BlockId id = BlockId(layout.blocks.size());
	const Rectangle r = grid.block(i, j), cell = grid.cell(i, j);
	const float pavement = p.pavement_width;
	const Rectangle inner{ r.x0 + pavement, r.z0 + pavement, r.x1 - pavement, r.z1 - pavement };
	CityBlock block;
	block.min = { r.x0, 0.0f, r.z0 };
	block.max = { r.x1, 0.0f, r.z1 };
	block.cell_min = { cell.x0, 0.0f, cell.z0 };
	block.cell_max = { cell.x1, 0.0f, cell.z1 };
	for (uint32_t row = 0; row < p.lots_deep; ++row) {
		for (uint32_t column = 0; column < p.lots_along; ++column) {
			block.lots.push_back(LotId(layout.lots.size()));
			layout.lots.push_back(make_lot(p, inner, column, row));
			layout.lots.back().block = id;
			layout.lots.back().seed = derive_seed(p.seed, layout.lots.size() - 1);
		}
	}
	layout.blocks.push_back(std::move(block));
	add_pavements(layout, r, pavement, id);
}

bool assign_types(Layout &layout, const LayoutParameters &p, Diagnostics &diagnostics) {
	std::vector<glm::vec2> positions;
	for (const Lot &lot : layout.lots) {
		const glm::vec3 middle = (lot.polygon[0] + lot.polygon[2]) / 2.0f;
		const glm::vec3 fraction = (middle - layout.min) / (layout.max - layout.min + glm::vec3(0.0f, 1.0f, 0.0f));
		positions.push_back({ fraction.x, fraction.z });
	}
	const std::vector<std::string> types = assign_land_use(positions, p.land_use, p.districts, p.seed, diagnostics);
	for (size_t i = 0; i < types.size(); ++i) {
		layout.lots[i].type = types[i];
	}
	return !types.empty();
}

} // namespace

std::optional<Layout> make_layout(const LayoutParameters &parameters, Diagnostics &diagnostics) {
	if (!check(parameters, diagnostics)) {
		return std::nullopt;
	}
	const Grid grid(parameters);
	const Rectangle city = grid.city();
	Layout layout;
	layout.seed = parameters.seed;
	layout.min = { city.x0, 0.0f, city.z0 };
	layout.max = { grid.west(parameters.blocks_x), 0.0f, grid.north(parameters.blocks_z) };
	add_streets(layout, parameters, grid);
	for (uint32_t j = 0; j < parameters.blocks_z; ++j) {
		for (uint32_t i = 0; i < parameters.blocks_x; ++i) {
			add_block(layout, parameters, grid, i, j);
		}
	}
	if (!assign_types(layout, parameters, diagnostics)) {
		return std::nullopt;
	}
	return layout;
}

LayoutParameters layout_for_lots(uint32_t count, LayoutParameters base) {
	if (count <= 20) {
		base.blocks_x = base.blocks_z = count > 0 ? 1 : 0;
		base.lots_deep = count % 2 == 0 ? 2 : 1;
		base.lots_along = count > 0 ? count / base.lots_deep : 1;
		return base;
	}
	const double per_block = double(base.lots_along) * base.lots_deep;
	const double width = double(base.lots_along) * base.lot_front + 2.0 * base.pavement_width + base.street_width;
	const double depth = double(base.lots_deep) * base.lot_front * base.lot_aspect + 2.0 * base.pavement_width + base.street_width;
	double best = INFINITY;
	for (uint32_t x = 1; x <= 1000; ++x) {
		const double rows = std::fmin(1000.0, std::fmax(1.0, std::round(count / (per_block * x))));
		// A tenth too many lots weighs as much as a city that is e^2 = 7 times as wide as deep.
		const double miss = std::abs(rows * x * per_block - count) / count * 20.0;
		const double stretch = std::abs(std::log(x * width / (rows * depth)));
		if (miss + stretch < best) {
			best = miss + stretch;
			base.blocks_x = x;
			base.blocks_z = uint32_t(rows);
		}
	}
	return base;
}

std::string lot_name(const Layout &layout, LotId lot) {
	return "lot " + std::to_string(index_of(lot)) + " (" + layout.lot(lot).type + ")";
}

} // namespace pcg
