#include "core/figure/crowd.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace pcg {

namespace {

constexpr float longest_step = 3600.0f; // seconds that somebody can have been on the way in
constexpr uint32_t ways_a_step = 4; // looked for at once; the others wait for the next picture
constexpr float near_door = 0.1f; // metres at which somebody who follows its person indoors is gone
constexpr float leaves_late = 0.5f; // metres from the door from which on it follows
constexpr float seen_radius = 1.0f; // metres

} // namespace

Crowd::Crowd(const Population &population, const PathProvider *paths, std::function<SimTime()> now) : _population(&population), _now(std::move(now)) {
	_around.paths = paths;
	_last = _now();
}

Body *Crowd::find(PersonId person) {
	const uint32_t slot = slot_of(person);
	return slot == no_slot ? nullptr : &_bodies[slot];
}

uint32_t Crowd::find_leaving(PersonId person) const {
	for (uint32_t slot = 0; slot < _bodies.size() && _leaving > 0; ++slot) {
		if (_bodies[slot].is_leaving && _bodies[slot].person == person) {
			return slot;
		}
	}
	return no_slot;
}

// Whoever steps out again while its body is still on its way in goes on with that body.
void Crowd::spawn_agent(PersonId person, glm::vec3 position) {
	if (_slots.size() <= index_of(person)) {
		_slots.resize(_population->persons.size(), no_slot);
	}
	if (find(person)) {
		place_agent(person, position, glm::vec3(0.0f, 0.0f, 1.0f), AgentPose::Stand);
		return;
	}
	uint32_t slot = find_leaving(person);
	if (slot != no_slot) {
		_bodies[slot].is_leaving = false;
		--_leaving;
		_bodies[slot].stand(position, _bodies[slot].aim, AgentPose::Stand);
	} else {
		slot = uint32_t(_bodies.size());
		_bodies.push_back(_spare.empty() ? Body() : std::move(_spare.back()));
		if (!_spare.empty()) {
			_spare.pop_back();
		}
		Body &body = _bodies.back();
		body.person = person;
		body.looks = looks_of(*_population, person);
		body.natural_speed = _population->person(person).walking_speed;
		body.walked = body.strayed = 0.0f;
		body.has_scene = body.moves_itself = body.is_leaving = false;
		body.shows_figure = true;
		body.stand(position, glm::vec3(0.0f, 0.0f, 1.0f), AgentPose::Stand);
		body.settle();
		_positions.push_back(position);
		_levels.push_back(DetailLevel::Data);
	}
	_slots[index_of(person)] = slot;
}

void Crowd::walk_agent(PersonId person, std::span<const glm::vec3> path, float speed) {
	Body *body = find(person);
	if (body && !path.empty()) {
		body->set_out(path, speed, _now());
	}
}

void Crowd::place_agent(PersonId person, glm::vec3 position, glm::vec3 facing, AgentPose pose) {
	if (Body *body = find(person)) {
		body->stand(position, facing, pose);
	}
}

void Crowd::free_agent(PersonId person) {
	const uint32_t slot = slot_of(person);
	if (slot == no_slot) {
		return;
	}
	_slots[index_of(person)] = no_slot;
	Body &body = _bodies[slot];
	if (_levels[slot] == DetailLevel::Data || body.gap() < leaves_late || !is_seen(_eye, _limits, body.position)) {
		drop(slot);
		return;
	}
	body.stand(body.path.empty() ? body.on_path : body.path.back(), body.aim, AgentPose::Stand);
	lose_scene(slot);
	body.is_leaving = true;
	++_leaving;
}

void Crowd::drop(uint32_t slot) {
	_leaving -= _bodies[slot].is_leaving;
	if (slot + 1 != _bodies.size()) {
		std::swap(_bodies[slot], _bodies.back());
		_positions[slot] = _positions.back();
		_levels[slot] = _levels.back();
		if (!_bodies[slot].is_leaving) {
			_slots[index_of(_bodies[slot].person)] = slot;
		}
	}
	_spare.push_back(std::move(_bodies.back()));
	_bodies.pop_back();
	_positions.pop_back();
	_levels.pop_back();
}

void Crowd::clear() {
	_bodies.clear();
	_positions.clear();
	_levels.clear();
	_spare.clear();
	_slots.clear();
	_leaving = 0;
}

bool Crowd::is_seen(const Eye &eye, const DetailLimits &limits, glm::vec3 point) const {
	return glm::distance(eye.position, point) < std::max(limits.figure_distance, limits.agent_distance) && eye.sees(point, seen_radius);
}

