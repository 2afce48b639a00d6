#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <glm/vec2.hpp>

#include "core/population/population.h"
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
	using Filter = std::function<bool(PersonId)>;

	// Counts those that the filter takes; all without one.
	explicit HeatMap(HeatGrid grid, Filter filter = {}) : _grid(grid), _filter(std::move(filter)), _seconds(grid.cell_count()) {}

	const HeatGrid &grid() const { return _grid; }
	const std::vector<double> &person_seconds() const { return _seconds; }
	double total() const;

	void on_lived(const LivedSpan &span) override;

private:
	void add(glm::vec3 position, double seconds);

	HeatGrid _grid;
	Filter _filter;
	std::vector<double> _seconds;
};

} // namespace pcg
