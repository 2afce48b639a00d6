#include "core/sim/age_heat.h"

#include <algorithm>

namespace pcg {

namespace {

constexpr uint32_t most_cells_of_hours = 256; // along the longer side: 72 maps of large cities stay below 40 MB
constexpr uint32_t least_coarsening = 2;

uint32_t coarsening_of(const HeatGrid &grid) {
	const uint32_t longer = std::max(grid.columns, grid.rows);
	return std::max(least_coarsening, (longer + most_cells_of_hours - 1) / most_cells_of_hours);
}

// So many cells that coarser ones cover the same ground.
HeatGrid divisible(HeatGrid grid) {
	const uint32_t by = coarsening_of(grid);
	grid.columns = (grid.columns + by - 1) / by * by;
	grid.rows = (grid.rows + by - 1) / by * by;
	return grid;
}

HeatGrid coarser(const HeatGrid &grid) {
	const uint32_t by = coarsening_of(grid);
	return { grid.origin, grid.cell * float(by), grid.columns / by, grid.rows / by };
}

} // namespace

AgeHeat::AgeHeat(const CityModel &city, const Population &population) : _population(population) {
	const HeatGrid grid = divisible(grid_over(city));
	_days.assign(groups, HeatMap(grid));
	_hours.assign(hours * groups, HeatMap(coarser(grid)));
}

HeatMap AgeHeat::map(std::optional<size_t> group, std::optional<size_t> hour) const {
	if (group) {
		return one(*group, hour);
	}
	HeatMap sum = one(0, hour);
	for (size_t other = 1; other < groups; ++other) {
		sum.add(one(other, hour));
	}
	return sum;
}

void AgeHeat::on_lived(const LivedSpan &span) {
	if (span.state == PersonState::Inside) {
		return;
	}
	const size_t group = age_group(_population.person(span.person).age);
	_days[group].on_lived(span);
	const double length = (span.end - span.start).in_seconds(), metres = span.last_metre - span.first_metre;
	LivedSpan part = span;
	while (part.start < span.end) { // hour by hour; walks are even
		const size_t hour = size_t(part.start.time_of_day().ms / Duration::hours(1).ms);
		part.end = std::min(span.end, SimTime::at(part.start.day(), Duration::hours(int64_t(hour) + 1)));
		part.last_metre = part.end == span.end ? span.last_metre : span.first_metre + metres * (part.end - span.start).in_seconds() / length;
		_hours[hour * groups + group].on_lived(part);
		part.start = part.end;
		part.first_metre = part.last_metre;
	}
}

} // namespace pcg
