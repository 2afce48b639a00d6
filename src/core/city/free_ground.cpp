#include "core/city/free_ground.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "core/cga/instances.h"
#include "core/city/cell_grid.h"

namespace pcg {

namespace {

// Between the world and coordinates along the lot's front.
class LotFrame {
public:
	explicit LotFrame(const Lot &lot) : _origin(lot.polygon[0]) {
		const glm::vec3 along = lot.polygon[1] - lot.polygon[0];
		const float length = std::hypot(along.x, along.z);
		_along = length > 0.0f ? glm::vec3(along.x, 0.0f, along.z) / length : glm::vec3(1.0f, 0.0f, 0.0f);
		_inwards = { _along.z, 0.0f, -_along.x }; // left of the front's direction, seen from above
	}
	glm::vec2 to_lot(glm::vec3 point) const { return { glm::dot(point - _origin, _along), glm::dot(point - _origin, _inwards) }; }
	glm::vec3 to_world(glm::vec2 point) const { return _origin + _along * point.x + _inwards * point.y; }
	float height(glm::vec3 point) const { return point.y - _origin.y; }

private:
	glm::vec3 _origin, _along, _inwards;
};

// The part of a face between two heights, as corners of its plan.
class BandCutter {
public:
	BandCutter(const LotFrame &frame, float low, float high) : _frame(frame), _low(low), _high(high) {}

	const std::vector<glm::vec2> &cut(std::span<const glm::vec3> outline) {
		_corners.assign(outline.begin(), outline.end());
		clip(_low, 1.0f);
		clip(_high, -1.0f);
		_plan.clear();
		for (const glm::vec3 &corner : _corners) {
			_plan.push_back(_frame.to_lot(corner));
		}
		return _plan;
	}

private:
	void clip(float limit, float sign) {
		_kept.clear();
		for (size_t i = 0; i < _corners.size(); ++i) {
			const glm::vec3 a = _corners[i], b = _corners[(i + 1) % _corners.size()];
			const float da = (_frame.height(a) - limit) * sign, db = (_frame.height(b) - limit) * sign;
			if (da > 0.0f) {
				_kept.push_back(a);
			}
			if ((da > 0.0f) != (db > 0.0f)) {
				_kept.push_back(a + (b - a) * (da / (da - db)));
			}
		}
		std::swap(_corners, _kept);
	}

	const LotFrame &_frame;
	float _low, _high;
	std::vector<glm::vec3> _corners, _kept;
	std::vector<glm::vec2> _plan;
};

// Lowest and highest y of a box that holds the instance; most windows of a city are above all heads.
std::pair<double, double> heights_of(const cga::ModelInstance &instance, const std::pair<glm::dvec3, glm::dvec3> &bounds) {
	std::pair<double, double> heights(instance.origin.y, instance.origin.y);
	for (int axis = 0; axis < 3; ++axis) {
		const double a = instance.axes[axis].y * bounds.first[axis], b = instance.axes[axis].y * bounds.second[axis];
		heights.first += std::min(a, b);
		heights.second += std::max(a, b);
	}
	return heights;
}

std::pair<glm::dvec3, glm::dvec3> bounds_of(const Mesh &mesh) {
	std::pair<glm::dvec3, glm::dvec3> bounds(glm::dvec3(INFINITY), glm::dvec3(-INFINITY));
	for (const glm::vec3 &point : mesh.positions) {
		bounds = { glm::min(bounds.first, glm::dvec3(point)), glm::max(bounds.second, glm::dvec3(point)) };
	}
	return bounds;
}

void block_instance(const cga::ModelInstance &instance, const Mesh &mesh, BandCutter &band, CellGrid &grid) {
	std::vector<glm::vec3> outline;
	for (const MeshFace &face : mesh.faces) {
		outline.clear();
		for (const glm::vec3 &point : mesh.loop(face.first_loop)) {
			outline.push_back(cga::placed(instance, point));
		}
		grid.block(band.cut(outline));
	}
}

void block_instances(const cga::DerivationResult &model, double low, double high, BandCutter &band, CellGrid &grid) {
	constexpr double margin = 0.01; // rounding
	std::vector<std::pair<glm::dvec3, glm::dvec3>> bounds;
	for (const cga::ModelPrototype &prototype : model.prototypes) {
		bounds.push_back(bounds_of(*prototype.mesh));
	}
	for (const cga::ModelInstance &instance : model.instances) {
		const auto [bottom, top] = heights_of(instance, bounds[instance.prototype]);
		if (instance.object < 0 && top > low - margin && bottom < high + margin) {
			block_instance(instance, *model.prototypes[instance.prototype].mesh, band, grid);
		}
	}
}

} // namespace

std::vector<std::vector<glm::vec3>> free_ground(const Lot &lot, const cga::DerivationResult &model, const FreeGroundOptions &options) {
	if (lot.polygon.size() < 3) {
		return {};
	}
	const LotFrame frame(lot);
	std::vector<glm::vec2> outline;
	for (const glm::vec3 &corner : lot.polygon) {
		outline.push_back(frame.to_lot(corner));
	}
	CellGrid grid(outline, options.cell);
	if (grid.is_flat()) {
		return {};
	}
	BandCutter band(frame, options.step_height, options.head_height);
	for (const MeshFace &face : model.mesh.faces) {
		grid.block(band.cut(model.mesh.loop(face.first_loop)));
	}
	const double ground = double(lot.polygon[0].y);
	block_instances(model, ground + double(options.step_height), ground + double(options.head_height), band, grid);
	std::vector<bool> is_entry_edge;
	for (float width : lot.street_widths) {
		is_entry_edge.push_back(width > 0.0f);
	}
	grid.keep_connected(is_entry_edge);
	std::vector<std::vector<glm::vec3>> pieces;
	for (const CellGrid::Box &box : grid.boxes()) {
		const std::vector<glm::vec2> plan = grid.plan_of(box);
		std::vector<glm::vec3> piece;
		for (const glm::vec2 &corner : plan) {
			piece.push_back(frame.to_world(corner));
		}
		if (!piece.empty()) {
			pieces.push_back(std::move(piece));
		}
	}
	return pieces;
}

} // namespace pcg
