#include "core/geometry/setback.h"

#include <algorithm>
#include <cmath>

#include "core/cga/components.h"
#include "core/cga/operations/face_pieces.h"
#include "core/cga/operations/operations.h"
#include "core/cga/uv_edges.h"

// setback(distance) { selector : body | .. | remainder : body } and its relatives (CGA reference, section 4.4).
namespace pcg::cga {

namespace {

constexpr uint32_t nobody = UINT32_MAX;

// Becomes the setback where it is to lie: moving one moves all of its points.
struct SetbackOf {
	const Loops2 &polygon;
	std::span<const double> distances;
	operator Setback() const { return set_back(polygon, distances); }
};

class SetbackOperation {
public:
	SetbackOperation(Context &context, const Geometry &geometry, const Block &block, double uv_set)
			: _context(context), _parent(context.shape), _entries(context.vm.entries(block)), _geometry(&geometry), _faces(flat_faces(geometry)),
			  _uv_set(uv_set >= 0.0 && uv_set < double(uv_set_count) ? size_t(uv_set) : uv_set_count) {
		_edges = components_of(geometry, ComponentKind::FaceEdges);
		drop_edges_of_flat_faces(geometry);
		assign();
	}

	// Of all edges, selected or not, in order of comp(fe).
	size_t edge_count() const { return _edges.size(); }
	Shape edge(uint32_t index) {
		const ComponentInfo *info = &_edges[index];
		Shape shape = edge_shape(_parent, { &info, 1 }, false, false, _context.builder, _context.arena);
		shape.comp_index = index;
		shape.comp_total = uint32_t(_edges.size());
		return shape;
	}

	Flow run(std::span<const double> distances) {
		const SmallVector<Setback, 1> results = move(distances);
		Context::Children children(_context);
		for (uint32_t e = 0; e < _entries.size(); ++e) {
			const bool is_remainder = is_word(_context, _entries[e], "remainder");
			if (run_pieces(_context, children, _parent, _entries[e], is_remainder ? rest_of(results) : strips_of(results, e)) != Flow::Next) {
				return Flow::Stop;
			}
		}
		return Flow::Next;
	}

	double rest_area(std::span<const double> distances) {
		double area = 0.0;
		for (const Setback &result : move(distances)) {
			for (const Loops2 &polygon : result.rest) {
				area += area_of(polygon);
			}
		}
		return area;
	}

private:
	// Only faces with an area have edges to move.
	void drop_edges_of_flat_faces(const Geometry &geometry) {
		std::erase_if(_edges, [&](const ComponentInfo &info) { return geometry.outline(geometry.faces[info.face]).size() < 3; });
	}

	void find_corners() {
		for (const FlatFace &face : _faces) {
			for (uint32_t l = face.face().first_loop; l < face.face().first_loop + face.face().loop_count; ++l) {
				const uint32_t first = _geometry->first_point(l), end = _geometry->loop_ends[l];
				for (uint32_t i = first; i < end; ++i) {
					_corners.emplace_back(i, i + 1 < end ? i + 1 : first);
				}
			}
		}
	}

	// Each edge goes to the first entry that selects it.
	void assign() {
		_entry_of.resize(_edges.size(), nobody);
		for (const BlockEntry &entry : _entries) {
			_uv_sides.push_back(entry.word != no_symbol ? uv_side_of(_context.vm.program().texts[entry.word].view) : UvSide::None);
		}
		if (std::ranges::any_of(_uv_sides, [](UvSide side) { return side != UvSide::None; })) {
			find_corners();
		}
		for (uint32_t i = 0; i < _edges.size(); ++i) {
			for (uint32_t e = 0; e < _entries.size() && _entry_of[i] == nobody; ++e) {
				const bool is_selected = _uv_sides[e] != UvSide::None ? selects_uv(_uv_sides[e], i) : selects(_entries[e], i);
				_entry_of[i] = is_selected ? e : nobody;
			}
		}
	}

