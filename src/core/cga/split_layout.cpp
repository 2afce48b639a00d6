#include "core/cga/split_layout.h"

#include <algorithm>
#include <cmath>

namespace pcg::cga {

namespace {

constexpr double least_part = 1e-6;

struct Sums {
	double fixed = 0.0; // metres
	double flexible = 0.0;

	Sums &operator+=(Sums other) {
		fixed += other.fixed;
		flexible += other.flexible;
		return *this;
	}
	friend Sums operator*(double count, Sums sums) { return { count * sums.fixed, count * sums.flexible }; }
};

double clean(double value) {
	return std::isfinite(value) && value > 0.0 ? value : 0.0;
}

Sums sums_of(const SplitGroup &group, double length) {
	Sums sums;
	for (const SplitSize &size : group.sizes) {
		const double value = clean(size.value);
		(size.kind == SizeKind::Flexible ? sums.flexible : sums.fixed) += size.kind == SizeKind::Relative ? value * length : value;
	}
	return sums;
}

class Layouter {
public:
	Layouter(std::span<const SplitGroup> groups, double length, uint32_t max_parts, Arena &arena)
			: _groups(groups), _length(length), _max_parts(max_parts), _arena(arena), _counts(arena.allocate<uint32_t>(groups.size())),
			  _sums(arena.allocate<Sums>(groups.size())) {}

	SplitLayout run() {
		for (size_t i = 0; i < _groups.size(); ++i) {
			_counts[i] = 1;
			_sums[i] = sums_of(_groups[i], _length);
			(_groups[i].is_repeated ? _pattern : _outer) += _sums[i];
			_repeats += _groups[i].is_repeated ? 1 : 0;
		}
		if (_repeats > 0) {
			count();
		}
		place();
		return _layout;
	}

private:
	Sums total() const {
		Sums sums;
		for (size_t i = 0; i < _groups.size(); ++i) {
			sums += double(_counts[i]) * _sums[i];
		}
		return sums;
	}
	// How much the flexible parts are stretched, 1 = not at all; negative: the fixed ones do not fit.
	double stretch() const {
		const Sums sums = total();
		return (_length - sums.fixed) / sums.flexible;
	}

	// All repeats of a block come equally often, so that two around a door leave it in the middle.
	void count() {
		const double nominal = _pattern.fixed + _pattern.flexible;
		if (nominal <= 1e-9) {
			set_counts(0.0);
			return;
		}
		if (_pattern.flexible == 0.0 && _outer.flexible == 0.0) { // nothing can be stretched: a single one is cut in the end
			const double room = std::max(0.0, _length - _outer.fixed);
			_repeat_room = _repeats == 1 ? room : _repeat_room;
			set_counts(_repeats == 1 ? std::ceil(room / nominal - 1e-9) : std::max(1.0, std::floor(room / nominal + 1e-9)));
			return;
		}
		const double ideal = std::clamp((_length - _outer.fixed - _outer.flexible) / nominal, 0.0, double(_max_parts) + 1.0);
		const double least = _outer.flexible > 0.0 ? 0.0 : 1.0; // where others can fill the length alone, they may
		const double few = std::max(least, std::floor(ideal));
		set_counts(few);
		const double stretch_of_few = stretch();
		set_counts(few + 1.0);
		const double stretch_of_more = stretch();
		const bool is_alone = _outer.fixed == 0.0 && _outer.flexible == 0.0;
		if (stretch_of_few < 0.0 && !is_alone) { // not even one fits beside the others
			set_counts(0.0);
		} else if (stretch_of_more < 0.0 || std::abs(stretch_of_few - 1.0) <= std::abs(stretch_of_more - 1.0)) {
			set_counts(few);
		}
	}

	void set_counts(double count) {
		size_t sizes = 0;
		for (const SplitGroup &group : _groups) {
			sizes += group.is_repeated ? group.sizes.size() : 0;
		}
		const double most = double(_max_parts) / double(std::max<size_t>(sizes, 1));
		_layout.is_clamped |= count > most;
		for (size_t i = 0; i < _groups.size(); ++i) {
			_counts[i] = _groups[i].is_repeated ? uint32_t(std::min(count, most)) : 1;
		}
	}

	void place() {
		const Sums sums = total();
		const double left = std::max(0.0, _length - sums.fixed);
		size_t parts = 0;
		for (size_t i = 0; i < _groups.size(); ++i) {
			parts += _counts[i] * _groups[i].sizes.size();
		}
		const double most = _length / least_part + 1.0; // of parts that are long enough
		_layout.parts = { _arena.allocate<SplitPart>(double(parts) < most ? parts : size_t(most)), 0 };
		_scale = sums.flexible > 0.0 ? left / sums.flexible : 0.0;
		for (size_t i = 0; i < _groups.size(); ++i) {
			const double limit = _groups[i].is_repeated ? std::min(_length, _at + _repeat_room) : _length;
			for (uint32_t n = 0; n < _counts[i] && _at < limit; ++n) {
				place_once(_groups[i], limit);
			}
		}
	}

	void place_once(const SplitGroup &group, double limit) {
		for (const SplitSize &size : group.sizes) {
			double extent = clean(size.value);
			if (size.kind != SizeKind::Absolute) {
				extent *= size.kind == SizeKind::Relative ? _length : _scale;
			}
			double end = _at + extent;
			if (extent > 0.0 && end > limit - least_part) { // cut, or short of it by rounding alone
				end = std::max(_at, limit);
			}
			if (end - _at > least_part) {
				_layout.parts = { _layout.parts.data(), _layout.parts.size() + 1 };
				_layout.parts.back() = { size.entry, _at, end };
			}
			_at = end;
		}
	}

	std::span<const SplitGroup> _groups;
	double _length;
	uint32_t _max_parts;
	Arena &_arena;
	uint32_t *_counts; // by group
	Sums *_sums;
	Sums _pattern, _outer; // of all repeats, once each; of what is not repeated
	size_t _repeats = 0;
	double _repeat_room = 1e300; // what the repeated parts may fill
	double _scale = 1.0;
	double _at = 0.0;
	SplitLayout _layout;
};

} // namespace

SplitLayout lay_out_split(std::span<const SplitGroup> groups, double length, uint32_t max_parts, Arena &arena) {
	return Layouter(groups, clean(length), max_parts, arena).run();
}

} // namespace pcg::cga
