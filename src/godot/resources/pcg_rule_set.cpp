#include "godot/resources/pcg_rule_set.h"

#include <godot_cpp/core/class_db.hpp>

#include "core/cga/dialect.h"
#include "core/io/rule_loader.h"
#include "godot/convert.h"
#include "godot/ports/engine_files.h"
#include "godot/ports/script_builtins.h"
#include "godot/report.h"

using namespace godot;

namespace pcg {

void PCGRuleSet::_bind_methods() {
	BIND_ENUM_CONSTANT(DIALECT_CGA);
	BIND_ENUM_CONSTANT(DIALECT_AGENDA);
	ClassDB::bind_static_method("PCGRuleSet", D_METHOD("from_file", "path"), &PCGRuleSet::from_file);
	ClassDB::bind_static_method("PCGRuleSet", D_METHOD("add_function", "name", "parameters", "result", "function"), &PCGRuleSet::add_function);
	ClassDB::bind_static_method("PCGRuleSet", D_METHOD("add_operation", "name", "parameters", "operation"), &PCGRuleSet::add_operation);
	bind_language();
	ClassDB::bind_method(D_METHOD("reload"), &PCGRuleSet::reload);
	ClassDB::bind_method(D_METHOD("get_file"), &PCGRuleSet::get_file);
	ClassDB::bind_method(D_METHOD("has_errors"), &PCGRuleSet::has_errors);
	ClassDB::bind_method(D_METHOD("get_diagnostics"), &PCGRuleSet::get_diagnostics);
	ClassDB::bind_method(D_METHOD("get_diagnostics_text"), &PCGRuleSet::get_diagnostics_text);
	ClassDB::bind_method(D_METHOD("get_rules"), &PCGRuleSet::get_rules);
	ClassDB::bind_method(D_METHOD("get_start_rules"), &PCGRuleSet::get_start_rules);
	ClassDB::bind_method(D_METHOD("get_attributes"), &PCGRuleSet::get_attributes);
	ClassDB::bind_method(D_METHOD("set_dialect", "dialect"), &PCGRuleSet::set_dialect);
	ClassDB::bind_method(D_METHOD("get_dialect"), &PCGRuleSet::get_dialect);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "dialect", PROPERTY_HINT_ENUM, "CGA,Agenda"), "set_dialect", "get_dialect");
	ClassDB::bind_method(D_METHOD("set_source", "source"), &PCGRuleSet::set_source);
	ClassDB::bind_method(D_METHOD("get_source"), &PCGRuleSet::get_source);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "source", PROPERTY_HINT_MULTILINE_TEXT), "set_source", "get_source");
}

// What comes from a file is neither edited nor stored here.
void PCGRuleSet::_validate_property(PropertyInfo &p_property) const {
	if (!_file.is_empty() && (p_property.name == StringName("source") || p_property.name == StringName("dialect"))) {
		p_property.usage = PROPERTY_USAGE_EDITOR | PROPERTY_USAGE_READ_ONLY;
	}
}

Ref<PCGRuleSet> PCGRuleSet::from_file(const String &p_path) {
	Ref<PCGRuleSet> rules;
	rules.instantiate();
	rules->read_file(p_path);
	return rules;
}

bool PCGRuleSet::add_function(const String &p_name, const Dictionary &p_parameters, int p_result, const godot::Callable &p_function) {
	Diagnostics diagnostics;
	const bool is_added = add_script_function(p_name, p_parameters, Variant::Type(p_result), p_function, diagnostics);
	report(diagnostics);
	return is_added;
}

bool PCGRuleSet::add_operation(const String &p_name, const Dictionary &p_parameters, const godot::Callable &p_operation) {
	Diagnostics diagnostics;
	const bool is_added = add_script_operation(p_name, p_parameters, p_operation, diagnostics);
	report(diagnostics);
	return is_added;
}

