#include "core/sim/heat_map_image.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcg {

namespace {

using Color = std::array<float, 3>;

constexpr Color street{ 255, 255, 255 };
constexpr Color lot{ 205, 205, 208 };
constexpr Color walkable{ 246, 246, 244 };
// "inferno" of matplotlib (Smith and van der Walt, CC0), from its light end to its dark one.
constexpr std::array<Color, 8> ramp{ Color{ 252, 255, 164 }, Color{ 250, 193, 39 }, Color{ 245, 125, 21 },
	Color{ 212, 72, 66 }, Color{ 159, 42, 99 }, Color{ 101, 21, 110 }, Color{ 40, 11, 84 }, Color{ 0, 0, 4 } };
constexpr double single_cell = 4.0; // what a cell has of its own after smoothing, as a divisor
constexpr float fully_covered = 0.08f; // heat from which on the ground does not show through
constexpr float covered_overlay = 0.35f; // the same of overlays, below which there is a city to be seen

Color mix(Color a, Color b, float share) {
	return { a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share, a[2] + (b[2] - a[2]) * share };
}

Color ramp_color(float heat) {
	const float place = std::clamp(heat, 0.0f, 1.0f) * float(ramp.size() - 1);
	const size_t i = std::min(size_t(place), ramp.size() - 2);
	return mix(ramp[i], ramp[i + 1], place - float(i));
}

void set_pixel(RgbImage &image, size_t pixel, Color color) {
	for (size_t channel = 0; channel < 3; ++channel) {
		image.pixels[pixel * 3 + channel] = uint8_t(std::lround(color[channel]));
	}
}

// Even-odd scan conversion at pixel centres.
void fill_polygon(RgbImage &image, const HeatGrid &grid, const GroundPolygon &polygon, Color color) {
	const float pixel_size = grid.cell * float(grid.columns) / float(image.width);
	std::vector<float> crossings;
	for (uint32_t y = 0; y < image.height; ++y) {
		const float z = grid.origin.y + (float(y) + 0.5f) * pixel_size;
		crossings.clear();
		for (size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
			if ((polygon[i].z > z) != (polygon[j].z > z)) {
				const float share = (z - polygon[i].z) / (polygon[j].z - polygon[i].z);
				crossings.push_back(polygon[i].x + (polygon[j].x - polygon[i].x) * share);
			}
		}
		std::sort(crossings.begin(), crossings.end());
		for (size_t i = 0; i + 1 < crossings.size(); i += 2) {
			const float from = std::ceil((crossings[i] - grid.origin.x) / pixel_size - 0.5f);
			const float to = std::floor((crossings[i + 1] - grid.origin.x) / pixel_size - 0.5f);
			for (float x = std::max(from, 0.0f); x <= std::min(to, float(image.width - 1)); ++x) {
				set_pixel(image, size_t(y) * image.width + size_t(x), color);
			}
		}
	}
}

// One pass of (1 2 1) / 4 along both axes: takes the stairs off diagonal walks.
std::vector<double> smoothed(const std::vector<double> &cells, uint32_t columns, uint32_t rows) {
	std::vector<double> result = cells;
	const auto pass = [&](size_t stride, uint32_t count, uint32_t lines, size_t line_stride) {
		const std::vector<double> source = result;
		for (uint32_t line = 0; line < lines; ++line) {
			for (uint32_t i = 0; i < count; ++i) {
				const size_t here = line * line_stride + i * stride;
				const double before = source[i > 0 ? here - stride : here];
				const double after = source[i + 1 < count ? here + stride : here];
				result[here] = (before + 2.0 * source[here] + after) / 4.0;
			}
		}
	};
	pass(1, columns, rows, columns);
	pass(columns, rows, columns, 1);
	return result;
}

// What the hottest 3 % of the cells that were entered have at least.
double hot(std::vector<double> cells) {
	std::erase_if(cells, [](double seconds) { return seconds <= 0.0; });
	if (cells.empty()) {
		return 1.0;
	}
	const size_t rank = std::min(cells.size() - 1, size_t(double(cells.size()) * 0.97));
	std::nth_element(cells.begin(), cells.begin() + long(rank), cells.end());
	return cells[rank];
}

RgbImage draw_plan(const HeatGrid &grid, const GroundPlan &plan, uint32_t scale) {
	RgbImage image{ grid.columns * scale, grid.rows * scale, {} };
	image.pixels.resize(size_t(image.width) * image.height * 3);
	for (size_t pixel = 0; pixel < image.pixels.size() / 3; ++pixel) {
		set_pixel(image, pixel, street);
	}
	for (const GroundPolygon &polygon : plan.lots) {
		fill_polygon(image, grid, polygon, lot);
	}
	for (const GroundPolygon &polygon : plan.walkable) {
		fill_polygon(image, grid, polygon, walkable);
	}
	return image;
}

// Between the middles of the four cells around the point, which is in cells from the grid's corner.
double sample(const std::vector<double> &cells, const HeatGrid &grid, double x, double y) {
	x = std::clamp(x - 0.5, 0.0, double(grid.columns - 1));
	y = std::clamp(y - 0.5, 0.0, double(grid.rows - 1));
	const size_t left = size_t(x), top = size_t(y);
	const size_t right = std::min<size_t>(left + 1, grid.columns - 1), bottom = std::min<size_t>(top + 1, grid.rows - 1);
	const auto at = [&](size_t column, size_t row) { return cells[row * grid.columns + column]; };
	const double upper = std::lerp(at(left, top), at(right, top), x - double(left));
	const double lower = std::lerp(at(left, bottom), at(right, bottom), x - double(left));
	return std::lerp(upper, lower, y - double(top));
}

// Heat from 0 to 1 everywhere on the map.
class HeatField {
public:
	HeatField(const HeatMap &map, const HeatMapStyle &style) : _grid(map.grid()), _cells(map.person_seconds()) {
		const double limit = style.darkest > 0.0 ? single_cell * style.darkest : hot(_cells);
		for (double &seconds : _cells) {
			seconds = std::min(seconds, limit);
		}
		_cells = smoothed(_cells, _grid.columns, _grid.rows);
		_darkest = style.darkest > 0.0 ? style.darkest : hot(_cells);
	}
	// At the middle of a pixel of a picture with so many pixels a cell.
	float at(size_t pixel, uint32_t width, uint32_t scale) const {
		const double x = (double(pixel % width) + 0.5) / scale, y = (double(pixel / width) + 0.5) / scale;
		return float(std::sqrt(std::min(sample(_cells, _grid, x, y) / _darkest, 1.0)));
	}

private:
	const HeatGrid &_grid;
	std::vector<double> _cells;
	double _darkest = 1.0;
};

uint32_t scale_of(const HeatMapStyle &style) { return std::clamp(style.pixels_per_cell, 1u, 16u); }

} // namespace

