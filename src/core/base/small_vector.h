#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace pcg {

// As std::vector, but with room for a few elements in itself: lists that are made and thrown away in inner loops are short as a rule, and one that is
// short needs no memory. Moving one may move its elements.
template <typename T, uint32_t few> class SmallVector {
public:
	using value_type = T;
	using reference = T &;
	using const_reference = const T &;
	using iterator = T *;
	using const_iterator = const T *;
	using size_type = size_t;
	using difference_type = std::ptrdiff_t;

	SmallVector() {}
	SmallVector(std::initializer_list<T> values) { append(values.begin(), values.size()); }
	explicit SmallVector(size_t count, const T &value = T()) { resize(count, value); }
	template <std::input_iterator Iterator> SmallVector(Iterator first, Iterator last) { insert(end(), first, last); }
	SmallVector(const std::vector<T> &values) { append(values.data(), values.size()); }
	SmallVector(const SmallVector &other) { append(other.data(), other.size()); }
	SmallVector(SmallVector &&other) noexcept { take(other); }
	SmallVector &operator=(const SmallVector &other) {
		if (this != &other) {
			clear();
			append(other.data(), other.size());
		}
		return *this;
	}
	SmallVector &operator=(SmallVector &&other) noexcept {
		if (this != &other) {
			clear();
			release();
			take(other);
		}
		return *this;
	}
	~SmallVector() {
		clear();
		release();
	}

	void push_back(const T &value) { emplace_back(value); }
	void push_back(T &&value) { emplace_back(std::move(value)); }
	template <typename... Args> T &emplace_back(Args &&...args) {
		if (_size == _capacity) [[unlikely]] {
			T value(std::forward<Args>(args)...); // the arguments may lie in the memory that is given back
			reserve(2 * size_t(_capacity));
			return *::new (_data + _size++) T(std::move(value));
		}
		return *::new (_data + _size++) T(std::forward<Args>(args)...);
	}
	void pop_back() { _data[--_size].~T(); }
	void resize(size_t count, const T &value = T()) {
		reserve(count);
		for (; _size < count; ++_size) {
			::new (_data + _size) T(value);
		}
		cut_off(count);
	}
	void assign(size_t count, const T &value) {
		clear();
		resize(count, value);
	}
	template <std::input_iterator Iterator> iterator insert(const_iterator at, Iterator first, Iterator last) {
		const std::ptrdiff_t place = at - _data, old_size = _size;
		for (; first != last; ++first) {
			emplace_back(*first);
		}
		std::rotate(_data + place, _data + old_size, end());
		return _data + place;
	}
	iterator erase(const_iterator first, const_iterator last) {
		T *target = _data + (first - _data);
		cut_off(size_t(std::move(_data + (last - _data), end(), target) - _data));
		return target;
	}
	void clear() { cut_off(0); }
	void reserve(size_t count) {
		if (count <= _capacity) {
			return;
		}
		T *memory = std::allocator<T>().allocate(count);
		std::uninitialized_move(begin(), end(), memory);
		std::destroy(begin(), end());
		release();
		_data = memory;
		_capacity = uint32_t(count);
	}

	T *data() { return _data; }
	const T *data() const { return _data; }
	size_t size() const { return _size; }
	bool empty() const { return _size == 0; }
	T &operator[](size_t i) { return _data[i]; }
	const T &operator[](size_t i) const { return _data[i]; }
	T &front() { return _data[0]; }
	const T &front() const { return _data[0]; }
	T &back() { return _data[_size - 1]; }
	const T &back() const { return _data[_size - 1]; }
	T *begin() { return _data; }
	T *end() { return _data + _size; }
	const T *begin() const { return _data; }
	const T *end() const { return _data + _size; }
	auto rbegin() const { return std::reverse_iterator(end()); }
	auto rend() const { return std::reverse_iterator(begin()); }
	bool operator==(const SmallVector &other) const { return std::equal(begin(), end(), other.begin(), other.end()); }

private:
	T *own() { return reinterpret_cast<T *>(_few); }
	void append(const T *values, size_t count) {
		reserve(_size + count);
		std::uninitialized_copy_n(values, count, end());
		_size += uint32_t(count);
	}
	void cut_off(size_t count) {
		if (count < _size) {
			std::destroy(_data + count, end());
			_size = uint32_t(count);
		}
	}
	// Back to its own room; it holds nothing.
	void release() {
		if (_data != own()) {
			std::allocator<T>().deallocate(_data, _capacity);
			_data = own();
			_capacity = few;
		}
	}
	// Of another, while this one is empty and has its own room only.
	void take(SmallVector &other) {
		if (other._data == other.own()) {
			std::uninitialized_move(other.begin(), other.end(), _data);
			_size = other._size;
			other.clear();
			return;
		}
		_data = std::exchange(other._data, other.own());
		_size = std::exchange(other._size, 0u);
		_capacity = std::exchange(other._capacity, few);
	}

	T *_data = own();
	uint32_t _size = 0, _capacity = few;
	alignas(T) std::byte _few[few * sizeof(T)];
};

// Takes out what a predicate holds for.
template <typename T, uint32_t few, typename Predicate> void erase_if(SmallVector<T, few> &list, Predicate is_out) {
	list.erase(std::remove_if(list.begin(), list.end(), is_out), list.end());
}

} // namespace pcg
