#include <doctest/doctest.h>

#include "core/base/bytes.h"

using namespace pcg;

TEST_CASE("values are written with the least byte first, and come back") {
	ByteWriter writer;
	writer.values(uint32_t(0x01020304), int8_t(-1), 1.5, true);
	writer.text("ab");
	writer.list(std::vector<uint16_t>{ 7, 300 }, [](auto &archive, auto &value) { archive.values(value); });
	CHECK(writer.bytes().substr(0, 5) == "\x04\x03\x02\x01\xFF");
	CHECK(writer.bytes().size() == 4 + 1 + 8 + 1 + (8 + 2) + (8 + 4));

	ByteReader reader(writer.bytes());
	uint32_t number = 0;
	int8_t small = 0;
	double real = 0.0;
	bool truth = false;
	std::string text;
	std::vector<uint16_t> list;
	reader.values(number, small, real, truth);
	reader.text(text);
	reader.list(list, [](auto &archive, auto &value) { archive.values(value); });
	CHECK(reader.is_good());
	CHECK(reader.is_at_end());
	CHECK(number == 0x01020304);
	CHECK(small == -1);
	CHECK(real == 1.5);
	CHECK(truth);
	CHECK(text == "ab");
	CHECK(list == std::vector<uint16_t>{ 7, 300 });
}

TEST_CASE("what cannot be is noticed, and nothing is read behind it") {
	enum class Color : uint8_t { Red, Blue };
	using namespace std::string_literals;
	Color color = Color::Blue;
	const std::string third = "\x02";
	ByteReader choice(third);
	choice.choice(color, 2);
	CHECK(!choice.is_good());
	CHECK(color == Color::Red);

	bool truth = false;
	const std::string two = "\x02";
	ByteReader boolean(two);
	boolean.values(truth);
	CHECK(!boolean.is_good());

	uint32_t number = 9;
	const std::string short_bytes = "\x01\x01";
	ByteReader cut(short_bytes);
	cut.values(number);
	CHECK(!cut.is_good());
	CHECK(number == 0);

	std::vector<uint8_t> list;
	const std::string huge = "\xFF\xFF\xFF\xFF\xFF\xFF\xFF\x7F\x01"s; // a length that no memory holds
	ByteReader reader(huge);
	reader.list(list, [](auto &archive, auto &value) { archive.values(value); });
	CHECK(!reader.is_good());
	CHECK(list.empty());
	std::string text;
	ByteReader words(huge);
	words.text(text);
	CHECK(!words.is_good());
	CHECK(text.empty());
}

TEST_CASE("whole numbers beyond their limit are refused, the largest of all only where it may be") {
	const int64_t largest = std::numeric_limits<int64_t>::max();
	const auto read = [](int64_t value, bool can_be_max) {
		ByteWriter writer;
		writer.whole(value, 100, can_be_max);
		ByteReader reader(writer.bytes());
		int64_t number = 1;
		reader.whole(number, 100, can_be_max);
		return reader.is_good() ? number : -1;
	};
	CHECK(read(100, false) == 100);
	CHECK(read(-100, true) == -100);
	CHECK(read(101, true) == -1);
	CHECK(read(-101, false) == -1);
	CHECK(read(largest, true) == largest);
	CHECK(read(largest, false) == -1);
	CHECK(read(std::numeric_limits<int64_t>::min(), true) == -1);
}
