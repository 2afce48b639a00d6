#include <cmath>
#include <string>

#include "core/agenda/functions/functions.h"

namespace pcg::agenda {

namespace {

bool wrong_type(Vm &vm, std::string_view function, std::string_view wanted, const Value &value) {
	if (!vm.has_failed()) {
		vm.fail("wrong-type", "'" + std::string(function) + "' needs " + std::string(wanted) + " for each member, not " + std::string(type_name(value.type)),
				"write a comparison, as in age < 18");
	}
	return false;
}

Value count(Vm &vm, const Args &args) {
	Context &context = context_of(vm);
	if (args.count() == 0) {
		return Value::of(double(context.member_count()));
	}
	FocusScope scope(context);
	size_t matching = 0;
	for (size_t i = 0; i < context.member_count(); ++i) {
		scope.focus(context.member(i));
		const Value value = vm.evaluate(Chunk(args[0].index));
		if (vm.has_failed() || (!value.is_bool() && !wrong_type(vm, "count", "true or false", value))) {
			return {};
		}
		matching += value.boolean;
	}
	return Value::of(double(matching));
}

// Keeps the best member; of equals each with the same probability, without a list of them.
class Choice {
public:
	void offer(PersonId id, double score, Random &random) {
		if (_ties > 0 && score < _best) {
			return;
		}
		_ties = _ties > 0 && score == _best ? _ties + 1 : 1;
		_best = score;
		if (_ties == 1 || random.index(_ties) == 0) {
			_chosen = id;
		}
	}
	PersonId chosen() const { return _chosen; }

private:
	PersonId _chosen = PersonId::Invalid;
	double _best = 0.0;
	size_t _ties = 0;
};

Value choose_member(Vm &vm, const Args &args) {
	Context &context = context_of(vm);
	FocusScope scope(context);
	Choice choice;
	for (size_t i = 0; i < context.member_count(); ++i) {
		const PersonId member = context.member(i);
		scope.focus(member);
		const Value value = vm.evaluate(Chunk(args[0].index));
		if (vm.has_failed()) {
			return {};
		}
		if (value.is_bool()) {
			if (value.boolean) {
				choice.offer(member, 0.0, vm.random());
			}
		} else if (!value.is_number()) {
			wrong_type(vm, "chooseMember", "true or false, or a number", value);
			return {};
		} else if (!std::isnan(value.number)) {
			choice.offer(member, value.number, vm.random());
		}
	}
	return Value::of(context.number_of(choice.chosen()));
}

} // namespace

void add_member_functions(Dialect &dialect) {
	dialect.functions.push_back({ "count", { { "predicate", ParamKind::Predicate, {}, true } }, ValueType::Number, count,
			"Members of the household for whom the predicate is true, or all members." });
	dialect.functions.push_back({ "chooseMember", { { "predicateOrScore", ParamKind::Predicate } }, ValueType::Number, choose_member,
			"One of the members for whom the predicate is true, at random; with a number the member with the largest, ties at random; -1 if "
			"there is none." });
}

} // namespace pcg::agenda
