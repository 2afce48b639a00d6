#include "tests/core/lang/test_dialects.h"

namespace pcg::test {

namespace {

LogHost &log_of(Vm &vm) { return static_cast<LogHost &>(vm.host()); }

// log(..): writes its arguments.
Flow op_log(Vm &vm, const Args &args) {
	std::string line;
	for (const Value &value : args.values) {
		const char *const prefix = value.size_kind == SizeKind::Relative ? "'" : (value.size_kind == SizeKind::Flexible ? "~" : "");
		line += (line.empty() ? "" : ",") + std::string(value.is_number() ? prefix : "") + value_text(value);
	}
	log_of(vm).log.push_back(line);
	return Flow::Next;
}

Flow op_wait(Vm &vm, const Args &) {
	log_of(vm).log.emplace_back("wait");
	return Flow::Pause;
}

Flow op_stop(Vm &, const Args &) { return Flow::Stop; }

// As members of the agenda dialect: the first entry that holds for a member runs with that member as the focus.
Flow op_members(Vm &vm, const Args &args) {
	LogHost &host = log_of(vm);
	const int before = host.focus;
	for (size_t member = 0; member < host.members.size(); ++member) {
		host.focus = int(member);
		for (const BlockEntry &entry : vm.entries(*args.block)) {
			const Value head = vm.evaluate(entry.head);
			if (vm.has_failed()) {
				return Flow::Stop;
			}
			if (head.is_bool() && head.boolean) {
				if (vm.run_body(entry.body) != Flow::Next) {
					return Flow::Stop;
				}
				break;
			}
		}
	}
	host.focus = before;
	return Flow::Next;
}

Value count_members(Vm &vm, const Args &args) {
	LogHost &host = log_of(vm);
	const int before = host.focus;
	double count = 0;
	for (size_t member = 0; member < host.members.size(); ++member) {
		host.focus = int(member);
		const Value matches = args.count() == 0 ? Value::of(true) : vm.evaluate(Chunk(args[0].chunk));
		count += matches.is_bool() && matches.boolean ? 1 : 0;
	}
	host.focus = before;
	return Value::of(count);
}

Flow op_later(Vm &vm, const Args &args) {
	log_of(vm).log.push_back("later:" + vm.program().rules[args[0].rule].name);
	return Flow::Next;
}

Value read_age(Vm &vm) {
	const LogHost &host = log_of(vm);
	return host.focus < 0 ? vm.fail("needs-focus", "`age` needs a focused person") : Value::of(host.members[size_t(host.focus)]);
}

Value read_time(Vm &) { return Value::of(77.0); }

void log_entries(Vm &vm, const Block &block) {
	LogHost &host = log_of(vm);
	host.log.emplace_back("{");
	for (const BlockEntry &entry : vm.entries(block)) {
		if (entry.kind != BlockEntry::Kind::Body) {
			log_entries(vm, vm.program().blocks[entry.block]);
			continue;
		}
		const char *const separator = entry.separator == BlockEntry::Separator::All ? "="
				: entry.separator == BlockEntry::Separator::Connected				? "=:"
																					: ":";
		std::string head = entry.word != no_symbol ? std::string(vm.program().texts[entry.word].view) : "";
		if (entry.head != Chunk::None) {
			const Value value = vm.evaluate(entry.head);
			head += value.size_kind == SizeKind::Flexible ? "~" : (value.size_kind == SizeKind::Relative ? "'" : "");
			head += value_text(value);
		}
		host.log.push_back(head + separator);
		vm.run_body(entry.body);
	}
	host.log.emplace_back(block.is_repeated ? "}*" : "}");
}

Flow op_block(Vm &vm, const Args &args) {
	log_entries(vm, *args.block);
	return Flow::Next;
}

Flow op_set(Vm &vm, const Args &args) {
	if (args[0].type == ValueType::Attribute) {
		vm.attribute_values()[args[0].index] = args[1];
	} else {
		log_of(vm).log.push_back("set variable " + std::string(vm.program().dialect->variables[args[0].index].name));
	}
	return Flow::Next;
}

ParamSpec repeated(std::string_view name) {
	ParamSpec param = { name, ParamKind::Any };
	param.is_repeated = true;
	return param;
}

Dialect make_day() {
	Dialect dialect;
	dialect.name = "day";
	dialect.locals = Dialect::Locals::Dynamic;
	dialect.has_time_units = true;
	add_math_functions(dialect);
	ParamSpec optional_predicate = { "predicate", ParamKind::Predicate };
	optional_predicate.is_optional = true;
	dialect.functions.push_back({ "count", { optional_predicate }, ValueType::Number, count_members, "" });
	dialect.operations = {
		{ "log", { repeated("values") }, BlockKind::None, op_log, "" },
		{ "wait", { { "seconds", ParamKind::Number } }, BlockKind::None, op_wait, "", Phase::Simulation },
		{ "stop", {}, BlockKind::None, op_stop, "", Phase::Both },
		{ "members", {}, BlockKind::Predicates, op_members, "" },
		{ "later", { { "rule", ParamKind::Rule } }, BlockKind::None, op_later, "" },
		{ "days", { { "mask", ParamKind::Text } }, BlockKind::Bodies, op_block, "" },
	};
	dialect.variables = { { "age", ValueType::Number, read_age, "" }, { "time", ValueType::Number, read_time, "", true } };
	return dialect;
}

Dialect make_shape() {
	Dialect dialect;
	dialect.name = "shape";
	dialect.locals = Dialect::Locals::Lexical;
	dialect.rule_calls = Dialect::RuleCalls::ByHost;
	dialect.unknown_names = Dialect::UnknownNames::LeafSymbol;
	add_math_functions(dialect);
	dialect.operations = {
		{ "log", { repeated("values") }, BlockKind::None, op_log, "" },
		{ "split", { { "axis", ParamKind::Word, "x y z" } }, BlockKind::Sizes, op_block, "" },
		{ "comp", { { "kind", ParamKind::Word, "f e v" } }, BlockKind::Selectors, op_block, "" },
		{ "set", { { "name", ParamKind::Target }, { "value", ParamKind::Any } }, BlockKind::None, op_set, "" },
		{ "extrude", { { "height", ParamKind::Number } }, BlockKind::None, op_log, "" },
		{ "extrude", { { "mode", ParamKind::Word, "world.up face.normal" }, { "height", ParamKind::Number } }, BlockKind::None, op_log, "" },
	};
	VariableSpec color = { "material.color.r", ValueType::Number, read_time, "" };
	color.is_writable = true;
	dialect.variables = { color, { "scope.sx", ValueType::Number, read_time, "" } };
	return dialect;
}

} // namespace

std::string LogHost::text() const {
	std::string joined;
	for (const std::string &line : log) {
		joined += (joined.empty() ? "" : " ") + line;
	}
	return joined;
}

Flow LogHost::call_rule(Vm &vm, RuleId rule, std::span<const Value> args) {
	const RuleInfo &info = vm.program().rules[index_of(rule)];
	log.push_back((info.is_leaf_symbol ? "leaf:" : "") + info.name);
	if (!info.is_leaf_symbol && runs_called_rules) {
		vm.call(rule, std::vector<Value>(args.begin(), args.end()));
	}
	return Flow::Next;
}

const Dialect &day_dialect() {
	static const Dialect dialect = make_day();
	return dialect;
}

const Dialect &shape_dialect() {
	static const Dialect dialect = make_shape();
	return dialect;
}

std::shared_ptr<const Program> program_of(const std::string &text, const Dialect &dialect, Diagnostics &diagnostics) {
	MemorySourceProvider provider;
	provider.add("test.rules", text);
	return load_program("test.rules", dialect, provider, diagnostics);
}

namespace {

std::string run_text(const std::string &text, const Dialect &dialect, uint64_t seed) {
	Diagnostics diagnostics;
	const auto program = program_of(text, dialect, diagnostics);
	if (program == nullptr) {
		return to_text(diagnostics);
	}
	LogHost host;
	Vm vm(*program, host);
	vm.begin(seed);
	const RunState state = vm.call(program->find_rule("Start"));
	if (state != RunState::Finished) {
		host.log.emplace_back(state == RunState::Failed ? "failed " + places_of(host.diagnostics) : "paused");
	}
	return host.text();
}

std::string check_text(const std::string &text, const Dialect &dialect) {
	Diagnostics diagnostics;
	program_of(text, dialect, diagnostics);
	return places_of(diagnostics);
}

} // namespace

std::string run_day(const std::string &text, uint64_t seed) { return run_text(text, day_dialect(), seed); }
std::string run_shape(const std::string &text, uint64_t seed) { return run_text(text, shape_dialect(), seed); }
std::string check_day(const std::string &text) { return check_text(text, day_dialect()); }
std::string check_shape(const std::string &text) { return check_text(text, shape_dialect()); }

std::string places_of(const Diagnostics &diagnostics) {
	std::string text;
	for (const Diagnostic &diagnostic : diagnostics.list()) {
		text += (text.empty() ? "" : "; ") + std::string(diagnostic.id) + " " + std::to_string(diagnostic.line) + ":" +
				std::to_string(diagnostic.column);
	}
	return text;
}

} // namespace pcg::test
