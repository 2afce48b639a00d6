#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace pcg {

// Work that worker threads hand to the engine's main thread, because the engine answers it nowhere else: asked from another thread for what is on
// the graphics card it waits for the main thread, which may be waiting for that thread.
class MainThread {
public:
	// Made on the main thread.
	MainThread() = default;
	// Runs `work` on the main thread and waits for its end; on the main thread itself at once. False, and it was not run, after close().
	bool run(const std::function<void()> &work);
	// On the main thread, again and again while workers work: runs what waits.
	void run_waiting();
	// Whoever waits goes on at once, and nobody waits any more. On the main thread.
	void close();

private:
	struct Call {
		const std::function<void()> *work = nullptr;
		bool is_done = false;
	};

	const std::thread::id _main = std::this_thread::get_id();
	std::mutex _mutex;
	std::condition_variable _ended;
	std::deque<Call *> _waiting; // on the stacks of those who wait
	bool _is_closed = false;
};

} // namespace pcg