	bool selects_uv(UvSide side, uint32_t index) const {
		const auto [from, to] = _corners[index];
		return matches(side, *_geometry, _geometry->faces[_edges[index].face], from, to, _uv_set);
	}

	bool selects(const BlockEntry &entry, uint32_t index) {
		const Selector selector = entry.word != no_symbol ? _context.selector(entry.word) : Selector{};
		if (selector.kind != SelectorKind::Unknown) {
			return matches(selector, _edges[index].component, _parent, _context.lot());
		}
		if (entry.head == Chunk::None || is_word(_context, entry, "remainder")) {
			return false;
		}
		const Value value = _context.evaluate_selected(edge(index), { &_edges[index].component, &_parent }, entry.head);
		if (!value.is_number()) {
			return value.is_bool() && value.boolean;
		}
		const double count = double(_edges.size()), wrapped = std::fmod(value.number, count); // of any index: modulo
		return wrapped + (wrapped < 0.0 ? count : 0.0) == double(index);
	}

	SmallVector<Setback, 1> move(std::span<const double> distances) {
		SmallVector<Setback, 1> results;
		uint32_t first = 0;
		bool is_complete = true;
		for (const FlatFace &face : _faces) {
			SmallVector<double, 8> own(face.edge_count(), 0.0);
			for (uint32_t i = 0; i < own.size(); ++i) {
				const uint32_t index = first + i;
				own[i] = index < distances.size() && _entry_of[index] != nobody ? distances[index] : 0.0;
			}
			first += face.edge_count();
			results.emplace_back(SetbackOf{ face.loops(), own });
			is_complete &= results.back().is_complete;
		}
		if (!is_complete) {
			_context.vm.warn("broken-outline", "the outline of this face crosses itself; its edges are not set back");
		}
		return results;
	}

	SeenPieces strips_of(std::span<const Setback> results, uint32_t entry) const {
		SeenPieces pieces;
		uint32_t first = 0;
		for (size_t f = 0; f < _faces.size(); ++f) {
			for (const SetbackStrip &strip : results[f].strips) {
				if (_entry_of[first + strip.edge] == entry) {
					pieces.push_back({ &_faces[f], &strip.polygon });
				}
			}
			first += _faces[f].edge_count();
		}
		return pieces;
	}

	SeenPieces rest_of(std::span<const Setback> results) const {
		SeenPieces pieces;
		for (size_t f = 0; f < _faces.size(); ++f) {
			for (const Loops2 &polygon : results[f].rest) {
				pieces.push_back({ &_faces[f], &polygon });
			}
		}
		return pieces;
	}

