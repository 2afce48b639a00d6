#include "godot/main_thread.h"

namespace pcg {

bool MainThread::run(const std::function<void()> &work) {
	if (std::this_thread::get_id() == _main) {
		work();
		return true;
	}
	Call call{ &work };
	std::unique_lock lock(_mutex);
	if (_is_closed) {
		return false;
	}
	_waiting.push_back(&call);
	_ended.wait(lock, [&] { return call.is_done || _is_closed; });
	return call.is_done;
}

void MainThread::run_waiting() {
	std::unique_lock lock(_mutex);
	while (!_waiting.empty()) {
		Call *call = _waiting.front();
		_waiting.pop_front();
		lock.unlock();
		(*call->work)(); // its owner waits: nobody but this thread closes
		lock.lock();
		call->is_done = true;
		_ended.notify_all();
	}
}

void MainThread::close() {
	const std::scoped_lock lock(_mutex);
	_is_closed = true;
	_waiting.clear();
	_ended.notify_all();
}

} // namespace pcg