void Crowd::update(SimTime time, const Eye &eye, const DetailLimits &limits) {
	const float seconds = float((time - _last).in_seconds());
	const bool is_jump = seconds < 0.0f || seconds > longest_step;
	_last = time;
	_eye = eye;
	_limits = limits;
	_around.seconds = is_jump ? 0.0f : seconds;
	_around.turned = turned_within(_around.seconds);
	_around.ways_left = ways_a_step;
	drop_leavers(eye, is_jump);
	for (size_t i = 0; i < _bodies.size(); ++i) {
		Body &body = _bodies[i];
		const glm::vec3 before = body.place;
		body.advance(time, _around.turned);
		if (is_jump) {
			body.settle();
		} else {
			const bool is_visible = body.is_astray(before) && (is_seen(eye, limits, body.position) || is_seen(eye, limits, body.place));
			step_body(body, before, is_visible, _around);
		}
		_positions[i] = body.position;
	}
	_chooser.choose(_positions, _levels, eye, limits);
	for (const uint32_t slot : _chooser.leavers()) {
		lose_scene(slot);
	}
	_new_agents.clear();
	for (const uint32_t slot : _chooser.comers()) {
		if (_bodies[slot].is_leaving) { // nobody is there whom a scene could show
			_levels[slot] = DetailLevel::Figure;
		} else {
			_new_agents.push_back(slot);
		}
	}
}

void Crowd::drop_leavers(const Eye &eye, bool is_settled) {
	for (size_t i = _bodies.size(); i-- > 0 && _leaving > 0;) {
		if (_bodies[i].is_leaving && (is_settled || _bodies[i].gap() < near_door || !is_seen(eye, _limits, _bodies[i].position))) {
			drop(uint32_t(i));
		}
	}
}

void Crowd::set_scene(uint32_t slot, bool moves_itself, bool shows_figure) {
	_bodies[slot].has_scene = true;
	_bodies[slot].moves_itself = moves_itself;
	_bodies[slot].shows_figure = shows_figure;
}

void Crowd::lose_scene(uint32_t slot) {
	set_scene(slot, false, true);
	_bodies[slot].has_scene = false;
	if (_levels[slot] == DetailLevel::Agent) {
		_levels[slot] = DetailLevel::Figure;
	}
}

void Crowd::move_agent(uint32_t slot, glm::vec3 position) {
	move_body(_bodies[slot], position, _around);
	_positions[slot] = position;
}

glm::vec3 Crowd::position(PersonId person) const {
	const uint32_t slot = slot_of(person);
	return slot == no_slot ? glm::vec3(0.0f) : _bodies[slot].on_path;
}

// Bodies are taken for three balls above each other, a little larger far off, where a pixel is wide.
PersonId Crowd::pick(glm::vec3 origin, glm::vec3 direction, float reach) const {
	PersonId best = PersonId::Invalid;
	for (size_t i = 0; i < _bodies.size(); ++i) {
		for (const float height : { 0.3f, 0.85f, 1.4f }) {
			const glm::vec3 middle = _positions[i] + glm::vec3(0.0f, height, 0.0f) - origin;
			const float along = glm::dot(middle, direction);
			const float radius = std::max(0.35f, 0.008f * along);
			const bool is_shown = _levels[i] != DetailLevel::Data && !_bodies[i].is_leaving;
			if (is_shown && along > 0.0f && along < reach && glm::dot(middle, middle) - along * along < radius * radius) {
				reach = along;
				best = _bodies[i].person;
			}
		}
	}
	return best;
}

void Crowd::write_figures() {
	for (std::vector<float> &figures : _figures) {
		figures.clear();
	}
	for (size_t i = 0; i < _bodies.size(); ++i) {
		const Body &body = _bodies[i];
		if (_levels[i] == DetailLevel::Data || (_levels[i] == DetailLevel::Agent && !body.shows_figure)) {
			continue;
		}
		// The figure looks along -z: its z axis points away from where it goes.
		const float back_x = -body.facing.x, back_z = -body.facing.z;
		const float walks = body.shown_pose == AgentPose::Walk ? 1.0f : 0.0f, sits = body.shown_pose == AgentPose::Sit ? 1.0f : 0.0f;
		const float numbers[crowd_stride] = { back_z, 0.0f, back_x, body.position.x, //
			0.0f, 1.0f, 0.0f, body.position.y, //
			-back_x, 0.0f, back_z, body.position.z, //
			body.looks.top.r, body.looks.top.g, body.looks.top.b, 1.0f, //
			body.walked + body.strayed, walks, sits, float(body.looks.hair + 8 * body.looks.skin) };
		std::vector<float> &figures = _figures[body.looks.kind];
		figures.insert(figures.end(), std::begin(numbers), std::end(numbers));
	}
}

} // namespace pcg
