#include <glm/geometric.hpp>

#include "core/agenda/functions/functions.h"

namespace pcg::agenda {

namespace {

// Two passes over the objects of the type rather than a list of candidates: nothing is allocated.
template <typename Test> Value pick(Vm &vm, const std::vector<ObjectId> &objects, const Test &is_candidate) {
	size_t count = 0;
	for (ObjectId id : objects) {
		count += is_candidate(id);
	}
	if (count == 0) {
		return Value::of(-1.0);
	}
	size_t chosen = vm.random().index(count);
	for (ObjectId id : objects) {
		if (is_candidate(id) && chosen-- == 0) {
			return Value::of(context_of(vm).number_of(id));
		}
	}
	return Value::of(-1.0);
}

Value find_object(Vm &vm, const Args &args) {
	Context &context = context_of(vm);
	const TypeId type = context.find_type(vm, *args[0].text, TypeUse::Object);
	const std::vector<ObjectId> &objects = context.city().objects_of_type(type);
	if (args.count() < 2) {
		return pick(vm, objects, [&](ObjectId id) { return context.has_free_place(id); });
	}
	if (!require_focus(vm, "findObject with a radius")) {
		return {};
	}
	glm::vec3 here{ 0.0f };
	if (!context.present_position(here)) {
		return Value::of(-1.0);
	}
	const double radius = args.number(1);
	return pick(vm, objects, [&](ObjectId id) {
		return double(glm::distance(context.city().object(id).position, here)) <= radius && context.has_free_place(id);
	});
}

} // namespace

void add_object_functions(Dialect &dialect) {
	dialect.functions.push_back({ "findObject", { { "type", ParamKind::Text }, { "radius", ParamKind::Number, {}, true } }, ValueType::Number,
			find_object,
			"A free object of this type, at random; with a radius in metres only those around the person (around home while agendas are "
			"written); -1 if there is none." });
}

} // namespace pcg::agenda
