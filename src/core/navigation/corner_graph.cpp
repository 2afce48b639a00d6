#include "core/navigation/corner_graph.h"

#include <cmath>
#include <utility>

#include "core/base/hash_index.h"
#include "core/base/parallel.h"
#include "core/navigation/landmarks.h"
#include "core/navigation/nav_mesh.h"

namespace pcg {

namespace {

// A walk by way of a third corner stands for the straight one if it costs at most so much more.
constexpr float detour = 1.0001f;
constexpr size_t batch = 256; // corners that a thread looks out of at a time
constexpr float near = 1.0f; // metres between a change and what a corner sees that may have something to do with it

// All looks of a batch together, by corner 128. Where polygons are piled on one another nearly all cones overlap, on plain ground next to none. Once the bound
// is used up, only a little is looked at out of each corner.
constexpr size_t overlapping_of_batch = batch << 7;
constexpr size_t cones_of_late_look = 32;

// Looks out of some corners, one after the other, within the bounds above.
class Lookout {
public:
	Lookout(const NavMesh &mesh, const Corners &corners, const CornerPolygons &polygons) : _sight(mesh, corners), _polygons(polygons) {}

	std::span<const SeenCorner> look(uint32_t corner) {
		_sight.limit(_overlapping < overlapping_of_batch ? Sight::most_cones : cones_of_late_look);
		const std::span<const SeenCorner> seen = _sight.look(corner, _polygons.of(corner));
		_overlapping += _sight.overlapping_count();
		return seen;
	}
	const Sight &sight() const { return _sight; }

private:
	Sight _sight;
	const CornerPolygons &_polygons;
	size_t _overlapping = 0; // cones
};

bool is_before(const SeenCorner &a, const SeenCorner &b) { return a.corner < b.corner; }

void in_batches(size_t count, const std::function<void(size_t first, size_t end)> &work) {
	parallel_for((count + batch - 1) / batch, {}, [&](size_t index) { work(index * batch, std::min((index + 1) * batch, count)); });
}

// Rounding may let one see the other but not be seen. Who looked at a part only is left what it saw: all that see it would be too many.
void make_mutual(std::vector<std::vector<SeenCorner>> &walks, const std::function<bool(uint32_t corner)> &is_cut_short) {
	std::vector<std::pair<uint32_t, SeenCorner>> missing;
	for (uint32_t corner = 0; corner < walks.size(); ++corner) {
		std::erase_if(walks[corner], [&](const SeenCorner &seen) {
			const bool is_mutual = std::binary_search(walks[seen.corner].begin(), walks[seen.corner].end(), SeenCorner{ corner, 0.0f }, is_before);
			if (!is_mutual && !is_cut_short(seen.corner)) {
				missing.push_back({ seen.corner, { corner, seen.cost } });
			}
			return !is_mutual && is_cut_short(seen.corner);
		});
	}
	for (const auto &[corner, seen] : missing) {
		walks[corner].push_back(seen);
	}
}

// Of the walks in `direct`, those that go by way of `middle`, from where `onwards` leads on, become negative: they stay what they cost, for those beyond.
void leave_out(const SeenCorner &middle, const std::vector<SeenCorner> &onwards, std::vector<float> &direct) {
	for (const SeenCorner &end : onwards) {
		const float cost = std::abs(direct[end.corner]);
		if (middle.cost < cost && end.cost < cost && middle.cost + end.cost <= detour * cost) {
			direct[end.corner] = -cost;
		}
	}
}

// What a metre costs on the ground that there is, each cost once, from cheap to dear.
std::vector<float> grounds_of(const NavMesh &mesh) {
	std::vector<float> grounds;
	for (uint32_t polygon = 0; polygon < mesh.polygon_count(); ++polygon) {
		if (grounds.empty() || mesh.cost(polygon) != grounds.back()) {
			grounds.push_back(mesh.cost(polygon));
		}
	}
	std::sort(grounds.begin(), grounds.end());
	grounds.erase(std::unique(grounds.begin(), grounds.end()), grounds.end());
	return grounds;
}

// Extents reach out in steps that each add 4.4 % and 4 cm, so that 254 of them are 60 km; what is farther counts as anywhere.
constexpr float steps_by_octave = 16.0f;
constexpr uint8_t anywhere = 255;

uint8_t steps_of(float metres) {
	const float steps = std::ceil(steps_by_octave * std::log2(1.0f + metres) + 0.01f); // a little more than it is, for rounding
	return steps < float(anywhere) ? uint8_t(steps) : anywhere;
}

float reach_of(uint8_t steps) {
	static const std::array<float, anywhere + 1> reaches = [] {
		std::array<float, anywhere + 1> metres{};
		for (size_t i = 0; i < anywhere; ++i) {
			metres[i] = std::exp2(float(i) / steps_by_octave) - 1.0f;
		}
		metres[anywhere] = INFINITY;
		return metres;
	}();
	return reaches[steps];
}

} // namespace

CornerGraph::Extent::Extent(glm::vec3 corner, const Sight &sight) : is_cut_short(sight.is_cut_short()) {
	const PlanBox box = sight.extent();
	min_x = steps_of(corner.x - box.min_x);
	min_z = steps_of(corner.z - box.min_z);
	max_x = steps_of(box.max_x - corner.x);
	max_z = steps_of(box.max_z - corner.z);
}

PlanBox CornerGraph::Extent::box(glm::vec3 corner) const {
	return { corner.x - reach_of(min_x), corner.z - reach_of(min_z), corner.x + reach_of(max_x), corner.z + reach_of(max_z) };
}

struct CornerGraph::Builder {
	const NavMesh &mesh;
	const CornerPolygons &polygons;
	CornerGraph &graph;
	CornerWalks walks;

