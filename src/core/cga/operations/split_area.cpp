#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/cga/measure.h"
#include "core/cga/operations/operations.h"
#include "core/cga/operations/split_parts.h"
#include "core/geometry/polygon.h"

// splitArea(axis) { area : body | .. }* (CGA reference, section 4.3).
namespace pcg::cga {

namespace {

// The area of all faces on the low side of planes across an axis.
class AreaBelow {
public:
	AreaBelow(const Geometry &geometry, int axis) : _geometry(geometry), _axis(axis) {
		for (uint32_t i = 0; i < geometry.face_count; ++i) {
			_normals.push_back(face_normal(geometry, geometry.faces[i]));
		}
	}

	double operator()(double at) const {
		double sum = 0.0;
		for (uint32_t f = 0; f < _geometry.face_count; ++f) {
			const GeometryFace &face = _geometry.faces[f];
			for (uint32_t i = 0; i < face.loop_count; ++i) { // holes run the other way round
				sum += 0.5 * glm::dot(_normals[f], vector_below(_geometry.loop(face.first_loop + i), at));
			}
		}
		return sum;
	}

	double total() const { return (*this)(_geometry.high[_axis] + 1.0); }

	// Where so much lies below.
	double place(double area) const {
		double low = _geometry.low[_axis], high = _geometry.high[_axis];
		for (int i = 0; i < 60; ++i) {
			const double middle = 0.5 * (low + high);
			((*this)(middle) < area ? low : high) = middle;
		}
		return 0.5 * (low + high);
	}

private:
	// As area_vector(), of the part of a loop with coordinates below `at`: what lies above is pressed flat onto the plane.
	glm::dvec3 vector_below(std::span<const glm::dvec3> loop, double at) const {
		_part.clear();
		for (size_t i = 0; i < loop.size(); ++i) {
			const glm::dvec3 a = loop[i], b = loop[(i + 1) % loop.size()];
			if (a[_axis] <= at) {
				_part.push_back(a);
			}
			if ((a[_axis] <= at) != (b[_axis] <= at)) {
				_part.push_back(glm::mix(a, b, (at - a[_axis]) / (b[_axis] - a[_axis])));
			}
		}
		return area_vector(_part);
	}

	const Geometry &_geometry;
	int _axis;
	std::vector<glm::dvec3> _normals;
	mutable std::vector<glm::dvec3> _part;
};

Flow split_area(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	context.mark_replaced();
	const int axis = int(args[0].word);
	const bool adjusts = args.count() < 2 || args[1].word == 0;
	const Geometry *geometry = baked(context.shape, context.arena);
	if (geometry == nullptr || args.block == nullptr) {
		return Flow::Next;
	}
	if (geometry->is_closed) {
		vm.warn("not-flat", "splitArea is for flat shapes; the area of a solid's surface is split", "use split()");
	}
	const AreaBelow area(*geometry, axis);
	const double total = area.total();
	const bool is_mirrored = context.shape.size[axis] < 0.0; // parts count from the scope's origin
	const ArenaScope scope(context.scratch);
	const SplitSizes sizes = split_sizes(context, *args.block);
	const SplitLayout layout = lay_out_split(sizes.groups, std::max(0.0, total), context.limits().max_repeats, context.scratch);
	const double width = std::abs(context.shape.size[axis]);
	const auto distance = [&](double part) {
		if (part <= 1e-9 * total || part >= total * (1.0 - 1e-9)) {
			return part <= 1e-9 * total ? 0.0 : width;
		}
		return is_mirrored ? -area.place(total - part) : area.place(part);
	};
	for (SplitPart &part : layout.parts) {
		part.from = distance(part.from);
		part.to = distance(part.to);
	}
	return run_split(context, sizes, layout, axis, adjusts);
}

} // namespace

void add_split_area_operations(Dialect &dialect) {
	using enum ParamKind;
	dialect.operations.push_back({ "splitArea", { { "axis", Word, "x y z" }, { "mode", Word, "adjust noAdjust", true } }, BlockKind::Sizes, split_area,
			"As split, for flat shapes; sizes are areas: 30 square metres, '0.5 of the area, ~1 share of what is left; { .. }* repeats." });
}

} // namespace pcg::cga
