#include <cmath>
#include <limits>

#include "core/agenda/functions/functions.h"

namespace pcg::agenda {

namespace {

double distance(const Context &context, const Args &args) {
	const BuildingId from = context.building_of(args.number(0));
	const BuildingId to = context.building_of(args.number(1));
	if (!is_valid(from) || !is_valid(to)) {
		return std::numeric_limits<double>::infinity();
	}
	return context.paths().distance(from, to);
}

Value get_distance(Vm &vm, const Args &args) { return Value::of(distance(context_of(vm), args)); }

Value get_distance_in_time(Vm &vm, const Args &args) {
	if (!require_focus(vm, "getDistanceInTime")) {
		return {};
	}
	const Context &context = context_of(vm);
	return Value::of(distance(context, args) / double(context.population().person(context.focus()).walking_speed));
}

Value find_building(Vm &vm, const Args &args) {
	Context &context = context_of(vm);
	const TypeId type = context.find_type(vm, *args[0].text, TypeUse::Building);
	const std::vector<BuildingId> &buildings = context.city().buildings_of_type(type);
	return Value::of(buildings.empty() ? -1.0 : context.number_of(buildings[vm.random().index(buildings.size())]));
}

Value find_nearest_building(Vm &vm, const Args &args) {
	Context &context = context_of(vm);
	const TypeId type = context.find_type(vm, *args[0].text, TypeUse::Building);
	const BuildingId from = context.building_of(args.number(1));
	if (!is_valid(type) || !is_valid(from)) {
		return Value::of(-1.0);
	}
	return Value::of(context.number_of(context.paths().nearest_building(type, from)));
}

Value is_valid_id(Vm &, const Args &args) { return Value::of(std::isfinite(args.number(0)) && args.number(0) >= 0.0); }

} // namespace

void add_building_functions(Dialect &dialect) {
	const ParamSpec a{ "a", ParamKind::Number };
	const ParamSpec b{ "b", ParamKind::Number };
	const ParamSpec type{ "type", ParamKind::Text };
	dialect.functions.push_back({ "getDistance", { a, b }, ValueType::Number, get_distance,
			"Walking distance between the entrances of two buildings in metres; infinite if there is no way." });
	dialect.functions.push_back({ "getDistanceInTime", { a, b }, ValueType::Number, get_distance_in_time,
			"Seconds that the focused person walks between two buildings; infinite if there is no way." });
	dialect.functions.push_back({ "findBuilding", { type }, ValueType::Number, find_building,
			"A building with an entrance of this type, at random; -1 if there is none." });
	dialect.functions.push_back({ "findNearestBuilding", { type, { "building", ParamKind::Number } }, ValueType::Number, find_nearest_building,
			"The building with an entrance of this type that is nearest to walk to; -1 if there is none." });
	dialect.functions.push_back({ "isValid", { { "id", ParamKind::Number } }, ValueType::Bool, is_valid_id,
			"Whether a building, object or member was found." });
}

} // namespace pcg::agenda
