#include "core/lang/compiler.h"

#include <algorithm>
#include <bit>
#include <functional>

#include "core/base/random.h"

namespace pcg {

namespace {

// The same in every run: text by its number in the program.
uint64_t hash_constant(const Value &value) {
	const uint64_t type = uint64_t(value.type) << 8 | uint64_t(value.size_kind);
	switch (value.type) {
		case ValueType::Void: return type;
		case ValueType::Number: return derive_seed(type, std::bit_cast<uint64_t>(value.number));
		case ValueType::Bool: return derive_seed(type, value.boolean);
		case ValueType::Text: return derive_seed(type, value.text->symbol);
		default: return derive_seed(type, value.index);
	}
}

} // namespace

std::shared_ptr<const Program> compile(const RuleSet &set, const Dialect &dialect, Diagnostics &diagnostics) {
	return Compiler(set, dialect, diagnostics).run();
}

Compiler::Compiler(const RuleSet &set, const Dialect &dialect, Diagnostics &diagnostics)
		: _set(set), _dialect(dialect), _diagnostics(diagnostics), _program(std::make_shared<Program>()), _definitions(set.definitions) {}

std::shared_ptr<const Program> Compiler::run() {
	_program->dialect = &_dialect;
	for (const auto &file : _set.files) {
		_program->files.push_back(file->path);
		_program->sources.push_back(file->source);
	}
	// Where the outermost rule returns to.
	_program->code.push_back({ OpCode::End, 0, 0, 0 });
	_program->places.push_back({});
	for (size_t i = 0; !_set.files.empty() && i < _set.files[0]->ast.styles.size(); ++i) {
		const std::string name(_set.files[0]->ast.styles[i].name);
		const bool is_new = name != "Default" && std::find(_program->styles.begin(), _program->styles.end(), name) == _program->styles.end();
		if (is_new) {
			_program->styles.push_back(name);
		}
	}
	declare();
	compile_definitions();
	finish();
	return _diagnostics.has_errors() ? nullptr : _program;
}

// --- Declarations

std::vector<Annotation> Compiler::annotations_of(const Definition &definition) const {
	std::vector<Annotation> annotations;
	for (const AstAnnotation &annotation : definition.item->annotations) {
		annotations.push_back({ std::string(annotation.name), annotation.arguments });
	}
	return annotations;
}

uint32_t Compiler::slot(std::string_view slot_name) {
	const auto [found, is_new] = _slots.emplace(slot_name, uint32_t(_program->slot_names.size()));
	if (is_new) {
		_program->slot_names.emplace_back(slot_name);
	}
	return found->second;
}

// Every name that some parameter or set() makes a local.
void Compiler::collect_slots() {
	if (!is_dynamic()) {
		return;
	}
	for (const Definition &definition : _definitions) {
		for (const AstLocal &local : definition.item->locals) {
			slot(local.name);
		}
	}
	for (const auto &file : _set.files) {
		for (const Command &command : file->ast.commands) {
			if (command.kind == CommandKind::Call && command.name == "set" && command.arguments.count > 0) {
				const Expr &target = file->ast.exprs[file->ast.list(command.arguments)[0]];
				if (target.kind == ExprKind::Name) {
					slot(target.name);
				}
			}
		}
	}
	_program->slot_count = uint32_t(_program->slot_names.size());
}

void Compiler::add_params(Callable &callable, std::span<const AstParam> params) {
	callable.param_count = uint32_t(params.size());
	callable.frame_size = is_dynamic() ? 0 : callable.param_count;
	callable.first_slot = uint32_t(_program->param_slots.size());
	if (is_dynamic()) {
		for (const AstParam &param : params) {
			_program->param_slots.push_back(slot(param.name));
		}
	}
}

// The definition that the name of this one stands for.
size_t Compiler::winner_of(const Definition &definition) const {
	const uint32_t found = _set.find_rule(0, definition.name, definition.param_count);
	return found != no_node ? found : size_t(&definition - _definitions.data());
}

void Compiler::declare_rule(Definition &definition) {
	const AstItem &item = *definition.item;
	definition.index = uint32_t(_program->rules.size());
	RuleInfo info;
	info.name = definition.name;
	open_scope(definition);
	info.place = place(definition.offset);
	for (const AstParam &param : item.params) {
		info.params.emplace_back(param.name);
	}
	info.annotations = annotations_of(definition);
	info.has_paper_arrow = item.has_paper_arrow;
	info.is_replaced = winner_of(definition) != size_t(&definition - _definitions.data());
	_program->rules.push_back(std::move(info));
	_program->callables.emplace_back();
	add_params(_program->callables.back(), item.params);
}

void Compiler::declare_attribute(Definition &definition) {
	definition.index = uint32_t(_program->attributes.size());
	AttributeInfo info;
	info.name = definition.name;
	open_scope(definition);
	info.place = place(definition.offset);
	info.annotations = annotations_of(definition);
	info.default_text = definition.item->value_text;
	info.kind = definition.item->kind == AstItem::Kind::Attribute  ? AttributeInfo::Kind::Attribute
			: definition.item->kind == AstItem::Kind::Constant ? AttributeInfo::Kind::Constant
															   : AttributeInfo::Kind::Plain;
	_program->attributes.push_back(std::move(info));
}

void Compiler::declare_function(Definition &definition) {
	definition.index = uint32_t(_functions.size());
	_functions.emplace_back();
	add_params(_functions.back(), definition.item->params);
}

void Compiler::declare() {
	for (Definition &definition : _definitions) {
		switch (definition.kind) {
			case Definition::Kind::Rule:
				declare_rule(definition);
				break;
			case Definition::Kind::Attribute:
				declare_attribute(definition);
				break;
			case Definition::Kind::Function:
				declare_function(definition);
				break;
		}
	}
	collect_slots();
	mark_start_rules();
	check_annotations();
	if (_program->slot_names.size() > 0xFFFF && _scope.source != nullptr) {
		error("too-many-names", 0, "more than 65535 names of local values");
	}
}

// --- Definitions

void Compiler::open_scope(const Definition &definition) {
	const Module &module = _set.modules[definition.module];
	const ParsedFile &file = *_set.files[module.file];
	_scope = { &file.ast, file.source.get(), module.file, module.space, {}, false };
	const auto &params = definition.override_item != nullptr ? definition.override_item->params : definition.item->params;
	for (const AstParam &param : params) {
		_scope.locals.push_back(param.name);
	}
}

// Constants first, those of imported files before all: where they are plain values, what uses them can be looked at with them.
void Compiler::compile_definitions() {
	std::vector<const Definition *> constants, others;
	for (const Definition &definition : _definitions) {
		(is_dynamic() && is_constant(definition) ? constants : others).push_back(&definition);
	}
	std::ranges::stable_sort(constants, std::greater(), &Definition::module);
	_constant_values.resize(_program->attributes.size());
	for (const Definition *definition : constants) {
		compile_definition(*definition);
		_constant_values[definition->index] = constant_of(_program->attributes[definition->index].code);
	}
	for (const Definition *definition : others) {
		compile_definition(*definition);
	}
	compile_own_values();
}

void Compiler::compile_definition(const Definition &definition) {
	open_scope(definition);
	_current_value = definition.kind == Definition::Kind::Attribute ? uint32_t(&definition - _definitions.data()) : no_node;
	begin_chunk();
	if (definition.kind == Definition::Kind::Rule) {
		compile_rule(definition);
	} else {
		compile_value(definition);
	}
}

// `with ( a := e )`: values of the frame, computed when it begins.
void Compiler::compile_locals(const AstItem &item) {
	for (const AstLocal &local : item.locals) {
		expression(local.value);
		if (is_dynamic()) {
			emit(OpCode::SetSlot, local.offset, -1, slot(local.name));
		}
		_scope.locals.push_back(local.name);
	}
}

void Compiler::compile_rule(const Definition &definition) {
	_current_rule = definition.index;
	if (definition.override_item != nullptr) {
		body(definition.override_item->body);
	} else {
		compile_locals(*definition.item);
		body(definition.item->body);
	}
	_current_rule = no_node;
	const Chunk code = end_chunk(OpCode::End, definition.offset);
	_program->rules[definition.index].code = code;
	Callable &callable = _program->callables[definition.index];
	callable.code = code;
	callable.frame_size = is_dynamic() ? 0 : uint32_t(_scope.locals.size());
}

void Compiler::compile_value(const Definition &definition) {
	const bool is_attribute = definition.kind == Definition::Kind::Attribute;
	_scope.is_attribute = is_attribute;
	Known known = ValueType::Void;
	if (definition.inherits != no_node) {
		emit(OpCode::LoadAttribute, definition.offset, 1, _definitions[definition.inherits].index);
	} else if (definition.override_item != nullptr) {
		known = expression(definition.override_item->value);
	} else {
		compile_locals(*definition.item);
		known = expression(definition.item->value);
	}
	const Chunk code = end_chunk(OpCode::Return, definition.offset);
	if (is_attribute) {
		_program->attributes[definition.index].code = code;
		_program->attributes[definition.index].type = known;
	} else {
		_functions[definition.index].code = code;
		_functions[definition.index].frame_size = is_dynamic() ? 0 : uint32_t(_scope.locals.size());
	}
}

void Compiler::finish() {
	const uint32_t rule_count = uint32_t(_program->callables.size());
	_program->callables.insert(_program->callables.end(), _functions.begin(), _functions.end());
	uint64_t fingerprint = _program->code.size();
	for (Instruction &instruction : _program->code) {
		if (instruction.code == OpCode::CallUser) { // Rules may have been added after this was compiled.
			instruction.operand += rule_count;
		}
		const uint64_t word = uint64_t(instruction.operand) << 32 | uint64_t(instruction.extra) << 16 | uint64_t(instruction.count) << 8 |
				uint64_t(instruction.code);
		fingerprint = fingerprint * 0x9E3779B97F4A7C15ull ^ word;
	}
	for (const Text &text : _program->texts) {
		fingerprint = fingerprint * 0x9E3779B97F4A7C15ull ^ hash_text(text.view);
	}
	for (const Value &value : _program->constants) {
		fingerprint = fingerprint * 0x9E3779B97F4A7C15ull ^ hash_constant(value);
	}
	_program->fingerprint = fingerprint;
	if (is_strict() && !_diagnostics.has_errors()) {
		warn_unused_and_phases();
	}
}

// --- Code

uint32_t Compiler::symbol(std::string_view text) {
	const auto [found, is_new] = _symbols.emplace(std::string(text), uint32_t(_program->texts.size()));
	if (is_new) {
		_program->text_storage.emplace_back(text);
		_program->texts.push_back({ _program->text_storage.back(), found->second });
	}
	return found->second;
}

uint32_t Compiler::constant(const Value &value) {
	_program->constants.push_back(value);
	return uint32_t(_program->constants.size() - 1);
}

uint32_t Compiler::emit(OpCode code, uint32_t offset, int effect, uint32_t operand, uint32_t extra, size_t count) {
	Builder &builder = _builders.back();
	if (count > 255) {
		error("too-many-arguments", offset, "more than 255 arguments");
		count = 255;
	}
	builder.code.push_back({ code, uint8_t(count), uint16_t(extra), operand });
	builder.places.push_back(place(offset));
	builder.depth = uint32_t(int(builder.depth) + effect);
	builder.max_depth = std::max(builder.max_depth, builder.depth + 1);
	return here() - 1;
}

uint32_t Compiler::emit_jump(OpCode code, uint32_t offset, int effect, uint32_t extra) { return emit(code, offset, effect, 0, extra); }

void Compiler::land(uint32_t jump) { _builders.back().code[jump].operand = here() - jump - 1; }

void Compiler::emit_constant(const Value &value, uint32_t offset) { emit(OpCode::PushConstant, offset, 1, constant(value)); }

bool Compiler::ends_in_constant(uint32_t begin, Value &value) const {
	const Builder &builder = _builders.back();
	if (builder.code.size() != begin + 1 || builder.code.back().code != OpCode::PushConstant) {
		return false;
	}
	value = _program->constants[builder.code.back().operand];
	return true;
}

void Compiler::drop_code(uint32_t begin, uint32_t depth) {
	Builder &builder = _builders.back();
	builder.code.resize(begin);
	builder.places.resize(begin);
	builder.depth = depth;
}

Chunk Compiler::end_chunk(OpCode last, uint32_t offset) {
	emit(last, offset, 0);
	Builder builder = std::move(_builders.back());
	_builders.pop_back();
	const Chunk chunk = Chunk(_program->code.size());
	_program->code.insert(_program->code.end(), builder.code.begin(), builder.code.end());
	_program->places.insert(_program->places.end(), builder.places.begin(), builder.places.end());
	_program->max_stack = std::max(_program->max_stack, builder.max_depth + 1);
	return chunk;
}

} // namespace pcg
