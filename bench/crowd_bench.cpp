// Bodies in the core: what a frame costs that moves everybody, chooses who is shown how and writes the figures; and that it takes no memory. Everybody
// walks to and fro on a field of 500 m, the camera flies over it. No peer.
#include <chrono>
#include <cmath>
#include <cstdint>
#include <string>

#include <glm/gtc/matrix_transform.hpp>

#include "bench/allocation_count.h"
#include "bench/figure.h"
#include "core/base/random.h"
#include "core/figure/crowd.h"

using namespace pcg;

namespace {

constexpr float field = 500.0f; // metres
constexpr int frames = 600;
constexpr int first_frames = 300; // until lists have grown

Population make_people(uint32_t count) {
	Population population;
	population.households.push_back({ .first_member = PersonId(0), .member_count = uint16_t(count) });
	for (uint32_t i = 0; i < count; ++i) {
		population.persons.push_back({ .household = HouseholdId(0), .age = float(i % 90) });
	}
	return population;
}

Eye eye_over(float time) {
	const glm::vec3 position(field / 2.0f + 200.0f * std::cos(time), 30.0f, field / 2.0f + 200.0f * std::sin(time));
	const glm::vec3 ahead = position + glm::vec3(-std::sin(time), -0.4f, std::cos(time));
	return Eye::at(position, glm::perspective(1.0f, 1.6f, 0.1f, 1000.0f) * glm::lookAt(position, ahead, glm::vec3(0, 1, 0)));
}

void measure(uint32_t count, const std::string &name) {
	const Population population = make_people(count);
	SimTime now;
	Crowd crowd(population, nullptr, [&] { return now; });
	Random random(1);
	for (uint32_t i = 0; i < count; ++i) {
		const glm::vec3 home(float(random.uniform()) * field, 0.0f, float(random.uniform()) * field);
		const glm::vec3 path[] = { home, home + glm::vec3(40, 0, 0), home + glm::vec3(40, 0, 40) };
		crowd.spawn_agent(PersonId(i), home);
		crowd.walk_agent(PersonId(i), path, 1.3f);
	}
	const auto live = [&](int begin, int end) {
		for (int frame = begin; frame < end; ++frame) {
			now = SimTime{ frame * 16 };
			crowd.update(now, eye_over(float(frame) * 0.002f), {});
			crowd.write_figures();
		}
	};
	live(0, first_frames);
	const uint64_t before = bench::heap.allocations;
	const auto start = std::chrono::steady_clock::now();
	live(first_frames, first_frames + frames);
	const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
	bench::print(name + "_frame", seconds / frames * 1000.0, "ms");
	bench::print(name + "_allocations_per_frame", double(bench::heap.allocations - before) / frames, "allocations");
}

} // namespace

int main() {
	measure(2'000, "crowd_2k");
	measure(20'000, "crowd_20k");
	return 0;
}
