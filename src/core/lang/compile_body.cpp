#include <algorithm>
#include <utility>
#include <charconv>

#include "core/lang/compiler.h"

// Successors to code that leaves nothing on the stack.
namespace pcg {

void Compiler::body(uint32_t id) {
	for (uint32_t child : _scope.ast->list(_scope.ast->bodies[id].commands)) {
		command(_scope.ast->commands[child]);
	}
}

Chunk Compiler::body_chunk(uint32_t id, uint32_t offset) {
	begin_chunk();
	body(id);
	return end_chunk(OpCode::End, offset);
}

void Compiler::command(const Command &command) {
	switch (command.kind) {
		case CommandKind::Call:
			call_command(command);
			return;
		case CommandKind::Group:
			emit(OpCode::PushGroup, command.offset, 0);
			body(command.body);
			emit(OpCode::PopGroup, command.offset, 0);
			return;
		case CommandKind::Case:
			case_command(command);
			return;
		case CommandKind::Chance:
			chance_command(command);
			return;
		case CommandKind::Inline:
			inline_command(command);
			return;
		case CommandKind::ImportCall:
			import_command(command);
			return;
	}
}

// inline { .. }: an operation with one body, where the dialect has it.
void Compiler::inline_command(const Command &command) {
	const int operation = _dialect.find_operation("inline", 1);
	if (operation < 0) {
		complain("not-in-this-language", command.offset, "inline exists in CGA only; its commands run as if they stood here");
		body(command.body);
		return;
	}
	Expr word;
	word.kind = ExprKind::Name;
	word.offset = command.offset;
	word.name = command.name.empty() ? std::string_view("append") : command.name;
	if (!word_argument(_dialect.operations[size_t(operation)].params[0], word)) {
		complain("unknown-word", command.offset, "inline takes one of: " + std::string(_dialect.operations[size_t(operation)].params[0].words));
		emit_constant(Value::of_index(ValueType::Word, 0), command.offset);
	}
	BlockEntry entry;
	entry.place = place(command.offset);
	entry.body = body_chunk(command.body, command.offset);
	_program->blocks.push_back({ uint32_t(_program->entries.size()), 1, false });
	_program->entries.push_back(entry);
	emit(OpCode::CallBlock, command.offset, -1, uint32_t(_program->blocks.size() - 1), uint32_t(operation), 1);
	emit(OpCode::Data, command.offset, 0, 0);
	emit(OpCode::Data, command.offset, 0, 0);
}

// --- Chains

void Compiler::case_command(const Command &command) {
	const auto branches = _scope.ast->list(command.branches);
	std::vector<uint32_t> ends;
	bool has_else = false, is_decided = false;
	for (uint32_t id : branches) {
		const Branch &branch = _scope.ast->branches[id];
		has_else = branch.condition == no_node;
		warn_unreachable(is_decided, branch.offset);
		warn_indented(_scope.ast->branches[branches[0]].offset, branch.offset);
		if (has_else) {
			body(branch.body);
			break;
		}
		const uint32_t begin = here();
		expression(branch.condition);
		Value constant;
		is_decided = ends_in_constant(begin, constant) && is_always_true(constant, branch.offset);
		const uint32_t next = emit_jump(OpCode::JumpIfFalse, _scope.ast->exprs[branch.condition].offset, -1);
		body(branch.body);
		if (id != branches.back()) {
			ends.push_back(emit_jump(OpCode::Jump, branch.offset, 0));
		}
		land(next);
	}
	for (uint32_t end : ends) {
		land(end);
	}
	if (!has_else && !is_strict()) {
		warn("missing-else", command.offset, "this `case` has no `else:`", "where no condition holds, nothing happens");
	}
}

void Compiler::chance_command(const Command &command) {
	std::vector<uint32_t> ends, shares;
	emit(OpCode::Draw, command.offset, 1);
	for (uint32_t id : _scope.ast->list(command.branches)) {
		const Branch &branch = _scope.ast->branches[id];
		if (branch.condition == no_node) {
			emit(OpCode::Pop, branch.offset, -1);
			body(branch.body);
			break;
		}
		shares.push_back(branch.condition);
		share(branch.condition);
		const uint32_t next = emit_jump(OpCode::ChanceJump, _scope.ast->exprs[branch.condition].offset, -2);
		body(branch.body);
		ends.push_back(emit_jump(OpCode::Jump, branch.offset, 1));
		land(next);
	}
	const auto branches = _scope.ast->list(command.branches);
	if (!branches.empty() && _scope.ast->branches[branches.back()].condition != no_node) {
		emit(OpCode::Pop, command.offset, -1);
	}
	for (uint32_t end : ends) {
		land(end);
	}
	warn_shares(shares);
}

// --- Calls

void Compiler::call_command(const Command &command) {
	if (is_dynamic() && command.name == "set") {
		set_local(command);
		return;
	}
	const uint32_t rule = _set.find_rule(_scope.space, command.name, command.arguments.count);
	if (rule != no_node && command.block == no_node) {
		rule_call(rule, command);
		return;
	}
	const int operation = choose_operation(command.name, command.arguments);
	if (operation >= 0) {
		operation_call(operation, command);
		return;
	}
	unknown_command(command);
}

// set(name, expr): the name is seen by this rule from here on and by the rules that it calls after it.
void Compiler::set_local(const Command &command) {
	const auto list = _scope.ast->list(command.arguments);
	if (is_broken(command.arguments)) {
		return;
	}
	if (list.size() != 2) {
		complain("wrong-argument-count", command.offset, "`set` does not take " + std::to_string(list.size()) + " arguments",
				"it is set(name, value)");
		return;
	}
	const Expr &target = _scope.ast->exprs[list[0]];
	if (target.kind != ExprKind::Name || target.name.find('.') != std::string_view::npos) {
		complain("not-a-name", target.offset, "`set` needs a plain name first", "as in set(time, 5m)");
		return;
	}
	const uint32_t value = _set.find_value(_scope.space, target.name, 0);
	const bool is_const = value != no_node && is_constant(_definitions[value]);
	const int variable = value == no_node ? _dialect.find_variable(target.name) : -1;
	if (is_const || (variable >= 0 && !_dialect.variables[size_t(variable)].is_writable)) {
		complain("read-only", target.offset, "`" + std::string(target.name) + "` can only be read",
				is_const ? "it is declared with const" : "the language gives its value: take another name");
	}
	expression(list[1]);
	emit(OpCode::SetSlot, command.offset, -1, slot(target.name));
}

void Compiler::rule_arguments(NodeRange list) {
	for (uint32_t id : _scope.ast->list(list)) {
		expression(id);
	}
}

void Compiler::rule_call(uint32_t definition, const Command &command) {
	rule_arguments(command.arguments);
	const bool is_by_host = _dialect.rule_calls == Dialect::RuleCalls::ByHost;
	const uint32_t index = _definitions[replaced_by_caller(definition)].index;
	_edges.push_back({ _current_rule, index, false });
	emit(is_by_host ? OpCode::CallHostRule : OpCode::CallRule, command.offset, -int(command.arguments.count), index, 0,
			command.arguments.count);
}

void Compiler::operation_call(int operation, const Command &command) {
	const OperationSpec &spec = _dialect.operations[size_t(operation)];
	const uint32_t mask = arguments(spec.params, spec.name, command.arguments);
	const int effect = -int(command.arguments.count);
	_uses.push_back({ _current_rule, uint32_t(operation), place(command.offset) });
	const uint32_t at = check_constants(uint32_t(operation), command);
	if (spec.block == BlockKind::None) {
		if (command.block != no_node) {
			complain("unexpected-block", _scope.ast->blocks[command.block].offset, "`" + std::string(spec.name) + "` takes no { }");
		}
		emit(OpCode::CallOperation, at, effect, mask, uint32_t(operation), command.arguments.count);
		return;
	}
	if (command.block == no_node) {
		complain("missing-block", command.offset, "`" + std::string(spec.name) + "` needs { } behind it");
		return;
	}
	_open_blocks.push_back({ uint32_t(operation), _constant_arguments.empty() ? Value() : _constant_arguments[0] });
	const uint32_t first = block(command.block, spec.block);
	const uint32_t second = command.second_block == no_node ? 0 : block(command.second_block, spec.block == BlockKind::Sizes ? BlockKind::Selectors : spec.block) + 1;
	_open_blocks.pop_back();
	emit(OpCode::CallBlock, at, effect, first, uint32_t(operation), command.arguments.count);
	emit(OpCode::Data, at, 0, mask);
	emit(OpCode::Data, at, 0, second);
}

void Compiler::unknown_command(const Command &command) {
	if (_set.has_rule(_scope.space, command.name) || _dialect.has_operation(command.name)) {
		wrong_count(command.name, command.arguments, command.offset);
		return;
	}
	if (is_strict() && (_dialect.has_function(command.name) || _set.has_value(_scope.space, command.name))) {
		const bool is_function = _dialect.has_function(command.name) || command.has_arguments;
		complain("not-a-command", command.offset,
				"`" + std::string(command.name) + "` is a " + (is_function ? "function" : "value") + ", not a rule or an operation",
				"use it inside of an expression");
		return;
	}
	if (is_strict()) {
		unknown("rule or operation", command.name, command.offset, true);
		return;
	}
	if (command.block != no_node) {
		warn("unknown-name", command.offset, "unknown operation `" + std::string(command.name) + "`; it is left out",
				did_you_mean(command.name, true));
		return;
	}
	leaf_call(command);
}

// A name without a rule is a shape that stays as it is.
void Compiler::leaf_call(const Command &command) {
	const std::string key = std::string(command.name) + "/" + std::to_string(command.arguments.count);
	const auto [found, is_new] = _leaves.emplace(key, uint32_t(_program->rules.size()));
	if (is_new) {
		RuleInfo info;
		info.name = std::string(command.name);
		info.params.resize(command.arguments.count);
		info.place = place(command.offset);
		info.is_leaf_symbol = true;
		_program->rules.push_back(std::move(info));
		Callable callable;
		callable.param_count = command.arguments.count;
		_program->callables.push_back(callable);
		if (!command.name.ends_with('.') && !_set.is_excused(_scope.space, command.name)) {
			std::string hint = did_you_mean(command.name, true);
			hint += (hint.empty() ? "" : " ") + std::string("If the shape is meant to end here, write a dot behind the name.");
			warn("unknown-name", command.offset, "no rule or operation is called `" + std::string(command.name) + "`; the shape ends here", hint);
		}
	}
	rule_arguments(command.arguments);
	emit(OpCode::CallHostRule, command.offset, -int(command.arguments.count), found->second, 0, command.arguments.count);
}

// --- Blocks

uint32_t Compiler::block(uint32_t id, BlockKind kind) {
	const AstBlock &source = _scope.ast->blocks[id];
	const auto list = _scope.ast->list(source.entries);
	const uint32_t index = uint32_t(_program->blocks.size());
	const uint32_t first = uint32_t(_program->entries.size());
	_program->blocks.push_back({ first, uint32_t(list.size()), source.is_repeated });
	_program->entries.resize(first + list.size());
	bool is_decided = false;
	for (size_t i = 0; i < list.size(); ++i) {
		const AstEntry &written = _scope.ast->entries[list[i]];
		warn_unreachable(is_decided, written.offset);
		const BlockEntry entry = block_entry(written, kind);
		is_decided = kind == BlockKind::Predicates && entry.head != Chunk::None && is_always_true(constant_of(entry.head), written.offset);
		_program->entries[first + i] = entry; // after the nested blocks have had theirs
	}
	return index;
}

// False: the entry has no commands, because of a mistake that the parser has told.
bool Compiler::check_head(const AstEntry &source, BlockKind kind) {
	const bool has_head = source.head != no_node;
	if (has_head && kind == BlockKind::Bodies) {
		complain("unexpected-head", source.offset, "nothing is selected here: this block holds commands only");
	}
	if (!has_head && kind == BlockKind::Selectors) {
		complain("missing-head", source.offset, "a selector and `:` belong in front of the commands", "for all: { all: .. }");
	}
	return has_head || kind != BlockKind::Predicates;
}

BlockEntry Compiler::block_entry(const AstEntry &source, BlockKind kind) {
	BlockEntry entry;
	entry.place = place(source.offset);
	if (source.kind != AstEntry::Kind::Body) {
		entry.kind = source.kind == AstEntry::Kind::Repeat ? BlockEntry::Kind::Repeat : BlockEntry::Kind::Group;
		if (kind != BlockKind::Sizes) {
			complain("nested-block", source.offset, "blocks inside of blocks have a meaning in splits only");
		}
		entry.block = block(source.block, kind);
		return entry;
	}
	entry.separator = source.separator == TokenKind::Assign	   ? BlockEntry::Separator::All
			: source.separator == TokenKind::ConnectedAssign ? BlockEntry::Separator::Connected
															 : BlockEntry::Separator::Each;
	const bool has_head = source.head != no_node;
	if (!check_head(source, kind)) {
		return entry;
	}
	if (source.depth != no_node) {
		entry.depth = value_chunk(source.depth, true);
	}
	if (has_head && kind != BlockKind::Bodies) {
		const BlockEntry head = entry_with_head(source, kind);
		entry.word = head.word;
		entry.head = head.head;
	} else if (kind == BlockKind::Sizes) {
		entry.head = missing_size(source);
	}
	entry.body = _has_value_blocks ? value_chunk(source.body, false) : body_chunk(source.body, source.offset);
	return entry;
}

// What gives a value without arguments: of the rule set, a parameter, or built in.
bool Compiler::is_value_name(std::string_view name) const {
	const bool is_own = _set.has_value(_scope.space, name) || std::find(_scope.locals.begin(), _scope.locals.end(), name) != _scope.locals.end();
	return is_own || (!is_selector_word(name) && (_dialect.find_function(name, 0) >= 0 || _dialect.find_variable(name) >= 0));
}

BlockEntry Compiler::entry_with_head(const AstEntry &source, BlockKind kind) {
	BlockEntry entry;
	const Expr &head = _scope.ast->exprs[source.head];
	const bool is_word = kind == BlockKind::Selectors && head.kind == ExprKind::Name;
	entry.word = is_word ? symbol(head.name) : no_symbol;
	const bool is_defined = is_word && is_value_name(head.name);
	if (is_word && !is_defined && !_dialect.selector_words.empty() && !is_selector_word(head.name)) {
		warn("unknown-selector", head.offset, "`" + std::string(head.name) + "` selects nothing: there is no selector, value or function of that name");
	}
	if (!is_word || is_defined) {
		const bool was_selector = std::exchange(_scope.is_selector, kind == BlockKind::Selectors);
		entry.head = value_chunk(source.head, kind == BlockKind::Sizes);
		_scope.is_selector = was_selector;
	}
	return entry;
}

// Up to 2014 a part without a size had the weight 1.
Chunk Compiler::missing_size(const AstEntry &source) {
	if (!is_older_than(2015.0)) {
		warn("missing-size", source.offset, "a size and `:` belong in front of the commands; ~1 is taken", "for what is left: { ~1: .. }");
	}
	begin_chunk();
	Value one = Value::of(1.0);
	one.size_kind = SizeKind::Flexible;
	emit_constant(one, source.offset);
	return end_chunk(OpCode::Return, source.offset);
}

bool Compiler::is_older_than(double version) const {
	double own = 2009.1; // of files that do not say it
	const std::string_view text = _scope.ast->version;
	std::from_chars(text.data(), text.data() + text.size(), own);
	return own < version;
}

} // namespace pcg
