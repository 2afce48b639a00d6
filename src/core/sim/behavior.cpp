#include "core/sim/behavior.h"

#include <glm/geometric.hpp>

#include "core/agenda/agenda_generator.h"
#include "core/sim/saved_state.h"
#include "core/sim/simulation.h"

namespace pcg {

namespace {

// A rule that loops without ever waiting must not hold the simulation up: loops that take less than `shortest_rest` a round end at max_depth.
constexpr VmLimits behavior_limits{ .max_depth = 1000, .max_steps = 1'000'000, .max_stack = 4096 };
constexpr Duration shortest_rest = Duration{ 1000 };
constexpr uint64_t rule_stream = 0x72756C65; // keeps draws of rules apart from those for floating slots
constexpr float arm_length = 0.01f; // metres within which a person stands at its place

} // namespace

Behavior::Behavior(Simulation &simulation, const agenda::World &world, const SimulationSettings &settings)
	: agenda::Context(world), _simulation(simulation), _seed(settings.seed), _vm(*world.program, *this, behavior_limits, &simulation._rule_stacks) {
	for (const AttributeOverride &attribute : settings.overrides) {
		override_attribute(_vm, attribute);
	}
}

RunState Behavior::begin(PersonId person, RuleId rule) {
	_person = person;
	_rule = rule;
	_pose = AgentPose::Stand;
	_uses_on_arrival = false;
	set_household(population().person(person).household);
	set_focus(person);
	_vm.begin(household_seed(_seed, household_id()));
	_random = Random(derive_seed(derive_seed(_seed, rule_stream), index_of(person)), uint64_t(_simulation.now().ms));
	_vm.use_random(_random);
	return _vm.call(rule);
}

RunState Behavior::resume() {
	if (_uses_on_arrival) {
		_uses_on_arrival = false;
		_simulation.use_place(_person, _pose);
	}
	return _vm.resume();
}

void Behavior::end() {
	if (_vm.is_paused()) {
		_vm.abandon();
	}
}

SavedBehavior Behavior::save() const {
	return { _person, _rule, _pose, _uses_on_arrival, _random.key(), _random.counter(), _vm.save() };
}

bool Behavior::restore(const SavedBehavior &saved) {
	if (index_of(saved.person) >= population().persons.size() || !_vm.restore(saved.run)) {
		return false;
	}
	_person = saved.person;
	_rule = saved.rule;
	_pose = saved.pose;
	_uses_on_arrival = saved.uses_on_arrival;
	set_household(population().person(_person).household);
	set_focus(_person);
	_random.restore(saved.random_key, saved.random_counter);
	_vm.use_random(_random);
	return true;
}

// Until the person's due moment.
Flow Behavior::pause() {
	if (_simulation.record(_person).due >= _simulation.now() + shortest_rest) {
		_vm.drop_finished_callers();
	}
	return Flow::Pause;
}

Flow Behavior::wait(double seconds) {
	if (!(seconds > 0.0)) {
		return Flow::Next;
	}
	_simulation.record(_person).due = _simulation.now() + Duration::seconds(seconds);
	return pause();
}

Flow Behavior::wait_until_next_task() {
	_simulation.record(_person).due = never;
	return pause();
}

Flow Behavior::stay_inside(double seconds) {
	if (_simulation.is_outside(_person)) {
		_vm.warn("stay-outdoors", "stayInside(seconds) while the person is outdoors: it waits there",
				"call goToBuilding(building) before it");
	}
	return wait(seconds);
}

Flow Behavior::go_to_building(double number) {
	const BuildingId building = building_of(number);
	if (!is_valid(building)) {
		_simulation.emit(_person, SimEventKind::Unreachable);
		return Flow::Stop;
	}
	const PersonRecord &record = _simulation.record(_person);
	if (record.state == PersonState::Inside && record.target().building() == building) {
		return Flow::Next;
	}
	return _simulation.go_to_building(_person, building, Purpose::Rule) ? pause() : Flow::Stop;
}

Flow Behavior::go_to_zone(const Text &type) {
	glm::vec3 position{ 0.0f };
	glm::vec3 entry{ 0.0f };
	const TypeId id = find_type(_vm, type, agenda::TypeUse::Zone);
	ZoneId zone = ZoneId::Invalid;
	if (is_valid(id) && present_position(position)) {
		zone = paths().nearest_zone(id, position, entry);
		if (!is_valid(zone) && _simulation.is_outside(_person) && paths().nearest_walkable(position, position)) {
			zone = paths().nearest_zone(id, position, entry); // it is where nobody can walk
		}
	}
	if (!is_valid(zone)) {
		_simulation.emit(_person, SimEventKind::Unreachable);
		return Flow::Stop;
	}
	return _simulation.go_to_point(_person, target_of(zone), entry, Purpose::Rule) ? pause() : Flow::Stop;
}

bool Behavior::find_object(double number, ObjectId &object) {
	object = object_of(number);
	if (is_valid(object) && !city().object(object).is_removed) {
		return _simulation.reserve_place(_person, object);
	}
	_simulation.emit(_person, SimEventKind::Unreachable);
	return false;
}

Flow Behavior::go_to_object(double number) {
	ObjectId object = ObjectId::Invalid;
	if (!find_object(number, object)) {
		return Flow::Stop;
	}
	const Place &place = city().object(object).places[_simulation.record(_person).object_place];
	const bool goes = _simulation.go_to_point(_person, target_of(object), place.position, Purpose::Rule);
	return goes ? pause() : Flow::Stop;
}

Flow Behavior::interact(double number, std::string_view action) {
	ObjectId object = ObjectId::Invalid;
	if (!find_object(number, object)) {
		return Flow::Stop;
	}
	_pose = action == "sit" ? AgentPose::Sit : AgentPose::Stand;
	const PersonRecord &record = _simulation.record(_person);
	const Place &place = city().object(object).places[record.object_place];
	if (record.pose == AgentPose::Sit && _pose == AgentPose::Sit) {
		return Flow::Next; // on that seat: it has reserved no other
	}
	if (record.state != PersonState::Inside && glm::distance(record.position, place.position) <= arm_length) {
		_simulation.use_place(_person, _pose);
		return Flow::Next;
	}
	_uses_on_arrival = true;
	const bool goes = _simulation.go_to_point(_person, target_of(object), place.position, Purpose::Rule);
	return goes ? pause() : Flow::Stop;
}

Value Behavior::day(Vm &) { return Value::of(double(_simulation.now().weekday())); }

Value Behavior::time(Vm &) { return Value::of(_simulation.now().time_of_day().in_seconds()); }

bool Behavior::present_position(glm::vec3 &position) const {
	position = _simulation.position(_person);
	const PersonRecord &record = _simulation.record(_person);
	return record.state != PersonState::Inside || is_valid(record.target().building());
}

bool Behavior::has_free_place(ObjectId object) const {
	return _simulation.record(_person).reserved_object == index_of(object) || _simulation.is_place_free(object);
}

void Behavior::report(Diagnostic diagnostic) {
	if (_simulation._is_replaying) {
		return;
	}
	if (diagnostic.id != agenda::missing_type_id) {
		diagnostic.message += " (" + name_of(_person) + " of " + name_of(household_id()) + ", day " + std::to_string(_simulation.now().day()) + ", " +
				clock_text(_simulation.now().time_of_day(), true) + ")";
	}
	if (diagnostic.severity == Severity::Error) {
		_simulation.emit(_person, SimEventKind::RuleFailed);
	}
	_simulation.note(std::move(diagnostic));
}

} // namespace pcg
