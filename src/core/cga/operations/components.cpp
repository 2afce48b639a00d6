#include "core/cga/components.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/cga/context.h"
#include "core/cga/operations/operations.h"

// comp(kind) { selector : body | .. } (CGA reference, section 4.1).
namespace pcg::cga {

namespace {

constexpr uint32_t nobody = UINT32_MAX;

class ComponentSplit {
public:
	ComponentSplit(Context &context, ComponentKind kind, bool keeps_axes)
			: _context(context), _scope(context.scratch), _parent(context.shape), _kind(kind), _keeps_axes(keeps_axes) {}

	Flow run(const Block &block) {
		if (!prepare(block)) {
			return Flow::Next;
		}
		_context.record_occluder();
		if (_kind == ComponentKind::Faces) {
			_trim = _context.trimmer.source_of(_parent, *_geometry, _keeps_axes, _context.arena);
		}
		Context::Children children(_context);
		for (uint32_t i = 0; i < _entries.size(); ++i) {
			if (run_entry(i, children) != Flow::Next) {
				return Flow::Stop;
			}
		}
		return Flow::Next;
	}

	// Of the function comp(): one value for each component, in order; 0, false or "" for those that nobody selects.
	Value values(const Block &block) {
		std::vector<Value> result;
		ValueType type = ValueType::Number;
		if (prepare(block)) {
			result.resize(_components.size());
			for (uint32_t e = 0; e < _entries.size(); ++e) {
				const std::vector<std::vector<uint32_t>> groups = groups_of(e);
				for (uint32_t i = 0; i < groups.size(); ++i) {
					const Value value = _context.evaluate_on(child_of(_entries[e], groups[i], i, uint32_t(groups.size())), _entries[e].body);
					type = value.type;
					std::ranges::for_each(groups[i], [&](uint32_t component) { result[component] = value; });
				}
			}
		}
		for (Value &value : result) {
			value = value.is_void() ? _context.vm.default_of(type) : value;
		}
		return Value::of(_context.vm.make_array(result, 1, type));
	}

private:
	bool prepare(const Block &block) {
		_geometry = baked(_parent, _context.arena);
		if (_geometry == nullptr) {
			return false;
		}
		_components = components_of(*_geometry, _kind);
		if (_kind == ComponentKind::Edges) {
			name_roof_edges(*_geometry, _components);
		}
		_entries = _context.vm.entries(block);
		assign();
		return true;
	}

	bool is_face_kind() const { return _kind == ComponentKind::Faces || _kind == ComponentKind::Groups || _kind == ComponentKind::Materials; }

	// Each component goes to the first entry that selects it; indices beyond the last one count on from the first.
	void assign() {
		_entry_of = _context.scratch.allocate<uint32_t>(_components.size());
		std::fill_n(_entry_of, _components.size(), nobody);
		for (uint32_t i = 0; i < _components.size(); ++i) {
			for (uint32_t e = 0; e < _entries.size() && _entry_of[i] == nobody; ++e) {
				_entry_of[i] = selects(_entries[e], i) ? e : nobody;
			}
		}
	}

	Selector selector_of_entry(const BlockEntry &entry) const { return entry.word != no_symbol ? _context.selector(entry.word) : Selector{}; }

	bool selects(const BlockEntry &entry, uint32_t component) {
		const Selector selector = selector_of_entry(entry);
		if (selector.kind != SelectorKind::Unknown) {
			return fits(selector, _components[component]);
		}
		if (entry.head == Chunk::None) {
			return false;
		}
		Shape child = shape_of({ &component, 1 }, false);
		child.comp_index = component;
		child.comp_total = uint32_t(_components.size());
		const Value value = _context.evaluate_selected(child, { &_components[component].component, &_parent }, entry.head);
		return value.is_bool() ? value.boolean : value.is_number() && std::fmod(value.number, double(_components.size())) == double(component);
	}

	// A group or a material fits where one of its faces does.
	bool fits(Selector selector, const ComponentInfo &info) {
		if (info.faces.empty()) {
			return matches(selector, info.component, _parent, _context.lot());
		}
		if (_faces.empty()) {
			_faces = components_of(*_geometry, ComponentKind::Faces);
		}
		return std::ranges::any_of(info.faces, [&](uint32_t face) { return matches(selector, _faces[face].component, _parent, _context.lot()); });
	}

