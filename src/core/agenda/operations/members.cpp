#include <array>
#include <string>
#include <vector>

#include "core/agenda/context.h"
#include "core/agenda/operations/operations.h"

namespace pcg::agenda {

namespace {

// A condition that yields a member's id, as chooseMember(..) does, is evaluated once for all members, so that exactly one is chosen.
class Conditions {
public:
	Conditions(Vm &vm, std::span<const BlockEntry> entries) : _vm(vm), _entries(entries) {
		if (entries.size() > _few.size()) {
			_many.resize(entries.size());
		}
	}

	// Whether the focused member is meant. False too after a failure.
	bool holds(size_t entry, PersonId member) {
		Chosen &chosen = _many.empty() ? _few[entry] : _many[entry];
		if (!chosen.is_known) {
			const Value value = _vm.evaluate(_entries[entry].head);
			if (_vm.has_failed() || value.is_bool()) {
				return !_vm.has_failed() && value.boolean;
			}
			if (!value.is_number()) {
				_vm.fail("wrong-type", "a condition of 'members' is true or false, or a member's id, not " + std::string(type_name(value.type)),
						"write a comparison, as in age < 18, or chooseMember(..)");
				return false;
			}
			chosen = { true, value.number };
			check_member(value.number);
		}
		return chosen.id == context_of(_vm).number_of(member);
	}

private:
	struct Chosen {
		bool is_known = false;
		double id = -1.0;
	};

	void check_member(double number) {
		const Context &context = context_of(_vm);
		bool is_member = number == -1.0;
		for (size_t i = 0; i < context.member_count() && !is_member; ++i) {
			is_member = number == context.number_of(context.member(i));
		}
		if (!is_member) {
			_vm.warn("no-member", "this condition of 'members' is a number that is no member's id, so it matches nobody",
					"write a comparison, as in age < 18, or chooseMember(..)");
		}
	}

	Vm &_vm;
	std::span<const BlockEntry> _entries;
	std::array<Chosen, 8> _few{};
	std::vector<Chosen> _many;
};

Flow members(Vm &vm, const Args &args) {
	Context &context = context_of(vm);
	if (context.is_simulating()) {
		return Flow::Next;
	}
	const std::span<const BlockEntry> entries = vm.entries(*args.block);
	Conditions conditions(vm, entries);
	FocusScope scope(context);
	for (size_t i = 0; i < context.member_count(); ++i) {
		for (size_t entry = 0; entry < entries.size(); ++entry) {
			scope.focus(context.member(i));
			const bool is_meant = conditions.holds(entry, context.member(i));
			if (vm.has_failed()) {
				return Flow::Stop;
			}
			if (!is_meant) {
				continue;
			}
			if (vm.run_body(entries[entry].body) == Flow::Stop) {
				return Flow::Stop;
			}
			break;
		}
	}
	return Flow::Next;
}

} // namespace

void add_members(Dialect &dialect) {
	dialect.operations.push_back({ "members", {}, BlockKind::Predicates, members,
			"members { condition : actions | condition : actions }: for each member of the household, focuses it and runs the actions of the "
			"first condition that is true for it." });
}

} // namespace pcg::agenda
