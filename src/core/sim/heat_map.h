#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "core/semantics/city_model.h"
#include "core/sim/observer.h"

namespace pcg {

// A grid over the ground, x to the east, z to the south; the first cell is the north-west one.
struct HeatGrid {
	glm::vec2 origin{ 0.0f }; // of the north-west corner: (x, z), metres
	float cell = 2.0f; // metres
	uint32_t columns = 0;
	uint32_t rows = 0;

	size_t cell_count() const { return size_t(columns) * rows; }
};

// Covers all entrances, zones and objects of the city with a margin, at most `max_cells` along its longer side.
HeatGrid grid_over(const CityModel &city, float margin = 20.0f, float cell = 2.0f, uint32_t max_cells = 1024);

// Person-seconds outdoors per cell (paper, figure "Heat-maps"), walking and standing.
class HeatMap : public SimulationObserver {
public:
	explicit HeatMap(HeatGrid grid) : _grid(grid), _seconds(grid.cell_count()) {}

	const HeatGrid &grid() const { return _grid; }
	const std::vector<double> &person_seconds() const { return _seconds; }
	double total() const;
	// One of the same grid.
	void add(const HeatMap &other);

	void on_lived(const LivedSpan &span) override;

private:
	void add(glm::vec3 position, double seconds);

	HeatGrid _grid;
	std::vector<double> _seconds;
};

} // namespace pcg
