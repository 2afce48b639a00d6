#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/population/age_group.h"
#include "core/population/population.h"
#include "core/sim/heat_map.h"

namespace pcg {

// Heat maps of each age group, of all time and, with coarser cells on the same ground, of each hour of the day.
class AgeHeat : public SimulationObserver {
public:
	// Both outlive it.
	AgeHeat(const CityModel &city, const Population &population);

	// Of the grid of all time; those of hours cover the same.
	const HeatGrid &grid() const { return _days.front().grid(); }
	// What one group, or everybody, spent in one hour of the day (0 to 23), or ever.
	HeatMap map(std::optional<size_t> group, std::optional<size_t> hour) const;

	void on_lived(const LivedSpan &span) override;

private:
	static constexpr size_t groups = age_group_names.size();
	static constexpr size_t hours = 24;
	const HeatMap &one(size_t group, std::optional<size_t> hour) const { return hour ? _hours[*hour * groups + group] : _days[group]; }

	const Population &_population;
	std::vector<HeatMap> _days; // by group
	std::vector<HeatMap> _hours; // by hour, then group
};

} // namespace pcg
