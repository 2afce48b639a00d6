#include "core/city/cell_grid.h"

#include <algorithm>
#include <cmath>

namespace pcg {

namespace {

// What touches a cell by less than a millimetre leaves it free.
constexpr float touch = 1e-3f;
constexpr uint32_t max_cells_per_side = 2000;
constexpr double least_area = 1e-4; // doubled, square metres

double doubled_area(const std::vector<glm::vec2> &polygon) {
	double sum = 0.0;
	for (size_t i = 1; i + 1 < polygon.size(); ++i) {
		const glm::vec2 a = polygon[i] - polygon[0], b = polygon[i + 1] - polygon[0];
		sum += double(a.x) * b.y - double(a.y) * b.x;
	}
	return sum;
}

uint32_t cells_for(float extent, float cell) {
	const float count = std::ceil(extent / cell - touch);
	return count >= 1.0f ? uint32_t(std::fmin(count, float(max_cells_per_side))) : 1;
}

} // namespace

void cut(const std::vector<glm::vec2> &polygon, int axis, float limit, bool is_above, std::vector<glm::vec2> &kept) {
	kept.clear();
	const auto depth = [&](glm::vec2 p) { return is_above ? p[axis] - limit : limit - p[axis]; };
	for (size_t i = 0; i < polygon.size(); ++i) {
		const glm::vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
		const float da = depth(a), db = depth(b);
		if (da >= 0.0f) {
			kept.push_back(a);
		}
		if ((da > 0.0f && db < 0.0f) || (da < 0.0f && db > 0.0f)) {
			glm::vec2 crossing = a + (b - a) * (da / (da - db));
			crossing[axis] = limit;
			kept.push_back(crossing);
		}
	}
}

CellGrid::CellGrid(std::vector<glm::vec2> outline, float cell) : _outline(std::move(outline)) {
	glm::vec2 max = _outline[0];
	_min = _outline[0];
	for (const glm::vec2 &corner : _outline) {
		_min = { std::fmin(_min.x, corner.x), std::fmin(_min.y, corner.y) };
		max = { std::fmax(max.x, corner.x), std::fmax(max.y, corner.y) };
	}
	_columns = cells_for(max.x - _min.x, cell);
	_rows = cells_for(max.y - _min.y, cell);
	_cell = { (max.x - _min.x) / float(_columns), (max.y - _min.y) / float(_rows) };
	const double extent = double(max.x - _min.x) * (max.y - _min.y);
	const bool is_rectangle = std::abs(doubled_area(_outline) / 2.0 - extent) < 1e-4 * extent;
	_cells.assign(size_t(_columns) * _rows, is_rectangle ? Cell::Free : Cell::Outside);
	if (!is_rectangle) {
		find_inside();
	}
}

// Row by row: what is left of an outline with many corners between two lines has few.
void CellGrid::find_inside() {
	std::vector<glm::vec2> band, spare, part;
	for (uint32_t row = 0; row < _rows; ++row) {
		cut(_outline, 1, _min.y + _cell.y * float(row), true, spare);
		cut(spare, 1, _min.y + _cell.y * float(row + 1), false, band);
		for (uint32_t column = 0; column < _columns; ++column) {
			cut(band, 0, _min.x + _cell.x * float(column), true, spare);
			cut(spare, 0, _min.x + _cell.x * float(column + 1), false, part);
			if (doubled_area(part) > least_area) {
				at(column, row) = Cell::Free;
			}
		}
	}
}

uint32_t CellGrid::clamp_column(float u) const {
	const float column = std::floor((u - _min.x) / _cell.x);
	return column <= 0.0f ? 0 : uint32_t(std::fmin(column, float(_columns - 1)));
}

uint32_t CellGrid::clamp_row(float v) const {
	const float row = std::floor((v - _min.y) / _cell.y);
	return row <= 0.0f ? 0 : uint32_t(std::fmin(row, float(_rows - 1)));
}

void CellGrid::block(const std::vector<glm::vec2> &plan) {
	float low = INFINITY, high = -INFINITY;
	for (const glm::vec2 &corner : plan) {
		low = std::fmin(low, corner.y);
		high = std::fmax(high, corner.y);
	}
	if (!(low <= _min.y + _cell.y * float(_rows)) || !(high >= _min.y)) {
		return;
	}
	const uint32_t first = clamp_row(high - low > 2.0f * touch ? low + touch : (low + high) / 2.0f);
	const uint32_t last = clamp_row(high - low > 2.0f * touch ? high - touch : (low + high) / 2.0f);
	for (uint32_t row = first; row <= last; ++row) {
		block_row(row, plan);
	}
}

void CellGrid::block_row(uint32_t row, const std::vector<glm::vec2> &plan) {
	const float south = _min.y + _cell.y * float(row), north = south + _cell.y;
	// The last row also takes what runs exactly along the lot's edge.
	cut(plan, 1, row == 0 ? south - touch : south, true, _spare);
	cut(_spare, 1, row + 1 == _rows ? north + touch : north, false, _part);
	float low = INFINITY, high = -INFINITY;
	for (const glm::vec2 &corner : _part) {
		low = std::fmin(low, corner.x);
		high = std::fmax(high, corner.x);
	}
	if (!(low <= _min.x + _cell.x * float(_columns)) || !(high >= _min.x)) {
		return;
	}
	const bool is_wide = high - low > 2.0f * touch;
	const uint32_t first = clamp_column(is_wide ? low + touch : (low + high) / 2.0f);
	const uint32_t last = clamp_column(is_wide ? high - touch : (low + high) / 2.0f);
	for (uint32_t column = first; column <= last; ++column) {
		if (at(column, row) == Cell::Free) {
			at(column, row) = Cell::Blocked;
		}
	}
}

void CellGrid::keep_connected(const std::vector<bool> &is_entry_edge) {
	std::vector<uint32_t> open;
	for (size_t edge = 0; edge < _outline.size(); ++edge) {
		const glm::vec2 a = _outline[edge], b = _outline[(edge + 1) % _outline.size()];
		if (edge >= is_entry_edge.size() || !is_entry_edge[edge]) {
			continue;
		}
		// Half a cell inwards of the edge (left of its direction), so that rounding cannot put it into the next lot.
		const float length = std::hypot(b.x - a.x, b.y - a.y);
		const glm::vec2 inwards = glm::vec2(a.y - b.y, b.x - a.x) * (0.5f * std::fmin(_cell.x, _cell.y) / std::fmax(length, touch));
		const uint32_t steps = uint32_t(length / std::fmin(_cell.x, _cell.y)) * 2 + 1;
		for (uint32_t step = 0; step < steps; ++step) {
			const glm::vec2 point = a + (b - a) * ((float(step) + 0.5f) / float(steps)) + inwards;
			const uint32_t column = clamp_column(point.x), row = clamp_row(point.y);
			if (at(column, row) == Cell::Free) {
				at(column, row) = Cell::Reached;
				open.push_back(row * _columns + column);
			}
		}
	}
	spread(open);
	for (Cell &cell : _cells) {
		cell = cell == Cell::Reached ? Cell::Free : (cell == Cell::Free ? Cell::Blocked : cell);
	}
}

void CellGrid::spread(std::vector<uint32_t> &open) {
	const auto reach = [&](uint32_t column, uint32_t row) {
		if (column < _columns && row < _rows && at(column, row) == Cell::Free) {
			at(column, row) = Cell::Reached;
			open.push_back(row * _columns + column);
		}
	};
	while (!open.empty()) {
		const uint32_t column = open.back() % _columns, row = open.back() / _columns;
		open.pop_back();
		reach(column + 1, row);
		reach(column - 1, row); // wraps to a column beyond the last
		reach(column, row + 1);
		reach(column, row - 1);
	}
}

bool CellGrid::is_convex_outline() const {
	const size_t count = _outline.size();
	for (size_t i = 0; i < count; ++i) {
		const glm::vec2 in = _outline[(i + 1) % count] - _outline[i], out = _outline[(i + 2) % count] - _outline[(i + 1) % count];
		if (in.x * out.y - in.y * out.x < -touch * (std::hypot(in.x, in.y) + std::hypot(out.x, out.y))) {
			return false;
		}
	}
	return true;
}

std::vector<CellGrid::Box> CellGrid::boxes() const {
	std::vector<Box> boxes;
	std::vector<bool> is_taken(_cells.size(), false);
	// A box may reach over the outline, which cuts it, so that slanted edges do not end in steps. A concave one could cut it to pieces.
	const bool may_reach_out = is_convex_outline();
	const auto is_open = [&](uint32_t column, uint32_t row) {
		const Cell cell = at(column, row);
		return (cell == Cell::Free && !is_taken[size_t(row) * _columns + column]) || (may_reach_out && cell == Cell::Outside);
	};
	for (uint32_t row = 0; row < _rows; ++row) {
		for (uint32_t column = 0; column < _columns; ++column) {
			if (at(column, row) != Cell::Free || is_taken[size_t(row) * _columns + column]) {
				continue;
			}
			Box box{ column, row, column + 1, row + 1 };
			while (box.column_end < _columns && is_open(box.column_end, row)) {
				++box.column_end;
			}
			const auto is_row_open = [&](uint32_t candidate) {
				uint32_t c = column;
				while (c < box.column_end && is_open(c, candidate)) {
					++c;
				}
				return c == box.column_end;
			};
			while (box.row_end < _rows && is_row_open(box.row_end)) {
				++box.row_end;
			}
			for (uint32_t r = box.row; r < box.row_end; ++r) {
				std::fill_n(is_taken.begin() + size_t(r) * _columns + column, box.column_end - column, true);
			}
			boxes.push_back(box);
		}
	}
	return boxes;
}

std::vector<glm::vec2> CellGrid::plan_of(Box box) const {
	std::vector<glm::vec2> plan, spare;
	cut(_outline, 0, _min.x + _cell.x * float(box.column), true, spare);
	cut(spare, 0, _min.x + _cell.x * float(box.column_end), false, plan);
	cut(plan, 1, _min.y + _cell.y * float(box.row), true, spare);
	cut(spare, 1, _min.y + _cell.y * float(box.row_end), false, plan);
	return doubled_area(plan) > least_area ? plan : std::vector<glm::vec2>();
}

} // namespace pcg
