#include "core/lang/compiler.h"
#include "core/lang/opcode.h"

// Warnings about what is sound but has no effect. For strict dialects: in CGA hosts start where they like, and there is one phase.
namespace pcg {

// Which rules run in which phase, from the start rule on: plain calls stay in the phase, rules that are given away run in the simulation.
Compiler::Reached Compiler::reached_rules() const {
	struct Step {
		uint32_t rule;
		bool is_later;
	};
	std::vector<std::vector<const Edge *>> callees(_program->rules.size());
	for (const Edge &edge : _edges) {
		if (edge.from != no_node) {
			callees[edge.from].push_back(&edge);
		}
	}
	Reached reached{ std::vector<bool>(callees.size()), std::vector<bool>(callees.size()) };
	std::vector<Step> open;
	const auto reach = [&](uint32_t rule, bool is_later) {
		std::vector<bool> &known = is_later ? reached.simulation : reached.generation;
		if (!known[rule]) {
			known[rule] = true;
			open.push_back({ rule, is_later });
		}
	};
	reach(index_of(_program->start_rule), false);
	while (!open.empty()) {
		const Step step = open.back();
		open.pop_back();
		for (const Edge *edge : callees[step.rule]) {
			reach(edge->to, step.is_later || edge->is_delayed);
		}
	}
	return reached;
}

void Compiler::warn_at(std::string_view id, const SourcePlace &at, std::string message, std::string hint) {
	const Source &source = *_program->sources[at.file];
	_diagnostics.add({ Severity::Warning, id, source.name(), at.line, at.column, std::move(message), std::move(hint),
			source.excerpt(at.line, at.column) });
}

// What stands behind a condition that always holds.
void Compiler::warn_unreachable(bool is_decided, uint32_t offset) {
	if (is_decided && is_strict()) {
		warn("unreachable", offset, "this is never reached: the condition before it always holds");
	}
}

// Two `case` in one sequence are one choice, wherever they stand: one that is written as if it belonged to the branch above hardly means that.
void Compiler::warn_indented(uint32_t first_case, uint32_t offset) {
	const SourcePlace first = place(first_case), here = place(offset);
	if (is_strict() && here.line > first.line && here.column > first.column) {
		warn("indented-case", offset, "this is one more branch of the `case` in line " + std::to_string(first.line) + ", and not a part of the branch above",
				"put it into [ ] to make it a part of that branch, or write it below the first `case`");
	}
}

bool Compiler::is_always_true(const Value &condition, uint32_t offset) {
	if (condition.is_bool() && !condition.boolean && is_strict()) {
		warn("unreachable", offset, "this is never reached: its condition never holds");
	}
	return condition.is_bool() && condition.boolean;
}

Value Compiler::constant_of(Chunk chunk) const {
	const Instruction &first = _program->code[uint32_t(chunk)];
	const bool is_all = _program->code[uint32_t(chunk) + 1].code == OpCode::Return;
	return first.code == OpCode::PushConstant && is_all ? _program->constants[first.operand] : Value();
}

// What cannot hold whatever happens. Gives the place that it is told at, which is the call's from then on: what it says while it runs is the same.
uint32_t Compiler::check_constants(uint32_t operation, const Command &command) {
	const OperationSpec &spec = _dialect.operations[operation];
	if (spec.check == nullptr || _constant_arguments.empty()) {
		return command.offset;
	}
	std::vector<Value> around;
	for (const OpenBlock &open : _open_blocks) {
		if (open.operation == operation) {
			around.push_back(open.first_argument);
		}
	}
	std::optional<CallProblem> problem = spec.check({ spec.name, _constant_arguments, around });
	if (!problem) {
		return command.offset;
	}
	const uint32_t at = problem->argument < 0 ? command.offset : _scope.ast->exprs[_scope.ast->list(command.arguments)[size_t(problem->argument)]].offset;
	warn(problem->id, at, std::move(problem->message), std::move(problem->hint));
	return at;
}

void Compiler::warn_unused_and_phases() {
	if (!is_valid(_program->start_rule)) {
		return; // A library of rules for others.
	}
	const Reached reached = reached_rules();
	for (uint32_t rule = 0; rule < _program->rules.size(); ++rule) {
		const RuleInfo &info = _program->rules[rule];
		if (!reached.generation[rule] && !reached.simulation[rule] && info.place.file == 0 && info.name.find('.') == std::string::npos) {
			warn_at("unused-rule", info.place, "the rule `" + info.name + "` is never used",
					"nothing that begins at `" + _program->rules[index_of(_program->start_rule)].name + "` calls it");
		}
	}
	warn_phases(reached);
}

void Compiler::warn_phases(const Reached &reached) {
	for (const OperationUse &use : _uses) {
		if (use.rule == no_node) {
			continue;
		}
		const OperationSpec &spec = _dialect.operations[use.operation];
		if (spec.phase == Phase::Generation && reached.simulation[use.rule]) {
			warn_at("wrong-phase", use.place, "`" + std::string(spec.name) + "` writes agendas: a rule that runs later disregards it",
					"`" + _program->rules[use.rule].name + "` runs while the simulation does");
		} else if (spec.phase == Phase::Simulation && reached.generation[use.rule]) {
			warn_at("wrong-phase", use.place, "`" + std::string(spec.name) + "` does nothing while agendas are written",
					"call it from a rule that is given to delayedRule or floatingTask");
		}
	}
}

} // namespace pcg
