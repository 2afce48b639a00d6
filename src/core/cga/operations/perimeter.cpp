#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/cga/operations/face_pieces.h"
#include "core/cga/operations/operations.h"
#include "core/cga/operations/split_parts.h"
#include "core/geometry/inner_rectangle.h"
#include "core/geometry/setback.h"

// splitAndSetbackPerimeter(offset) { length : depth : body | .. }* { remainder : body } (CGA reference, section 4.4).
namespace pcg::cga {

namespace {

constexpr uint32_t no_part = UINT32_MAX;

// The outline's selected edges as one way around, from its first edge on.
struct Chain {
	struct Link {
		uint32_t edge;
		double from, to; // metres along the chain
	};
	std::vector<Link> links;
	double length = 0.0;
};

Chain chain_of(const Loop2 &outline, const std::vector<bool> &is_selected, uint32_t first_edge) {
	Chain chain;
	const uint32_t count = uint32_t(outline.size());
	for (uint32_t i = 0; i < count; ++i) {
		const uint32_t edge = (first_edge + i) % count;
		if (is_selected[edge]) {
			const double length = glm::distance(outline[edge], outline[(edge + 1) % count]);
			chain.links.push_back({ edge, chain.length, chain.length + length });
			chain.length += length;
		}
	}
	return chain;
}

// The outline with a corner wherever a part ends, and the part that each of its edges belongs to.
struct Sections {
	Loops2 polygon;
	std::vector<uint32_t> part_of; // by edge of the polygon
};

// Part at a place of the chain; the pattern begins at `offset` and runs around.
uint32_t part_at(const SplitLayout &layout, double place, double offset, double length) {
	const double at = std::fmod(std::fmod(place - offset, length) + length, length);
	for (uint32_t i = 0; i < layout.parts.size(); ++i) {
		if (at >= layout.parts[i].from && at < layout.parts[i].to) {
			return i;
		}
	}
	return no_part;
}

Sections cut_outline(const Loops2 &polygon, const Chain &chain, const SplitLayout &layout, double offset) {
	Sections sections;
	std::vector<double> ends;
	for (const SplitPart &part : layout.parts) {
		for (const double end : { part.from, part.to }) {
			ends.push_back(std::fmod(std::fmod(end + offset, chain.length) + chain.length, chain.length));
		}
	}
	std::ranges::sort(ends);
	sections.polygon.emplace_back();
	const Loop2 &outline = polygon[0];
	for (uint32_t edge = 0; edge < outline.size(); ++edge) {
		const glm::dvec2 a = outline[edge], b = outline[(edge + 1) % outline.size()];
		const auto link = std::ranges::find(chain.links, edge, &Chain::Link::edge);
		sections.polygon[0].push_back(a);
		if (link == chain.links.end()) {
			sections.part_of.push_back(no_part);
			continue;
		}
		double from = link->from;
		const double margin = 1e-7 * chain.length;
		for (const double end : ends) {
			if (end > from + margin && end < link->to - margin) {
				sections.part_of.push_back(part_at(layout, 0.5 * (from + end), offset, chain.length));
				sections.polygon[0].push_back(glm::mix(a, b, (end - link->from) / (link->to - link->from)));
				from = end;
			}
		}
		sections.part_of.push_back(part_at(layout, 0.5 * (from + link->to), offset, chain.length));
	}
	for (size_t hole = 1; hole < polygon.size(); ++hole) {
		sections.polygon.push_back(polygon[hole]);
		sections.part_of.insert(sections.part_of.end(), polygon[hole].size(), no_part);
	}
	return sections;
}

// What each part covers when its section is set back: deeper ones first, each of them what those before it left. Those of one depth meet halfway.
class Coverage {
public:
	Coverage(const Sections &sections, const std::vector<double> &depths) : parts(depths.size()), _sections(sections), _depths(depths) {
		const auto has_depth = [](double depth) { return depth > 0.0; };
		std::vector<double> levels;
		std::ranges::copy_if(depths, std::back_inserter(levels), has_depth);
		std::ranges::sort(levels, std::greater());
		levels.erase(std::ranges::unique(levels).begin(), levels.end());
		for (const double level : levels) {
			const auto is_of_level = [&](uint32_t part) { return depths[part] == level; };
			claim(set_back_if(is_of_level));
			for (uint32_t part = 0; part < depths.size(); ++part) {
				if (is_of_level(part)) { // where another one of this depth stopped it
					claim(set_back_if([&](uint32_t other) { return other == part; }));
				}
			}
		}
		claim(set_back_if([&](uint32_t part) { return has_depth(depths[part]); })); // between them at inner corners
	}

