#include "core/lang/compiler.h"
#include "core/lang/opcode.h"

// Warnings about what is sound but has no effect. For strict dialects: in CGA hosts start where they like, and there is one phase.
namespace pcg {

// Everything that `reached` leads to by plain calls.
void Compiler::spread(std::vector<bool> &reached) const {
	std::vector<std::vector<uint32_t>> callees(reached.size());
	std::vector<uint32_t> open;
	for (const Edge &edge : _edges) {
		if (!edge.is_delayed && edge.from != no_node) {
			callees[edge.from].push_back(edge.to);
		}
	}
	for (uint32_t rule = 0; rule < reached.size(); ++rule) {
		if (reached[rule]) {
			open.push_back(rule);
		}
	}
	while (!open.empty()) {
		const uint32_t rule = open.back();
		open.pop_back();
		for (uint32_t callee : callees[rule]) {
			if (!reached[callee]) {
				reached[callee] = true;
				open.push_back(callee);
			}
		}
	}
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

void Compiler::warn_unused_and_phases() {
	std::vector<bool> generation(_program->rules.size()), simulation(_program->rules.size());
	if (!is_valid(_program->start_rule)) {
		return; // A library of rules for others.
	}
	generation[index_of(_program->start_rule)] = true;
	spread(generation);
	// Rules that run later may ask for rules that run later still.
	for (size_t round = 0; round <= _edges.size(); ++round) {
		bool has_grown = false;
		for (const Edge &edge : _edges) {
			const bool is_reached = edge.from != no_node && (generation[edge.from] || simulation[edge.from]);
			if (edge.is_delayed && is_reached && !simulation[edge.to]) {
				simulation[edge.to] = true;
				has_grown = true;
			}
		}
		if (!has_grown) {
			break;
		}
		spread(simulation);
	}
	for (uint32_t rule = 0; rule < _program->rules.size(); ++rule) {
		const RuleInfo &info = _program->rules[rule];
		if (!generation[rule] && !simulation[rule] && info.place.file == 0 && info.name.find('.') == std::string::npos) {
			warn_at("unused-rule", info.place, "the rule `" + info.name + "` is never used",
					"nothing that begins at `" + _program->rules[index_of(_program->start_rule)].name + "` calls it");
		}
	}
	warn_phases(generation, simulation);
}

void Compiler::warn_phases(const std::vector<bool> &generation, const std::vector<bool> &simulation) {
	for (const OperationUse &use : _uses) {
		if (use.rule == no_node) {
			continue;
		}
		const OperationSpec &spec = _dialect.operations[use.operation];
		if (spec.phase == Phase::Generation && simulation[use.rule]) {
			warn_at("wrong-phase", use.place, "`" + std::string(spec.name) + "` writes agendas: a rule that runs later disregards it",
					"`" + _program->rules[use.rule].name + "` runs while the simulation does");
		} else if (spec.phase == Phase::Simulation && generation[use.rule]) {
			warn_at("wrong-phase", use.place, "`" + std::string(spec.name) + "` does nothing while agendas are written",
					"call it from a rule that is given to delayedRule or floatingTask");
		}
	}
}

} // namespace pcg
