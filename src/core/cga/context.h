#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/cga/asset_store.h"
#include "core/cga/clip.h"
#include "core/cga/derivation.h"
#include "core/cga/model_builder.h"
#include "core/cga/selectors.h"
#include "core/cga/shape.h"
#include "core/cga/surroundings.h"
#include "core/cga/trim.h"
#include "core/cga/texture_files.h"
#include "core/lang/vm.h"

// One running derivation: what the operations act on. A rule call only puts a copy of the current shape aside; the rules of these copies run,
// in order, when the calling rule is through. So the depth of the grammar never lies on the machine's stack, and the memory of a rule's
// shapes is free again when the last of its descendants is done.
namespace pcg::cga {

class Context final : public VmHost {
public:
	Context(const Program &program, const DeriveOptions &options);

	DerivationResult derive(const InitialShape &initial_shape, const Neighbors &neighbors);
	std::shared_ptr<const Occluders> occluders(const InitialShape &initial_shape);

	// For operations, functions and variables.
	static Context &of(Vm &vm) { return static_cast<Context &>(vm.host()); }
	Shape shape; // the current one
	Arena arena;
	Arena scratch; // for an ArenaScope
	GeometryBuilder builder;
	Clipper clipper;
	ModelBuilder model;
	Surroundings surroundings;
	Trimmer trimmer;
	TextureFiles texture_files;
	AssetStore assets;
	const Lot &lot() const { return _lot; }
	const InitialShape &initial_shape() const { return *_initial_shape; }
	std::string_view start_rule_name() const;
	const DeriveLimits &limits() const { return _options.limits; }
	const DeriveOptions &options() const { return _options; }
	// As it was when the running body or bracket began (CGA reference: op_center).
	const Shape &saved_shape() const { return *_saved.back(); }
	Selector selector(uint32_t symbol) const { return _selectors[symbol]; }
	// As parse_color(); texts of the program are read once.
	bool read_color(const Text &text, glm::vec4 &color) const;
	// The component that a selector's expression is asked about, and the shape that it is part of; nullptr at other times.
	struct Selection {
		const Component *component = nullptr;
		const Shape *whole = nullptr;
	};
	const Selection &selection() const { return _selection; }
	bool selects(Selector selector) const { return matches(selector, *_selection.component, *_selection.whole, _lot); }
	bool is_paper_rule() const; // the running rule was written with `->`

	// Runs bodies on shapes of their own, each of which is a leaf if its body makes nothing of it. At its end the current shape is as it was at its
	// beginning; in between it is no shape in particular: bodies that only call a rule do not change it.
	class Children;
	// One of them.
	Flow run_child(const Shape &child, Chunk body);
	Value evaluate_on(const Shape &other, Chunk chunk);
	// Of a selector's expression: words such as `top` in it ask for the component.
	Value evaluate_selected(const Shape &child, Selection selection, Chunk chunk);
	// The current shape gets a successor: it is no leaf itself.
	void mark_replaced() { _body.is_replaced = true; }
	// The current shape, as queries of other shapes may find it: before operations that take a body apart, and for label().
	void record_occluder(uint64_t label = 0) { surroundings.record(shape, label); }
	// Copies of what shapes share, to be changed: the current shape's own afterwards.
	Look &own_look();
	void own_attributes();
	// inline: runs the body and the rules that it calls at once; what comes of it is the current shape.
	enum class Merge : uint32_t { Append, Unify, Recompose };
	Flow run_inline(Chunk body, Merge strategy);
	// "0;2;1;": the way to the shape whose rule runs.
	std::string tree_key() const;
	// The current shape's random numbers begin anew.
	void reseed(uint64_t seed);

	// The number, or 0 with a warning if it is infinite or not a number.
	double finite(const Value &value) {
		return value.is_number() && std::abs(value.number) <= most_number ? value.number : finite_with_care(value);
	}
	// The same in metres: '0.5 is half of `whole`.
	double length(const Value &value, double whole);
	glm::dvec3 lengths(const Args &args, size_t first);

