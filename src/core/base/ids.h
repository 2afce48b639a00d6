#pragma once

#include <cstdint>
#include <functional>

// Ids are types, so that the compiler refuses to mix them. All are dense indices into the owning container; `Invalid` is the only
// value that names nothing. Only the rule languages show ids as plain numbers (-1 for Invalid): see `to_number`, `to_id`.
namespace pcg {

enum class PersonId : uint32_t { Invalid = 0xFFFFFFFF };
enum class HouseholdId : uint32_t { Invalid = 0xFFFFFFFF };
enum class LotId : uint32_t { Invalid = 0xFFFFFFFF };
enum class BlockId : uint32_t { Invalid = 0xFFFFFFFF };
enum class BuildingId : uint32_t { Invalid = 0xFFFFFFFF };
enum class EntranceId : uint32_t { Invalid = 0xFFFFFFFF };
enum class ZoneId : uint32_t { Invalid = 0xFFFFFFFF };
enum class ObjectId : uint32_t { Invalid = 0xFFFFFFFF };
// A type of entrance, zone or object ("school", "park", "bench") in one city's TypeTable.
enum class TypeId : uint32_t { Invalid = 0xFFFFFFFF };
// A rule of one Program.
enum class RuleId : uint32_t { Invalid = 0xFFFFFFFF };

template <typename Id> constexpr uint32_t index_of(Id id) { return static_cast<uint32_t>(id); }
template <typename Id> constexpr bool is_valid(Id id) { return id != Id::Invalid; }

// How an id looks inside the rule languages.
template <typename Id> constexpr double to_number(Id id) { return is_valid(id) ? double(index_of(id)) : -1.0; }

// The id that a number of the rule languages means; Invalid for anything negative, fractional, not finite or not below `count`.
template <typename Id> constexpr Id to_id(double number, size_t count) {
	if (!(number >= 0.0) || !(number < double(count)) || number != double(uint32_t(number))) {
		return Id::Invalid;
	}
	return Id(uint32_t(number));
}

} // namespace pcg
