#include "core/cga/neighborhood.h"

#include <algorithm>
#include <mutex>
#include <new>

#include <glm/common.hpp>

#include "core/geometry/bounds_tree.h"

namespace pcg::cga {

namespace {

Bounds3 bounds_of(const InitialShape &shape) {
	Bounds3 bounds;
	bool is_first = true;
	for (const InitialShape::Face &face : shape.faces) {
		for (const glm::dvec3 &point : face.outline) {
			bounds = is_first ? Bounds3{ point, point } : Bounds3{ glm::min(bounds.low, point), glm::max(bounds.high, point) };
			is_first = false;
		}
	}
	return bounds;
}

// One interpreter per thread at a time, and each kept for the next lot.
class Pool {
public:
	Pool(const Program &program, const DeriveOptions &options) : _program(program), _options(options) {}

	template <typename Use> void with(Use use) {
		std::unique_ptr<Deriver> deriver;
		{
			const std::lock_guard<std::mutex> lock(_mutex);
			if (!_resting.empty()) {
				deriver = std::move(_resting.back());
				_resting.pop_back();
			}
		}
		if (!deriver) {
			deriver = std::make_unique<Deriver>(_program, _options);
		}
		use(*deriver);
		const std::lock_guard<std::mutex> lock(_mutex);
		_resting.push_back(std::move(deriver));
	}

private:
	const Program &_program;
	DeriveOptions _options;
	std::mutex _mutex;
	std::vector<std::unique_ptr<Deriver>> _resting;
};

// GNU's allocator lets the heap of a thread that is not the first grow by a system call for each 4 KB, and during each of them other threads wait for
// new memory. What was asked for in one piece and given back stays at the heap's end: the models of some 32 small lots, 20 KB, take one call.
void make_room_for_models() {
	::operator delete(::operator new(32 * 1024));
}

// Small lots take microseconds: a thread takes several that lie side by side, or the threads would wait for each other's counters and locks.
template <typename Use> void for_each_lot(size_t count, Pool &pool, const WorkOptions &work, Use use) {
	constexpr size_t most = 32, least_turns = 256; // so that no thread is left with a long last turn
	const size_t run = std::clamp<size_t>(count / least_turns, 1, most);
	parallel_for((count + run - 1) / run, work, [&](size_t turn) {
		if (run > 1) {
			make_room_for_models();
		}
		pool.with([&](Deriver &deriver) {
			for (size_t i = turn * run; i < std::min(count, (turn + 1) * run); ++i) {
				use(deriver, i);
			}
		});
	});
}

} // namespace

std::vector<bool> asked_about(std::span<const DeriveJob> jobs, std::span<const size_t> asking, double occlusion_distance) {
	std::vector<bool> result(jobs.size(), false);
	std::vector<Bounds3> boxes;
	for (const DeriveJob &job : jobs) {
		boxes.push_back(bounds_of(*job.shape));
	}
	BoundsTree tree;
	tree.build(boxes);
	const glm::dvec3 margin(occlusion_distance + 1e-3, 1e9, occlusion_distance + 1e-3); // however far apart in height
	const Program *known = nullptr;
	ContextUse use;
	for (const size_t job : asking) {
		if (known != jobs[job].program) {
			known = jobs[job].program;
			use = context_use(*known);
		}
		if (use.inter_labels) {
			return std::vector<bool>(jobs.size(), true);
		}
		tree.any(boxes[job].low - margin, boxes[job].high + margin, [&](uint32_t other) {
			result[other] = result[other] || other != job;
			return false;
		});
	}
	return result;
}

std::vector<DerivationResult> derive_all(const Program &program, std::span<const InitialShape> shapes, const DeriveOptions &options, const WorkOptions &work) {
	Pool pool(program, options);
	std::vector<std::shared_ptr<const Occluders>> occluders(shapes.size());
	if (context_use(program).asks_inter() && shapes.size() > 1) {
		for_each_lot(shapes.size(), pool, work, [&](Deriver &deriver, size_t i) { occluders[i] = deriver.occluders(shapes[i]); });
	}
	std::vector<DerivationResult> results(shapes.size());
	for_each_lot(shapes.size(), pool, work, [&](Deriver &deriver, size_t i) { results[i] = deriver.derive(shapes[i], { occluders, i }); });
	return results;
}

} // namespace pcg::cga