RgbImage draw_heat_map(const HeatMap &map, const GroundPlan &plan, const HeatMapStyle &style) {
	const uint32_t scale = scale_of(style);
	RgbImage image = draw_plan(map.grid(), plan, scale);
	const HeatField field(map, style);
	for (size_t pixel = 0; pixel < image.pixels.size() / 3; ++pixel) {
		const float heat = field.at(pixel, image.width, scale);
		if (heat > 0.0f) {
			const uint8_t *old = &image.pixels[pixel * 3];
			const Color below{ float(old[0]), float(old[1]), float(old[2]) };
			set_pixel(image, pixel, mix(below, ramp_color(heat), std::min(heat / fully_covered, 1.0f)));
		}
	}
	return image;
}

RgbaImage draw_heat_overlay(const HeatMap &map, const HeatMapStyle &style) {
	const uint32_t scale = scale_of(style);
	RgbaImage image{ map.grid().columns * scale, map.grid().rows * scale, {} };
	image.pixels.reserve(size_t(image.width) * image.height * 4);
	const HeatField field(map, style);
	for (size_t pixel = 0; pixel < size_t(image.width) * image.height; ++pixel) {
		const float heat = field.at(pixel, image.width, scale);
		const Color color = ramp_color(heat);
		for (const float channel : { color[0], color[1], color[2], 255.0f * std::min(heat / covered_overlay, 1.0f) }) {
			image.pixels.push_back(uint8_t(std::lround(channel)));
		}
	}
	return image;
}

} // namespace pcg