	Polygons2 rest() const { return _taken.empty() ? Polygons2{ _sections.polygon } : overlay(_sections.polygon, _taken, OverlayKind::Difference); }

	std::vector<Loops2> parts;
	bool is_complete = true;

private:
	template <typename Filter> Setback set_back_if(Filter is_moved) {
		std::vector<double> distances;
		for (const uint32_t part : _sections.part_of) {
			distances.push_back(part != no_part && is_moved(part) ? _depths[part] : 0.0);
		}
		return set_back(_sections.polygon, distances);
	}

	void claim(const Setback &setback) {
		is_complete &= setback.is_complete;
		std::vector<Loops2> strips(parts.size());
		for (const SetbackStrip &strip : setback.strips) {
			append(strips[_sections.part_of[strip.edge]], strip.polygon);
		}
		for (uint32_t part = 0; part < parts.size(); ++part) {
			for (const Loops2 &polygon : strips[part].empty() ? Polygons2() : overlay(strips[part], _taken, OverlayKind::Difference)) {
				append(parts[part], polygon);
				append(_taken, polygon);
			}
		}
	}

	static void append(Loops2 &loops, const Loops2 &more) { loops.insert(loops.end(), more.begin(), more.end()); }

	const Sections &_sections;
	const std::vector<double> &_depths;
	Loops2 _taken;
};

class PerimeterSplit {
public:
	PerimeterSplit(Context &context, const Args &args) : _context(context), _args(args), _parent(context.shape), _sizes(split_sizes(context, *args.block)) {}

	Flow run(std::span<const FlatFace> faces) {
		FacePieces rest;
		uint32_t first_edge = 0;
		for (const FlatFace &face : faces) {
			if (split(face, first_edge, rest) != Flow::Next) {
				return Flow::Stop;
			}
			first_edge += face.edge_count();
		}
		if (_args.second_block != nullptr) {
			for (const BlockEntry &entry : _context.vm.entries(*_args.second_block)) {
				if (is_word(_context, entry, "remainder") && run_rest(entry, rest) != Flow::Next) {
					return Flow::Stop;
				}
			}
		}
		return Flow::Next;
	}

private:
	Flow run_rest(const BlockEntry &entry, const FacePieces &rest) {
		Context::Children children(_context);
		return run_pieces(_context, children, _parent, entry, seen(rest));
	}

	Flow split(const FlatFace &face, uint32_t first, FacePieces &rest) {
		const Loop2 &outline = face.loops()[0];
		const Chain chain = chain_of(outline, selected(uint32_t(outline.size()), first), first_edge(uint32_t(outline.size())));
		if (chain.length <= 0.0) {
			rest.push_back({ &face, face.loops() });
			return Flow::Next;
		}
		const SplitLayout layout = lay_out_split(_sizes.groups, chain.length, _context.limits().max_repeats, _context.scratch);
		const Sections sections = cut_outline(face.loops(), chain, layout, _context.length(_args[0], chain.length));
		const std::vector<double> depths = depths_of(layout);
		const Coverage coverage(sections, depths);
		if (!coverage.is_complete) {
			_context.vm.warn("broken-outline", "the outline of this face crosses itself; its edges are not set back");
		}
		for (Loops2 &polygon : coverage.rest()) {
			polygon[0] = begun_near(polygon[0], outline[0], outline[1]);
			rest.push_back({ &face, std::move(polygon) });
		}
		for (uint32_t part = 0; part < layout.parts.size(); ++part) {
			if (run_section(face, sections, coverage.parts[part], layout, part) != Flow::Next) {
				return Flow::Stop;
			}
		}
		return Flow::Next;
	}