	glm::dvec3 normal_of(uint32_t component) const {
		const GeometryFace &face = _geometry->faces[component];
		return _geometry->outline(face).size() >= 3 ? _components[component].component.normal : face_normal(*_geometry, face); // of edges another
	}

	Shape shape_of(std::span<const uint32_t> components, bool is_roof_edge) {
		if (_kind == ComponentKind::Faces) {
			return face_shape(_parent, _scope_frame, *_geometry, components, normal_of(components[0]), _keeps_axes, _context.builder, _context.arena);
		}
		if (is_face_kind()) { // there is no one face that could say how to turn
			_set.clear();
			for (const uint32_t component : components) {
				_set.insert(_set.end(), _components[component].faces.begin(), _components[component].faces.end());
			}
			std::ranges::sort(_set);
			return face_shape(_parent, _scope_frame, *_geometry, _set, {}, true, _context.builder, _context.arena);
		}
		_infos.clear();
		for (const uint32_t component : components) {
			_infos.push_back(&_components[component]);
		}
		return _kind == ComponentKind::Holes ? hole_shape(_parent, *_geometry, _infos, _keeps_axes, _context.builder, _context.arena)
											 : edge_shape(_parent, _infos, _keeps_axes, is_roof_edge, _context.builder, _context.arena);
	}

	// The components that are one shape together.
	std::vector<std::vector<uint32_t>> groups_of(uint32_t index) {
		const ArenaScope scope(_context.scratch);
		const std::span<const uint32_t> mine = components_of_entry(index);
		if (_entries[index].separator == BlockEntry::Separator::Connected) {
			return connected_groups(mine);
		}
		if (_entries[index].separator == BlockEntry::Separator::All) {
			return mine.empty() ? std::vector<std::vector<uint32_t>>() : std::vector<std::vector<uint32_t>>{ { mine.begin(), mine.end() } };
		}
		std::vector<std::vector<uint32_t>> groups;
		for (const uint32_t component : mine) {
			groups.push_back({ component });
		}
		return groups;
	}

	// In the scratch memory.
	std::span<const uint32_t> components_of_entry(uint32_t index) const {
		uint32_t *mine = _context.scratch.allocate<uint32_t>(_components.size());
		size_t count = 0;
		for (uint32_t i = 0; i < _components.size(); ++i) {
			if (_entry_of[i] == index) {
				mine[count++] = i;
			}
		}
		return { mine, count };
	}

	Flow run_entry(uint32_t index, Context::Children &children) {
		const BlockEntry &entry = _entries[index];
		Flow flow = Flow::Next;
		if (entry.separator != BlockEntry::Separator::Each) {
			const std::vector<std::vector<uint32_t>> groups = groups_of(index);
			for (uint32_t i = 0; i < groups.size() && flow == Flow::Next; ++i) {
				flow = run_one(entry, groups[i], i, uint32_t(groups.size()), children);
			}
			return flow;
		}
		const ArenaScope scope(_context.scratch);
		const std::span<const uint32_t> mine = components_of_entry(index);
		for (uint32_t i = 0; i < mine.size() && flow == Flow::Next; ++i) {
			flow = run_one(entry, mine.subspan(i, 1), i, uint32_t(mine.size()), children);
		}
		return flow;
	}

	Shape child_of(const BlockEntry &entry, std::span<const uint32_t> components, uint32_t index, uint32_t total) {
		Shape child = shape_of(components, is_roof_edge(selector_of_entry(entry).kind));
		child.comp_index = index;
		child.comp_total = total;
		child.comp_selector = entry.word;
		child.comp_entry = uint32_t(&entry - _context.vm.program().entries.data());
		return child;
	}

	Flow run_one(const BlockEntry &entry, std::span<const uint32_t> components, uint32_t index, uint32_t total, Context::Children &children) {
		Shape child = child_of(entry, components, index, total);
		if (_trim != nullptr && entry.separator == BlockEntry::Separator::Each) {
			child.trim = _trim;
			child.trim_face = _components[components[0]].face;
		}
		return child.geometry != nullptr ? children.run(child, entry.body) : Flow::Next;
	}

