// What an editor of rule files asks: the words of a dialect, a check of text that is not saved yet, and where names are defined.
#include <godot_cpp/core/class_db.hpp>

#include "core/cga/dialect.h"
#include "core/lang/parser.h"
#include "core/lang/reference.h"
#include "godot/convert.h"
#include "godot/ports/engine_files.h"
#include "godot/ports/script_builtins.h"
#include "godot/resources/pcg_rule_set.h"

using namespace godot;

namespace pcg {

namespace {

// The files of the engine, save one whose text is in an editor.
class EditedFiles : public EngineFiles {
public:
	EditedFiles(std::string path, std::string text) : _path(std::move(path)), _text(std::move(text)) {}
	Result<std::string> read(const std::string &path) override { return path == _path ? Result<std::string>(_text) : EngineFiles::read(path); }

private:
	std::string _path;
	std::string _text;
};

Dictionary to_entry(const char *kind, std::string_view name, std::string_view signature, std::string_view help) {
	Dictionary entry;
	entry["kind"] = kind;
	entry["name"] = to_godot(name);
	entry["signature"] = to_godot(signature);
	entry["help"] = to_godot(help);
	return entry;
}

Dictionary to_definition(const Program &program, const char *kind, const std::string &name, const SourcePlace &place) {
	Dictionary entry;
	entry["kind"] = kind;
	entry["name"] = to_godot(std::string_view(name));
	entry["file"] = place.file < program.files.size() ? to_godot(std::string_view(program.files[place.file])) : String();
	entry["line"] = place.line;
	entry["column"] = place.column;
	return entry;
}

} // namespace

void PCGRuleSet::bind_language() {
	ClassDB::bind_static_method("PCGRuleSet", D_METHOD("from_text", "path", "text"), &PCGRuleSet::from_text);
	ClassDB::bind_static_method("PCGRuleSet", D_METHOD("get_builtins", "dialect"), &PCGRuleSet::get_builtins);
	ClassDB::bind_static_method("PCGRuleSet", D_METHOD("get_keywords"), &PCGRuleSet::get_keywords);
	ClassDB::bind_method(D_METHOD("get_definitions"), &PCGRuleSet::get_definitions);
}

Ref<PCGRuleSet> PCGRuleSet::from_text(const String &p_path, const String &p_text) {
	Ref<PCGRuleSet> rules;
	rules.instantiate();
	rules->take_path(p_path);
	rules->_source = p_text;
	EditedFiles files(from_godot(p_path), from_godot(p_text));
	rules->compile_file(files);
	return rules;
}

TypedArray<Dictionary> PCGRuleSet::get_builtins(Dialect p_dialect) {
	TypedArray<Dictionary> result;
	const pcg::Dialect &dialect = p_dialect == DIALECT_CGA ? cga::cga_dialect() : agenda_dialect();
	for (const OperationSpec &spec : dialect.operations) {
		Dictionary entry = to_entry("operation", spec.name, signature_text(spec), spec.help);
		entry["has_block"] = spec.block != BlockKind::None;
		result.push_back(entry);
	}
	for (const FunctionSpec &spec : dialect.functions) {
		result.push_back(to_entry("function", spec.name, signature_text(spec), spec.help));
	}
	for (const VariableSpec &spec : dialect.variables) {
		result.push_back(to_entry("variable", spec.name, spec.name, spec.help));
	}
	for (const AnnotationSpec &spec : dialect.annotations) {
		result.push_back(to_entry("annotation", "@" + std::string(spec.name), signature_text(spec), spec.help));
	}
	return result;
}

PackedStringArray PCGRuleSet::get_keywords() {
	PackedStringArray words;
	for (const std::string_view word : keywords) {
		words.push_back(to_godot(word));
	}
	return words;
}

TypedArray<Dictionary> PCGRuleSet::get_definitions() const {
	TypedArray<Dictionary> result;
	if (!_program) {
		return result;
	}
	for (const RuleInfo &rule : _program->rules) {
		if (!rule.is_leaf_symbol) {
			result.push_back(to_definition(*_program, "rule", rule.name, rule.place));
		}
	}
	for (const AttributeInfo &attribute : _program->attributes) {
		result.push_back(to_definition(*_program, "attribute", attribute.name, attribute.place));
	}
	return result;
}

} // namespace pcg
