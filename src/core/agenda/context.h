#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/diagnostic.h"
#include "core/base/file_ids.h"
#include "core/base/ids.h"
#include "core/lang/program.h"
#include "core/lang/vm.h"
#include "core/population/population.h"
#include "core/ports/path_provider.h"
#include "core/semantics/city_model.h"

// What the built-ins of agenda rules see of the world, in both phases: while agendas are written (GenerationContext) and while a delayed
// rule runs (the simulation derives its own).
namespace pcg::agenda {

// What all runs of one program on one city share. Read-only, so threads share it too; the pointed-to objects outlive it.
struct World {
	const Program *program = nullptr;
	const CityModel *city = nullptr;
	const PathProvider *paths = nullptr;
	const Population *population = nullptr;
	FileNumbers numbers; // for messages
	FileNumbers rule_numbers; // those of them that rules use
	std::vector<TypeId> type_of_symbol; // by symbol of Program::texts: type names are looked up once, not once per household
};

// Asks for all type names of the program's texts; make it anew when types were added to the city.
World make_world(const Program &program, const CityModel &city, const PathProvider &paths, const Population &population, const FileNumbers &numbers);

// What rules look for by the name of its type.
enum class TypeUse : uint8_t { Building, Zone, Object };

// The id of the warning that the city has nothing of a type. It is about the city: no household or person belongs to it.
constexpr std::string_view missing_type_id = "unknown-type";

// Whether one message makes the other unnecessary: a missing type is told once, everything else once for each place in the rules, what
// is told of every household (requirement.h) once for each reason there.
bool is_repeat(const Diagnostic &one, const Diagnostic &other);

class Context : public VmHost {
public:
	explicit Context(const World &world) : _world(&world) {}

	const World &world() const { return *_world; }
	const CityModel &city() const { return *_world->city; }
	const PathProvider &paths() const { return *_world->paths; }
	const Population &population() const { return *_world->population; }

	// Whose rules run. The focus is part of it: changing the household clears the focus.
	HouseholdId household_id() const { return _household; }
	const Household &household() const { return population().household(_household); }
	void set_household(HouseholdId id);
	// Invalid while nobody is focused.
	PersonId focus() const { return _focus; }
	void set_focus(PersonId id) { _focus = id; }
	size_t member_count() const { return household().member_count; }
	PersonId member(size_t i) const { return PersonId(index_of(household().first_member) + uint32_t(i)); }

	// Ids as rules know them: the numbers of the user's files, dense ids where there are none; -1 for nothing.
	double number_of(BuildingId id) const { return to_number(_world->rule_numbers.buildings, id); }
	double number_of(ObjectId id) const { return to_number(_world->rule_numbers.objects, id); }
	double number_of(HouseholdId id) const { return to_number(_world->rule_numbers.households, id); }
	double number_of(PersonId id) const { return to_number(_world->rule_numbers.persons, id); }
	// Invalid if the city has none of that number.
	BuildingId building_of(double number) const { return to_id<BuildingId>(_world->rule_numbers.buildings, number, city().buildings().size()); }
	ObjectId object_of(double number) const { return to_id<ObjectId>(_world->rule_numbers.objects, number, city().objects().size()); }
	// "person 12", "household 7": for messages, with the numbers of the user's files.
	std::string name_of(PersonId id) const { return "person " + number_text(_world->numbers.persons, id); }
	std::string name_of(HouseholdId id) const { return "household " + number_text(_world->numbers.households, id); }

	// Operations of the other phase are disregarded (PCG language, sections 5 and 6).
	virtual bool is_simulating() const = 0;
	// `day` (0 Monday .. 6 Sunday) and `time` (seconds of the day); may fail through the Vm.
	virtual Value day(Vm &vm) = 0;
	virtual Value time(Vm &vm) = 0;
	// Where the focused person is; at home while agendas are written. False: nowhere known (no home, no entrance).
	virtual bool present_position(glm::vec3 &position) const = 0;
	// Whether somebody could still use the object. While agendas are written all are free.
	virtual bool has_free_place(ObjectId object) const = 0;

	// The type that a text argument names, if the city has something of it; otherwise Invalid, and a warning that says what is missing.
	TypeId find_type(Vm &vm, const Text &text, TypeUse use);

private:
	TypeId type_named(const Text &text) const;
	bool has_any(TypeId type, TypeUse use) const;
	std::string_view closest_type(std::string_view name, TypeUse use) const;

	const World *_world;
	HouseholdId _household = HouseholdId::Invalid;
	PersonId _focus = PersonId::Invalid;
};

// The context behind a built-in's handler.
inline Context &context_of(Vm &vm) { return static_cast<Context &>(vm.host()); }

// The focus is set to a member for the evaluation of a predicate or the body of `members`, and put back.
class FocusScope {
public:
	explicit FocusScope(Context &context) : _context(context), _saved(context.focus()) {}
	~FocusScope() { _context.set_focus(_saved); }
	FocusScope(const FocusScope &) = delete;
	FocusScope &operator=(const FocusScope &) = delete;
	void focus(PersonId id) { _context.set_focus(id); }

private:
	Context &_context;
	PersonId _saved;
};

// Fails the run: `what` names the built-in that needs somebody focused.
void fail_focus(Vm &vm, std::string_view what);

// Fails the run unless somebody is focused.
inline bool require_focus(Vm &vm, std::string_view what) {
	if (is_valid(context_of(vm).focus())) [[likely]] {
		return true;
	}
	fail_focus(vm, what);
	return false;
}

} // namespace pcg::agenda
