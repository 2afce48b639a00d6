#include "core/base/file_ids.h"

namespace pcg {

bool FileIds::add(int64_t number) {
	constexpr int64_t most = int64_t(1) << 53;
	_are_exact = _are_exact && number >= 0 && number <= most;
	_numbers.push_back(number);
	return _indices.emplace(number, uint32_t(_numbers.size() - 1)).second;
}

uint32_t FileIds::index_of(int64_t number) const {
	const auto found = _indices.find(number);
	return found == _indices.end() ? 0xFFFFFFFF : found->second;
}

FileNumbers FileNumbers::exact() const {
	FileNumbers result = *this;
	for (const FileIds **ids : { &result.buildings, &result.zones, &result.objects, &result.households, &result.persons }) {
		*ids = *ids != nullptr && (*ids)->are_exact() ? *ids : nullptr;
	}
	return result;
}

} // namespace pcg
