#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

// Independent pieces of work spread over threads. Results must not depend on the order: give every piece its own place to write to and its
// own random stream.
namespace pcg {

struct WorkOptions {
	unsigned threads = 0; // 0 = as many as the machine runs at once; 1 = none but the caller's
	// Told now and then how much is done; on any of the threads, never on two at once.
	std::function<void(size_t done, size_t total)> progress;
	// Set by anybody to stop early; pieces that run are finished.
	const std::atomic<bool> *cancel = nullptr;
};

// Calls `work(i)` once for each i below `count`. False if it was cancelled.
bool parallel_for(size_t count, const WorkOptions &options, const std::function<void(size_t index)> &work);

} // namespace pcg
