#include "core/figure/crowd.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/random.h"
#include "core/population/names.h"

namespace pcg {

namespace {

constexpr float adult_age = 15.0f; // from here on a body has an adult's size
constexpr float elder_age = 65.0f;
constexpr float widest_step_aside = 0.45f; // metres

// The shader's tone for each of hair_colors(); its last two are the gray and white of the old.
constexpr uint8_t hair_tones[] = { 0, 1, 2, 3, 4, 5, 6 };

// The same for one person always; -0.45 .. 0.45 m to the left of the way.
float step_aside(PersonId person) {
	return (float(mix64(index_of(person)) >> 40) / float(1u << 24) * 2.0f - 1.0f) * widest_step_aside;
}

} // namespace

Looks looks_of(const Population &population, PersonId id) {
	const Person &person = population.person(id);
	const FigureAge age = person.age < adult_age ? FigureAge::Child : (person.age < elder_age ? FigureAge::Adult : FigureAge::Elder);
	Looks looks;
	looks.kind = uint8_t((person.gender == Gender::Woman ? 3 : 0) + int(age));
	looks.hair = age == FigureAge::Elder ? uint8_t(6 + index_of(id) % 2) : hair_tones[population.household(person.household).hair_color % std::size(hair_tones)];
	looks.skin = uint8_t(mix64(index_of(person.household)) % 8);
	const NamedColor &top = clothes_colors()[person.clothes_color % clothes_colors().size()];
	looks.top = glm::vec3(top.red, top.green, top.blue) / 255.0f;
	return looks;
}

Figure make_figure_of_kind(size_t kind) { return make_figure(kind >= 3, FigureAge(kind % 3)); }

Crowd::Crowd(const Population &population, std::function<SimTime()> now) : _population(&population), _now(std::move(now)) {}

uint32_t Crowd::slot_of(PersonId person) const {
	return index_of(person) < _slots.size() ? _slots[index_of(person)] : no_slot;
}

Crowd::Body *Crowd::find(PersonId person) {
	const uint32_t slot = slot_of(person);
	return slot == no_slot ? nullptr : &_bodies[slot];
}

void Crowd::spawn_agent(PersonId person, glm::vec3 position) {
	if (_slots.size() <= index_of(person)) {
		_slots.resize(_population->persons.size(), no_slot);
	}
	if (!find(person)) {
		_slots[index_of(person)] = uint32_t(_bodies.size());
		_bodies.push_back({});
		_bodies.back().person = person;
		_bodies.back().looks = looks_of(*_population, person);
	}
	place_agent(person, position, glm::vec3(0.0f, 0.0f, 1.0f), AgentPose::Stand);
}

void Crowd::walk_agent(PersonId person, std::span<const glm::vec3> path, float speed) {
	Body *body = find(person);
	if (!body || path.empty()) {
		return;
	}
	body->path.assign(path.begin(), path.end());
	body->position = path.front();
	body->speed = speed;
	body->departure = _now();
	body->segment = 0;
	body->walked_before = 0.0f;
	body->pose = AgentPose::Walk;
}

void Crowd::place_agent(PersonId person, glm::vec3 position, glm::vec3 facing, AgentPose pose) {
	if (Body *body = find(person)) {
		body->path.clear();
		body->position = position;
		body->facing = facing;
		body->pose = pose;
	}
}

void Crowd::free_agent(PersonId person) {
	const uint32_t slot = slot_of(person);
	if (slot == no_slot) {
		return;
	}
	if (slot + 1 != _bodies.size()) {
		_bodies[slot] = std::move(_bodies.back());
		_slots[index_of(_bodies[slot].person)] = slot;
	}
	_bodies.pop_back();
	_slots[index_of(person)] = no_slot;
}

void Crowd::clear() {
	_bodies.clear();
	_slots.clear();
}

glm::vec3 Crowd::position(PersonId person) const {
	const uint32_t slot = slot_of(person);
	return slot == no_slot ? glm::vec3(0.0f) : _bodies[slot].position;
}

void Crowd::advance(Body &body, SimTime time) {
	const float walked = std::max(0.0f, float((time - body.departure).in_seconds()) * body.speed);
	if (walked < body.walked_before) {
		body.segment = 0;
		body.walked_before = 0.0f;
	}
	body.walked = walked;
	while (body.segment + 1 < body.path.size()) {
		const glm::vec3 from = body.path[body.segment], way = body.path[body.segment + 1] - from;
		const float length = glm::length(way);
		if (walked <= body.walked_before + length && length > 0.0f) {
			body.facing = way / length;
			body.position = from + body.facing * (walked - body.walked_before);
			return;
		}
		body.walked_before += length;
		++body.segment;
	}
	body.position = body.path.back(); // arrived; the next call of the simulation says what follows
	body.pose = AgentPose::Stand;
	body.path.clear();
}

void Crowd::update(SimTime time) {
	for (std::vector<float> &instances : _instances) {
		instances.clear();
	}
	for (Body &body : _bodies) {
		if (!body.path.empty()) {
			advance(body, time);
		}
		write(body);
	}
}

void Crowd::write(const Body &body) {
	const float length = std::hypot(body.facing.x, body.facing.z);
	// The figure looks along -z: its z axis points away from where it goes.
	const float back_x = length > 1e-6f ? -body.facing.x / length : 0.0f, back_z = length > 1e-6f ? -body.facing.z / length : 1.0f;
	const bool walks = body.pose == AgentPose::Walk, sits = body.pose == AgentPose::Sit;
	const float aside = walks ? step_aside(body.person) : 0.0f;
	const float x = body.position.x - back_z * aside, z = body.position.z + back_x * aside;
	const float numbers[crowd_stride] = { back_z, 0.0f, back_x, x, //
		0.0f, 1.0f, 0.0f, body.position.y, //
		-back_x, 0.0f, back_z, z, //
		body.looks.top.r, body.looks.top.g, body.looks.top.b, 1.0f, //
		body.walked, walks ? 1.0f : 0.0f, sits ? 1.0f : 0.0f, float(body.looks.hair + 8 * body.looks.skin) };
	std::vector<float> &instances = _instances[body.looks.kind];
	instances.insert(instances.end(), std::begin(numbers), std::end(numbers));
}

} // namespace pcg
