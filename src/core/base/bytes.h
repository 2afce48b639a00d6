#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

// Values as bytes and back, the same on every machine: whole numbers with the least byte first, floats by their bits. Writer and reader have the
// same functions, so one template that names the fields of a record serves both.
namespace pcg {

template <typename T>
concept Scalar = std::is_arithmetic_v<T> || std::is_enum_v<T>;

namespace detail {
template <size_t Size> struct Bits;
template <> struct Bits<1> { using Type = uint8_t; };
template <> struct Bits<2> { using Type = uint16_t; };
template <> struct Bits<4> { using Type = uint32_t; };
template <> struct Bits<8> { using Type = uint64_t; };
} // namespace detail
template <Scalar T> using BitsOf = typename detail::Bits<sizeof(T)>::Type;

class ByteWriter {
public:
	static constexpr bool is_reading = false;

	template <Scalar... T> void values(const T &...all) { (put(all), ...); }
	// An enumeration whose values are 0 .. count - 1.
	template <Scalar T> void choice(const T &value, size_t) { put(value); }
	// A number within -most .. most, or, if `can_be_max`, the largest that there is.
	void whole(const int64_t &value, int64_t, bool = false) { put(value); }
	void text(const std::string &value) {
		values(uint64_t(value.size()));
		_bytes += value;
	}
	template <typename List, typename Visit> void list(const List &items, Visit &&visit) {
		values(uint64_t(items.size()));
		for (const auto &item : items) {
			visit(*this, item);
		}
	}
	const std::string &bytes() const { return _bytes; }
	std::string take() { return std::move(_bytes); }

private:
	template <Scalar T> void put(const T &value) {
		const BitsOf<T> bits = std::bit_cast<BitsOf<T>>(value);
		for (size_t i = 0; i < sizeof(T); ++i) {
			_bytes += char(uint8_t(bits >> (8 * i)));
		}
	}

	std::string _bytes;
};

// After the first thing that cannot be, is_good() is false and everything read is zero or empty.
class ByteReader {
public:
	static constexpr bool is_reading = true;

	explicit ByteReader(std::string_view bytes) : _bytes(bytes) {}

	bool is_good() const { return _is_good; }
	bool is_at_end() const { return _position == _bytes.size(); }
	void fail() { _is_good = false; }

	template <Scalar... T> void values(T &...all) { (get(all), ...); }
	template <Scalar T> void choice(T &value, size_t count) {
		get(value);
		if (size_t(value) >= count) {
			value = T();
			fail();
		}
	}
	void whole(int64_t &value, int64_t most, bool can_be_max = false) {
		get(value);
		const bool is_max = value == std::numeric_limits<int64_t>::max();
		if (is_max ? !can_be_max : value > most || value < -most) {
			value = 0;
			fail();
		}
	}
	void text(std::string &value) {
		const uint64_t size = count(1);
		value.assign(_bytes.substr(_position, size));
		_position += size;
	}
	template <typename List, typename Visit> void list(List &items, Visit &&visit) {
		items.clear();
		const uint64_t size = count(1); // every item takes a byte at least: no list is larger than what is left
		for (uint64_t i = 0; i < size && _is_good; ++i) {
			items.emplace_back();
			visit(*this, items.back());
		}
	}

private:
	template <Scalar T> void get(T &value) {
		if (!_is_good || _bytes.size() - _position < sizeof(T)) {
			fail();
			value = T();
			return;
		}
		BitsOf<T> bits = 0;
		for (size_t i = 0; i < sizeof(T); ++i) {
			bits = BitsOf<T>(bits | BitsOf<T>(BitsOf<T>(uint8_t(_bytes[_position + i])) << (8 * i)));
		}
		_position += sizeof(T);
		if constexpr (std::is_same_v<T, bool>) {
			value = bits != 0;
			_is_good = bits <= 1;
		} else {
			value = std::bit_cast<T>(bits);
		}
	}
	uint64_t count(uint64_t item_size) {
		uint64_t size = 0;
		get(size);
		if (size > (_bytes.size() - _position) / item_size) {
			fail();
			return 0;
		}
		return size;
	}

	std::string_view _bytes;
	size_t _position = 0;
	bool _is_good = true;
};

} // namespace pcg