	Context &_context;
	Shape _parent;
	std::span<const BlockEntry> _entries;
	const Geometry *_geometry;
	SmallVector<FlatFace, 1> _faces;
	size_t _uv_set;
	std::vector<ComponentInfo> _edges; // of all faces, in order
	std::vector<std::pair<uint32_t, uint32_t>> _corners; // of each edge, if an entry selects by texture
	SmallVector<UvSide, 8> _uv_sides; // that the entries select
	SmallVector<uint32_t, 8> _entry_of;
};

// One number for all edges, or an array with one for each.
SmallVector<double, 8> distances_of(Context &context, const Value &value, size_t edges, double fallback) {
	if (value.type != ValueType::Array) {
		return SmallVector<double, 8>(edges, value.is_number() ? setback_distance(context, value) : fallback);
	}
	SmallVector<double, 8> distances(edges, 0.0);
	for (size_t i = 0; i < edges && i < size_t(value.array->rows) * value.array->columns; ++i) {
		distances[i] = setback_distance(context, value.array->values[i]);
	}
	return distances;
}

Flow setback(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	context.mark_replaced();
	const Geometry *geometry = baked(context.shape, context.arena);
	if (geometry == nullptr || args.block == nullptr) {
		return Flow::Next;
	}
	SetbackOperation operation(context, *geometry, *args.block, args.number_or(1, 0.0));
	return operation.run(distances_of(context, args[0], operation.edge_count(), 0.0));
}

Flow setback_per_edge(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	context.mark_replaced();
	const Geometry *geometry = baked(context.shape, context.arena);
	if (geometry == nullptr || args.block == nullptr) {
		return Flow::Next;
	}
	SetbackOperation operation(context, *geometry, *args.block, args.number_or(1, 0.0));
	SmallVector<double, 8> distances;
	for (uint32_t i = 0; i < operation.edge_count(); ++i) {
		distances.push_back(setback_distance(context, context.evaluate_on(operation.edge(i), Chunk(args[0].chunk))));
	}
	return operation.run(distances);
}

// The distance common to all edges, within their bounds, that leaves `area`: it falls as the distance grows.
SmallVector<double, 8> distances_for_area(SetbackOperation &operation, double area, const SmallVector<double, 8> &least, const SmallVector<double, 8> &most) {
	SmallVector<double, 8> distances = least;
	const auto set = [&](double more) {
		for (size_t i = 0; i < least.size(); ++i) {
			distances[i] = std::min(least[i] + more, std::max(least[i], most[i]));
		}
	};
	double low = 0.0, high = 1.0;
	set(high);
	while (operation.rest_area(distances) > area && high < 1e6) {
		high *= 2.0;
		set(high);
	}
	for (int i = 0; i < 50; ++i) {
		const double middle = 0.5 * (low + high);
		set(middle);
		(operation.rest_area(distances) > area ? low : high) = middle;
	}
	set(low);
	return distances;
}

Flow setback_to_area(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	context.mark_replaced();
	const Geometry *geometry = baked(context.shape, context.arena);
	const double area = context.finite(args[0]);
	if (geometry == nullptr || args.block == nullptr) {
		return Flow::Next;
	}
	if (area <= 0.0) {
		vm.warn("not-positive", "the area that a setback leaves must be above 0; nothing is set back");
	}
	const Value &last = args[args.count() - 1]; // an argument that is no array is the uv set
	SetbackOperation operation(context, *geometry, *args.block, args.count() > 1 && last.is_number() ? last.number : 0.0);
	const auto bounds = [&](size_t i, double fallback) {
		const bool is_given = args.count() > i && args[i].type == ValueType::Array;
		return distances_of(context, is_given ? args[i] : Value(), operation.edge_count(), fallback);
	};
	const SmallVector<double, 8> least = bounds(1, 0.0);
	return operation.run(area > 0.0 ? distances_for_area(operation, area, least, bounds(2, 1e9)) : least);
}

} // namespace

void add_setback_operations(Dialect &dialect) {
	for (const std::string_view word : { "remainder", "uv.left", "uv.right", "uv.bottom", "uv.top", "uv.uMin", "uv.uMax", "uv.vMin", "uv.vMax" }) {
		dialect.selector_words.push_back(word);
	}
	using enum ParamKind;
	auto &operations = dialect.operations;
	const ParamSpec uv_set = { "uvSet", Number, {}, true };
	operations.push_back({ "setback", { { "distance", Any }, uv_set }, BlockKind::Selectors, setback,
			"Moves the selected edges of each face inwards, all by one distance or each by its own of an array in order of comp(fe). Each edge's "
			"selector gets the strip that it passed over, `remainder` what is left." });
	operations.push_back({ "setbackPerEdge", { { "distance", Predicate }, uv_set }, BlockKind::Selectors, setback_per_edge,
			"As setback; the distance is worked out for each edge, as for a shape of comp(fe)." });
	operations.push_back({ "setbackToArea", { { "area", Number }, { "minDistances", Any, {}, true }, { "maxDistances", Any, {}, true }, uv_set },
			BlockKind::Selectors, setback_to_area,
			"As setback, with the distance that leaves a remainder of this area, square metres; arrays bound the distance of each edge." });
}

} // namespace pcg::cga
