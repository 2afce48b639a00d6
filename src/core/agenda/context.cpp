#include "core/agenda/context.h"

#include "core/agenda/requirement.h"

namespace pcg::agenda {

namespace {

// What a use is called, and how a rule that builds lots makes it: before and after the name of the type.
struct TypeWords {
	std::string_view what, before, after;
};

const TypeWords &words_of(TypeUse use) {
	static constexpr TypeWords words[] = { { "building", "entrance(\"", "\")" }, { "zone", "zone(\"", "\")" },
		{ "object", "@Object(\"", "\") before the rule of its shape" } };
	return words[size_t(use)];
}

} // namespace

bool is_repeat(const Diagnostic &one, const Diagnostic &other) {
	if (one.id != other.id || one.id == missing_type_id) {
		return one.id == other.id && one.message == other.message;
	}
	const bool is_same_reason = one.hint == other.hint || !is_told_of_all(one.id); // its hint says what to do about the reason
	return is_same_reason && one.file == other.file && one.line == other.line && one.column == other.column;
}

World make_world(const Program &program, const CityModel &city, const PathProvider &paths, const Population &population,
		const FileNumbers &numbers) {
	World world{ &program, &city, &paths, &population, numbers, numbers.exact(), {} };
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

TypeId Context::find_type(Vm &vm, const Text &text, TypeUse use) {
	const TypeId type = type_named(text);
	if (has_any(type, use)) {
		return type;
	}
	const TypeWords &words = words_of(use);
	const std::string name(text.view);
	const std::string_view closest = closest_type(name, use);
	vm.warn_each(missing_type_id, "the city has no " + std::string(words.what) + " of type '" + name + "'",
			closest.empty() ? "add lots whose rules make one: " + std::string(words.before) + name + std::string(words.after)
							: "did you mean '" + std::string(closest) + "'?");
	return TypeId::Invalid;
}

bool Context::has_any(TypeId type, TypeUse use) const {
	switch (use) {
		case TypeUse::Building: return !city().buildings_of_type(type).empty();
		case TypeUse::Zone: return !city().zones_of_type(type).empty();
		case TypeUse::Object: return !city().objects_of_type(type).empty();
	}
	return false;
}

// Among those that the city has for this use; empty if none is close.
std::string_view Context::closest_type(std::string_view name, TypeUse use) const {
	std::vector<std::string_view> names;
	for (size_t i = 0; i < city().types.size(); ++i) {
		const TypeId type = TypeId(uint32_t(i));
		if (has_any(type, use)) {
			names.push_back(city().types.name(type));
		}
	}
	return closest_name(name, names);
}

TypeId Context::type_named(const Text &text) const {
	if (text.symbol < _world->type_of_symbol.size()) {
		return _world->type_of_symbol[text.symbol];
	}
	return city().types.find(text.view);
}

void fail_focus(Vm &vm, std::string_view what) {
	vm.fail("no-focus", "'" + std::string(what) + "' needs a person, but nobody is focused here",
			"call it inside members { condition: .. }, which focuses one member after the other");
}

} // namespace pcg::agenda
