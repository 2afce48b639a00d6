#include <algorithm>
#include <iterator>

#include "core/lang/compiler.h"

// Start rules and annotations.
namespace pcg {

// Of the main file, or where that has none, of the files that it imports into its own space.
void Compiler::mark_start_rules() {
	if (mark_start_rules(true) == 0) {
		mark_start_rules(false);
	}
}

uint32_t Compiler::mark_start_rules(bool in_main_file) {
	uint32_t count = 0;
	for (const Definition &definition : _definitions) {
		const Module &module = _set.modules[definition.module];
		if (definition.kind != Definition::Kind::Rule || module.space != 0 || (module.file == 0) != in_main_file) {
			continue;
		}
		const std::vector<AstAnnotation> &annotations = definition.item->annotations;
		const bool is_marked = std::ranges::any_of(annotations, [](const AstAnnotation &annotation) { return annotation.name == "StartRule"; });
		if (is_marked || definition.item->is_start) {
			const uint32_t rule = _definitions[winner_of(definition)].index; // the mark stays where a style redefines the rule
			_program->rules[rule].is_start = true;
			_program->start_rule = count++ == 0 ? RuleId(rule) : _program->start_rule;
			check_start_rule(definition);
		}
	}
	return count;
}

// Where hosts begin at one rule without asking (PCG language, section 1). CGA's name the one they want.
void Compiler::check_start_rule(const Definition &definition) {
	if (!is_strict()) {
		return;
	}
	open_scope(definition);
	const RuleInfo &first = _program->rules[index_of(_program->start_rule)];
	const std::string name = "`" + definition.name + "`";
	if (first.name != definition.name || first.params.size() != definition.param_count) {
		error("several-start-rules", definition.offset, name + " is marked @StartRule, and `" + first.name + "` in line " + std::to_string(first.place.line) + " is, too",
				"leave the mark at one of them");
	} else if (definition.param_count > 0) {
		error("start-rule-parameters", definition.offset, "the start rule " + name + " has parameters, and nobody there to give their values",
				"let a rule without parameters call it, and mark that one @StartRule");
	}
}

// Hosts of other languages have annotations of their own; where a strict dialect lists what it knows, another one is misspelt.
void Compiler::check_annotations() {
	if (!is_strict() || _dialect.annotations.empty()) {
		return;
	}
	for (size_t i = 0; i < _definitions.size(); ++i) {
		open_scope(_definitions[i]);
		const std::vector<AstAnnotation> &annotations = _definitions[i].item->annotations;
		for (size_t at = 0; at < annotations.size(); ++at) {
			check_annotation(annotations[at], std::span(annotations).first(at));
		}
	}
}

void Compiler::check_annotation(const AstAnnotation &annotation, std::span<const AstAnnotation> before) {
	const std::string name = "`@" + std::string(annotation.name) + "`";
	const auto spec = std::ranges::find(_dialect.annotations, annotation.name, &AnnotationSpec::name);
	if (spec == _dialect.annotations.end()) {
		std::vector<std::string_view> known;
		std::ranges::transform(_dialect.annotations, std::back_inserter(known), &AnnotationSpec::name);
		const std::string_view closest = closest_name(annotation.name, known);
		warn("unknown-annotation", annotation.offset, "there is no annotation " + name + "; it means nothing",
				closest.empty() ? std::string() : "did you mean `@" + std::string(closest) + "`?");
	} else if (!spec->arguments.empty()) {
		return;
	} else if (!annotation.arguments.empty()) {
		warn("annotation-arguments", annotation.offset, name + " takes no arguments; they mean nothing");
	} else if (std::ranges::find(before, annotation.name, &AstAnnotation::name) != before.end()) {
		warn("repeated-annotation", annotation.offset, name + " stands here twice");
	}
}

} // namespace pcg
