#include "core/sim/heat_map.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "core/sim/walk_pool.h"

namespace pcg {

HeatGrid grid_over(const CityModel &city, float margin, float cell, uint32_t max_cells) {
	glm::vec2 low{ std::numeric_limits<float>::max() };
	glm::vec2 high{ std::numeric_limits<float>::lowest() };
	const auto take_in = [&](glm::vec3 point) {
		low = { std::min(low.x, point.x), std::min(low.y, point.z) };
		high = { std::max(high.x, point.x), std::max(high.y, point.z) };
	};
	for (const Entrance &entrance : city.entrances()) {
		take_in(entrance.position);
	}
	for (const CityObject &object : city.objects()) {
		take_in(object.position);
	}
	for (const Zone &zone : city.zones()) {
		std::for_each(zone.polygon.begin(), zone.polygon.end(), take_in);
	}
	if (low.x > high.x) {
		low = high = glm::vec2(0.0f);
	}
	HeatGrid grid;
	grid.origin = low - margin;
	const glm::vec2 size = high - low + 2.0f * margin;
	grid.cell = std::max(cell, std::max(size.x, size.y) / float(max_cells));
	grid.columns = std::max(1u, uint32_t(std::ceil(size.x / grid.cell)));
	grid.rows = std::max(1u, uint32_t(std::ceil(size.y / grid.cell)));
	return grid;
}

double HeatMap::total() const { return std::accumulate(_seconds.begin(), _seconds.end(), 0.0); }

void HeatMap::add(const HeatMap &other) {
	std::transform(_seconds.begin(), _seconds.end(), other._seconds.begin(), _seconds.begin(), std::plus<>());
}

void HeatMap::add(glm::vec3 position, double seconds) {
	const float column = std::floor((position.x - _grid.origin.x) / _grid.cell);
	const float row = std::floor((position.z - _grid.origin.y) / _grid.cell);
	if (column >= 0.0f && row >= 0.0f && column < float(_grid.columns) && row < float(_grid.rows)) {
		_seconds[size_t(row) * _grid.columns + size_t(column)] += seconds;
	}
}

void HeatMap::on_lived(const LivedSpan &span) {
	if (span.state == PersonState::Inside) {
		return;
	}
	const double seconds = (span.end - span.start).in_seconds();
	const double metres = span.last_metre - span.first_metre;
	if (span.state != PersonState::Walking || metres <= 0.0) {
		add(span.position, seconds);
		return;
	}
	const int samples = std::max(1, int(std::ceil(metres / (0.5 * double(_grid.cell)))));
	for (int i = 0; i < samples; ++i) {
		const double metre = span.first_metre + metres * (double(i) + 0.5) / double(samples);
		add(point_along(span.path, metre), seconds / double(samples));
	}
}

} // namespace pcg
