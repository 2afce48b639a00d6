#include "core/agenda/agenda_batches.h"

#include <algorithm>
#include <atomic>
#include <tuple>

#include "core/agenda/renumbering.h"
#include "core/base/parallel.h"

namespace pcg {

namespace {

// The rule around a call is the last one that begins before it in the same file.
TaskOrigin origin_at(const Program &program, uint32_t address) {
	const SourcePlace place = program.places[address > 0 ? address - 1 : 0];
	const auto position = [](const SourcePlace &at) { return std::tie(at.line, at.column); };
	const RuleInfo *rule = nullptr;
	for (const RuleInfo &candidate : program.rules) {
		if (candidate.place.file == place.file && !(position(place) < position(candidate.place)) &&
				(rule == nullptr || position(rule->place) < position(candidate.place))) {
			rule = &candidate;
		}
	}
	return { rule != nullptr ? rule->name : std::string(), place.file < program.files.size() ? program.files[place.file] : std::string(), place.line };
}

class Joining {
public:
	Joining(std::vector<AgendaBatch> &batches, const Program &program, size_t person_count) :
			_batches(batches), _program(program), _person_count(person_count), _is_origin(program.code.size() + 1) {}

	AgendaSet run(unsigned threads) {
		const WorkOptions work{ .threads = threads, .progress = {}, .cancel = nullptr };
		parallel_for(_batches.size(), work, [this](size_t i) { find_origins(_batches[i]); });
		number_origins();
		lay_out();
		parallel_for(_batches.size(), work, [this](size_t i) { write(i); });
		return std::move(_set);
	}

private:
	// Where a batch begins in the set.
	struct Place {
		size_t person = 0, task = 0, floating_task = 0, group = 0;
	};

	void find_origins(const AgendaBatch &batch) {
		for (const Task &task : batch.tasks) {
			if (!_is_origin[task.origin].load(std::memory_order_relaxed)) {
				_is_origin[task.origin].store(true, std::memory_order_relaxed);
			}
		}
	}

	// Addresses in the program become dense numbers in the order of the program.
	void number_origins() {
		_origin_number.resize(_is_origin.size());
		for (uint32_t address = 0; address < _is_origin.size(); ++address) {
			if (_is_origin[address].load(std::memory_order_relaxed)) {
				_origin_number[address] = uint32_t(_set.origins.size());
				_set.origins.push_back(origin_at(_program, address));
			}
		}
	}

	void lay_out() {
		_places.resize(_batches.size());
		_renumberings.reserve(_batches.size());
		Place next;
		for (size_t i = 0; i < _batches.size(); ++i) {
			const AgendaBatch &batch = _batches[i];
			_places[i] = next;
			_renumberings.emplace_back(_set, batch.names, batch.requirements, _origin_number, next.group);
			next.person += batch.task_counts.size();
			next.task += batch.tasks.size();
			next.floating_task += batch.floating_tasks.size();
			next.group += batch.groups.size();
		}
		_set.tasks.resize(next.task);
		_set.floating_tasks.resize(next.floating_task);
		_set.groups.resize(next.group);
		_set.first_task.resize(_person_count + 1);
		_set.first_floating_task.resize(_person_count + 1);
		std::fill(_set.first_task.begin() + ptrdiff_t(next.person), _set.first_task.end(), uint32_t(next.task));
		std::fill(_set.first_floating_task.begin() + ptrdiff_t(next.person), _set.first_floating_task.end(), uint32_t(next.floating_task));
	}

	void write(size_t index) {
		AgendaBatch &batch = _batches[index];
		const Place &place = _places[index];
		Task *out = _set.tasks.data() + place.task;
		for (const Task &task : batch.tasks) {
			*out++ = _renumberings[index].apply(task);
		}
		std::copy(batch.floating_tasks.begin(), batch.floating_tasks.end(), _set.floating_tasks.begin() + ptrdiff_t(place.floating_task));
		std::move(batch.groups.begin(), batch.groups.end(), _set.groups.begin() + ptrdiff_t(place.group));
		uint32_t task = uint32_t(place.task), floating_task = uint32_t(place.floating_task);
		for (size_t i = 0; i < batch.task_counts.size(); ++i) {
			_set.first_task[place.person + i] = task;
			_set.first_floating_task[place.person + i] = floating_task;
			task += batch.task_counts[i];
			floating_task += batch.floating_counts[i];
		}
		batch = { .tasks = {}, .task_counts = {}, .floating_tasks = {}, .floating_counts = {}, .groups = {}, .names = {}, .requirements = {},
			.diagnostics = std::move(batch.diagnostics) };
	}

	std::vector<AgendaBatch> &_batches;
	const Program &_program;
	size_t _person_count;
	AgendaSet _set;
	std::vector<std::atomic<bool>> _is_origin; // by address
	std::vector<uint32_t> _origin_number;
	std::vector<Place> _places;
	std::vector<Renumbering> _renumberings;
};

} // namespace

AgendaSet join_batches(std::vector<AgendaBatch> &batches, const Program &program, size_t person_count, unsigned threads) {
	return Joining(batches, program, person_count).run(threads);
}

} // namespace pcg