	void run() {
		look_out();
		graph.set_walks(mesh, polygons, thin(), [](const CornerWalks &in_parts, size_t, uint32_t landmark) { return walk_costs(in_parts, landmark); });
	}

	void look_out() {
		const Corners &corners = graph._corners;
		walks.resize(corners.count());
		graph._extents.resize(corners.count());
		in_batches(corners.count(), [&](size_t first, size_t end) {
			Lookout lookout(mesh, corners, polygons);
			for (size_t corner = first; corner < end; ++corner) {
				const std::span<const SeenCorner> seen = lookout.look(uint32_t(corner));
				graph._extents[corner] = Extent(mesh.point(uint32_t(corner)), lookout.sight());
				walks[corner].assign(seen.begin(), seen.end());
				std::sort(walks[corner].begin(), walks[corner].end(), is_before);
			}
		});
		make_mutual(walks, [this](uint32_t corner) { return graph._extents[corner].is_cut_short; });
	}

	// Along straight streets everybody sees everybody; the walks to the next corners are enough. What is left out is made of shorter walks, which
	// are there or made of still shorter ones.
	CornerWalks thin() const {
		CornerWalks kept(walks.size());
		in_batches(walks.size(), [&](size_t first, size_t end) {
			std::vector<float> direct(walks.size(), 0.0f);
			for (size_t corner = first; corner < end; ++corner) {
				thin(walks[corner], direct, kept[corner]);
			}
		});
		return kept;
	}

	// `direct` is 0 for all corners, before and after.
	void thin(const std::vector<SeenCorner> &from, std::vector<float> &direct, std::vector<SeenCorner> &kept) const {
		for (const SeenCorner &seen : from) {
			direct[seen.corner] = seen.cost;
		}
		for (const SeenCorner &middle : from) {
			leave_out(middle, walks[middle.corner], direct);
		}
		for (const SeenCorner &seen : from) {
			if (direct[seen.corner] > 0.0f) {
				kept.push_back(seen);
			}
			direct[seen.corner] = 0.0f;
		}
	}
};

// After a change of the ground. Corners are fresh if what they saw has changed, or if they are new. The walks of all others are as they were, also
// those to fresh ones: only between two fresh ones has to be looked anew.
struct CornerGraph::Updater {
	const NavMesh &mesh;
	const CornerPolygons &polygons;
	const NavMesh &old_mesh;
	std::span<const PlanBox> changed;
	CornerGraph &graph;
	const CornerGraph &before = old_mesh.corner_graph();
	std::vector<uint32_t> new_of = {}, old_of = {}; // corners; no_corner where there is none
	std::vector<uint32_t> fresh = {};
	std::vector<bool> is_fresh = {}; // of new ones
	CornerWalks seen = {}; // by fresh ones of each other
	CornerWalks walks = {};

