#include "core/population/walking_speed.h"

#include <algorithm>
#include <array>

namespace pcg {

namespace {

struct SpeedAtAge {
	float age;
	float men;
	float women;
};

// Decades stand at their middle.
constexpr std::array<SpeedAtAge, 13> speeds{ {
		{ 0.0f, 1.10f, 1.10f },
		{ 2.99f, 1.10f, 1.10f },
		{ 3.0f, 0.86f, 0.86f },
		{ 4.0f, 1.00f, 1.00f },
		{ 5.0f, 1.08f, 1.08f },
		{ 7.0f, 1.14f, 1.14f },
		{ 25.0f, 1.358f, 1.341f },
		{ 35.0f, 1.433f, 1.337f },
		{ 45.0f, 1.434f, 1.390f },
		{ 55.0f, 1.433f, 1.313f },
		{ 65.0f, 1.339f, 1.241f },
		{ 75.0f, 1.262f, 1.132f },
		{ 90.0f, 0.968f, 0.943f },
} };

float speed_of(const SpeedAtAge &entry, Gender gender) { return gender == Gender::Man ? entry.men : entry.women; }

} // namespace

float mean_walking_speed(Gender gender, float age) {
	for (size_t i = 1; i < speeds.size(); ++i) {
		const SpeedAtAge &low = speeds[i - 1];
		const SpeedAtAge &high = speeds[i];
		if (age < high.age) {
			const float share = std::max(0.0f, (age - low.age) / (high.age - low.age));
			return speed_of(low, gender) + share * (speed_of(high, gender) - speed_of(low, gender));
		}
	}
	return speed_of(speeds.back(), gender);
}

float draw_walking_speed(Random &random, Gender gender, float age) {
	const float deviation = float(random.uniform(-0.1, 0.1));
	return std::max(slowest_walking_speed, mean_walking_speed(gender, age) * (1.0f + deviation));
}

} // namespace pcg