void PCGRuleSet::take_path(const String &p_path) {
	_file = p_path;
	_dialect = p_path.get_extension().to_lower() == "pcg" ? DIALECT_AGENDA : DIALECT_CGA;
}

void PCGRuleSet::read_file(const String &p_path) {
	take_path(p_path);
	reload();
	notify_property_list_changed();
}

// The editor moves files, and tells their resources of it by their path alone.
String PCGRuleSet::get_file() const {
	const String path = get_path();
	return _file.is_empty() || path.is_empty() || path.contains("::") ? _file : path;
}

void PCGRuleSet::reload() {
	_file = get_file();
	if (!_file.is_empty()) {
		const Result<std::string> bytes = read_engine_file(_file);
		_source = bytes ? to_godot(std::string_view(*bytes)) : String();
	}
	compile();
	emit_changed();
}

void PCGRuleSet::set_source(const String &p_source) {
	_file = String();
	_source = p_source;
	compile();
	emit_changed();
}

void PCGRuleSet::set_dialect(Dialect p_dialect) {
	if (_dialect != p_dialect) {
		_dialect = p_dialect;
		reload();
	}
}

void PCGRuleSet::compile() {
	if (!_file.is_empty()) {
		EngineFiles files;
		compile_file(files);
		return;
	}
	_diagnostics = Diagnostics();
	MemorySourceProvider text;
	const std::string name = _dialect == DIALECT_CGA ? "rules.cga" : "rules.pcg";
	text.add(name, from_godot(_source));
	_program = load_program(name, _dialect == DIALECT_CGA ? cga::cga_dialect() : agenda_dialect(), text, _diagnostics);
}

void PCGRuleSet::compile_file(SourceProvider &files) {
	_diagnostics = Diagnostics();
	_program = load_program(from_godot(_file), _dialect == DIALECT_CGA ? cga::cga_dialect() : agenda_dialect(), files, _diagnostics);
}

TypedArray<Dictionary> PCGRuleSet::get_diagnostics() const { return to_godot(_diagnostics); }

String PCGRuleSet::get_diagnostics_text() const { return to_godot(std::string_view(to_text(_diagnostics))).strip_edges(); }

PackedStringArray PCGRuleSet::get_rules() const {
	PackedStringArray names;
	for (const RuleInfo &rule : _program ? _program->rules : std::vector<RuleInfo>()) {
		if (!rule.is_leaf_symbol && !rule.is_replaced) {
			names.push_back(to_godot(std::string_view(rule.name)));
		}
	}
	return names;
}

PackedStringArray PCGRuleSet::get_start_rules() const {
	PackedStringArray names;
	for (const RuleInfo &rule : _program ? _program->rules : std::vector<RuleInfo>()) {
		if (rule.is_start) {
			names.push_back(to_godot(std::string_view(rule.name)));
		}
	}
	return names;
}

TypedArray<Dictionary> PCGRuleSet::get_attributes() const {
	TypedArray<Dictionary> result;
	for (const AttributeInfo &attribute : _program ? _program->attributes : std::vector<AttributeInfo>()) {
		Dictionary entry;
		entry["name"] = to_godot(std::string_view(attribute.name));
		entry["is_constant"] = attribute.kind == AttributeInfo::Kind::Constant;
		entry["is_plain"] = attribute.kind == AttributeInfo::Kind::Plain;
		entry["type"] = to_godot(type_name(attribute.type));
		entry["default"] = to_godot(std::string_view(attribute.default_text));
		entry["file"] = to_godot(std::string_view(_program->files[attribute.place.file]));
		entry["line"] = attribute.place.line;
		Dictionary annotations;
		for (const Annotation &annotation : attribute.annotations) {
			annotations[to_godot(std::string_view(annotation.name))] = to_godot(annotation.arguments);
		}
		entry["annotations"] = annotations;
		result.push_back(entry);
	}
	return result;
}

} // namespace pcg