	// False if corners are gone that should not: the changes were not told right.
	bool run() {
		match();
		if (!inherit()) {
			return false;
		}
		look_out();
		thin();
		graph.set_walks(mesh, polygons, std::move(walks), [this](const CornerWalks &in_parts, size_t index, uint32_t landmark) {
			return measure(in_parts, index, landmark);
		});
		return true;
	}

	// Corners in the same place, to the bit.
	void match() {
		HashIndex places;
		for (uint32_t corner = 0; corner < graph._corners.count(); ++corner) {
			places.add(hash_of(mesh.point(corner)));
		}
		new_of.assign(before._corners.count(), no_corner);
		old_of.assign(graph._corners.count(), no_corner);
		is_fresh.assign(graph._corners.count(), true);
		for (uint32_t corner = 0; corner < before._corners.count(); ++corner) {
			const glm::vec3 place = old_mesh.point(corner);
			const uint32_t found = places.find(hash_of(place), [&](uint32_t other) { return mesh.point(other) == place; });
			if (found != HashIndex::none) {
				new_of[corner] = found;
				old_of[found] = corner;
				const PlanBox extent = before._extents[corner].box(place);
				is_fresh[found] = std::ranges::any_of(changed, [&](const PlanBox &box) { return extent.is_near(box, near); });
			}
		}
	}

	bool inherit() {
		walks.resize(graph._corners.count());
		graph._extents.resize(walks.size());
		for (uint32_t corner = 0; corner < walks.size(); ++corner) {
			if (is_fresh[corner]) {
				fresh.push_back(corner);
				continue;
			}
			graph._extents[corner] = before._extents[old_of[corner]];
			walks[corner] = before._walks.of(old_mesh.points(), old_of[corner]);
			for (SeenCorner &walk : walks[corner]) {
				walk.corner = new_of[walk.corner];
				if (walk.corner == no_corner) {
					return false;
				}
				if (is_fresh[walk.corner]) {
					walks[walk.corner].push_back({ corner, walk.cost });
				}
			}
		}
		return true;
	}

	void look_out() {
		seen.resize(walks.size());
		in_batches(fresh.size(), [&](size_t first, size_t end) {
			Lookout lookout(mesh, graph._corners, polygons);
			for (size_t i = first; i < end; ++i) {
				for (const SeenCorner &other : lookout.look(fresh[i])) {
					if (is_fresh[other.corner]) {
						seen[fresh[i]].push_back(other);
					}
				}
				graph._extents[fresh[i]] = Extent(mesh.point(fresh[i]), lookout.sight());
				std::sort(seen[fresh[i]].begin(), seen[fresh[i]].end(), is_before);
			}
		});
		make_mutual(seen, [this](uint32_t corner) { return graph._extents[corner].is_cut_short; });
	}

	void thin() {
		CornerWalks kept(fresh.size());
		in_batches(fresh.size(), [&](size_t first, size_t end) {
			std::vector<float> direct(walks.size(), 0.0f);
			for (size_t i = first; i < end; ++i) {
				thin(fresh[i], direct, kept[i]);
			}
		});
		for (size_t i = 0; i < fresh.size(); ++i) {
			std::vector<SeenCorner> &all = walks[fresh[i]];
			all.insert(all.end(), kept[i].begin(), kept[i].end());
			std::sort(all.begin(), all.end(), is_before);
		}
	}

	void thin(uint32_t corner, std::vector<float> &direct, std::vector<SeenCorner> &kept) const {
		for (const SeenCorner &other : seen[corner]) {
			direct[other.corner] = other.cost;
		}
		for (const SeenCorner &middle : seen[corner]) {
			leave_out(middle, seen[middle.corner], direct);
		}
		for (const SeenCorner &middle : walks[corner]) {
			leave_out(middle, walks[middle.corner], direct);
		}
		for (const SeenCorner &other : seen[corner]) {
			if (direct[other.corner] > 0.0f) {
				kept.push_back(other);
			}
			direct[other.corner] = 0.0f;
		}
	}

