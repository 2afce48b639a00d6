#include <doctest/doctest.h>

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

#include "core/figure/detail_levels.h"

using namespace pcg;

namespace {

// An eye at the origin that looks along -z, 90 degrees wide.
Eye eye_to_the_north() { return Eye::at(glm::vec3(0.0f), glm::perspective(glm::radians(90.0f), 1.0f, 0.1f, 1000.0f)); }

struct Row {
	std::vector<glm::vec3> positions;
	std::vector<DetailLevel> levels;
	DetailChooser chooser;
	DetailLimits limits{ .agent_distance = 10.0f, .agent_limit = 3, .figure_distance = 100.0f, .figure_limit = 5, .hysteresis = 0.2f, .switch_budget = 100 };

	// One body each at so many metres before the eye.
	explicit Row(std::initializer_list<float> metres) {
		for (const float metre : metres) {
			positions.push_back({ 0.0f, 0.0f, -metre });
		}
		levels.assign(positions.size(), DetailLevel::Data);
	}
	void choose() { chooser.choose(positions, levels, eye_to_the_north(), limits); }
	ptrdiff_t count(DetailLevel level) const { return std::count(levels.begin(), levels.end(), level); }
};

} // namespace

TEST_CASE("an eye sees what lies in its picture") {
	const Eye eye = eye_to_the_north();
	CHECK(eye.sees({ 0, 0, -5 }, 0.0f));
	CHECK(eye.sees({ 4.9f, 0, -5 }, 0.0f));
	CHECK_FALSE(eye.sees({ 5.1f, 0, -5 }, 0.0f));
	CHECK(eye.sees({ 5.1f, 0, -5 }, 1.0f)); // a part of it
	CHECK_FALSE(eye.sees({ 0, 0, 5 }, 1.0f)); // behind
	CHECK_FALSE(Eye().sees({ 0, 0, -5 }, 1.0f)); // shut
}

TEST_CASE("the near are agents, the further ones figures, the far ones data") {
	Row row({ 5, 50, 150 });
	row.choose();
	CHECK(row.levels == std::vector{ DetailLevel::Agent, DetailLevel::Figure, DetailLevel::Data });
	CHECK(row.chooser.comers().size() == 1);
	row.choose();
	CHECK(row.chooser.comers().empty());
	CHECK(row.chooser.leavers().empty());
}

TEST_CASE("figures out of the picture are data, agents stay so that turning round costs nothing") {
	Row row({ 5, 50, -5, -50 });
	row.choose();
	CHECK(row.levels == std::vector{ DetailLevel::Agent, DetailLevel::Figure, DetailLevel::Agent, DetailLevel::Data });
}

TEST_CASE("where a limit is reached the nearest come first") {
	Row row({ 9, 8, 7, 6, 60, 50, 40, 30, 20 });
	row.choose();
	CHECK(row.count(DetailLevel::Agent) == 3);
	CHECK(row.levels[0] == DetailLevel::Figure); // the furthest of four
	CHECK(row.count(DetailLevel::Figure) == 5);
	CHECK(row.levels[4] == DetailLevel::Data);
}

TEST_CASE("who stands on the border does not flicker") {
	Row row({ 9.9f });
	row.choose();
	for (const float metres : { 10.1f, 9.9f, 11.9f }) {
		row.positions[0].z = -metres;
		row.choose();
		CHECK(row.levels[0] == DetailLevel::Agent);
	}
	row.positions[0].z = -12.1f;
	row.choose();
	CHECK(row.levels[0] == DetailLevel::Figure);
	row.positions[0].z = -10.1f;
	row.choose();
	CHECK(row.levels[0] == DetailLevel::Figure);
}

TEST_CASE("of two who are equally near the one who is an agent stays it") {
	Row row({ 5, 9 });
	row.limits.agent_limit = 1;
	row.choose();
	row.positions[1].z = -4.5f; // nearer, but not by a fifth
	row.choose();
	CHECK(row.levels[0] == DetailLevel::Agent);
	row.positions[1].z = -4.0f;
	row.choose();
	CHECK(row.levels[1] == DetailLevel::Agent);
	CHECK(row.levels[0] == DetailLevel::Figure);
}

TEST_CASE("switches are spread over pictures, the furthest go and the nearest come first") {
	Row row({ 3, 2, 1, 4, 5 });
	row.limits.agent_limit = 10;
	row.limits.switch_budget = 2;
	row.choose();
	CHECK(row.count(DetailLevel::Agent) == 2);
	CHECK(row.levels[2] == DetailLevel::Agent);
	row.choose();
	row.choose();
	CHECK(row.count(DetailLevel::Agent) == 5);
	for (glm::vec3 &position : row.positions) {
		position.z -= 50.0f;
	}
	row.choose();
	CHECK(row.count(DetailLevel::Agent) == 3);
	CHECK(row.levels[4] == DetailLevel::Figure);
	row.limits.agent_limit = 0;
	row.choose();
	row.choose();
	CHECK(row.count(DetailLevel::Agent) == 0);
}

TEST_CASE("a body that is gone and nobody who looks are nothing special") {
	Row row({ 5, 50 });
	row.choose();
	row.chooser.choose(row.positions, row.levels, Eye(), row.limits);
	CHECK(row.count(DetailLevel::Data) == 2);
	row.chooser.choose({}, {}, eye_to_the_north(), row.limits);
	CHECK(row.chooser.comers().empty());
}
