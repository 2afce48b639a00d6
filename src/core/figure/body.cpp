#include "core/figure/body.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/random.h"

namespace pcg {

namespace {

constexpr float widest_step_aside = 0.45f; // metres
constexpr float aside_over = 1.5f; // metres of way after setting out, and before arriving, over which it steps aside
constexpr float turn_rate = 9.0f; // 1/s
constexpr float homing_speed = 0.7f; // m/s beside the path
constexpr float hurry = 1.5f; // times the natural speed on the way back
constexpr float patience = 5.0f; // seconds without coming nearer
constexpr float least_progress = 0.25f; // metres
constexpr float slowest_walk = 0.15f; // m/s that look like walking
constexpr float look_ahead_within = 0.3f; // metres from its place up to which it looks where its path leads

// The same for one person always; -0.45 .. 0.45 m to the left of the way, so that a family does not walk inside itself.
float step_aside(PersonId person) { return (float(mix64(index_of(person)) >> 40) / float(1u << 24) * 2.0f - 1.0f) * widest_step_aside; }

glm::vec3 flat(glm::vec3 vector) { return { vector.x, 0.0f, vector.z }; }

void turn(glm::vec3 &facing, glm::vec3 aim, float share) {
	const glm::vec3 goal = flat(aim), turned = facing + (goal - facing) * share;
	const float length = glm::length(turned);
	facing = length > 1e-3f ? turned / length : (glm::dot(goal, goal) > 0.0f ? goal : facing);
}

bool find_way_back(Body &body, glm::vec3 from, Surroundings &around) {
	if (around.ways_left == 0) {
		return false;
	}
	--around.ways_left;
	if (around.paths) {
		around.paths->find_path(from, body.place, body.way_back);
	}
	if (body.way_back.empty()) {
		body.way_back.assign({ from, body.place }); // off the ground: straight back
	}
	body.way_next = 1;
	return true;
}

// Along the way back at a brisk pace; at its end, for the place moved on meanwhile, along the next.
glm::vec3 walk_back(Body &body, Surroundings &around) {
	float metres = body.natural_speed * hurry * around.seconds;
	glm::vec3 at = body.position;
	for (int way = 0; way < 2 && (!body.way_back.empty() || find_way_back(body, at, around)); ++way) {
		for (; body.way_next < body.way_back.size(); ++body.way_next) {
			const glm::vec3 goal = body.way_back[body.way_next];
			const float length = glm::distance(at, goal);
			if (length > metres) {
				return at + (goal - at) * (metres / length);
			}
			at = goal;
			metres -= length;
		}
		body.way_back.clear();
	}
	return at;
}

void forget_way_back(Body &body) {
	body.way_back.clear();
	body.nearest_gap = 0.0f;
	body.stalled = 0.0f;
	body.is_carried = false;
}

// Whoever moves itself and comes no nearer for a while is stuck.
void watch_progress(Body &body, float gap, float seconds) {
	if (body.nearest_gap == 0.0f || gap < body.nearest_gap - least_progress) {
		body.nearest_gap = gap;
		body.stalled = 0.0f;
	} else {
		body.stalled += seconds;
		body.is_carried |= body.stalled > patience;
	}
}

glm::vec3 next_position(Body &body, glm::vec3 before, bool is_seen, Surroundings &around) {
	const glm::vec3 drift = body.position - before;
	const float gap = glm::length(drift);
	if (gap < back_home) {
		forget_way_back(body);
		return body.place;
	}
	if (body.is_astray(before)) {
		if (!is_seen) {
			forget_way_back(body);
			body.was_placed = true;
			return body.place;
		}
		watch_progress(body, gap, around.seconds);
		return gap > astray_distance ? walk_back(body, around) : body.place + drift * std::max(0.0f, 1.0f - hurry * around.seconds / gap);
	}
	forget_way_back(body);
	return body.place + drift * std::max(0.0f, 1.0f - homing_speed * around.seconds / gap);
}

} // namespace

float turned_within(float seconds) { return 1.0f - std::exp(-turn_rate * seconds); }

bool Body::is_astray(glm::vec3 before) const {
	const glm::vec3 drift = position - before;
	return is_carried || glm::dot(drift, drift) > astray_distance * astray_distance;
}

float Body::gap() const { return glm::distance(position, place); }

void Body::set_out(std::span<const glm::vec3> way, float metres_per_second, SimTime now) {
	path.assign(way.begin(), way.end());
	length = 0.0f;
	for (size_t i = 0; i + 1 < path.size(); ++i) {
		length += glm::distance(path[i], path[i + 1]);
	}
	on_path = path.front();
	speed = metres_per_second;
	departure = now;
	segment = 0;
	walked_before = 0.0f;
	walked = 0.0f;
	pose = AgentPose::Walk;
}

void Body::stand(glm::vec3 where, glm::vec3 look, AgentPose how) {
	path.clear();
	on_path = where;
	aim = look;
	pose = how;
}

void Body::settle() {
	place = on_path;
	position = place;
	facing = glm::length(flat(aim)) > 0.0f ? glm::normalize(flat(aim)) : facing;
	heading = facing;
	shown_pose = pose;
	was_placed = true;
	forget_way_back(*this);
}

void Body::advance(SimTime time, float turned) {
	if (!path.empty()) {
		const float metres = std::max(0.0f, float((time - departure).in_seconds()) * speed);
		if (metres < walked_before) {
			segment = 0;
			walked_before = 0.0f;
		}
		walked = metres;
		while (segment + 1 < path.size()) {
			const glm::vec3 way = path[segment + 1] - path[segment];
			const float step = glm::length(way);
			if (walked <= walked_before + step && step > 0.0f) {
				aim = way / step;
				on_path = path[segment] + aim * (walked - walked_before);
				break;
			}
			walked_before += step;
			++segment;
		}
		if (segment + 1 >= path.size()) { // arrived; the next call of the simulation says what follows
			stand(path.back(), aim, AgentPose::Stand);
		}
	}
	turn(facing, aim, turned);
	turn(heading, aim, turned);
	const float share = path.empty() ? 0.0f : std::clamp(std::min(walked, length - walked) / aside_over, 0.0f, 1.0f);
	place = on_path + glm::vec3(heading.z, 0.0f, -heading.x) * (step_aside(person) * share);
}

void step_body(Body &body, glm::vec3 before, bool is_seen, Surroundings &around) {
	body.was_placed = false;
	const bool is_home = glm::distance(body.position, before) < back_home;
	const glm::vec3 next = next_position(body, before, is_seen, around), way = next - body.position;
	body.velocity = around.seconds > 0.0f ? way / around.seconds : glm::vec3(0.0f);
	if (body.moves_itself && !body.was_placed && !body.is_carried) {
		return; // move_body() follows
	}
	if (is_home || body.was_placed) {
		body.position = next;
		body.shown_pose = body.pose;
	} else {
		move_body(body, next, around);
	}
	body.was_placed |= body.is_carried;
}

void move_body(Body &body, glm::vec3 position, const Surroundings &around) {
	const float metres = glm::distance(position, body.position);
	if (around.seconds > 0.0f) {
		const bool walks = metres > slowest_walk * around.seconds;
		body.strayed += metres - (body.path.empty() ? 0.0f : body.speed * around.seconds);
		body.shown_pose = walks ? AgentPose::Walk : (body.pose == AgentPose::Walk ? AgentPose::Stand : body.pose);
		if (walks && glm::distance(position, body.place) > look_ahead_within) {
			turn(body.facing, (position - body.position) / metres, around.turned);
		}
	}
	body.position = position;
}

} // namespace pcg
