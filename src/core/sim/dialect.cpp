#include "core/sim/dialect.h"

#include <cmath>
#include <optional>
#include <string>

#include "core/agenda/dialect.h"
#include "core/sim/behavior.h"

namespace pcg {

namespace {

// While agendas are written there is no behavior: the operation is disregarded.
Behavior *behavior_of(Vm &vm) {
	agenda::Context &context = agenda::context_of(vm);
	return context.is_simulating() ? static_cast<Behavior *>(&context) : nullptr;
}

Flow op_wait(Vm &vm, const Args &args) {
	Behavior *behavior = behavior_of(vm);
	return behavior ? behavior->wait(args.number(0)) : Flow::Next;
}

Flow op_wait_until_next_task(Vm &vm, const Args &) {
	Behavior *behavior = behavior_of(vm);
	return behavior ? behavior->wait_until_next_task() : Flow::Next;
}

Flow op_stay_inside(Vm &vm, const Args &args) {
	Behavior *behavior = behavior_of(vm);
	return behavior ? behavior->stay_inside(args.number(0)) : Flow::Next;
}

Flow op_go_to_building(Vm &vm, const Args &args) {
	Behavior *behavior = behavior_of(vm);
	return behavior ? behavior->go_to_building(args.number(0)) : Flow::Next;
}

Flow op_go_to_zone(Vm &vm, const Args &args) {
	Behavior *behavior = behavior_of(vm);
	return behavior ? behavior->go_to_zone(*args[0].text) : Flow::Next;
}

Flow op_go_to_object(Vm &vm, const Args &args) {
	Behavior *behavior = behavior_of(vm);
	return behavior ? behavior->go_to_object(args.number(0)) : Flow::Next;
}

Flow op_interact(Vm &vm, const Args &args) {
	Behavior *behavior = behavior_of(vm);
	const std::string_view action = args.count() > 1 ? args[1].text->view : std::string_view("use");
	return behavior ? behavior->interact(args.number(0), action) : Flow::Next;
}

std::optional<CallProblem> check_seconds(const KnownCall &call) {
	const Value &seconds = call.arguments[0];
	if (!seconds.is_number() || (seconds.number > 0.0 && std::isfinite(seconds.number))) {
		return std::nullopt;
	}
	if (seconds.number > 0.0) {
		return CallProblem{ "no-length", "'" + std::string(call.operation) + "' never ends: the time is infinite",
			"waitUntilNextTask() waits until the time of the rule is over" };
	}
	return CallProblem{ "no-length", "'" + std::string(call.operation) + "' does not wait: the time is not above 0", "it is a span in seconds, as in 10m" };
}

void add_operation(Dialect &dialect, std::string_view name, std::vector<ParamSpec> params, OperationHandler handler,
		std::string_view help, ConstantCheck check = nullptr) {
	OperationSpec spec;
	spec.name = name;
	spec.params = std::move(params);
	spec.handler = handler;
	spec.help = help;
	spec.phase = Phase::Simulation;
	spec.check = check;
	dialect.operations.push_back(std::move(spec));
}

void add_simulation_operations(Dialect &dialect) {
	const ParamSpec seconds{ .name = "seconds", .kind = ParamKind::Number };
	const ParamSpec building{ .name = "building", .kind = ParamKind::Number };
	const ParamSpec object{ .name = "object", .kind = ParamKind::Number };
	const ParamSpec type{ .name = "type", .kind = ParamKind::Text };
	const ParamSpec action{ .name = "action", .kind = ParamKind::Text, .is_optional = true };
	add_operation(dialect, "wait", { seconds }, op_wait, "Stands idle for that long; inside a building it stays inside.",
			check_seconds);
	add_operation(dialect, "waitUntilNextTask", {}, op_wait_until_next_task,
			"Idle until the time of this rule is over.");
	add_operation(dialect, "stayInside", { seconds }, op_stay_inside,
			"Stays inside the building that the person is in for that long.");
	add_operation(dialect, "goToBuilding", { building }, op_go_to_building,
			"Walks to the building and enters it; goes on inside. No way there: the rule ends.");
	add_operation(dialect, "goToZone", { type }, op_go_to_zone,
			"Walks to the nearest zone of the type; goes on there. No such zone or no way: the rule ends.");
	add_operation(dialect, "goToObject", { object }, op_go_to_object,
			"Reserves a free place of the object and walks to it. None free or no way: the rule ends.");
	add_operation(dialect, "interact", { object, action }, op_interact,
			"Uses a place of the object, walking to it first if need be; \"sit\" sits down. None free: the rule ends.");
}

} // namespace

const Dialect &pcg_dialect() {
	static const Dialect dialect = [] {
		Dialect merged = agenda::make_dialect();
		add_simulation_operations(merged);
		return merged;
	}();
	return dialect;
}

} // namespace pcg