	// VmHost
	Flow call_rule(Vm &vm, RuleId rule, std::span<const Value> args) override;
	void push_group(Vm &vm) override;
	void pop_group(Vm &vm) override;
	Value *copy_attributes(Vm &vm) override;
	bool is_interrupted() override;
	void report(Diagnostic diagnostic) override { model.result().diagnostics.add(std::move(diagnostic)); }

	Vm vm;

private:
	struct Body {
		Random random;
		uint64_t child_count = 0;
		bool is_replaced = false;
	};
	// A shape that waits for its rule; `rule` Invalid: the place where the memory of a finished branch is given back.
	struct Pending {
		RuleId rule = RuleId::Invalid;
		Shape *shape = nullptr;
		const Value *args = nullptr;
		uint32_t arg_count = 0;
		Arena::Mark mark;
	};

	void run_pass(const InitialShape &initial_shape);
	void rehearse(const InitialShape &initial_shape);
	void begin(const InitialShape &initial_shape, const Neighbors &neighbors);
	bool set_up(const InitialShape &initial_shape);
	RuleId find_start_rule() const;
	RuleId start_rule();
	void set_overrides();
	void run_rules(RuleId start);
	bool run_rule(const Pending &pending);
	void make_current(const Shape &other);
	void run_now();
	void merge(std::span<const Shape> leaves, Merge strategy);
	std::vector<const Geometry *> parts_of(std::span<const Shape> leaves, bool keeps_looks);
	const Geometry *part_of(const Shape &leaf, bool keeps_look);
	void unify(std::span<const Geometry *> parts);
	void connect_parts();
	// A shape that calls rules, as its children see it.
	struct Caller {
		const Shape &shape;
		uint64_t seed;
		TreePlace tree;
	};
	Flow call_rule(const Caller &caller, uint64_t child_index, RuleId rule, std::span<const Value> args);
	Flow call_leaf(const Caller &caller, uint64_t child_index);
	void add_leaf(const Shape &leaf);
	// False: there are too many, or the derivation was stopped.
	bool count_shape() {
		const DerivationResult &result = model.result();
		if (result.shape_count < _options.limits.max_shapes && result.face_count <= _options.limits.max_faces && (result.shape_count & 63) != 63) [[likely]] {
			++model.result().shape_count;
			return true;
		}
		return check_limits();
	}
	bool check_limits();
	// Far beyond any city: larger sizes leave what the exchange formats can say.
	static constexpr double most_number = 1e9;
	double finite_with_care(const Value &value);

	const Program &_program;
	DeriveOptions _options;
	const InitialShape *_initial_shape = nullptr;
	Lot _lot;
	Body _body;
	std::vector<const Shape *> _saved; // innermost last
	std::vector<const Shape *> _groups; // as they were at each open bracket
	std::vector<Pending> _stack; // last first
	std::vector<Pending> _children; // of the running rule, in order
	std::vector<Selector> _selectors; // by symbol
	struct KnownColor {
		bool is_color = false, has_opacity = false;
		glm::vec4 color{ 0.0f };
	};
	std::vector<KnownColor> _colors; // by symbol
	Selection _selection;
	std::vector<std::string_view> _object_tags; // by rule; empty: no object
	Look _default_look;
	ContextUse _context_use;
	std::chrono::steady_clock::time_point _start;
	uint32_t _successor_count = 0; // of the running rule
	std::vector<Shape> *_collected = nullptr; // leaves that inline takes
	bool _is_stopped = false; // a limit was met
	bool _is_rehearsal = false; // no model is made
};

class Context::Children {
public:
	explicit Children(Context &context) : _context(context), _parent(context.shape), _body(context._body) {}
	~Children() {
		_context.make_current(_parent);
		_context._body = _body;
	}
	Children(const Children &) = delete;
	Children &operator=(const Children &) = delete;

	const Shape &parent() const { return _parent; }
	Flow run(const Shape &child, Chunk body);

private:
	Flow run_as_current(const Shape &child, uint64_t seed, TreePlace tree, Chunk body);

	Context &_context;
	const Shape _parent;
	Body _body; // of the parent
};

} // namespace pcg::cga
