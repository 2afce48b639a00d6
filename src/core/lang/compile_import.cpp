#include <algorithm>

#include "core/lang/compiler.h"

// imp(a = 1).Rule(x) and imp(a = 1).f(x): calls of an import with attributes of their own (CGA reference: import).
namespace pcg {

namespace {

// Of the space and of those inside of it.
std::vector<uint32_t> attributes_below(const RuleSet &set, const std::vector<Definition> &definitions, uint32_t space) {
	std::vector<bool> is_below(set.spaces.size(), false);
	for (uint32_t i = 0; i < set.spaces.size(); ++i) { // parents come before their children
		is_below[i] = i == space || (set.spaces[i].parent != no_node && is_below[set.spaces[i].parent]);
	}
	std::vector<uint32_t> attributes;
	for (uint32_t i = 0; i < set.spaces.size(); ++i) {
		if (!is_below[i]) {
			continue;
		}
		for (const auto &[name, list] : set.spaces[i].values) {
			for (uint32_t definition : list) {
				if (definitions[definition].kind == Definition::Kind::Attribute) {
					attributes.push_back(definitions[definition].index);
				}
			}
		}
	}
	std::sort(attributes.begin(), attributes.end());
	return attributes;
}

} // namespace

void RuleSet::replace(uint32_t definition, uint32_t module, const AstOverride &by) {
	const Definition old = definitions[definition];
	Definition &changed = definitions[definition];
	changed.module = module;
	changed.offset = by.offset;
	changed.override_item = &by;
	if (old.item->is_extension && old.override_item == nullptr) {
		changed.replaced = uint32_t(definitions.size());
		definitions.push_back(old);
	}
}

// import imp : "f" (Ext --> My)   extension My --> imp.Ext: in My the call means the rule that My stands for, not My again.
uint32_t Compiler::replaced_by_caller(uint32_t definition) const {
	const Definition &called = _definitions[definition];
	if (called.replaced == no_node || _current_rule == no_node) {
		return definition;
	}
	const Module &module = _set.modules[called.module];
	const Ast &ast = _set.files[module.file]->ast;
	const auto commands = ast.list(ast.bodies[called.override_item->body].commands);
	const Command *only = commands.size() == 1 ? &ast.commands[commands[0]] : nullptr;
	const bool is_call = only != nullptr && only->kind == CommandKind::Call;
	const uint32_t own = is_call ? _set.find_rule(module.space, only->name, only->arguments.count) : no_node;
	return own != no_node && _definitions[own].index == _current_rule ? called.replaced : definition;
}

// import imp : "f"   attr x = imp.x + 1: in what the importing file gives, imp.x is what the import has of its own.
bool Compiler::is_given_here(uint32_t definition) const {
	const Definition &asked = _definitions[definition];
	return _current_value != no_node && (asked.inherits == _current_value || (asked.override_item != nullptr && definition == _current_value));
}

// An attribute that has no name for anybody else.
uint32_t Compiler::own_value_of(uint32_t definition) {
	const auto known = std::ranges::find(_own_values, definition, &OwnValue::definition);
	if (known != _own_values.end()) {
		return known->attribute;
	}
	AttributeInfo info;
	info.name = _definitions[definition].name + " of its own";
	info.place = _program->attributes[_definitions[definition].index].place;
	info.kind = AttributeInfo::Kind::Constant;
	_program->attributes.push_back(std::move(info));
	_own_values.push_back({ definition, uint32_t(_program->attributes.size() - 1) });
	return _own_values.back().attribute;
}

void Compiler::compile_own_values() {
	for (size_t i = 0; i < _own_values.size(); ++i) { // grows on the way
		const OwnValue value = _own_values[i];
		Definition own = _definitions[value.definition];
		own.module = own.own_module;
		own.override_item = nullptr;
		open_scope(own);
		_scope.is_attribute = true;
		_current_value = value.definition;
		begin_chunk();
		compile_locals(*own.item);
		expression(own.item->value);
		_program->attributes[value.attribute].code = end_chunk(OpCode::Return, own.item->offset);
	}
	_current_value = no_node;
}

uint32_t Compiler::begin_import(uint32_t import_call, uint32_t offset) {
	const AstImportCall &call = _scope.ast->import_calls[import_call];
	const std::string path = std::string(call.import) + ".x";
	std::string_view name = path;
	const uint32_t space = _set.enter_space(_scope.space, name);
	if (space == no_node || is_strict()) {
		complain(is_strict() ? "not-in-this-language" : "unknown-import", offset,
				is_strict() ? "calls of an import with attributes of their own exist in CGA only"
							: "there is no import `" + std::string(call.import) + "`");
		return no_node;
	}
	ImportScope scope;
	scope.attributes = attributes_below(_set, _definitions, space);
	for (const AstOverride &item : call.overrides) {
		if (item.is_protected()) { // as written anew, which it is anyway
			continue;
		}
		const uint32_t found = item.value == no_node ? no_node : _set.find_value(space, item.name, 0);
		if (found == no_node || _definitions[found].kind != Definition::Kind::Attribute) {
			warn("unknown-name", item.offset, item.value == no_node ? "a call replaces attributes only; rules are replaced where the file is imported"
							: "`" + std::string(call.import) + "` has no attribute `" + std::string(item.name) + "`");
			continue;
		}
		expression(item.value);
		scope.overridden.push_back(_definitions[found].index);
	}
	const size_t count = scope.overridden.size();
	_program->import_scopes.push_back(std::move(scope));
	emit(OpCode::BeginImport, offset, -int(count), uint32_t(_program->import_scopes.size() - 1), 0, count);
	return space;
}

void Compiler::import_command(const Command &command) {
	rule_arguments(command.arguments);
	const uint32_t space = begin_import(command.block, command.offset);
	const uint32_t rule = space == no_node ? no_node : _set.find_rule(space, command.name, command.arguments.count);
	const int effect = -int(command.arguments.count);
	if (rule != no_node) {
		emit(_dialect.rule_calls == Dialect::RuleCalls::ByHost ? OpCode::CallHostRule : OpCode::CallRule, command.offset, effect,
				_definitions[rule].index, 0, command.arguments.count);
		_edges.push_back({ _current_rule, _definitions[rule].index, false });
	} else {
		if (space != no_node && !_set.is_excused(space, command.name)) {
			warn("unknown-name", command.offset, "the import has no rule `" + std::string(command.name) + "` with so many parameters; it is left out");
		}
		for (uint32_t i = 0; i < command.arguments.count; ++i) {
			emit(OpCode::Pop, command.offset, -1);
		}
	}
	if (space != no_node) {
		emit(OpCode::EndImport, command.offset, 0);
	}
}

Compiler::Known Compiler::import_call(const Expr &expr) {
	// The arguments mean what they mean to the caller: they lie on the stack before the import's attributes are changed.
	for (uint32_t argument_id : _scope.ast->list(expr.children)) {
		expression(argument_id);
	}
	const uint32_t space = begin_import(expr.block, expr.offset);
	const uint32_t found = space == no_node ? no_node : _set.find_value(space, expr.name, expr.children.count);
	if (found != no_node) {
		const bool is_attribute = _definitions[found].kind == Definition::Kind::Attribute;
		emit(is_attribute ? OpCode::LoadAttribute : OpCode::CallUser, expr.offset, 1 - int(expr.children.count), _definitions[found].index, 0,
				expr.children.count);
	} else {
		if (space != no_node && !_set.is_excused(space, expr.name)) {
			warn("unknown-name", expr.offset, "the import has no function `" + std::string(expr.name) + "` with so many parameters");
		}
		for (uint32_t i = 0; i < expr.children.count; ++i) {
			emit(OpCode::Pop, expr.offset, -1);
		}
		unknown_value(expr.offset);
	}
	if (space != no_node) {
		emit(OpCode::EndImport, expr.offset, 0);
	}
	return ValueType::Void;
}

} // namespace pcg
