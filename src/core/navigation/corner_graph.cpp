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

// All looks of a batch together: on the ground of cities they take less than half of it. Once it is used up, only a little is looked at out of each corner.
constexpr size_t cones_of_batch = batch << 8;
constexpr size_t cones_of_late_look = 32;

// Looks out of some corners, one after the other, within the bounds above.
class Lookout {
public:
	Lookout(const NavMesh &mesh, const Corners &corners, const CornerPolygons &polygons) : _sight(mesh, corners), _polygons(polygons) {}

	std::span<const SeenCorner> look(uint32_t corner) {
		_sight.limit(_used < cones_of_batch ? Sight::most_cones : cones_of_late_look);
		const std::span<const SeenCorner> seen = _sight.look(corner, _polygons.of(corner));
		_used += _sight.cone_count();
		return seen;
	}
	const Sight &sight() const { return _sight; }

private:
	Sight _sight;
	const CornerPolygons &_polygons;
	size_t _used = 0;
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

} // namespace

CornerGraph::Extent::Extent(const Sight &sight) : Extent(sight.extent()) { is_cut_short = sight.is_cut_short(); }

CornerGraph::Extent::Extent(const PlanBox &box) {
	const auto whole = [](float units) { return int16_t(std::clamp(units, -32768.0f, 32767.0f)); };
	min_x = whole(std::floor(box.min_x / unit));
	min_z = whole(std::floor(box.min_z / unit));
	max_x = whole(std::ceil(box.max_x / unit));
	max_z = whole(std::ceil(box.max_z / unit));
}

bool CornerGraph::Extent::is_near(const PlanBox &box) const {
	const Extent other(box);
	return min_x <= other.max_x && max_x >= other.min_x && min_z <= other.max_z && max_z >= other.min_z;
}

struct CornerGraph::Builder {
	const NavMesh &mesh;
	const CornerPolygons &polygons;
	CornerGraph &graph;
	Walks walks;

	void run() {
		look_out();
		graph.set_walks(thin());
		graph.measure_far(mesh, polygons, [this](size_t, uint32_t landmark) { return walk_costs(graph, landmark); });
	}

	void look_out() {
		const Corners &corners = graph._corners;
		walks.resize(corners.count());
		graph._extents.resize(corners.count());
		in_batches(corners.count(), [&](size_t first, size_t end) {
			Lookout lookout(mesh, corners, polygons);
			for (size_t corner = first; corner < end; ++corner) {
				const std::span<const SeenCorner> seen = lookout.look(uint32_t(corner));
				graph._extents[corner] = Extent(lookout.sight());
				walks[corner].assign(seen.begin(), seen.end());
				std::sort(walks[corner].begin(), walks[corner].end(), is_before);
			}
		});
		make_mutual(walks, [this](uint32_t corner) { return graph._extents[corner].is_cut_short; });
	}

