#include "core/cga/context.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/cga/color.h"
#include "core/cga/initial_shape.h"

namespace pcg::cga {

namespace {

constexpr size_t most_texts = 100'000; // kept from lot to lot; more are made by rules that glue names together

VmLimits vm_limits(const DeriveLimits &limits) {
	VmLimits result;
	result.max_depth = limits.max_depth;
	result.max_steps = limits.max_steps;
	return result;
}

std::string_view object_tag(const RuleInfo &rule) {
	for (const Annotation &annotation : rule.annotations) {
		if (annotation.name == "Object" || annotation.name == "object") {
			return annotation.arguments.empty() ? std::string_view("object") : std::string_view(annotation.arguments[0]);
		}
	}
	return {};
}

} // namespace

Context::Context(const Program &program, const DeriveOptions &options)
		: assets(options.assets, program), vm(program, *this, vm_limits(options.limits)), _program(program), _options(options) {
	for (const Text &text : program.texts) {
		_selectors.push_back(selector_of(text.view));
		KnownColor &known = _colors.emplace_back();
		known.color.a = -1.0f;
		known.is_color = parse_color(text.view, known.color);
		known.has_opacity = known.color.a >= 0.0f;
	}
	for (const RuleInfo &rule : program.rules) {
		_object_tags.push_back(object_tag(rule));
	}
	_context_use = context_use(program);
}

bool Context::set_up(const InitialShape &initial_shape) {
	if (_program.dialect == nullptr || _program.dialect->name != "cga") {
		model.begin({});
		model.result().diagnostics.error("wrong-dialect", "these rules are not written in the shape grammar", "buildings are derived by .cga files");
		return false;
	}
	_initial_shape = &initial_shape;
	_lot = {};
	_saved.clear();
	_groups.clear();
	_stack.clear();
	_children.clear();
	_collected = nullptr;
	_body = { Random(initial_shape.seed), 0, false };
	arena.release({});
	shape = {};
	shape.look = &_default_look;
	_is_stopped = false;
	shape.seed = initial_shape.seed;
	Diagnostics diagnostics;
	const bool is_usable = make_initial_shape(initial_shape, builder, arena, _lot, shape, diagnostics);
	if (model.materials().texts().size() > most_texts) {
		model.materials().texts().clear();
		texture_files.clear();
	}
	model.begin(_lot, _options.counts_vertices);
	assets.begin();
	model.result().diagnostics.append(diagnostics);
	vm.begin(initial_shape.seed);
	vm.forget_warnings();
	vm.use_random(_body.random);
	if (is_usable) {
		set_overrides();
		vm.evaluate_attributes();
		shape.attributes = vm.attribute_values();
		own_attributes();
	}
	return is_usable && !vm.has_failed();
}

void Context::set_overrides() {
	vm.clear_overrides();
	for (const AttributeOverride &attribute : _initial_shape->attributes) {
		if (override_attribute(vm, attribute)) {
			continue;
		}
		if (std::optional<Diagnostic> problem = attribute_problem(_program, attribute)) {
			problem->severity = Severity::Warning; // lots of one city take what they know
			model.result().diagnostics.add(std::move(*problem));
		}
	}
}

RuleId Context::find_start_rule() const {
	const std::string &wanted = _initial_shape->start_rule;
	RuleId rule = wanted.empty() ? _program.start_rule : _program.find_rule(wanted);
	if (!is_valid(rule) && wanted.empty()) {
		rule = _program.find_rule("Lot");
		for (uint32_t i = 0; i < _program.rules.size() && !is_valid(rule); ++i) {
			const RuleInfo &info = _program.rules[i];
			rule = info.params.empty() && !info.is_leaf_symbol && !info.is_replaced ? RuleId(i) : rule;
		}
	}
	return rule;
}

std::string_view Context::start_rule_name() const {
	const RuleId rule = find_start_rule();
	return is_valid(rule) ? std::string_view(_program.rules[index_of(rule)].name) : std::string_view(_initial_shape->start_rule);
}

RuleId Context::start_rule() {
	const std::string &wanted = _initial_shape->start_rule;
	const RuleId rule = find_start_rule();
	if (!is_valid(rule)) {
		model.result().diagnostics.error("unknown-start-rule",
				wanted.empty() ? std::string("the rule set has no rule to start with") : "there is no rule \"" + wanted + "\" without parameters to start with",
				"mark one with @StartRule");
	}
	return rule;
}

void Context::run_rules(RuleId start) {
	_stack.push_back({ start, arena.make(shape), nullptr, 0, {} });
	while (!_stack.empty()) {
		const Pending pending = _stack.back();
		_stack.pop_back();
		if (!is_valid(pending.rule)) {
			arena.release(pending.mark);
			continue;
		}
		const Arena::Mark mark = arena.mark();
		if (!run_rule(pending)) {
			return;
		}
		if (_children.empty()) {
			arena.release(mark);
			continue;
		}
		_stack.push_back({ RuleId::Invalid, nullptr, nullptr, 0, mark });
		_stack.insert(_stack.end(), _children.rbegin(), _children.rend());
	}
}

// False: the derivation ends here.
bool Context::run_rule(const Pending &pending) {
	_children.clear();
	_successor_count = 0;
	if (!count_shape()) {
		return false;
	}
	const std::string_view tag = _object_tags[index_of(pending.rule)];
	if (!tag.empty()) {
		pending.shape->object = model.begin_object(tag, *pending.shape);
	}
	make_current(*pending.shape);
	_body = { Random(shape.seed), 0, false };
	_saved.push_back(pending.shape);
	const RunState state = vm.call(pending.rule, { pending.args, pending.arg_count });
	_saved.pop_back();
	if (!_body.is_replaced) {
		add_leaf(shape);
	}
	return state == RunState::Finished && !_is_stopped;
}

void Context::add_leaf(const Shape &leaf) {
	if (_collected != nullptr) {
		_collected->push_back(leaf);
		return;
	}
	surroundings.record(leaf, 0);
	if (!_is_rehearsal) {
		model.add_leaf(leaf);
	}
}

bool Context::is_interrupted() {
	const double most_seconds = _options.limits.max_seconds;
	const bool is_cancelled = _options.cancel != nullptr && _options.cancel->load(std::memory_order_relaxed);
	const bool is_late = most_seconds > 0.0 && std::chrono::duration<double>(std::chrono::steady_clock::now() - _start).count() > most_seconds;
	if ((is_cancelled || is_late) && !_is_stopped) {
		_is_stopped = true;
		if (is_cancelled) {
			model.result().diagnostics.error("cancelled", "the derivation was cancelled");
		} else {
			model.result().diagnostics.error("time-limit", "the derivation was stopped after " + value_text(Value::of(most_seconds)) + " seconds",
					"raise the limit, or look for a rule that calls itself without end");
		}
	}
	return _is_stopped;
}

bool Context::check_limits() {
	const DeriveLimits &limits = _options.limits;
	DerivationResult &result = model.result();
	if ((result.shape_count & 63) == 63 && is_interrupted()) {
		return false;
	}
	if (result.shape_count < limits.max_shapes && result.face_count <= limits.max_faces) {
		++result.shape_count;
		return true;
	}
	if (!_is_stopped) {
		const bool has_many_shapes = result.shape_count >= limits.max_shapes;
		const std::string most = std::to_string(has_many_shapes ? limits.max_shapes : limits.max_faces);
		result.diagnostics.error("too-many-shapes",
				"the derivation was stopped at the limit of " + most + (has_many_shapes ? " shapes" : " faces"),
				"a rule may call itself without end, or a split repeat a tiny size; else raise the limit");
		_is_stopped = true;
	}
	return false;
}

void Context::make_current(const Shape &other) {
	shape = other;
	vm.use_attributes(shape.attributes);
}

bool Context::is_paper_rule() const {
	const RuleId rule = vm.running_rule();
	return is_valid(rule) && _program.rules[index_of(rule)].has_paper_arrow;
}

// Most shapes are leaves and are only handed out: no copy is made of them.
inline Flow Context::call_leaf(const Caller &caller, uint64_t child_index) {
	if (!count_shape()) {
		return Flow::Stop;
	}
	++_successor_count;
	if (!surroundings.is_active()) {
		add_leaf(caller.shape);
		return Flow::Next;
	}
	Shape leaf = caller.shape;
	leaf.tree = surroundings.child(caller.tree, child_index);
	add_leaf(leaf);
	return Flow::Next;
}

Flow Context::call_rule(Vm &, RuleId rule, std::span<const Value> args) {
	mark_replaced();
	return call_rule({ shape, shape.seed, shape.tree }, _body.child_count++, rule, args);
}

Flow Context::call_rule(const Caller &caller, uint64_t child_index, RuleId rule, std::span<const Value> args) {
	if (_program.rules[index_of(rule)].is_leaf_symbol) {
		return call_leaf(caller, child_index);
	}
	Shape *child = arena.make(caller.shape);
	if (surroundings.is_active()) {
		child->tree = surroundings.child(caller.tree, child_index);
	}
	child->seed = derive_seed(caller.seed, child_index);
	child->depth = caller.shape.depth + 1;
	child->key = arena.make(KeyNode{ caller.shape.key, _successor_count++ });
	if (child->depth > _options.limits.max_depth) {
		vm.fail("too-deep", "rules call each other more than " + std::to_string(_options.limits.max_depth) + " levels deep",
				"end the recursion with a case, or raise the limit");
		return Flow::Stop;
	}
	_children.push_back({ rule, child, arena.copy(args.data(), args.size()), uint32_t(args.size()), {} });
	return Flow::Next;
}

void Context::push_group(Vm &) {
	_groups.push_back(arena.make(shape));
	_saved.push_back(_groups.back());
}

void Context::pop_group(Vm &) {
	make_current(*_groups.back());
	_groups.pop_back();
	_saved.pop_back();
}

Flow Context::Children::run(const Shape &child, Chunk body) {
	_body.is_replaced = true;
	if (!_context.count_shape()) {
		return Flow::Stop;
	}
	const uint64_t index = _body.child_count++;
	const uint64_t seed = derive_seed(_parent.seed, index);
	const TreePlace tree = _context.surroundings.is_active() ? _context.surroundings.child(_parent.tree, index) : child.tree;
	const RuleId rule = _context.vm.only_call(body);
	if (is_valid(rule)) { // most bodies: the child need not become the current shape
		return _context.vm.make_only_call(body, [&] { return _context.call_rule({ child, seed, tree }, 0, rule, {}); });
	}
	return run_as_current(child, seed, tree, body);
}

Flow Context::Children::run_as_current(const Shape &child, uint64_t seed, TreePlace tree, Chunk body) {
	_context.make_current(child);
	_context.shape.seed = seed;
	_context.shape.tree = tree;
	_context._body = { Random(seed), 0, false };
	_context._saved.push_back(&child);
	const Flow flow = _context.vm.run_body(body);
	_context._saved.pop_back();
	if (!_context._body.is_replaced) {
		++_context._successor_count;
		_context.add_leaf(_context.shape);
	}
	return flow;
}

Flow Context::run_child(const Shape &child, Chunk body) {
	return Children(*this).run(child, body);
}

Value Context::evaluate_on(const Shape &other, Chunk chunk) {
	const Shape outer = shape;
	make_current(other);
	const Value value = vm.evaluate(chunk);
	make_current(outer);
	return value;
}

Value Context::evaluate_selected(const Shape &child, Selection selection, Chunk chunk) {
	const Selection outer = _selection;
	_selection = selection;
	const Value value = evaluate_on(child, chunk);
	_selection = outer;
	return value;
}

Look &Context::own_look() {
	Look *copy = arena.make(*shape.look);
	shape.look = copy;
	return *copy;
}

void Context::own_attributes() {
	shape.attributes = arena.copy(shape.attributes, _program.attributes.size());
	vm.use_attributes(shape.attributes);
}

bool Context::read_color(const Text &text, glm::vec4 &color) const {
	if (text.symbol == no_symbol) {
		return parse_color(text.view, color);
	}
	const KnownColor &known = _colors[text.symbol];
	if (known.is_color) {
		color = glm::vec4(glm::vec3(known.color), known.has_opacity ? known.color.a : color.a);
	}
	return known.is_color;
}

double Context::finite_with_care(const Value &value) {
	if (!value.is_number()) {
		return 0.0;
	}
	if (!std::isfinite(value.number)) {
		vm.warn("not-finite", "this number is infinite or not a number; 0 is taken instead", "look for a division by zero or a root of a negative number");
		return 0.0;
	}
	if (std::abs(value.number) > most_number) {
		vm.warn("too-large", "this number is beyond 1e9; 0 is taken instead", "lengths are metres");
		return 0.0;
	}
	return value.number;
}

double Context::length(const Value &value, double whole) {
	return finite(value) * (value.size_kind == SizeKind::Relative ? whole : 1.0);
}

glm::dvec3 Context::lengths(const Args &args, size_t first) {
	return { length(args[first], shape.size.x), length(args[first + 1], shape.size.y), length(args[first + 2], shape.size.z) };
}

} // namespace pcg::cga
