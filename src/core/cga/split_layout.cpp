#include "core/cga/split_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
		size_t repeats = 0, repeat = 0;
		for (size_t i = 0; i < _groups.size(); ++i) {
			_counts[i] = 1;
			_sums[i] = sums_of(_groups[i], _length);
			repeat = _groups[i].is_repeated && repeats++ == 0 ? i : repeat;
		}
		if (repeats == 1) {
			count_one(repeat);
		} else if (repeats > 1) {
			count_several();
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
	Sums outside(size_t repeat) const {
		Sums sums = total();
		sums += -double(_counts[repeat]) * _sums[repeat];
		return sums;
	}
	// How much the flexible parts are stretched, 1 = not at all; negative: the fixed ones do not fit.
	double stretch() const {
		const Sums sums = total();
		return (_length - sums.fixed) / sums.flexible;
	}

	void count_one(size_t repeat) {
		const Sums pattern = _sums[repeat];
		const Sums outer = outside(repeat);
		const double nominal = pattern.fixed + pattern.flexible;
		if (nominal <= 1e-9) {
			_counts[repeat] = 0;
			return;
		}
		if (pattern.flexible == 0.0 && outer.flexible == 0.0) { // nothing can be stretched: the last one is cut
			_repeat_room = std::max(0.0, _length - outer.fixed);
			set_count(repeat, std::ceil(_repeat_room / pattern.fixed - 1e-9));
			return;
		}
		const double ideal = std::clamp((_length - outer.fixed - outer.flexible) / nominal, 0.0, double(_max_parts) + 1.0);
		const double least = outer.flexible > 0.0 ? 0.0 : 1.0; // where others can fill the length alone, they may
		set_count(repeat, std::max(least, std::floor(ideal)));
		const uint32_t few = _counts[repeat];
		const double stretch_of_few = stretch();
		set_count(repeat, few + 1.0);
		const double stretch_of_more = stretch();
		if (stretch_of_more < 0.0 || std::abs(stretch_of_few - 1.0) <= std::abs(stretch_of_more - 1.0)) {
			_counts[repeat] = few;
		}
		const bool is_alone = outer.fixed == 0.0 && outer.flexible == 0.0;
		if (stretch_of_few < 0.0 && !is_alone) { // not even one fits beside the others
			_counts[repeat] = 0;
		}
	}

	void set_count(size_t repeat, double count) {
		const double most = double(_max_parts) / double(_groups[repeat].sizes.size());
		_layout.is_clamped |= count > most;
		_counts[repeat] = uint32_t(std::min(count, most));
	}

	// How far the flexible parts are from their own sizes; where there are none, what is left empty. Infinite: they do not fit.
	double misfit() const {
		const Sums sums = total();
		const double left = _length - sums.fixed;
		if (left < -1e-9) {
			return std::numeric_limits<double>::infinity();
		}
		return sums.flexible > 0.0 ? std::abs(left / sums.flexible - 1.0) : left;
	}

	// One repetition at a time to the group that has the fewest, while they fit better.
	void count_several() {
		double best = misfit();
		for (uint32_t parts = 0; parts < _max_parts; ++parts) {
			size_t fewest = _groups.size();
			for (size_t i = 0; i < _groups.size(); ++i) {
				const bool is_candidate = _groups[i].is_repeated && _sums[i].fixed + _sums[i].flexible > 1e-9;
				if (is_candidate && (fewest == _groups.size() || _counts[i] < _counts[fewest])) {
					fewest = i;
				}
			}
			if (fewest == _groups.size()) {
				return;
			}
			++_counts[fewest];
			const double now = misfit();
			if (!(now < best)) {
				--_counts[fewest];
				return;
			}
			best = now;
		}
		_layout.is_clamped = true;
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
