#include "cli/progress.h"

#include <chrono>
#include <csignal>
#include <cstdio>

namespace pcg::cli {

namespace {

using Clock = std::chrono::steady_clock;

std::atomic<bool> cancelled{ false };
static_assert(std::atomic<bool>::is_always_lock_free); // may be set by a signal
std::atomic<bool> has_told{ false };

// A second Ctrl-C ends the program at once.
void on_interrupt(int) {
	cancelled = true;
	std::signal(SIGINT, SIG_DFL);
}

} // namespace

WorkOptions long_work(std::string what, unsigned threads) {
	static const auto previous = std::signal(SIGINT, on_interrupt);
	static_cast<void>(previous);
	WorkOptions work;
	work.threads = threads;
	work.cancel = &cancelled;
	work.progress = [what = std::move(what), start = Clock::now(), last = Clock::now()](size_t done, size_t total) mutable {
		const Clock::time_point now = Clock::now();
		if (now - start > std::chrono::seconds(2) && now - last > std::chrono::milliseconds(500)) {
			std::fprintf(stderr, "\r%s: %zu %%", what.c_str(), total > 0 ? 100 * done / total : 100);
			last = now;
			has_told = true;
		}
	};
	return work;
}

bool was_cancelled() { return cancelled; }

void end_progress() {
	if (has_told.exchange(false)) {
		std::fputc('\n', stderr);
	}
}

} // namespace pcg::cli
