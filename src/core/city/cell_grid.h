#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

// A lot as a grid of cells along its front: which of them can be walked on. Lot coordinates: u along the front, v into the lot, metres.
namespace pcg {

class CellGrid {
public:
	struct Box { // cells, `end` excluded
		uint32_t column, row, column_end, row_end;
	};

	// `outline` in lot coordinates, counter-clockwise. Cells are at most `cell` large; columns and rows divide the lot's extent exactly.
	CellGrid(std::vector<glm::vec2> outline, float cell);
	// No cell has a size, and nothing below may be asked.
	bool is_flat() const { return !(_cell.x > 0.0f && _cell.y > 0.0f); }

	// Everything that a polygon's plan touches. A line or a point blocks the cells that it runs through.
	void block(const std::vector<glm::vec2> &plan);
	// Keeps only what is connected with cells along these edges of the outline.
	void keep_connected(const std::vector<bool> &is_entry_edge);
	// The cells that can be walked on as few boxes.
	std::vector<Box> boxes() const;
	// A box cut by the lot's outline, in lot coordinates; empty where they share no area.
	std::vector<glm::vec2> plan_of(Box box) const;

private:
	enum class Cell : uint8_t { Outside, Blocked, Free, Reached };

	Cell &at(uint32_t column, uint32_t row) { return _cells[size_t(row) * _columns + column]; }
	Cell at(uint32_t column, uint32_t row) const { return _cells[size_t(row) * _columns + column]; }
	uint32_t clamp_column(float u) const;
	uint32_t clamp_row(float v) const;
	void find_inside();
	bool is_convex_outline() const; // but for a millimetre
	void block_row(uint32_t row, const std::vector<glm::vec2> &plan);
	void spread(std::vector<uint32_t> &open);

	std::vector<glm::vec2> _outline;
	glm::vec2 _min{ 0.0f }, _cell{ 0.25f };
	uint32_t _columns = 1, _rows = 1;
	std::vector<Cell> _cells;
	std::vector<glm::vec2> _part, _spare; // kept for their memory: cutting is most of the work
};

// The part of a polygon with coordinate `axis` (0 or 1) above `limit`, or below it. Concave polygons may keep edges of zero width.
void cut(const std::vector<glm::vec2> &polygon, int axis, float limit, bool is_above, std::vector<glm::vec2> &kept);

} // namespace pcg
