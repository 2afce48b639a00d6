#include "core/navigation/packed_walks.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/base/shrink.h"

namespace pcg {

PackedWalks::PackedWalks(std::span<const glm::vec3> points, std::span<const float> grounds, const CornerWalks &walks) {
	const size_t count = std::min(grounds.size(), most_grounds);
	for (size_t i = 0; i < count; ++i) {
		_grounds.push_back(grounds[i * grounds.size() / count]);
	}
	shrink(_grounds);
	_first.reserve(walks.size() + 1);
	_first.push_back(0);
	std::vector<std::pair<uint16_t, uint32_t>> sorted; // by group
	for (uint32_t corner = 0; corner < walks.size(); ++corner) {
		sorted.clear();
		for (const SeenCorner &seen : walks[corner]) {
			const auto more = int64_t(seen.corner) - int64_t(corner);
			const uint16_t ground = ground_of(seen.cost / glm::distance(points[corner], points[seen.corner]));
			sorted.push_back({ uint16_t(ground << ground_shift | (more == int16_t(more) ? 0 : far_off)), seen.corner });
		}
		std::sort(sorted.begin(), sorted.end());
		for (size_t first = 0, end = 0; first < sorted.size(); first = end) {
			while (end < sorted.size() && sorted[end].first == sorted[first].first && end - first < most_in_group) {
				++end;
			}
			add_group(corner, sorted[first].first, { sorted.data() + first, end - first });
		}
		_first.push_back(uint32_t(_words.size()));
	}
	shrink(_words);
}

// The index of the nearest.
uint16_t PackedWalks::ground_of(float cost) const {
	const auto dearer = std::lower_bound(_grounds.begin(), _grounds.end(), cost);
	const bool is_cheaper = dearer == _grounds.end() || (dearer != _grounds.begin() && cost - dearer[-1] < *dearer - cost);
	return uint16_t(dearer - _grounds.begin() - (is_cheaper ? 1 : 0));
}

void PackedWalks::add_group(uint32_t corner, uint16_t group, std::span<const std::pair<uint16_t, uint32_t>> walks) {
	_words.push_back(uint16_t(group | walks.size()));
	for (const auto &[same_group, there] : walks) {
		if (group & far_off) {
			_words.insert(_words.end(), { uint16_t(there), uint16_t(there >> 16) });
		} else {
			_words.push_back(uint16_t(there - corner));
		}
	}
}

std::vector<SeenCorner> PackedWalks::of(std::span<const glm::vec3> points, uint32_t corner) const {
	std::vector<SeenCorner> walks;
	walks.reserve(_first[corner + 1] - _first[corner]);
	for_walks(corner, [&](uint32_t there, float ground) { walks.push_back({ there, ground * glm::distance(points[corner], points[there]) }); });
	return walks;
}

} // namespace pcg
