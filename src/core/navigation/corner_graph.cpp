#include "core/navigation/corner_graph.h"

#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/navigation/nav_mesh.h"
#include "core/navigation/open_list.h"

namespace pcg {

namespace {

// A walk by way of a third corner stands for the straight one if it costs at most so much more.
constexpr float detour = 1.0001f;
constexpr size_t batch = 256; // corners that a thread looks out of at a time

} // namespace

struct CornerGraph::Builder {
	using Walks = std::vector<std::vector<SeenCorner>>; // by corner

	const NavMesh &mesh;
	CornerGraph &graph;
	Walks walks;

	void run() {
		look_out();
		const Walks thinned = thin();
		graph._first.assign(1, 0);
		for (const std::vector<SeenCorner> &list : thinned) {
			graph._walks.insert(graph._walks.end(), list.begin(), list.end());
			graph._first.push_back(uint32_t(graph._walks.size()));
		}
		measure_far();
	}

	void look_out() {
		const Corners &corners = graph._corners;
		walks.resize(corners.count());
		parallel_for((corners.count() + batch - 1) / batch, {}, [&](size_t index) {
			Sight sight(mesh, corners);
			for (size_t corner = index * batch; corner < std::min((index + 1) * batch, corners.count()); ++corner) {
				const std::span<const SeenCorner> seen = sight.look(uint32_t(corner));
				walks[corner].assign(seen.begin(), seen.end());
				std::sort(walks[corner].begin(), walks[corner].end(), is_before);
			}
		});
		make_mutual();
	}

	static bool is_before(const SeenCorner &a, const SeenCorner &b) { return a.corner < b.corner; }

	// Rounding may let one see the other but not be seen.
	void make_mutual() {
		std::vector<std::pair<uint32_t, SeenCorner>> missing;
		for (uint32_t corner = 0; corner < walks.size(); ++corner) {
			for (const SeenCorner &seen : walks[corner]) {
				if (!std::binary_search(walks[seen.corner].begin(), walks[seen.corner].end(), SeenCorner{ corner, 0.0f }, is_before)) {
					missing.push_back({ seen.corner, { corner, seen.cost } });
				}
			}
		}
		for (const auto &[corner, seen] : missing) {
			walks[corner].push_back(seen);
		}
	}

	// Along straight streets everybody sees everybody; the walks to the next corners are enough. What is left out is made of shorter walks, which
	// are there or made of still shorter ones.
	Walks thin() const {
		Walks kept(walks.size());
		parallel_for((walks.size() + batch - 1) / batch, {}, [&](size_t index) {
			std::vector<float> direct(walks.size(), 0.0f);
			for (size_t corner = index * batch; corner < std::min((index + 1) * batch, walks.size()); ++corner) {
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
			for (const SeenCorner &end : walks[middle.corner]) {
				const float cost = std::abs(direct[end.corner]);
				if (middle.cost < cost && end.cost < cost && middle.cost + end.cost <= detour * cost) {
					direct[end.corner] = -cost; // stays what it costs, for those beyond
				}
			}
		}
		for (const SeenCorner &seen : from) {
			if (direct[seen.corner] > 0.0f) {
				kept.push_back(seen);
			}
			direct[seen.corner] = 0.0f;
		}
	}

	// As far from each other as the crow flies as can be, all on the ground on which most corners are.
	std::vector<uint32_t> choose_landmarks() const {
		const Corners &corners = graph._corners;
		std::vector<uint32_t> count(mesh.component_count());
		const auto ground_of = [&](uint32_t corner) { return mesh.component(corners.polygons(corner)[0]); };
		for (uint32_t corner = 0; corner < corners.count(); ++corner) {
			++count[ground_of(corner)];
		}
		const auto ground = uint32_t(std::max_element(count.begin(), count.end()) - count.begin());
		std::vector<float> nearest(corners.count());
		for (uint32_t corner = 0; corner < corners.count(); ++corner) {
			nearest[corner] = ground_of(corner) == ground ? glm::length(corners.position(corner)) : -1.0f;
		}
		std::vector<uint32_t> landmarks;
		while (landmarks.size() < landmark_count) {
			landmarks.push_back(uint32_t(std::max_element(nearest.begin(), nearest.end()) - nearest.begin()));
			for (uint32_t corner = 0; corner < corners.count(); ++corner) {
				nearest[corner] = std::min(nearest[corner], glm::distance(corners.position(corner), corners.position(landmarks.back())));
			}
		}
		return landmarks;
	}

	void measure_far() {
		graph._far.resize(walks.size());
		if (walks.empty()) {
			return;
		}
		const std::vector<uint32_t> landmarks = choose_landmarks();
		parallel_for(landmark_count, {}, [&](size_t k) {
			const std::vector<float> costs = measure(landmarks[k]);
			for (size_t corner = 0; corner < costs.size(); ++corner) {
				graph._far[corner][k] = std::isfinite(costs[corner]) ? costs[corner] : 0.0f; // where the landmark is out of reach it tells nothing
			}
		});
	}

	// Costs from one corner to all.
	std::vector<float> measure(uint32_t from) const {
		std::vector<float> costs(walks.size(), INFINITY);
		OpenList open;
		costs[from] = 0.0f;
		open.push({ 0.0f, from });
		while (!open.is_empty()) {
			const OpenList::Entry entry = open.pop();
			if (entry.estimate > costs[entry.node]) {
				continue; // a better way there was found in the meantime
			}
			for (const SeenCorner &next : graph.walks(entry.node)) {
				const float cost = entry.estimate + next.cost;
				if (cost < costs[next.corner]) {
					costs[next.corner] = cost;
					open.push({ cost, next.corner });
				}
			}
		}
		return costs;
	}
};

CornerGraph::CornerGraph(const NavMesh &mesh, float margin) : _corners(mesh, margin) { Builder{ mesh, *this, {} }.run(); }

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