	// Along straight streets everybody sees everybody; the walks to the next corners are enough. What is left out is made of shorter walks, which
	// are there or made of still shorter ones.
	Walks thin() const {
		Walks kept(walks.size());
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
	const CornerGraph &before;
	std::span<const PlanBox> changed;
	CornerGraph &graph;
	std::vector<uint32_t> new_of, old_of; // corners; no_corner where there is none
	std::vector<uint32_t> fresh;
	std::vector<bool> is_fresh; // of new ones
	Walks seen; // by fresh ones of each other
	Walks walks;

	// False if corners are gone that should not: the changes were not told right.
	bool run() {
		match();
		if (!inherit()) {
			return false;
		}
		look_out();
		thin();
		graph.set_walks(walks);
		graph.measure_far(mesh, polygons, [this](size_t index, uint32_t landmark) { return measure(index, landmark); });
		return true;
	}

	// Corners in the same place, to the bit.
	void match() {
		const Corners &corners = graph._corners;
		HashIndex places;
		for (uint32_t corner = 0; corner < corners.count(); ++corner) {
			places.add(hash_of(corners.position(corner)));
		}
		new_of.assign(before._corners.count(), no_corner);
		old_of.assign(graph._corners.count(), no_corner);
		is_fresh.assign(graph._corners.count(), true);
		for (uint32_t corner = 0; corner < before._corners.count(); ++corner) {
			const glm::vec3 place = before._corners.position(corner);
			const uint32_t found = places.find(hash_of(place), [&](uint32_t other) { return corners.position(other) == place; });
			if (found != HashIndex::none) {
				new_of[corner] = found;
				old_of[found] = corner;
				is_fresh[found] = std::ranges::any_of(changed, [&](const PlanBox &box) { return before._extents[corner].is_near(box); });
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
			for (const SeenCorner &walk : before.walks(old_of[corner])) {
				const uint32_t there = new_of[walk.corner];
				if (there == no_corner) {
					return false;
				}
				walks[corner].push_back({ there, walk.cost });
				if (is_fresh[there]) {
					walks[there].push_back({ corner, walk.cost });
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
				graph._extents[fresh[i]] = Extent(lookout.sight());
				std::sort(seen[fresh[i]].begin(), seen[fresh[i]].end(), is_before);
			}
		});
		make_mutual(seen, [this](uint32_t corner) { return graph._extents[corner].is_cut_short; });
	}

	void thin() {
		Walks kept(fresh.size());
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

	std::vector<float> measure(size_t index, uint32_t landmark) const {
		if (graph._landmarks[index] != before._landmarks[index] || old_of[landmark] == no_corner) {
			return walk_costs(graph, landmark);
		}
		std::vector<float> costs(walks.size(), INFINITY);
		for (uint32_t corner = 0; corner < costs.size(); ++corner) {
			const float cost = old_of[corner] != no_corner ? before._far[old_of[corner]][index] : 0.0f;
			costs[corner] = cost > 0.0f ? cost : INFINITY;
		}
		costs[landmark] = 0.0f;
		repair_walk_costs(graph, landmark, fresh, costs);
		return costs;
	}
};

CornerGraph::CornerGraph(const NavMesh &mesh, float margin) {
	CornerPolygons polygons;
	_corners = Corners(mesh, margin, polygons);
	Builder{ mesh, polygons, *this, {} }.run();
}

CornerGraph::CornerGraph(const NavMesh &mesh, float margin, const CornerGraph &before, std::span<const PlanBox> changed) {
	CornerPolygons polygons;
	_corners = Corners(mesh, margin, polygons);
	if (!Updater{ mesh, polygons, before, changed, *this, {}, {}, {}, {}, {}, {} }.run()) {
		Builder{ mesh, polygons, *this, {} }.run();
	}
}

size_t CornerGraph::cut_short_count() const {
	return size_t(std::ranges::count_if(_extents, [](const Extent &extent) { return extent.is_cut_short; }));
}

void CornerGraph::set_walks(const Walks &walks) {
	_first.assign(1, 0);
	_first.reserve(walks.size() + 1);
	for (const std::vector<SeenCorner> &list : walks) {
		_first.push_back(_first.back() + uint32_t(list.size()));
	}
	_walks.reserve(_first.back());
	for (const std::vector<SeenCorner> &list : walks) {
		_walks.insert(_walks.end(), list.begin(), list.end());
	}
}

void CornerGraph::measure_far(const NavMesh &mesh, const CornerPolygons &polygons,
		const std::function<std::vector<float>(size_t, uint32_t)> &measure) {
	_far.resize(_corners.count());
	if (_far.empty()) {
		return;
	}
	const std::vector<uint32_t> landmarks = choose_landmarks(mesh, _corners, polygons, landmark_count);
	for (size_t k = 0; k < landmark_count; ++k) {
		_landmarks[k] = _corners.position(landmarks[k]);
	}
	parallel_for(landmark_count, {}, [&](size_t k) {
		const std::vector<float> costs = measure(k, landmarks[k]);
		for (size_t corner = 0; corner < costs.size(); ++corner) {
			_far[corner][k] = std::isfinite(costs[corner]) ? costs[corner] : 0.0f; // where the landmark is out of reach it tells nothing
		}
	});
}

CornerGraph::Goal CornerGraph::goal(std::span<const SeenCorner> seen) const {
	Goal goal;
	goal.least.fill(INFINITY);
	goal.most.fill(-INFINITY);
	for (const SeenCorner &corner : seen) {
		for (size_t k = 0; k < landmark_count; ++k) {
			goal.least[k] = std::min(goal.least[k], _far[corner.corner][k] + corner.cost);
			goal.most[k] = std::max(goal.most[k], _far[corner.corner][k] - corner.cost);
		}
	}
	return goal;
}

} // namespace pcg
