#include "core/cga/components.h"

#include <algorithm>
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
			: _context(context), _parent(context.shape), _kind(kind), _keeps_axes(keeps_axes) {}

	Flow run(const Block &block) {
		const Geometry *geometry = baked(_parent, _context.arena);
		if (geometry == nullptr) {
			return Flow::Next;
		}
		_geometry = geometry;
		_context.record_occluder();
		if (_kind == ComponentKind::Faces) {
			_trim = _context.trimmer.source_of(_parent, *geometry, _keeps_axes, _context.arena);
		}
		_components = components_of(*geometry, _kind);
		_entries = _context.vm.entries(block);
		assign();
		for (uint32_t i = 0; i < _entries.size(); ++i) {
			if (run_entry(i) != Flow::Next) {
				return Flow::Stop;
			}
		}
		return Flow::Next;
	}

private:
	// Each component goes to the first entry that selects it.
	void assign() {
		_entry_of.assign(_components.size(), nobody);
		for (uint32_t i = 0; i < _components.size(); ++i) {
			for (uint32_t e = 0; e < _entries.size() && _entry_of[i] == nobody; ++e) {
				_entry_of[i] = selects(_entries[e], i) ? e : nobody;
			}
		}
	}

	bool selects(const BlockEntry &entry, uint32_t component) {
		const Selector selector = entry.word != no_symbol ? _context.selector(entry.word) : Selector{};
		if (selector.kind != SelectorKind::Unknown) {
			return matches(selector, _components[component].component, _parent, _context.lot());
		}
		if (entry.head == Chunk::None) {
			return false;
		}
		Shape child = shape_of({ &component, 1 });
		child.comp_index = component;
		child.comp_total = uint32_t(_components.size());
		const Value value = _context.evaluate_on(child, entry.head);
		return value.is_bool() ? value.boolean : value.is_number() && value.number == double(component);
	}

	Shape shape_of(std::span<const uint32_t> components) {
		return _kind == ComponentKind::Faces ? face_shape(_parent, *_geometry, components, _keeps_axes, _context.builder, _context.arena)
											 : edge_shape(_parent, _components[components[0]], _context.arena);
	}

	Flow run_entry(uint32_t index) {
		const BlockEntry &entry = _entries[index];
		std::vector<uint32_t> mine;
		for (uint32_t i = 0; i < _components.size(); ++i) {
			if (_entry_of[i] == index) {
				mine.push_back(i);
			}
		}
		if (entry.separator == BlockEntry::Separator::All && _kind == ComponentKind::Faces && !mine.empty()) {
			return run_one(entry, mine, 0, 1);
		}
		if (entry.separator == BlockEntry::Separator::Connected && _kind == ComponentKind::Faces) {
			const std::vector<std::vector<uint32_t>> groups = connected_groups(mine);
			Flow flow = Flow::Next;
			for (uint32_t i = 0; i < groups.size() && flow == Flow::Next; ++i) {
				flow = run_one(entry, groups[i], i, uint32_t(groups.size()));
			}
			return flow;
		}
		Flow flow = Flow::Next;
		for (uint32_t i = 0; i < mine.size() && flow == Flow::Next; ++i) {
			flow = run_one(entry, std::span(mine).subspan(i, 1), i, uint32_t(mine.size()));
		}
		return flow;
	}

	Flow run_one(const BlockEntry &entry, std::span<const uint32_t> components, uint32_t index, uint32_t total) {
		Shape child = shape_of(components);
		child.comp_index = index;
		child.comp_total = total;
		child.comp_selector = entry.word;
		if (_trim != nullptr && entry.separator == BlockEntry::Separator::Each) {
			child.trim = _trim;
			child.trim_face = _components[components[0]].face;
		}
		return child.geometry != nullptr ? _context.run_child(child, entry.body) : Flow::Next;
	}

	std::vector<std::vector<uint32_t>> connected_groups(const std::vector<uint32_t> &mine) {
		const std::vector<uint32_t> set_of = connected_sets(*_geometry, mine);
		std::vector<std::vector<uint32_t>> groups;
		for (const uint32_t face : mine) {
			const auto found = std::ranges::find_if(groups, [&](const auto &group) { return set_of[group[0]] == set_of[face]; });
			if (found == groups.end()) {
				groups.push_back({ face });
			} else {
				found->push_back(face);
			}
		}
		return groups;
	}

	Context &_context;
	Shape _parent;
	ComponentKind _kind;
	bool _keeps_axes;
	const Geometry *_geometry = nullptr;
	const TrimSource *_trim = nullptr;
	std::vector<ComponentInfo> _components;
	std::span<const BlockEntry> _entries;
	std::vector<uint32_t> _entry_of;
};

Flow comp(Vm &vm, const Args &args) {
	static constexpr ComponentKind kinds[] = { ComponentKind::Faces, ComponentKind::Edges, ComponentKind::Vertices, ComponentKind::FaceEdges };
	Context &context = Context::of(vm);
	context.mark_replaced();
	const bool keeps_axes = args.count() > 1 && args[1].word == 1;
	return args.block == nullptr ? Flow::Next : ComponentSplit(context, kinds[args[0].word], keeps_axes).run(*args.block);
}

} // namespace

void add_component_operations(Dialect &dialect) {
	using enum ParamKind;
	dialect.operations.push_back({ "comp", { { "kind", Word, "f e v fe" }, { "axes", Word, "zUp noAlign", true } }, BlockKind::Selectors, comp,
			"Makes shapes of faces (f), edges (e: shared ones once, fe: of each face) or vertices (v). Each goes to the first selector that fits; "
			"`=` puts all of one selector into one shape, `=:` each connected set." });
}

} // namespace pcg::cga
