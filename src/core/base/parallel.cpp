#include "core/base/parallel.h"

#include <algorithm>
#include <mutex>
#include <thread>
#include <vector>

namespace pcg {

namespace {

class Crew {
public:
	Crew(size_t count, const WorkOptions &options, const std::function<void(size_t)> &work) :
			_count(count), _options(options), _work(work) {}

	void run(size_t threads) {
		std::vector<std::thread> helpers;
		for (size_t i = 1; i < threads; ++i) {
			helpers.emplace_back([this] { take_pieces(); });
		}
		take_pieces();
		for (std::thread &helper : helpers) {
			helper.join();
		}
	}

	bool is_cancelled() const { return _options.cancel && _options.cancel->load(std::memory_order_relaxed); }
	bool is_done() const { return _done == _count; }

private:
	void take_pieces() {
		for (size_t i = _next++; i < _count && !is_cancelled(); i = _next++) {
			_work(i);
			const size_t done = ++_done;
			report(done);
		}
	}

	// Whoever finds another thread reporting leaves it to that one; the last piece always reports.
	void report(size_t done) {
		if (!_options.progress) {
			return;
		}
		std::unique_lock<std::mutex> lock(_report_mutex, std::defer_lock);
		if (done == _count) {
			lock.lock();
		} else if (!lock.try_lock()) {
			return;
		}
		if (done > _reported) {
			_reported = done;
			_options.progress(done, _count);
		}
	}

	size_t _count;
	const WorkOptions &_options;
	const std::function<void(size_t)> &_work;
	std::atomic<size_t> _next{ 0 };
	std::atomic<size_t> _done{ 0 };
	std::mutex _report_mutex;
	size_t _reported = 0;
};

} // namespace

bool parallel_for(size_t count, const WorkOptions &options, const std::function<void(size_t index)> &work) {
	const size_t machine = std::max(1u, std::thread::hardware_concurrency());
	const size_t wanted = options.threads > 0 ? std::min<size_t>(options.threads, 256) : machine;
	Crew crew(count, options, work);
	crew.run(std::max<size_t>(1, std::min(wanted, count)));
	return crew.is_done();
}

} // namespace pcg