	// Faces hang together by edges, edges by their ends; anything else stands alone.
	std::vector<std::vector<uint32_t>> connected_groups(std::span<const uint32_t> mine) const {
		std::vector<uint32_t> set_of(_components.size());
		std::iota(set_of.begin(), set_of.end(), 0);
		if (_kind == ComponentKind::Faces) {
			set_of = connected_sets(*_geometry, mine);
		} else if (_kind == ComponentKind::Edges || _kind == ComponentKind::FaceEdges) {
			set_of = connected_edges(_components, mine);
		}
		std::vector<std::vector<uint32_t>> groups;
		std::vector<uint32_t> group_of(_components.size(), nobody);
		for (const uint32_t component : mine) {
			uint32_t &group = group_of[set_of[component]];
			if (group == nobody) {
				group = uint32_t(groups.size());
				groups.emplace_back();
			}
			groups[group].push_back(component);
		}
		return groups;
	}

	Context &_context;
	ArenaScope _scope;
	const Shape _parent;
	const Frame _scope_frame = _parent.frame();
	ComponentKind _kind;
	bool _keeps_axes;
	const Geometry *_geometry = nullptr;
	const TrimSource *_trim = nullptr;
	std::vector<ComponentInfo> _components;
	std::vector<ComponentInfo> _faces; // where groups or materials are asked for sides
	std::span<const BlockEntry> _entries;
	uint32_t *_entry_of = nullptr; // by component
	std::vector<uint32_t> _set;
	std::vector<const ComponentInfo *> _infos;
};

ComponentSplit split_of(Context &context, const Args &args) {
	using enum ComponentKind;
	static constexpr ComponentKind kinds[] = { Faces, Edges, Vertices, FaceEdges, FaceVertices, Groups, Materials, Holes };
	return ComponentSplit(context, kinds[args[0].word], args.count() > 1 && args[1].word == 1);
}

Flow comp(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	context.mark_replaced();
	return args.block == nullptr ? Flow::Next : split_of(context, args).run(*args.block);
}

Value comp_values(Vm &vm, const Args &args) {
	return args.block == nullptr ? Value::of(vm.make_array({})) : split_of(Context::of(vm), args).values(*args.block);
}

Value is_selected(Vm &vm, const Args &args) {
	const Context &context = Context::of(vm);
	const Selector selector = args[0].is_text() ? selector_of(args[0].text->view) : Selector{};
	return Value::of(context.selection().component != nullptr && context.selects(selector));
}

Value is_tagged(Vm &vm, const Args &) {
	vm.warn("no-tags", "components carry no tags here: isTagged selects nothing", "select by direction, by index or by a condition instead");
	return Value::of(false);
}

} // namespace

void add_component_operations(Dialect &dialect) {
	using enum ParamKind;
	const std::vector<ParamSpec> kinds = { { "kind", Word, "f e v fe fv g m h" }, { "axes", Word, "zUp noAlign", true } };
	dialect.operations.push_back({ "comp", kinds, BlockKind::Selectors, comp,
			"Makes shapes of faces (f), edges (e: shared ones once, fe: of each face), vertices (v: shared ones once, fv: of each face), everything (g), materials "
			"(m) or holes (h). Each goes to the first selector that fits; `=` puts all of one selector into one shape, `=:` each connected set." });
	dialect.functions.push_back({ "comp", kinds, ValueType::Array, comp_values,
			"comp(fe) { street.front : 5 | all : scope.sx }: an array with a value for each component; 0, false or \"\" for those that nothing selects.", false, nullptr,
			true });
	dialect.functions.push_back({ "isSelected", { { "selector", Text } }, ValueType::Bool, is_selected,
			"In the selectors of a block: whether the component fits a selector word. `top && geometry.area > 3` is short for isSelected(\"top\") && .." });
	dialect.functions.push_back({ "isTagged", { { "tag", Text }, { "part", Word, "e v", true } }, ValueType::Bool, is_tagged,
			"Accepted: components carry no tags, so it is always false, with a warning." });
	for (const std::string_view word : selector_words()) {
		dialect.selector_words.push_back(word);
	}
	dialect.selector_function = "isSelected";
}

} // namespace pcg::cga
