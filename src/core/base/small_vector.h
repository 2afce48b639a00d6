#pragma once

#include <cstddef>
#include <initializer_list>
#include <type_traits>
#include <vector>

namespace pcg {

// A list that needs no memory of its own while it is short: for lists that are made and thrown away in inner loops.
template <typename T, size_t few> class SmallVector {
	static_assert(std::is_trivially_copyable_v<T>);

public:
	SmallVector() = default;
	SmallVector(std::initializer_list<T> values) {
		for (const T &value : values) {
			push_back(value);
		}
	}
	explicit SmallVector(size_t count, const T &value = T()) {
		for (size_t i = 0; i < count; ++i) {
			push_back(value);
		}
	}

	void push_back(const T &value) {
		if (_size < few) {
			_few[_size] = value;
		} else {
			if (_size == few) {
				_many.assign(_few, _few + few);
			}
			_many.push_back(value);
		}
		++_size;
	}
	T *data() { return _size <= few ? _few : _many.data(); }
	const T *data() const { return _size <= few ? _few : _many.data(); }
	size_t size() const { return _size; }
	bool empty() const { return _size == 0; }
	T &operator[](size_t i) { return data()[i]; }
	const T &operator[](size_t i) const { return data()[i]; }
	T *begin() { return data(); }
	T *end() { return data() + _size; }
	const T *begin() const { return data(); }
	const T *end() const { return data() + _size; }

private:
	T _few[few] = {};
	std::vector<T> _many; // all of them, once they are more than a few
	size_t _size = 0;
};

} // namespace pcg
