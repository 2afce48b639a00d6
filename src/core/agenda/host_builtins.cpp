#include "core/agenda/host_builtins.h"

#include <algorithm>
#include <iterator>

#include "core/agenda/generation_context.h"
#include "core/lang/parser.h"

namespace pcg {

namespace {

constexpr ValueType value_type(HostType type) {
	return type == HostType::Number ? ValueType::Number : type == HostType::Bool ? ValueType::Bool : ValueType::Text;
}

ParamSpec param_spec(const HostParam &param) {
	ParamSpec spec;
	spec.name = param.name;
	spec.kind = param.type == HostType::Number ? ParamKind::Number : param.type == HostType::Bool ? ParamKind::Bool : ParamKind::Text;
	spec.is_optional = param.is_optional;
	return spec;
}

std::vector<ParamSpec> param_specs(const std::vector<HostParam> &params) {
	std::vector<ParamSpec> specs;
	std::transform(params.begin(), params.end(), std::back_inserter(specs), param_spec);
	return specs;
}

Value call_function(Vm &vm, const Args &args) {
	const HostFunction &function = *static_cast<const HostFunction *>(args.user);
	HostCall call(vm, args, function.name);
	const HostValue value = function.call(call);
	if (vm.has_failed()) {
		return {};
	}
	if (value.index() != size_t(function.result)) {
		return vm.fail("host-error", "the host's function '" + function.name + "' gave another type of value than it was registered with");
	}
	switch (function.result) {
		case HostType::Number:
			return Value::of(std::get<double>(value));
		case HostType::Bool:
			return Value::of(std::get<bool>(value));
		case HostType::Text:
			return Value::of(vm.make_text(std::get<std::string>(value)));
	}
	return {};
}

Flow call_operation(Vm &vm, const Args &args) {
	const HostOperation &operation = *static_cast<const HostOperation *>(args.user);
	const bool is_simulating = agenda::context_of(vm).is_simulating();
	if (operation.phase != Phase::Both && is_simulating != (operation.phase == Phase::Simulation)) {
		return Flow::Next;
	}
	HostCall call(vm, args, operation.name);
	operation.call(call);
	return vm.has_failed() ? Flow::Stop : Flow::Next;
}

// What the lexer takes for one name, and the grammar for nothing else.
bool is_name(std::string_view name) {
	const bool is_plain = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
		return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
	});
	const bool is_number = !name.empty() && name.front() >= '0' && name.front() <= '9';
	const bool is_of_grammar = name == "set" || std::ranges::find(keywords, name) != std::end(keywords);
	return is_plain && !is_number && name.front() != '.' && name.back() != '.' && !is_of_grammar;
}

} // namespace

void HostCall::insert(TaskKind kind, double start, double end, uint32_t target) const {
	if (agenda::GenerationContext *context = agenda::writing_context(_vm)) {
		context->insert(_vm, _name, kind, start, end, target);
	}
}

template <typename Spec> bool HostDialect::is_sound(const Spec &spec, Diagnostics &diagnostics) const {
	const std::string name = "'" + spec.name + "'";
	if (!is_name(spec.name)) {
		diagnostics.error("host-name", name + " cannot be the name of a function or operation",
				"names are made of letters, digits and _, and are no words of the grammar, such as `case`");
		return false;
	}
	if (_dialect.has_function(spec.name) || _dialect.has_operation(spec.name) || _dialect.find_variable(spec.name) >= 0) {
		diagnostics.error("host-name", "the language has " + name + " already", "give it another name");
		return false;
	}
	const auto is_misplaced = [](const HostParam &a, const HostParam &b) { return a.is_optional && !b.is_optional; };
	if (std::adjacent_find(spec.params.begin(), spec.params.end(), is_misplaced) != spec.params.end()) {
		diagnostics.error("host-parameters", name + " has an optional parameter before one that is not", "optional parameters stand at the end");
		return false;
	}
	if (!spec.call) {
		diagnostics.error("host-call", name + " has nothing to call", "set `call`");
		return false;
	}
	return true;
}

bool HostDialect::add(HostFunction function, Diagnostics &diagnostics) {
	if (!is_sound(function, diagnostics)) {
		return false;
	}
	const HostFunction &kept = _functions.emplace_back(std::move(function));
	FunctionSpec spec;
	spec.name = kept.name;
	spec.params = param_specs(kept.params);
	spec.result = value_type(kept.result);
	spec.handler = call_function;
	spec.help = kept.help;
	spec.user = &kept;
	_dialect.functions.push_back(std::move(spec));
	return true;
}

bool HostDialect::add(HostOperation operation, Diagnostics &diagnostics) {
	if (!is_sound(operation, diagnostics)) {
		return false;
	}
	const HostOperation &kept = _operations.emplace_back(std::move(operation));
	OperationSpec spec;
	spec.name = kept.name;
	spec.params = param_specs(kept.params);
	spec.handler = call_operation;
	spec.help = kept.help;
	spec.phase = kept.phase;
	spec.user = &kept;
	_dialect.operations.push_back(std::move(spec));
	return true;
}

} // namespace pcg
