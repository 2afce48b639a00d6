#include "core/agenda/context.h"

#include <string>

namespace pcg::agenda {

World make_world(const Program &program, const CityModel &city, const PathProvider &paths, const Population &population) {
	World world{ &program, &city, &paths, &population, {} };
	world.type_of_symbol.reserve(program.texts.size());
	for (const Text &text : program.texts) {
		world.type_of_symbol.push_back(city.types.find(text.view));
	}
	return world;
}

void Context::set_household(HouseholdId id) {
	_household = id;
	_focus = PersonId::Invalid;
}

TypeId Context::find_type(const Text &text) const {
	if (text.symbol < _world->type_of_symbol.size()) {
		return _world->type_of_symbol[text.symbol];
	}
	return city().types.find(text.view);
}

bool require_focus(Vm &vm, std::string_view what) {
	if (is_valid(context_of(vm).focus())) {
		return true;
	}
	vm.fail("no-focus", "'" + std::string(what) + "' needs a person, but nobody is focused here",
			"call it inside members { condition: .. }, which focuses one member after the other");
	return false;
}

} // namespace pcg::agenda
