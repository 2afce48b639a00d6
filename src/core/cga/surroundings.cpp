#include "core/cga/surroundings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/base/small_vector.h"
#include "core/cga/measure.h"

namespace pcg::cga {

namespace {

constexpr double same_value = 1e-6; // metres or square metres that rank as equal

// The shape that asks, in world coordinates: its faces, or its points if it has no face.
class Asking {
public:
	Asking(const Shape &shape, glm::dvec3 origin) : _shape(shape), _origin(origin) {
		Frame frame = shape.frame();
		frame.origin += origin;
		for (uint32_t i = 0; shape.geometry != nullptr && i < shape.geometry->point_count; ++i) {
			_points.push_back(frame.to_parent(shape.to_scope(shape.geometry->points[i])));
		}
		if (_points.empty()) {
			_points.push_back(frame.origin);
		}
		_is_rectangle = shape.geometry != nullptr && shape.geometry->is_block && shape.geometry->face_count == 1;
	}

	Bounds3 bounds() const {
		glm::dvec3 low = _points[0], high = _points[0]; // in registers
		for (const glm::dvec3 &point : _points) {
			low = glm::min(low, point);
			high = glm::max(high, point);
		}
		return { low, high };
	}
	bool meets(OcclusionKind kind, const Occluder &occluder) {
		const ConvexBody::Relation quick = occluder.body.relation_to(_points, _is_rectangle);
		if (quick == ConvexBody::Relation::Apart) {
			return false;
		}
		if (quick == ConvexBody::Relation::Contact && kind != OcclusionKind::Inside) {
			return kind == OcclusionKind::Touches;
		}
		if (!_solid) {
			_solid = _shape.geometry != nullptr ? world_solid(_shape, _origin) : Solid();
		}
		const SolidRelation relation = _solid->triangles.empty() ? relate_points(_points, occluder.solid) : relate(*_solid, occluder.solid);
		return kind == OcclusionKind::Inside ? relation.is_inside : kind == OcclusionKind::Overlaps ? relation.overlaps : relation.touches;
	}

private:
	const Shape &_shape;
	glm::dvec3 _origin;
	SmallVector<glm::dvec3, 24> _points;
	bool _is_rectangle = false;
	std::optional<Solid> _solid; // made when it is needed
};

// The point of a scope's box that lies nearest to another.
glm::dvec3 nearest(const Frame &frame, glm::dvec3 size, glm::dvec3 point) {
	const glm::dvec3 zero(0.0);
	return frame.to_parent(glm::clamp(frame.to_local(point), glm::min(zero, size), glm::max(zero, size)));
}

// Between two boxes that lie anyhow: from one to the other and back until nothing gets nearer, which for convex bodies is the shortest way
// (Cheney and Goldstein 1959). To a tenth of a millimetre.
double box_distance(const Frame &a, glm::dvec3 a_size, const Frame &b, glm::dvec3 b_size) {
	glm::dvec3 in_a = a.to_parent(0.5 * a_size);
	double distance = INFINITY;
	for (int i = 0; i < 200; ++i) {
		const glm::dvec3 in_b = nearest(b, b_size, in_a);
		in_a = nearest(a, a_size, in_b);
		const double now = glm::distance(in_a, in_b);
		if (distance - now < 1e-7) {
			return now < 1e-5 ? 0.0 : now;
		}
		distance = now;
	}
	return distance;
}

// Less is better.
double key(Comparison comparison, glm::dvec3 low, glm::dvec3 high, double area) {
	switch (comparison) {
		case Comparison::Northernmost:
			return low.z;
		case Comparison::Southernmost:
			return -high.z;
		case Comparison::Easternmost:
			return -high.x;
		case Comparison::Westernmost:
			return low.x;
		case Comparison::Highest:
			return -high.y;
		case Comparison::Lowest:
			return low.y;
		case Comparison::Largest:
			return -area;
		default:
			return area;
	}
}

} // namespace

void Surroundings::begin(const Neighbors &neighbors, double occlusion_distance) {
	_neighbors = neighbors;
	_distance = occlusion_distance;
	_recording.reset();
	_known.reset();
	_near.clear();
	_has_near = false;
}

void Surroundings::start_recording() {
	_recording = std::make_shared<Occluders>();
}

void Surroundings::set_place(Bounds3 bounds, glm::dvec3 origin) {
	_bounds = bounds;
	_origin = origin;
	if (_recording) {
		_recording->set_bounds(bounds.low, bounds.high);
	}
}

std::shared_ptr<const Occluders> Surroundings::finish_recording(bool is_asked) {
	_recording->finish();
	std::shared_ptr<const Occluders> result = std::move(_recording);
	_recording.reset();
	if (is_asked) {
		_known = result;
	}
	return result;
}

// A pass that asks a record finds its places there, and what it records itself is for neighbours, which do not care for places.
TreePlace Surroundings::child(TreePlace parent, uint64_t child_index) {
	if (_known) {
		return _known->tree.child(parent, uint32_t(std::min<uint64_t>(child_index, UINT32_MAX)));
	}
	return { _recording->tree.add(parent.node), false };
}

void Surroundings::record(const Shape &shape, uint64_t label) {
	const bool is_solid = shape.geometry != nullptr && shape.geometry->is_closed;
	if (_recording && (is_solid || label != 0)) {
		_recording->add(shape, _origin, label);
	}
}

const std::vector<const Occluders *> &Surroundings::near() {
	if (_has_near) {
		return _near;
	}
	_has_near = true;
	for (size_t i = 0; i < _neighbors.all.size(); ++i) {
		const Occluders *other = _neighbors.all[i].get();
		if (other == nullptr || i == _neighbors.self) {
			continue;
		}
		const glm::dvec3 gap = glm::max(glm::max(other->low() - _bounds.high, _bounds.low - other->high()), glm::dvec3(0.0));
		if (std::hypot(gap.x, gap.z) <= _distance + same_value) { // however far apart in height
			_near.push_back(other);
		}
	}
	return _near;
}

bool Surroundings::occlusion(OcclusionKind kind, QueryTarget target, uint64_t label, const Shape &shape) {
	const bool asks_own = target != QueryTarget::Inter && _known != nullptr;
	const bool asks_others = target != QueryTarget::Intra && !near().empty();
	if (!asks_own && !asks_others) {
		return false;
	}
	Asking asking(shape, _origin);
	const glm::dvec3 margin(solid_tolerance);
	const Bounds3 bounds = asking.bounds();
	const glm::dvec3 low = bounds.low - margin, high = bounds.high + margin;
	const auto is_wanted = [&](const Occluder &occluder) { return label == 0 || occluder.label == label; };
	if (asks_own && _known->any_solid(low, high, [&](const Occluder &occluder) {
			return is_wanted(occluder) && !_known->tree.is_related(shape.tree, occluder.node) && asking.meets(kind, occluder);
		})) {
		return true;
	}
	return asks_others && std::ranges::any_of(near(), [&](const Occluders *other) {
		return other->any_solid(low, high, [&](const Occluder &occluder) { return is_wanted(occluder) && asking.meets(kind, occluder); });
	});
}

template <typename Visit> void Surroundings::for_each_labeled(QueryTarget target, uint64_t label, Visit visit) {
	const auto visit_all = [&](const Occluders &occluders) {
		for (const Occluder &occluder : occluders.list()) {
			if (occluder.label == label && label != 0) {
				visit(occluder);
			}
		}
	};
	if (target != QueryTarget::Inter && _known) {
		visit_all(*_known);
	}
	for (size_t i = 0; target != QueryTarget::Intra && i < _neighbors.all.size(); ++i) {
		if (_neighbors.all[i] && i != _neighbors.self) {
			visit_all(*_neighbors.all[i]);
		}
	}
}

double Surroundings::minimum_distance(QueryTarget target, uint64_t label, const Shape &shape) {
	Frame frame = shape.frame();
	frame.origin += _origin;
	double least = INFINITY;
	for_each_labeled(target, label, [&](const Occluder &occluder) {
		least = std::min(least, box_distance(frame, shape.size, occluder.frame, occluder.size));
	});
	return least;
}

double Surroundings::count(QueryTarget target, uint64_t label) {
	double sum = 0.0;
	for_each_labeled(target, label, [&](const Occluder &) { sum += 1.0; });
	return sum;
}

double Surroundings::rank(QueryTarget target, uint64_t label, Comparison comparison, const Shape &shape) {
	const Bounds3 bounds = world_bounds(shape, _origin);
	const double own = key(comparison, bounds.low, bounds.high, surface_area(shape));
	double better = 0.0;
	for_each_labeled(target, label, [&](const Occluder &occluder) {
		better += key(comparison, occluder.low, occluder.high, occluder.area) < own - same_value ? 1.0 : 0.0;
	});
	return better;
}

} // namespace pcg::cga
