#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "core/navigation/sight.h"

// The straight walks from all corners of a mesh, two bytes each and one more word a group: where they lead and on what ground. What they cost is
// worked out from that.
// Walks of a corner lie in groups on one kind of ground each: a word of how many, whether they lead far off, and which ground; then for each walk how much
// the number of the corner there is more than the number here, or its number in two words if that is far off.
namespace pcg {

class PackedWalks {
public:
	// So many different costs of a metre are told apart; of more, some stand for those next to them.
	static constexpr size_t most_grounds = 1024;

	PackedWalks() = default;
	// `points`: of the corners, perhaps followed by others. `grounds`: what a metre costs on each kind, each cost once, from cheap to dear.
	PackedWalks(std::span<const glm::vec3> points, std::span<const float> grounds, const CornerWalks &walks);

	// Calls `action(there, ground)` for all walks from a corner; a walk costs as much as it is long times `ground`.
	template <typename Action> void for_walks(uint32_t corner, Action action) const {
		const uint16_t *at = _words.data() + _first[corner], *const end = _words.data() + _first[corner + 1];
		while (at != end) {
			const uint16_t group = *at++;
			const float ground = _grounds[group >> ground_shift];
			for (size_t left = group & most_in_group; left > 0; --left) {
				uint32_t there = corner + uint32_t(int16_t(*at++));
				if (group & far_off) {
					there = at[-1] | uint32_t(at[0]) << 16;
					++at;
				}
				action(there, ground);
			}
		}
	}
	// The same with what each costs, sorted by ground and corner.
	std::vector<SeenCorner> of(std::span<const glm::vec3> points, uint32_t corner) const;

private:
	static constexpr uint16_t most_in_group = 31, far_off = 32;
	static constexpr uint32_t ground_shift = 6;

	uint16_t ground_of(float cost) const;
	void add_group(uint32_t corner, uint16_t group, std::span<const std::pair<uint16_t, uint32_t>> walks);

	std::vector<float> _grounds;
	std::vector<uint32_t> _first; // words; one more than corners
	std::vector<uint16_t> _words;
};

} // namespace pcg