	std::vector<float> measure(const CornerWalks &in_parts, size_t index, uint32_t landmark) const {
		if (graph._landmarks[index] != before._landmarks[index] || graph._unit != before._unit || old_of[landmark] == no_corner) {
			return walk_costs(in_parts, landmark);
		}
		std::vector<float> costs(in_parts.size(), INFINITY);
		for (uint32_t corner = 0; corner < costs.size(); ++corner) {
			if (old_of[corner] != no_corner) {
				costs[corner] = before.far_cost(old_of[corner], index);
			}
		}
		repair_walk_costs(in_parts, landmark, fresh, costs);
		return costs;
	}
};

CornerGraph::CornerGraph(const NavMesh &mesh, const Corners &corners, const CornerPolygons &polygons) : _corners(corners) {
	Builder{ mesh, polygons, *this, {} }.run();
}

CornerGraph::CornerGraph(const NavMesh &mesh, const Corners &corners, const CornerPolygons &polygons, const NavMesh &before,
		std::span<const PlanBox> changed) : _corners(corners) {
	if (!Updater{ mesh, polygons, before, changed, *this }.run()) {
		Builder{ mesh, polygons, *this, {} }.run();
	}
}

size_t CornerGraph::cut_short_count() const {
	return size_t(std::ranges::count_if(_extents, [](const Extent &extent) { return extent.is_cut_short; }));
}

void CornerGraph::set_far(uint32_t corner, size_t index, float cost) {
	const auto whole = uint32_t(std::min(cost, float(parts * uint32_t(beyond))));
	_far[corner][index] = int16_t(whole / parts);
	_far_parts[corner][index / 2] |= uint8_t(whole % parts << (index % 2 * 4));
}

float CornerGraph::far_cost(uint32_t corner, size_t index) const {
	const int16_t units = _far[corner][index];
	const uint32_t rest = _far_parts[corner][index / 2] >> (index % 2 * 4) & (parts - 1);
	return units < beyond ? float(parts * uint32_t(units) + rest) : INFINITY;
}

// Walks count in whole parts of a unit, less than they cost, so that estimates are never too high and what an edit changes is mended to the bit. A unit is
// such that the numbers reach for ways that cost a quarter more than as many metres along the city and across it: 5 cm for 300 lots, 20 cm for 10,000.
// Farther off landmarks tell less and less.
void CornerGraph::set_walks(const NavMesh &mesh, const CornerPolygons &polygons, CornerWalks walks, const Measure &measure) {
	constexpr float least_unit = 0.01f;
	_walks = PackedWalks(mesh.points(), grounds_of(mesh), walks);
	_far.resize(_corners.count());
	_far_parts.resize(_corners.count());
	if (_far.empty()) {
		return;
	}
	PlanBox box;
	for (uint32_t corner = 0; corner < _corners.count(); ++corner) {
		box.add(mesh.point(corner));
	}
	_unit = std::max(least_unit, 1.25f * (box.max_x - box.min_x + box.max_z - box.min_z) / float(beyond));
	for (std::vector<SeenCorner> &from : walks) {
		for (SeenCorner &walk : from) {
			walk.cost = std::floor(walk.cost * float(parts) / _unit);
		}
	}
	const std::vector<uint32_t> landmarks = choose_landmarks(mesh, _corners, polygons, landmark_count);
	for (size_t k = 0; k < landmark_count; ++k) {
		_landmarks[k] = mesh.point(landmarks[k]);
	}
	parallel_for(landmark_count / 2, {}, [&](size_t pair) { // that share bytes
		for (size_t k = 2 * pair; k < 2 * pair + 2; ++k) {
			const std::vector<float> costs = measure(walks, k, landmarks[k]);
			for (uint32_t corner = 0; corner < costs.size(); ++corner) {
				set_far(corner, k, costs[corner]);
			}
		}
	});
}

// A corner may be almost a unit farther than is known: the goal is that much nearer.
CornerGraph::Goal CornerGraph::goal(std::span<const SeenCorner> seen) const {
	Goal goal;
	goal.least.fill(beyond);
	goal.most.fill(0);
	for (const SeenCorner &corner : seen) {
		const Far &far = _far[corner.corner];
		const auto units = int16_t(std::min(corner.cost / _unit, float(beyond))), room = int16_t(beyond - units);
		for (size_t k = 0; k < landmark_count; ++k) {
			goal.least[k] = std::min(goal.least[k], int16_t(std::min(far[k], room) + units - 1));
			goal.most[k] = std::max(goal.most[k], int16_t(std::min(std::max(far[k], units) - units + 1, int(beyond))));
		}
	}
	return goal;
}

} // namespace pcg
