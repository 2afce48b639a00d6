#pragma once

#include <string_view>

#include "core/agenda/context.h"
#include "core/base/random.h"
#include "core/lang/vm.h"
#include "core/ports/agent_host.h"

namespace pcg {

class Simulation;
struct SavedBehavior;
struct SimulationSettings;

// A delayed rule while it runs (PCG language, section 6): an interpreter that can be put aside, and what its operations do to the person.
// Used again for the next person when it is over.
class Behavior : public agenda::Context {
public:
	Behavior(Simulation &simulation, const agenda::World &world, const SimulationSettings &settings);

	RunState begin(PersonId person, RuleId rule);
	RunState resume();
	void end();
	// From its beginning, for the same person.
	RunState begin_again() {
		end();
		return begin(_person, _rule);
	}

	// While it is paused; false: the saved run is damaged, or of another program.
	SavedBehavior save() const;
	bool restore(const SavedBehavior &saved);
	RuleId rule() const { return _rule; }

	// The operations; Pause: resume() is called when it is done, Stop: the rule ends.
	Flow wait(double seconds);
	Flow wait_until_next_task();
	Flow stay_inside(double seconds);
	Flow go_to_building(double building);
	Flow go_to_zone(const Text &type);
	Flow go_to_object(double object);
	Flow interact(double object, std::string_view action);

	bool is_simulating() const override { return true; }
	Value day(Vm &vm) override;
	Value time(Vm &vm) override;
	bool present_position(glm::vec3 &position) const override;
	bool has_free_place(ObjectId object) const override;
	void report(Diagnostic diagnostic) override;

private:
	PersonId person() const { return _person; }
	Flow pause();
	bool find_object(double number, ObjectId &object);

	Simulation &_simulation;
	uint64_t _seed;
	PersonId _person = PersonId::Invalid; // not the focus: rules may change that in members {}
	RuleId _rule = RuleId::Invalid;
	bool _uses_on_arrival = false; // interact() had to walk to the object first
	AgentPose _pose = AgentPose::Stand;
	Random _random;
	Vm _vm;
};

} // namespace pcg