	std::vector<bool> selected(uint32_t count, uint32_t first) const {
		const ArrayData *mask = _args.count() > 2 && _args[2].type == ValueType::Array ? _args[2].array : nullptr;
		std::vector<bool> result(count, mask == nullptr);
		for (uint32_t i = 0; mask != nullptr && i < count && first + i < mask->rows * mask->columns; ++i) {
			const Value &value = mask->values[first + i];
			result[i] = value.is_bool() && value.boolean;
		}
		return result;
	}

	uint32_t first_edge(uint32_t count) const {
		const double index = _args.count() > 1 ? std::fmod(std::floor(_context.finite(_args[1])), double(count)) : 0.0;
		return uint32_t(index < 0.0 ? index + double(count) : index);
	}

	Shape section_shape(const SplitLayout &layout, uint32_t part) const {
		Shape shape = _parent;
		shape.split_index = part;
		shape.split_total = uint32_t(layout.parts.size());
		return shape;
	}

	std::vector<double> depths_of(const SplitLayout &layout) const {
		std::vector<double> depths;
		for (uint32_t i = 0; i < layout.parts.size(); ++i) {
			const Chunk depth = _sizes.entries[layout.parts[i].entry]->depth;
			depths.push_back(depth == Chunk::None ? 0.0 : setback_distance(_context, _context.evaluate_on(section_shape(layout, i), depth)));
		}
		return depths;
	}

	// One shape, of several polygons where a deeper section cuts through; it begins with the section's edge.
	Flow run_section(const FlatFace &face, const Sections &sections, const Loops2 &covered, const SplitLayout &layout, uint32_t part) {
		if (covered.empty()) {
			return Flow::Next;
		}
		const Loop2 &outline = sections.polygon[0];
		const size_t edge = size_t(std::ranges::find(sections.part_of, part) - sections.part_of.begin());
		FacePieces pieces;
		for (Loops2 &polygon : overlay(covered, {}, OverlayKind::Union)) {
			polygon[0] = begun_near(polygon[0], outline[edge], outline[(edge + 1) % outline.size()]);
			pieces.push_back({ &face, std::move(polygon) });
		}
		BlockEntry entry = *_sizes.entries[layout.parts[part].entry];
		entry.separator = BlockEntry::Separator::All;
		Context::Children children(_context);
		return run_pieces(_context, children, section_shape(layout, part), entry, seen(pieces));
	}

	Context &_context;
	const Args &_args;
	Shape _parent;
	SplitSizes _sizes;
};

Flow split_and_setback_perimeter(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	context.mark_replaced();
	const Geometry *geometry = baked(context.shape, context.arena);
	if (geometry == nullptr || args.block == nullptr) {
		return Flow::Next;
	}
	const ArenaScope scope(context.scratch);
	return PerimeterSplit(context, args).run(flat_faces(*geometry));
}

} // namespace

void add_perimeter_operations(Dialect &dialect) {
	using enum ParamKind;
	dialect.operations.push_back({ "splitAndSetbackPerimeter",
			{ { "splitOffset", Size }, { "firstEdgeIndex", Number, {}, true }, { "selectedEdgesMask", Any, {}, true } }, BlockKind::Sizes,
			split_and_setback_perimeter,
			"Splits the outline of each face along its length and sets each section back by its own depth: { length : depth : body | .. }* "
			"{ remainder : body }. The pattern begins at the offset, on the first edge or the one given, and runs over the selected edges." });
}

} // namespace pcg::cga
