#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/base/ids.h"

// The numbers that a user's files give to what dense ids name here.
namespace pcg {

class FileIds {
public:
	// False if the number is already taken.
	bool add(int64_t number);
	int64_t number_of(uint32_t index) const { return _numbers[index]; }
	// 0xFFFFFFFF (the Invalid of every id type) if the file has no such number.
	uint32_t index_of(int64_t number) const;
	// Whether rules, which reckon in doubles and take what is below 0 for "none", can tell all of these numbers apart: 0 .. 2^53.
	bool are_exact() const { return _are_exact; }

private:
	std::vector<int64_t> _numbers;
	std::map<int64_t, uint32_t> _indices;
	bool _are_exact = true;
};

// Those of a city and its people; where null, the dense ids are the numbers.
struct FileNumbers {
	const FileIds *buildings = nullptr;
	const FileIds *zones = nullptr;
	const FileIds *objects = nullptr;
	const FileIds *households = nullptr;
	const FileIds *persons = nullptr;

	// What rules use: lists that they cannot tell apart are left out.
	FileNumbers exact() const;
};

// For messages and tables; "-1" for Invalid.
template <typename Id> std::string number_text(const FileIds *ids, Id id) {
	if (!is_valid(id)) {
		return "-1";
	}
	return std::to_string(ids != nullptr ? ids->number_of(index_of(id)) : int64_t(index_of(id)));
}

// How an id looks inside the rule languages, as `to_number` and `to_id`, where the ids are a file's.
template <typename Id> double to_number(const FileIds *ids, Id id) {
	return ids == nullptr || !is_valid(id) ? to_number(id) : double(ids->number_of(index_of(id)));
}

template <typename Id> Id to_id(const FileIds *ids, double number, size_t count) {
	constexpr double most = 9007199254740992.0; // 2^53
	if (ids == nullptr) {
		return to_id<Id>(number, count);
	}
	const bool is_whole = number >= 0.0 && number <= most && number == double(int64_t(number));
	const uint32_t index = is_whole ? ids->index_of(int64_t(number)) : pcg::index_of(Id::Invalid);
	return index < count ? Id(index) : Id::Invalid;
}

} // namespace pcg
